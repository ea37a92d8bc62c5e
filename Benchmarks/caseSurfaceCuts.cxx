// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// surface-cuts: images of surfaces that are simplified for the view, and of those that are
// simplified everywhere alike, on a flight towards a surface.

#include "benchCases.h"
#include "benchSurfacePipeline.h"

#include "gatunParallel.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace bench
{
namespace
{
// Pixels of an image are means of so many squared.
constexpr int Samples = 3;

struct SurfaceCutsOptions
{
  std::string File;
  std::vector<double> Errors{ 0.5, 1, 2, 4 };
  int Places = 4;
  int Levels = 8;
  int Memory = 1024;
  int Size = 400;
};

/** A surface in a window. */
class Flight
{
public:
  explicit Flight(const SurfaceCutsOptions& options)
    : Size(options.Size)
    , Pipeline(MakeSurfacePipeline(options.File, options.Memory))
    , Mapper(Pipeline.GetOwnMapper())
  {
    if (!this->Mapper)
    {
      throw Failure(options.File, "is no .gtn file");
    }
    this->Mapper->ScalarVisibilityOff();
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Samples * options.Size, Samples * options.Size);
    this->Window->AddRenderer(this->Renderer);
    this->Window->SetDesiredUpdateRate(0.001);
  }

  vtkGatunSurfaceMapper* GetMapper() { return this->Mapper; }

  /** From far, at a time of 0, to near, at 1, where the surface reaches to the horizon. */
  void Place(double time, double turn = 0)
  {
    double bounds[6];
    this->Mapper->GetBounds(bounds);
    const double radius = 0.5 * (bounds[1] - bounds[0]);
    const double far = 4 * radius;
    const double near = 1.15 * radius;
    const double distance = far * std::pow(near / far, time);
    const double ahead = vtkMath::Pi() / 5 * time + vtkMath::RadiansFromDegrees(turn);
    vtkCamera* const camera = this->Renderer->GetActiveCamera();
    const double angle = vtkMath::RadiansFromDegrees(turn);
    camera->SetPosition(distance * std::cos(angle), distance * std::sin(angle), 0.1 * radius);
    camera->SetFocalPoint(time * radius * std::cos(ahead), time * radius * std::sin(ahead), 0);
    camera->SetViewUp(time < 1e-3 ? 0 : std::cos(angle), std::sin(angle), time < 1e-3 ? 1 : 0.2);
    camera->SetViewAngle(40);
    this->Renderer->ResetCameraClippingRange();
  }

  double Draw()
  {
    const double seconds = SecondsOf(
      [this]
      {
        this->Window->Render();
        this->Window->WaitForCompletion();
      });
    if (this->Pipeline.HasFailed())
    {
      throw Failure("the surface", "cannot be drawn");
    }
    return seconds;
  }

  /** The last image, gray, each pixel a mean. */
  std::vector<double> Take()
  {
    const int wide = Samples * this->Size;
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetRGBACharPixelData(0, 0, wide - 1, wide - 1, 0, pixels);
    std::vector<double> image(static_cast<std::size_t>(this->Size) * this->Size);
    for (int y = 0; y < wide; ++y)
    {
      for (int x = 0; x < wide; ++x)
      {
        const unsigned char* const from = pixels->GetPointer(4 * (vtkIdType{ y } * wide + x));
        image[static_cast<std::size_t>(y / Samples) * this->Size + x / Samples] +=
          (from[0] + from[1] + from[2]) / (3.0 * Samples * Samples);
      }
    }
    return image;
  }

private:
  int Size;
  SurfacePipeline Pipeline;
  vtkGatunSurfaceMapper* Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

double FindDifference(const std::vector<double>& one, const std::vector<double>& other)
{
  double sum = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    sum += (one[i] - other[i]) * (one[i] - other[i]);
  }
  return std::sqrt(sum / static_cast<double>(one.size()));
}

/** The images of a place. */
Json::Value MeasurePlace(Flight& flight, const SurfaceCutsOptions& options, double time)
{
  vtkGatunSurfaceMapper* const mapper = flight.GetMapper();
  Json::Value json;
  json["time"] = time;
  flight.Place(time);
  flight.Draw();
  const std::vector<double> whole = flight.Take();
  json["cuts"] = Json::arrayValue;
  for (const double error : options.Errors)
  {
    mapper->SetPixelError(error);
    flight.Draw();
    Json::Value& cut = json["cuts"].append(Json::objectValue);
    cut["error"] = error;
    cut["points"] = Json::Int64{ mapper->GetNumberOfDrawnPoints() };
    cut["difference"] = FindDifference(flight.Take(), whole);
    const double drawing = flight.Draw();
    // The next frame of a flight.
    flight.Place(time, 0.5);
    const vtkIdType decoded = mapper->GetNumberOfDecodedChunks();
    const double moved = flight.Draw();
    cut["chunks"] = Json::Int64{ mapper->GetNumberOfDrawnChunks() };
    cut["newChunks"] = Json::Int64{ mapper->GetNumberOfDecodedChunks() - decoded };
    cut["updateSeconds"] = std::max(0.0, moved - drawing);
    cut["drawSeconds"] = flight.Draw();
    flight.Place(time);
  }
  mapper->SetPixelError(0);
  json["uniform"] = Json::arrayValue;
  double left = 1;
  for (int i = 0; i < options.Levels; ++i)
  {
    left /= 2;
    mapper->SetSimplificationRatio(1 - left);
    flight.Draw();
    Json::Value& uniform = json["uniform"].append(Json::objectValue);
    uniform["points"] = Json::Int64{ mapper->GetNumberOfDrawnPoints() };
    uniform["difference"] = FindDifference(flight.Take(), whole);
  }
  mapper->SetSimplificationRatio(0);
  return json;
}

void Measure(const SurfaceCutsOptions& options)
{
  Flight flight(options);
  Json::Value places(Json::arrayValue);
  for (int i = 0; i < options.Places; ++i)
  {
    places.append(
      MeasurePlace(flight, options, static_cast<double>(i) / std::max(1, options.Places - 1)));
  }
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["places"] = places;
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSurfaceCuts(CLI::App& app)
{
  auto options = std::make_shared<SurfaceCutsOptions>();
  CLI::App* const command = app.add_subcommand("surface-cuts",
    "Images of a surface simplified for the view and everywhere alike, from far to near, beside "
    "those of the whole");
  command->add_option("FILE", options->File, "A .gtn file with base meshes")->required();
  command->add_option("--errors", options->Errors, "Errors in pixels")->expected(-1);
  command->add_option("--places", options->Places, "Number of places of the camera")
    ->check(CLI::Range(1, 100));
  command->add_option("--levels", options->Levels, "Halvings of the number of points")
    ->check(CLI::Range(1, 30));
  command->add_option("--memory", options->Memory, "Memory for buffers of chunks in MiB")
    ->check(CLI::Range(0, 1 << 30));
  command->add_option("--size", options->Size, "Width and height in pixels")
    ->check(CLI::Range(1, 2048));
  command->callback([options] { Measure(*options); });
}
}
