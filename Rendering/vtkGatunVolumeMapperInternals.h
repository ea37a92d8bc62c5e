// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkGatunVolumeMapperInternals_h
#define vtkGatunVolumeMapperInternals_h

#include "gatunDetailSettings.h"
#include "gatunErrorCodes.h"
#include "gatunJustInTime.h"
#include "gatunOwned.h"
#include "gatunRayCaster.h"
#include "gatunRayImage.h"
#include "gatunRayRefresh.h"
#include "gatunRayRendering.h"
#include "gatunRayScene.h"
#include "gatunStatistics.h"
#include "vtkGatunVolumeMapper.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkFloatArray;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
class ParallelImage;
class ProcessExchange;
struct PublishedFile;

/** The kinds of input that the mapper draws in different ways. */
enum class InputKind
{
  None,
  Grid,
  File,
  Pieces
};

/** The part of a window that a renderer draws into, in pixels. */
struct Viewport
{
  int Width = 0;
  int Height = 0;
  int X = 0;
  int Y = 0;

  explicit Viewport(vtkRenderer* renderer);
};

/** What the processes of an image need to know of each other. */
struct PartFacts
{
  bool HasMesh = false;
  bool HasGeometry = false; ///< whether anything has been drawn before
  int Width = 0;
  int Height = 0;
  double Low = 0; ///< range of the values
  double High = 0;
  std::uint64_t File = 0; ///< the same for the same file and values; 0 if there is none
  std::array<double, 6> Bounds{};
};

/** What the first process chooses for the image of all. */
struct ParallelPlan
{
  RayGrid Grid;
  RayView View;
  float Distance = 1;            ///< of rays, in pixels
  std::uint64_t Points = 0;      ///< of the level of detail; 0: none
  std::optional<RayView> Detail; ///< the view of the level, if it has one
  std::uint64_t NextPoints = 0;  ///< of the level for the present view that is wanted next; 0: none
  bool IsInMotion = false;
  int ImageProcess = -1; ///< the process that shows the image, or -1
};

/** The rays of an image with a distance between them, in pixels. */
RayGrid MakeGrid(vtkRenderer* renderer, const Viewport& viewport, float distance);

/** Tells the threads in the background that a frame is being drawn. */
class FrameNotice
{
public:
  explicit FrameNotice(LevelOfDetailCache* levels)
    : Levels(levels)
  {
    this->Tell(true);
  }
  ~FrameNotice() { this->Tell(false); }
  FrameNotice(const FrameNotice&) = delete;
  FrameNotice& operator=(const FrameNotice&) = delete;

private:
  void Tell(bool drawing)
  {
    if (this->Levels)
    {
      this->Levels->SetDrawing(drawing);
    }
  }

  LevelOfDetailCache* const Levels;
};

/** All that an image depends on except the number of points. */
struct ImageSetup
{
  const void* Mesh;
  const void* Renderer;
  const void* Volume;
  RayView View;
  RayTable Table;
  RayLimits Limits;
  RaySettings Settings;

  bool operator==(const ImageSetup&) const = default;
};
}

/** The input of a mapper, and its frames. Methods throw gatun::Error. */
class vtkGatunVolumeMapper::vtkInternals
{
public:
  gatun::Owned<vtkGatunDetailPolicy> Policy;
  gatun::Statistics Statistics;
  gatun::RayScene Scene;
  gatun::RayImage Image;
  std::set<std::string> Reported; // causes of failures that were reported since the last image

  std::string Reason;       // that was reported
  std::uint64_t Points = 0; // of the mesh in the last image; 0: all
  double PartDrawn = 0;     // of the tiles of the last image

  // For bringing the last image up to date, if that is possible.
  std::shared_ptr<const gatun::ImageSetup> Setup;
  std::unique_ptr<gatun::RayRefresh> Refresh;

  // Seconds for each ray of the last image.
  std::map<std::pair<vtkRenderer*, vtkVolume*>, double> TimeOfRays;
  std::map<std::pair<vtkRenderer*, vtkVolume*>, gatun::JustInTime> Frames;

  std::optional<std::array<double, 6>> WholeBounds; // of all processes
  std::uint64_t BytesSent = 0;                      // for the last image

  // The input whose information could not be made, and when: it is not asked again before it has
  // changed, as it would report the same error.
  const void* FailedInput = nullptr;
  vtkMTimeType FailedTime = 0;

  void UpdateInformation(const gatun::RayProducer& producer);
  const gatun::PublishedFile* FindFile(vtkGatunVolumeMapper* mapper);
  const gatun::PublishedFile& GetFile(vtkGatunVolumeMapper* mapper);
  gatun::InputKind GetKind(vtkGatunVolumeMapper* mapper);
  std::string GetCause(vtkGatunVolumeMapper* mapper, const gatun::VTKFailure& failure);
  static gatun::RayArray GetArray(vtkGatunVolumeMapper* mapper);
  static std::uint64_t GetBudget(vtkGatunVolumeMapper* mapper);
  static bool IsParallel(vtkGatunVolumeMapper* mapper);
  static gatun::PieceShare GetPieces(vtkGatunVolumeMapper* mapper);
  bool Simplifies(vtkGatunVolumeMapper* mapper);
  void Pull(vtkGatunVolumeMapper* mapper);
  bool SetScene(vtkGatunVolumeMapper* mapper, const gatun::RaySource::Progress& progress);
  float ChooseDistance(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    const gatun::Viewport& viewport) const;
  std::shared_ptr<const gatun::DetailView> MakeDetailView(
    vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);
  gatun::FrameRequest GetRequest(
    vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);
  void ReportReason(vtkGatunVolumeMapper* mapper);
  gatun::RayStatistics Draw(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    const gatun::Viewport& viewport, const gatun::RayGrid& grid,
    const gatun::RaySource::Progress& progress, const gatun::Frame& frame);
  void DrawAnew(const gatun::ImageSetup& setup, std::shared_ptr<gatun::RaySource> source,
    const gatun::RayGrid& grid, const gatun::RaySource::Progress& progress);
  gatun::ImageSetup MakeSetup(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer,
    vtkVolume* volume, const gatun::RayView& view, const gatun::Range& values);
  void DrawFrame(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);
  static void RequireNumbers(vtkGatunVolumeMapper* mapper);

  // Images of several processes.
  void ReduceBounds(vtkGatunVolumeMapper* mapper, const std::array<double, 6>& own);
  gatun::PartFacts GetFacts(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer,
    vtkFloatArray* depths, const gatun::RaySource::Progress& progress);
  std::vector<gatun::PartFacts> GatherFacts(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer,
    vtkFloatArray* depths, gatun::ProcessExchange& exchange,
    const gatun::RaySource::Progress& progress);
  gatun::ParallelPlan MakePlan(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer,
    vtkVolume* volume, bool simplifies, gatun::Frame& frame,
    const gatun::RaySource::Progress& progress);
  std::shared_ptr<gatun::RaySource> FollowPlan(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer,
    vtkVolume* volume, const gatun::ParallelPlan& plan);
  void ShowParallel(vtkRenderer* renderer, vtkVolume* volume, const gatun::ParallelImage& image,
    vtkFloatArray* depths);
  void DrawParallel(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);
};

#endif
