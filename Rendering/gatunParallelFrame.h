// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunParallelFrame_h
#define gatunParallelFrame_h

#include "gatunFramePlanner.h"
#include "gatunProcessExchange.h"
#include "gatunVolumeFrame.h"

#include "vtkNew.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkFloatArray;
class vtkMultiProcessController;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
class ParallelImage;
class RayScene;
class VolumeImage;

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

/** The bounds of all parts that have any. */
std::array<double, 6> JoinBounds(const std::vector<std::array<double, 6>>& all);

/** One image of several processes. All methods but the getters are collective, in the order in
 * which they are declared. They throw gatun::Error in all processes if one of them fails. */
class ParallelFrame
{
public:
  using MakeFrame = std::function<std::unique_ptr<VolumeFrame>(PartFacts& facts)>;

  explicit ParallelFrame(vtkMultiProcessController* controller);
  ~ParallelFrame();

  /** Makes the frame of each process, with the facts of its mesh. Returns whether there is anything
   * to draw. */
  bool Gather(const MakeFrame& make);

  const VolumeFrame& GetFrame() const { return *this->Frame; }
  bool IsFirst() const { return this->Process == 0; }
  std::size_t GetProcesses() const { return this->Facts.size(); }

  /** Whether all processes have the same file. */
  bool HasOneFile() const;

  /** Takes the plan of the first process. Choose: is called in all. ImageProcess: see
   * vtkGatunVolumeMapper. */
  const ParallelPlan& Agree(const std::function<FramePlan()>& choose, int imageProcess);

  /** Casts rays through the part of this process, and shows its part of the image. Levels: of all
   * processes, if the mesh is simplified; null otherwise. */
  RayStatistics Draw(RayScene& scene, LevelOfDetailCache* levels,
    const RaySource::Progress& progress, VolumeImage& image);

  /** Seconds that the rays of this process took. */
  double GetCastSeconds() const { return this->CastSeconds; }

  /** Bytes that all processes have sent. */
  std::uint64_t GetBytesSent() const { return this->BytesSent; }

private:
  std::shared_ptr<RaySource> FollowPlan(LevelOfDetailCache& levels, const Range& values) const;
  std::shared_ptr<RaySource> Share(std::shared_ptr<RaySource> all) const;
  Range GetValues() const;
  float FindCenterDepth() const;
  void Show(const ParallelImage& merged, VolumeImage& image);

  ProcessExchange Exchange;
  const int Process;
  std::unique_ptr<VolumeFrame> Frame;
  std::vector<PartFacts> Facts; // of all processes
  vtkNew<vtkFloatArray> Depths; // of what was drawn before
  std::optional<ParallelPlan> Plan;
  std::shared_ptr<RaySource> Level; // that this process has chosen; null: the mesh
  double CastSeconds = 0;
  std::uint64_t BytesSent = 0;
};
}

#endif
