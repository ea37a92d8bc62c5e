// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnSurfaceRender.h"

#include "gtnArray.h"
#include "gtnFailure.h"
#include "gtnFileSteps.h"
#include "gtnInput.h"
#include "gtnJson.h"
#include "gtnProgress.h"
#include "gtnReadable.h"
#include "gtnRenderImage.h"
#include "gtnStep.h"
#include "gtnText.h"

#include "gatunFileReader.h"
#include "vtkGatunDefaults.h"
#include "vtkGatunDetailPolicy.h"
#include "vtkGatunSurfaceMapper.h"
#include "vtkGatunSurfaceReader.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkVolumeProperty.h"

#include <X11/Xlib.h>
#include <fmt/core.h>

#include <memory>
#include <optional>
#include <vector>

namespace gtn
{
namespace
{
// Samples of a pixel at the edges of triangles.
constexpr int Samples = 8;

/** Throws Failure without a display, where VTK would end the program. */
void RequireDisplay(const std::string& file)
{
  const std::unique_ptr<Display, int (*)(Display*)> display(XOpenDisplay(nullptr), XCloseDisplay);
  if (!display)
  {
    throw Failure(file,
      "is a surface, which is drawn by OpenGL and needs a display; where there is none, begin the "
      "command with xvfb-run -a");
  }
}

/** Throws Failure for options that only concern volumes. */
void RequireSurfaceOptions(const RenderOptions& options)
{
  if (options.BlendMode != 0 || options.UnitDistance || options.TimeBudget > 0 || options.Uniform)
  {
    throw Failure(options.Input.File,
      "is a surface; --mode, --unit-distance, --budget and --uniform are for volumes");
  }
  if (options.PixelError > 0 && ExtensionOf(options.Input.File) != ".gtn")
  {
    throw Failure(options.Input.File, "has no hierarchy, which --pixel-error needs; see gtn pack");
  }
}

/** A surface and the array that gives it its colors, if it has any. */
class SurfaceInput
{
public:
  SurfaceInput(const RenderInputOptions& options, Progress& progress)
  {
    if (ExtensionOf(options.File) == ".gtn")
    {
      this->Open(options);
    }
    else
    {
      this->Read(options, progress);
    }
    if (this->Cells == 0)
    {
      throw Failure(options.File, "has no cells");
    }
    for (const gatun::Range& range : this->Bounds)
    {
      if (!(range.Min <= range.Max))
      {
        throw Failure(options.File, "has no finite coordinates");
      }
    }
  }

  /** Consumer: a mapper or defaults. */
  template <typename Consumer>
  void Connect(Consumer* consumer) const
  {
    if (this->Reader)
    {
      consumer->SetInputConnection(this->Reader->GetOutputPort());
    }
    else
    {
      consumer->SetInputData(this->Surface);
    }
  }

  const gatun::Bounds& GetBounds() const { return this->Bounds; }
  std::uint64_t GetNumberOfCells() const { return this->Cells; }
  const std::optional<ArrayChoice>& GetArray() const { return this->Array; }
  int GetComponent() const { return this->Component; }
  const gatun::Range& GetRange() const { return this->Values; }

private:
  /** Leaves the surface in its file. */
  void Open(const RenderInputOptions& options)
  {
    CheckReadable(options.File);
    const FileSteps::Place place = OpenStep(options.File, options.Step, options.Quiet);
    const gatun::FileReader& file = *place.Mesh;
    if (this->Choose(options, GetChoices(file)))
    {
      this->Values = gtn::GetRange(file, *this->Array, this->Component, place.Step);
    }
    this->Bounds = file.GetBounds(place.Step);
    this->Cells = file.GetNumberOfCells();
    this->Reader = vtkSmartPointer<vtkGatunSurfaceReader>::New();
    this->Reader->SetFileName(options.File.c_str());
    this->Reader->SetLargeMesh(0);
    if (place.Time)
    {
      this->Reader->UpdateTimeStep(*place.Time);
    }
  }

  void Read(const RenderInputOptions& options, Progress& progress)
  {
    InputOptions inputOptions;
    inputOptions.Quiet = options.Quiet;
    Input input({ options.File }, inputOptions);
    const std::size_t step =
      ChooseStep(options.Step, options.File, input.GetTimes(), options.Quiet);
    this->Surface = vtkPolyData::SafeDownCast(input.Read(step, progress));
    if (!this->Surface)
    {
      throw Failure(options.File, "is no surface");
    }
    if (this->Choose(options, GetChoices(this->Surface)))
    {
      this->Values = gtn::GetRange(this->Surface, *this->Array, this->Component);
    }
    double bounds[6];
    this->Surface->GetBounds(bounds);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Bounds[axis] = { bounds[2 * axis], bounds[2 * axis + 1] };
    }
    this->Cells = static_cast<std::uint64_t>(this->Surface->GetNumberOfCells());
  }

  /** Returns whether there is an array to color by: a surface has one color without. */
  bool Choose(const RenderInputOptions& options, const std::vector<ArrayChoice>& choices)
  {
    if (choices.empty() && options.Array.Name.empty())
    {
      return false;
    }
    this->Array = ChooseArray(options.Array, options.File, choices, "to color by");
    this->Component = ChooseComponent(options.Array, options.File, *this->Array);
    return true;
  }

  vtkSmartPointer<vtkGatunSurfaceReader> Reader; // of a .gtn file
  vtkSmartPointer<vtkPolyData> Surface;          // of others
  gatun::Bounds Bounds;
  std::uint64_t Cells = 0;
  std::optional<ArrayChoice> Array;
  int Component = 0;
  gatun::Range Values;
};

/** Colors a surface by the array of an input. */
void SetColors(
  vtkGatunSurfaceMapper* mapper, const SurfaceInput& input, const RenderOptions& options)
{
  mapper->SetScalarVisibility(input.GetArray() ? 1 : 0);
  if (!input.GetArray())
  {
    return;
  }
  const ImageContent content{ options.Input.File, input.GetArray()->Name, input.GetRange() };
  // A surface has no opacities.
  const vtkSmartPointer<vtkVolumeProperty> property =
    MakeImageProperty(options, content, nullptr, input.GetBounds(), OpacityKind::Ramp);
  vtkColorTransferFunction* const colors = property->GetRGBTransferFunction();
  if (input.GetComponent() < 0)
  {
    colors->SetVectorModeToMagnitude();
  }
  else
  {
    colors->SetVectorModeToComponent();
    colors->SetVectorComponent(input.GetComponent());
  }
  mapper->SetLookupTable(colors);
  mapper->SetUseLookupTableScalarRange(true);
  mapper->SetColorModeToMapScalars();
  mapper->SetInterpolateScalarsBeforeMapping(true);
  if (input.GetArray()->Association == 0)
  {
    mapper->SetScalarModeToUsePointFieldData();
  }
  else
  {
    mapper->SetScalarModeToUseCellFieldData();
  }
  mapper->SelectColorArray(input.GetArray()->Name.c_str());
}

/** The window's pixels as WriteImage takes them. */
vtkSmartPointer<vtkImageData> TakePixels(vtkRenderWindow* window)
{
  const int* const size = window->GetSize();
  vtkNew<vtkFloatArray> colors;
  colors->SetName("RGBA");
  window->GetRGBAPixelData(0, 0, size[0] - 1, size[1] - 1, 0, colors);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->GetPointData()->AddArray(colors);
  return image;
}

Statistics StatisticsOf(vtkGatunSurfaceMapper* mapper)
{
  if (!mapper->GetIsDrawingFile())
  {
    return {};
  }
  vtkTable* const table = mapper->GetStatistics();
  const auto get = [table](const char* name) { return table->GetValueByName(0, name).ToDouble(); };
  return { { "chunks", "chunks drawn", Statistic::Count, get("DrawnChunks") },
    { "drawnPoints", "points left of a simplified surface", Statistic::Count, get("DrawnPoints") },
    { "decodedChunks", "chunks decoded so far", Statistic::Count, get("DecodedChunks") },
    { "bufferBytes", "buffers", Statistic::Bytes, get("BufferBytes") } };
}
} // anonymous namespace

//------------------------------------------------------------------------------
void RenderSurface(const RenderOptions& options, const Settings& settings)
{
  CheckImage(options);
  RequireSurfaceOptions(options);
  RequireDisplay(options.Input.File);
  std::unique_ptr<const SurfaceInput> input;
  {
    Progress progress("reading", settings.ShowProgress);
    input = std::make_unique<const SurfaceInput>(options.Input, progress);
  }
  vtkNew<vtkGatunSurfaceMapper> mapper;
  input->Connect(mapper.Get());
  vtkNew<vtkGatunDefaults> defaults;
  input->Connect(defaults.Get());
  SetColors(mapper, *input, options);
  mapper->GetDetailPolicy()->SetSimplificationRatio(options.Ratio);
  mapper->GetDetailPolicy()->SetPixelError(options.PixelError);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  // Over nothing: WriteImage adds the background.
  renderer->SetBackground(0, 0, 0);
  renderer->SetBackgroundAlpha(0);
  vtkNew<vtkRenderWindow> window;
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetAlphaBitPlanes(1);
  window->SetMultiSamples(Samples);
  window->SetSize(options.Width, options.Height);
  window->AddRenderer(renderer);
  vtkSmartPointer<vtkImageData> pixels;
  const auto render = [&](vtkCamera* camera, Progress& progress)
  {
    progress.Watch(mapper);
    renderer->SetActiveCamera(camera);
    const gatun::Bounds& box = input->GetBounds();
    renderer->ResetCameraClippingRange(
      box[0].Min, box[0].Max, box[1].Min, box[1].Max, box[2].Min, box[2].Max);
    window->Render();
    pixels = TakePixels(window);
    return pixels.Get();
  };
  const std::string array = input->GetArray() ? input->GetArray()->Name : std::string();
  const RenderedImage rendered = RenderImage(options, settings,
    { { options.Input.File, array, input->GetRange() }, input->GetBounds(), defaults, render,
      [&] { return StatisticsOf(mapper); } });

  Json::Value json;
  json["input"] = options.Input.File;
  json["cells"] = Json::UInt64{ input->GetNumberOfCells() };
  json["array"] = array;
  json["component"] = input->GetComponent();
  PrintImage(options, settings, rendered,
    fmt::format("a surface of {} cells", GroupDigits(input->GetNumberOfCells())), json);
}
}
