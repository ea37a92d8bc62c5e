// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn render: a mesh as a picture, or as many from all around.

#include "gtnCamera.h"
#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnJson.h"
#include "gtnMessages.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnPicture.h"
#include "gtnProgress.h"
#include "gtnRenderInput.h"
#include "gtnRenderOptions.h"
#include "gtnRenderStatistics.h"
#include "gtnText.h"
#include "gtnTransfer.h"

#include "vtkGatunRayCaster.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkVolumeProperty.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

namespace gtn
{
namespace
{

struct Drawn
{
  std::string File;
  vtkSmartPointer<vtkCamera> Camera;
  Measurement Taken{};
};

// The caster counts the samples of a ray, from the eye on, in floating-point numbers.
void RequireFewSamples(const RenderOptions& options, const gatun::Bounds& bounds, vtkCamera* camera)
{
  const double halfAngle = vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2;
  const double halfHeight = camera->GetParallelProjection()
    ? camera->GetParallelScale()
    : camera->GetDistance() * std::tan(halfAngle);
  const double distance = options.SampleDistance.value_or(2 * halfHeight / options.Height);
  double farthest = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double eye = camera->GetPosition()[i];
    farthest =
      std::hypot(farthest, std::max(std::abs(bounds[i].Min - eye), std::abs(bounds[i].Max - eye)));
  }
  constexpr double most = 1 << 23;
  if (!(farthest / distance < most))
  {
    throw Failure(options.Input.File,
      fmt::format("a sample distance of {:.3g} is too small for a mesh that reaches to {:.3g} from "
                  "the camera; give a larger --sample-distance",
        distance, farthest));
  }
}

Drawn DrawPicture(const RenderOptions& options, const RenderInput& input, vtkGatunRayCaster* caster,
  const std::string& file, double turn, Progress& progress)
{
  const double aspect = static_cast<double>(options.Width) / options.Height;
  Drawn drawn{ file, MakeCamera(options.Camera, input.GetBounds(), aspect, turn) };
  RequireFewSamples(options, input.GetBounds(), drawn.Camera);
  caster->SetCamera(drawn.Camera);
  const double readBefore = CountBytesRead();
  const auto start = std::chrono::steady_clock::now();
  progress.Watch(caster);
  input.Draw(caster);
  CheckInterrupt();
  CheckMessages(options.Input.File, options.Input.Quiet);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  drawn.Taken = Measure(caster, seconds.count(), CountBytesRead() - readBefore);
  return drawn;
}

void PrintJson(const RenderOptions& options, const RenderInput& input, vtkVolumeProperty* property,
  const std::vector<Drawn>& pictures, double peakMemory)
{
  Json json;
  json.BeginObject();
  json.Add("input", options.Input.File);
  json.Add("tets", input.GetNumberOfTets());
  json.Add("array", input.GetArray());
  json.Add("component", input.GetComponent());
  json.Add("mode", NameOfMode(options.BlendMode));
  json.Add("width", options.Width);
  json.Add("height", options.Height);
  json.Add("unitDistance", property->GetScalarOpacityUnitDistance());
  json.Add("shaded", property->GetShade() != 0);
  json.BeginArray("pictures");
  std::vector<Measurement> all;
  for (const Drawn& picture : pictures)
  {
    json.BeginObject();
    json.Add("file", picture.File);
    AddCamera(json, "camera", picture.Camera);
    AddMeasurement(json, picture.Taken);
    json.EndObject();
    all.push_back(picture.Taken);
  }
  json.EndArray();
  json.BeginObject("median");
  AddMeasurement(json, MedianOf(all));
  json.EndObject();
  json.Add("peakMemory", peakMemory);
  json.EndObject();
  fmt::print("{}", json.GetText());
}

void PrintText(const RenderOptions& options, const RenderInput& input,
  const std::vector<Drawn>& pictures, double peakMemory)
{
  std::vector<Measurement> all;
  for (const Drawn& picture : pictures)
  {
    all.push_back(picture.Taken);
  }
  const Measurement median = MedianOf(all);
  const std::string many =
    pictures.size() > 1 ? fmt::format(" to {}", FileOf(pictures.back().File)) : "";
  fmt::print("{}{}: {} x {}, '{}' of {} tetrahedra, {:.2f} s{}\n", pictures.front().File, many,
    options.Width, options.Height, Printable(input.GetArray()), Grouped(input.GetNumberOfTets()),
    median[0], pictures.size() > 1 ? " each" : "");
  if (options.Statistics)
  {
    if (pictures.size() > 1)
    {
      fmt::print("  median of {} pictures\n", pictures.size());
    }
    PrintTable(median, peakMemory);
  }
}

void Render(const RenderOptions& options, const Settings& settings)
{
  if (!IsPicture(options.Out))
  {
    throw UsageError(options.Out + ": the name must end in " + PictureFormats);
  }
  const std::vector<std::string> files = NamePictures(options);
  for (const std::string& file : files)
  {
    CheckWritable(file, options.Overwrite);
  }
  std::unique_ptr<const RenderInput> input;
  {
    Progress progress("reading", settings.ShowProgress);
    input = std::make_unique<const RenderInput>(options.Input, progress);
  }
  const PictureContent content{ options.Input.File, input->GetArray(), input->GetRange() };
  const vtkSmartPointer<vtkVolumeProperty> property = MakeProperty(MakeTransfer(options, content),
    options.UnitDistance.value_or(DiagonalOf(input->GetBounds()) / 100));
  property->SetShade(options.Shade);

  vtkNew<vtkGatunRayCaster> caster;
  caster->SetSize(options.Width, options.Height);
  caster->SetBlendMode(options.BlendMode);
  caster->SetSampleDistance(options.SampleDistance.value_or(0));
  caster->SetMemoryBudget(options.Memory);
  caster->SetSimplificationRatio(options.Ratio);
  caster->SetTimeBudget(options.TimeBudget);
  caster->SetProperty(property);
  input->Connect(caster);
  std::vector<Drawn> pictures;
  double peakMemory = 0;
  for (const std::string& file : files)
  {
    const auto number = static_cast<double>(pictures.size());
    const auto count = static_cast<double>(files.size());
    Progress progress(
      files.size() > 1 ? fmt::format("drawing {} of {}", number + 1, count) : "drawing",
      settings.ShowProgress);
    pictures.push_back(DrawPicture(options, *input, caster, file, 360 * number / count, progress));
    // Of one picture, before the libraries come that write it, which have no part in drawing.
    peakMemory = GetPeakMemory();
    WritePicture(caster->GetOutput(), options.Background,
      MakeRemarks(content, settings.CommandLine, pictures.back().Camera), file);
  }
  if (options.Json)
  {
    PrintJson(options, *input, property, pictures, peakMemory);
  }
  else if (!settings.Quiet || options.Statistics)
  {
    PrintText(options, *input, pictures, peakMemory);
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddRender(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = AddRenderOptions(app, settings, *options);
  command->callback(
    [options, &settings]
    {
      options->Input.Quiet = settings.Quiet;
      Render(*options, settings);
    });
}
}
