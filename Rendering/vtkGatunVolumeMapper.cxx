// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunVolumeMapper.h"

#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunJustInTime.h"
#include "gatunRayCaster.h"
#include "gatunRayPicture.h"
#include "gatunRayRefresh.h"
#include "gatunRayRendering.h"
#include "gatunRayScene.h"
#include "vtkGatunReader.h"

#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkTrivialProducer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunVolumeMapper);

namespace
{

//------------------------------------------------------------------------------
enum class InputKind
{
  None,
  Grid,
  File,
  Pieces
};

//------------------------------------------------------------------------------
/** Where a renderer draws, in pixels of its window. */
struct Viewport
{
  int Width = 0;
  int Height = 0;
  int X = 0;
  int Y = 0;

  explicit Viewport(vtkRenderer* renderer)
  {
    renderer->GetTiledSizeAndOrigin(&this->Width, &this->Height, &this->X, &this->Y);
  }
};

// One numbering for all classes that draw.
static_assert(int{ vtkGatunVolumeMapper::COMPOSITE_BLEND } == gatun::CompositeBlend);
static_assert(int{ vtkGatunVolumeMapper::MAXIMUM_INTENSITY_BLEND } == gatun::MaximumIntensityBlend);
static_assert(int{ vtkGatunVolumeMapper::AREA_BLEND } == gatun::AreaBlend);
static_assert(int{ vtkGatunVolumeMapper::XRAY_BLEND } == gatun::XRayBlend);

//------------------------------------------------------------------------------
void ToArray(const gatun::Bounds& box, double* bounds)
{
  vtkMath::UninitializeBounds(bounds);
  if (box[0].Min <= box[0].Max)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = box[axis].Min;
      bounds[2 * axis + 1] = box[axis].Max;
    }
  }
}

//------------------------------------------------------------------------------
// Seconds. Pictures that are allocated as much are at rest: what interacts allocates a second or
// less, what waits, minutes.
constexpr double LeastTimeAtRest = 10;

//------------------------------------------------------------------------------
/** All that a picture depends on but the number of points. */
struct PictureSetup
{
  const void* Mesh;
  const void* Renderer;
  const void* Volume;
  gatun::RayView View;
  gatun::RayTable Table;
  gatun::RayLimits Limits;
  gatun::RaySettings Settings;

  bool operator==(const PictureSetup&) const = default;
};

//------------------------------------------------------------------------------
/** Tells those who work in the background that a picture is being drawn. */
class Drawing
{
public:
  explicit Drawing(gatun::RayLevels* levels)
    : Levels(levels)
  {
    this->Tell(true);
  }
  ~Drawing() { this->Tell(false); }
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

private:
  void Tell(bool drawing)
  {
    if (this->Levels)
    {
      this->Levels->SetDrawing(drawing);
    }
  }

  gatun::RayLevels* const Levels;
};

//------------------------------------------------------------------------------
gatun::RayGrid MakeGrid(vtkRenderer* renderer, const Viewport& viewport, float distance)
{
  const bool toBorders =
    distance > 1 || std::max(viewport.Width, viewport.Height) > gatun::RayPicture::MostPixels;
  const auto count = [&](int pixels)
  { return toBorders ? std::max(2, static_cast<int>(std::ceil(pixels / distance))) : pixels; };
  return { count(viewport.Width), count(viewport.Height), renderer->GetTiledAspectRatio(),
    toBorders };
}

} // anonymous namespace

//------------------------------------------------------------------------------
class vtkGatunVolumeMapper::vtkInternals
{
public:
  gatun::RayScene Scene;
  gatun::RayPicture Picture;
  std::set<std::string> Told; // causes why nothing is drawn, since something was

  std::string Obstacle;     // that was told
  std::uint64_t Points = 0; // of what the last picture shows; 0: all
  double PartDrawn = 0;     // of its tiles

  // What the picture that was taken last can be brought up to date with, if that is possible.
  std::shared_ptr<const PictureSetup> Setup;
  std::unique_ptr<gatun::RayRefresh> Refresh;

  // Seconds for each ray of the last picture.
  std::map<std::pair<vtkRenderer*, vtkVolume*>, double> TimeOfRays;
  std::map<std::pair<vtkRenderer*, vtkVolume*>, gatun::JustInTime> Frames;

  static InputKind GetKind(vtkGatunVolumeMapper* mapper);
  static std::string GetCause(vtkGatunVolumeMapper* mapper, const gatun::VTKFailure& failure);
  static gatun::RayArray GetArray(vtkGatunVolumeMapper* mapper);
  static std::uint64_t GetBudget(vtkGatunVolumeMapper* mapper);
  static double GetRatio(vtkGatunVolumeMapper* mapper);
  static bool Simplifies(vtkGatunVolumeMapper* mapper);
  static void Pull(vtkGatunVolumeMapper* mapper);
  bool SetScene(vtkGatunVolumeMapper* mapper, const gatun::RaySource::Progress& progress);
  float ChooseDistance(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    const Viewport& viewport) const;
  gatun::FrameRequest GetRequest(
    vtkGatunVolumeMapper* mapper, vtkVolume* volume, const Viewport& viewport) const;
  void TellObstacle(vtkGatunVolumeMapper* mapper);
  gatun::RayStatistics Draw(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    const Viewport& viewport, const gatun::RayGrid& grid,
    const gatun::RaySource::Progress& progress, const gatun::Frame& frame);
  void DrawAnew(const PictureSetup& setup, std::shared_ptr<gatun::RaySource> source,
    const gatun::RayGrid& grid, const gatun::RaySource::Progress& progress);
  void DrawFrame(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);
};

//------------------------------------------------------------------------------
InputKind vtkGatunVolumeMapper::vtkInternals::GetKind(vtkGatunVolumeMapper* mapper)
{
  vtkAlgorithm* const input = gatun::GetProducer(mapper).Algorithm;
  if (!input)
  {
    return InputKind::None;
  }
  if (gatun::GetFileReader(input))
  {
    return InputKind::File;
  }
  // A grid that was given as such is there as a whole, whatever piece is asked for.
  return mapper->NumberOfPieces > 1 && !vtkTrivialProducer::SafeDownCast(input) ? InputKind::Pieces
                                                                                : InputKind::Grid;
}

//------------------------------------------------------------------------------
gatun::RayArray vtkGatunVolumeMapper::vtkInternals::GetArray(vtkGatunVolumeMapper* mapper)
{
  gatun::RayArray array;
  array.Component = mapper->ArrayComponent;
  const int mode = mapper->ScalarMode;
  if (mode == VTK_SCALAR_MODE_DEFAULT)
  {
    return array;
  }
  const bool ofPoints =
    mode == VTK_SCALAR_MODE_USE_POINT_DATA || mode == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA;
  const bool ofCells =
    mode == VTK_SCALAR_MODE_USE_CELL_DATA || mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  if (!ofPoints && !ofCells)
  {
    throw gatun::Error(
      gatun::ErrorCode::InvalidInput, "only arrays of points and of cells can be drawn");
  }
  array.Association = ofPoints ? 0 : 1;
  if (mode == VTK_SCALAR_MODE_USE_POINT_DATA || mode == VTK_SCALAR_MODE_USE_CELL_DATA)
  {
    return array;
  }
  if (mapper->ArrayAccessMode == VTK_GET_ARRAY_BY_ID)
  {
    array.Index = mapper->ArrayId;
    return array;
  }
  array.Name = mapper->ArrayName;
  if (array.Name.empty())
  {
    throw gatun::Error(gatun::ErrorCode::InvalidInput, "no array to draw is selected");
  }
  return array;
}

//------------------------------------------------------------------------------
std::uint64_t vtkGatunVolumeMapper::vtkInternals::GetBudget(vtkGatunVolumeMapper* mapper)
{
  return static_cast<std::uint64_t>(mapper->MemoryBudget) << 20;
}

//------------------------------------------------------------------------------
double vtkGatunVolumeMapper::vtkInternals::GetRatio(vtkGatunVolumeMapper* mapper)
{
  return gatun::GetRatio(gatun::GetProducer(mapper).Algorithm, mapper->SimplificationRatio);
}

//------------------------------------------------------------------------------
bool vtkGatunVolumeMapper::vtkInternals::Simplifies(vtkGatunVolumeMapper* mapper)
{
  return mapper->JustInTime || GetRatio(mapper) != 0;
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::Pull(vtkGatunVolumeMapper* mapper)
{
  const gatun::RayProducer producer = gatun::GetProducer(mapper);
  switch (GetKind(mapper))
  {
    case InputKind::None:
      break;
    case InputKind::Grid:
      gatun::PullPiece(producer, 0, 1);
      break;
    case InputKind::File:
    case InputKind::Pieces:
      // vtkVolume draws nothing where there is no object, even if it is empty.
      producer.Algorithm->UpdateDataObject();
      break;
  }
}

//------------------------------------------------------------------------------
/** Whether there is something to draw. */
bool vtkGatunVolumeMapper::vtkInternals::SetScene(
  vtkGatunVolumeMapper* mapper, const gatun::RaySource::Progress& progress)
{
  const gatun::RayProducer producer = gatun::GetProducer(mapper);
  const auto budget = GetBudget(mapper);
  switch (GetKind(mapper))
  {
    case InputKind::None:
      return false;
    case InputKind::File:
      this->Scene.SetFile(gatun::GetFileReader(producer.Algorithm)->GetFileName(),
        gatun::GetRequestedTime(producer), GetArray(mapper), budget, Simplifies(mapper));
      return true;
    case InputKind::Pieces:
      this->Scene.SetPieces(producer, mapper->NumberOfPieces, GetArray(mapper), budget, progress);
      return true;
    case InputKind::Grid:
      break;
  }
  Pull(mapper);
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(mapper->GetDataObjectInput());
  if (!grid)
  {
    throw gatun::Error(gatun::ErrorCode::InvalidInput, "the input is not a vtkUnstructuredGrid");
  }
  if (grid->GetNumberOfCells() == 0)
  {
    return false;
  }
  this->Scene.SetGrid(grid, GetArray(mapper), budget, Simplifies(mapper));
  return true;
}

//------------------------------------------------------------------------------
float vtkGatunVolumeMapper::vtkInternals::ChooseDistance(vtkGatunVolumeMapper* mapper,
  vtkRenderer* renderer, vtkVolume* volume, const Viewport& viewport) const
{
  if (!mapper->AutoAdjustSampleDistances)
  {
    return mapper->ImageSampleDistance;
  }
  const float least = mapper->MinimumImageSampleDistance;
  const auto known = this->TimeOfRays.find({ renderer, volume });
  const double allocated = volume->GetAllocatedRenderTime();
  if (known == this->TimeOfRays.end() || !(allocated > 0))
  {
    return least;
  }
  const double all = known->second * viewport.Width * viewport.Height;
  const auto wanted = static_cast<float>(std::sqrt(all / allocated));
  return std::max(least, std::min(wanted, mapper->MaximumImageSampleDistance));
}

//------------------------------------------------------------------------------
gatun::FrameRequest vtkGatunVolumeMapper::vtkInternals::GetRequest(
  vtkGatunVolumeMapper* mapper, vtkVolume* volume, const Viewport& viewport) const
{
  gatun::FrameRequest request;
  const double allocated = volume->GetAllocatedRenderTime();
  if (mapper->JustInTime && allocated > 0 && allocated < LeastTimeAtRest)
  {
    request.Budget = mapper->TimeBudget > 0 ? mapper->TimeBudget : allocated;
  }
  request.Ratio = GetRatio(mapper);
  request.Pixels = static_cast<double>(viewport.Width) * viewport.Height;
  const bool adjusts = mapper->AutoAdjustSampleDistances;
  request.LeastDistance =
    adjusts ? mapper->MinimumImageSampleDistance : mapper->ImageSampleDistance;
  request.LargestDistance = adjusts
    ? std::max(mapper->MinimumImageSampleDistance, mapper->MaximumImageSampleDistance)
    : mapper->ImageSampleDistance;
  return request;
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::TellObstacle(vtkGatunVolumeMapper* mapper)
{
  const std::string& obstacle = this->Scene.GetObstacle();
  if (obstacle != this->Obstacle)
  {
    this->Obstacle = obstacle;
    if (!obstacle.empty())
    {
      vtkWarningWithObjectMacro(mapper, << obstacle);
    }
  }
}

//------------------------------------------------------------------------------
gatun::RayStatistics vtkGatunVolumeMapper::vtkInternals::Draw(vtkGatunVolumeMapper* mapper,
  vtkRenderer* renderer, vtkVolume* volume, const Viewport& viewport, const gatun::RayGrid& grid,
  const gatun::RaySource::Progress& progress, const gatun::Frame& frame)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> matrix;
  volume->GetMatrix(matrix);
  const auto view = gatun::MakeRayView(camera, grid, mapper->SampleDistance, matrix, true);
  auto limits = gatun::MakeRayLimits(view, mapper->GetClippingPlanes(), matrix);
  if (mapper->IntermixIntersectingGeometry && renderer->GetNumberOfPropsRendered() > 0)
  {
    vtkNew<vtkFloatArray> depths;
    renderer->GetRenderWindow()->GetZbufferData(viewport.X, viewport.Y,
      viewport.X + viewport.Width - 1, viewport.Y + viewport.Height - 1, depths);
    const std::span<const float> zBuffer(
      depths->GetPointer(0), static_cast<std::size_t>(depths->GetNumberOfValues()));
    gatun::LimitByZBuffer(view, camera, grid, zBuffer, viewport.Width, viewport.Height, limits);
  }
  gatun::RaySettings settings;
  settings.Opaque = static_cast<float>(mapper->OpacityLimit);
  settings.Shading =
    gatun::MakeRayShading(volume->GetProperty(), camera, renderer->GetLights(), matrix);
  auto table = gatun::MakeRayTable(volume->GetProperty(), *gatun::RayModeOf(mapper->BlendMode),
    this->Scene.GetRange(), view.SampleDistance);
  if (frame.Source && !mapper->JustInTime)
  {
    // Somebody may be looking for the best ratio.
    settings.Repeatable = true;
    this->DrawAnew({ this->Scene.GetLevels(), renderer, volume, view, std::move(table),
                     std::move(limits), settings },
      frame.Source, grid, progress);
    return {};
  }
  this->Refresh.reset();
  gatun::RayCaster caster(view, std::move(table), limits, settings);
  this->Scene.Draw(caster, view, progress, frame.Source.get());
  this->Picture.Take(caster, grid);
  this->PartDrawn = 1;
  return caster.GetStatistics();
}

//------------------------------------------------------------------------------
/** Draws what another number of points changes. */
void vtkGatunVolumeMapper::vtkInternals::DrawAnew(const PictureSetup& setup,
  std::shared_ptr<gatun::RaySource> source, const gatun::RayGrid& grid,
  const gatun::RaySource::Progress& progress)
{
  if (!this->Refresh || *this->Setup != setup)
  {
    this->Setup = std::make_shared<const PictureSetup>(setup);
    this->Refresh = std::make_unique<gatun::RayRefresh>(
      [kept = this->Setup]
      {
        return std::make_unique<gatun::RayCaster>(
          kept->View, kept->Table, kept->Limits, kept->Settings);
      });
  }
  this->PartDrawn = this->Picture.Take(*this->Refresh, std::move(source), grid, progress);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::vtkInternals::DrawFrame(
  vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  const Viewport viewport(renderer);
  if (viewport.Width <= 0 || viewport.Height <= 0)
  {
    return;
  }
  gatun::RequireNumber("ImageSampleDistance", mapper->ImageSampleDistance);
  gatun::RequireNumber("MinimumImageSampleDistance", mapper->MinimumImageSampleDistance);
  gatun::RequireNumber("MaximumImageSampleDistance", mapper->MaximumImageSampleDistance);
  gatun::RequireNumber("OpacityLimit", mapper->OpacityLimit);
  gatun::RequireNumber("TimeBudget", mapper->TimeBudget);
  vtkRenderWindow* const window = renderer->GetRenderWindow();
  const auto progress = [mapper, window](double fraction)
  {
    mapper->UpdateProgress(fraction);
    return window->CheckAbortStatus() == 0;
  };
  if (!this->SetScene(mapper, progress))
  {
    return;
  }
  this->TellObstacle(mapper);
  // From here on, as the time for the input says nothing of the next picture.
  mapper->Timer->StartTimer();
  const auto key = std::make_pair(renderer, volume);
  gatun::RayLevels* const levels = this->Scene.GetLevels();
  gatun::JustInTime* const frames = levels ? &this->Frames[key] : nullptr;
  const gatun::FrameRequest request = this->GetRequest(mapper, volume, viewport);
  const gatun::Frame frame = frames ? frames->Begin(*levels, request, progress) : gatun::Frame{};
  const bool inMotion = frames && request.Budget > 0;
  const float distance = inMotion ? static_cast<float>(frame.Distance)
                                  : this->ChooseDistance(mapper, renderer, volume, viewport);
  const gatun::RayGrid grid = MakeGrid(renderer, viewport, distance);
  const Drawing drawing(levels);
  const double before = vtkTimerLog::GetUniversalTime();
  const auto statistics = this->Draw(mapper, renderer, volume, viewport, grid, progress, frame);
  const double cast = vtkTimerLog::GetUniversalTime() - before;
  this->Picture.Show(renderer, volume, mapper->IntermixIntersectingGeometry);
  if (inMotion)
  {
    window->WaitForCompletion(); // or the next picture would pay for this one
  }
  mapper->Timer->StopTimer();
  const double rays = static_cast<double>(grid.Width) * grid.Height;
  mapper->ImageSampleDistance = distance;
  mapper->TimeToDraw = mapper->Timer->GetElapsedTime();
  this->TimeOfRays[key] = mapper->TimeToDraw / rays;
  this->Points = frame.Points;
  if (frames && mapper->JustInTime)
  {
    frames->End(*levels, frame, rays, statistics, { cast, mapper->TimeToDraw });
  }
  mapper->UpdateProgress(1);
}

//------------------------------------------------------------------------------
vtkGatunVolumeMapper::vtkGatunVolumeMapper()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkGatunVolumeMapper::~vtkGatunVolumeMapper() = default;

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::SetBlendMode(int mode)
{
  if (!gatun::RayModeOf(mode))
  {
    vtkErrorMacro("Blend mode " << mode << " is not supported.");
  }
  else if (mode != this->BlendMode)
  {
    this->BlendMode = mode;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkGatunVolumeMapper::GetBytesRead()
{
  return this->Internals->Scene.GetBytesRead();
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunVolumeMapper::GetNumberOfDrawnPoints()
{
  return static_cast<vtkIdType>(this->Internals->Points);
}

//------------------------------------------------------------------------------
double vtkGatunVolumeMapper::GetPartDrawn()
{
  return this->Internals->PartDrawn;
}

//------------------------------------------------------------------------------
bool vtkGatunVolumeMapper::PrepareSimplification()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    const auto progress = [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return this->GetAbortExecute() == 0;
    };
    if (!vtkInternals::Simplifies(this) || !this->Internals->SetScene(this, progress) ||
      !this->Internals->Scene.GetLevels())
    {
      return false;
    }
    auto* const levels = this->Internals->Scene.GetLevels();
    levels->WaitForDetail(progress);
    levels->Wait();
    this->UpdateProgress(1);
    return true;
  }
  catch (...)
  {
    this->Fail();
    return false;
  }
}

//------------------------------------------------------------------------------
/** One for all the damage in a file, as threads meet the blocks that are damaged in any order. */
std::string vtkGatunVolumeMapper::vtkInternals::GetCause(
  vtkGatunVolumeMapper* mapper, const gatun::VTKFailure& failure)
{
  return failure.Code == vtkErrorCode::FileFormatError && GetKind(mapper) == InputKind::File
    ? gatun::GetFileReader(gatun::GetProducer(mapper).Algorithm)->GetFileName()
    : failure.Message;
}

//------------------------------------------------------------------------------
/** Reports what is being thrown. */
void vtkGatunVolumeMapper::Fail() noexcept
{
  try
  {
    const gatun::VTKFailure failure = gatun::DescribeFailure("The mesh cannot be drawn");
    this->SetErrorCode(failure.Code);
    if (failure.Aborted)
    {
      return;
    }
    auto& self = *this->Internals;
    self.Scene.Clear();
    if (self.Told.insert(self.GetCause(this, failure)).second)
    {
      vtkErrorMacro(<< failure.Message);
    }
  }
  catch (...)
  {
    // No memory for a message, or an observer of errors that throws.
    this->SetErrorCode(vtkErrorCode::UnknownError);
  }
}

//------------------------------------------------------------------------------
double* vtkGatunVolumeMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  auto& self = *this->Internals;
  try
  {
    switch (vtkInternals::GetKind(this))
    {
      case InputKind::None:
        break;
      case InputKind::Grid:
        return this->Superclass::GetBounds();
      case InputKind::File:
        ToArray(self.Scene.GetFileBounds(
                  gatun::GetFileReader(gatun::GetProducer(this).Algorithm)->GetFileName()),
          this->Bounds);
        break;
      case InputKind::Pieces:
        self.SetScene(this, {});
        ToArray(self.Scene.GetPieceBounds(), this->Bounds);
        break;
    }
  }
  catch (...)
  {
    this->Fail();
  }
  return this->Bounds;
}

//------------------------------------------------------------------------------
vtkDataSet* vtkGatunVolumeMapper::GetDataSetInput()
{
  return vtkInternals::GetKind(this) == InputKind::Grid ? this->Superclass::GetDataSetInput()
                                                        : nullptr;
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::Update()
{
  this->Update(0);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::Update(int port)
{
  this->Update(port, nullptr);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGatunVolumeMapper::Update(int, vtkInformationVector*)
{
  try
  {
    vtkInternals::Pull(this);
    return 1;
  }
  catch (...)
  {
    this->Fail();
    return 0;
  }
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGatunVolumeMapper::Update(vtkInformation*)
{
  return this->Update(0, nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::UpdateWholeExtent()
{
  this->Update(0);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  this->TimeToDraw = 0;
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    this->Internals->DrawFrame(this, renderer, volume);
    this->Internals->Told.clear();
  }
  catch (...)
  {
    this->Fail();
  }
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Picture.Release(window);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto tell = [](auto value) { return value ? "On" : "Off"; };
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "AutoAdjustSampleDistances: " << tell(this->AutoAdjustSampleDistances) << "\n";
  os << indent << "MinimumImageSampleDistance: " << this->MinimumImageSampleDistance << "\n";
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << "\n";
  os << indent << "IntermixIntersectingGeometry: " << tell(this->IntermixIntersectingGeometry)
     << "\n";
  os << indent << "ArrayComponent: " << this->ArrayComponent << "\n";
  os << indent << "OpacityLimit: " << this->OpacityLimit << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
  os << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
  os << indent << "JustInTime: " << tell(this->JustInTime) << "\n";
  os << indent << "TimeBudget: " << this->TimeBudget << "\n";
  os << indent << "SimplificationRatio: " << this->SimplificationRatio << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
