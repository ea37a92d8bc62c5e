// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkGatunVolumeMapperInternals_h
#define vtkGatunVolumeMapperInternals_h

#include "gatunFramePlanner.h"
#include "gatunMapperInput.h"
#include "gatunOwned.h"
#include "gatunParallelFrame.h"
#include "gatunStatistics.h"
#include "gatunVolumeFrame.h"
#include "gatunVolumeImage.h"
#include "vtkGatunVolumeMapper.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

/** The input of a mapper, and its frames. Methods throw gatun::Error. */
class vtkGatunVolumeMapper::vtkInternals
{
public:
  gatun::Owned<vtkGatunDetailPolicy> Policy;
  gatun::Statistics Statistics;
  gatun::MapperInput Input;
  gatun::FramePlanner Planner;
  gatun::VolumeImage Image;
  std::set<std::string> Reported; // causes of failures that were reported since the last image
  std::uint64_t Points = 0;       // of the mesh in the last image; 0: all
  std::uint64_t BytesSent = 0;    // for the last image
  std::optional<std::array<double, 6>> WholeBounds; // of all processes

  static bool IsParallel(vtkGatunVolumeMapper* mapper);
  static gatun::MapperConnection GetConnection(vtkGatunVolumeMapper* mapper);
  static gatun::RayArray GetArray(vtkGatunVolumeMapper* mapper);
  static std::uint64_t GetBudget(vtkGatunVolumeMapper* mapper);
  gatun::VolumeSettings GetSettings(vtkGatunVolumeMapper* mapper) const;
  bool Simplifies(vtkGatunVolumeMapper* mapper);
  bool SetScene(vtkGatunVolumeMapper* mapper, const gatun::RaySource::Progress& progress);
  std::size_t GetMerges(vtkGatunVolumeMapper* mapper);
  void Draw(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

private:
  gatun::RayStatistics Cast(const gatun::VolumeFrame& frame, const gatun::FramePlan& plan,
    const gatun::RayGrid& grid, const gatun::RaySource::Progress& progress);
  void DrawAlone(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    const gatun::RaySource::Progress& progress);
  std::unique_ptr<gatun::VolumeFrame> MakePart(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer,
    vtkVolume* volume, const gatun::RaySource::Progress& progress, gatun::PartFacts& facts);
  void DrawTogether(vtkGatunVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    const gatun::RaySource::Progress& progress);
  void ReportReason(vtkGatunVolumeMapper* mapper);
  void Finish(vtkGatunVolumeMapper* mapper, const gatun::FramePlan& plan, float distance);
};

#endif
