// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunHartleyCamera_h
#define gatunHartleyCamera_h

// VTK's cameras and properties as the projector of Hartley volumes wants them.

#include "gatunHartleyProjector.h"
#include "gatunHartleyVolume.h"

#include "vtkType.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <array>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkCamera;
class vtkVolumeProperty;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** Where the voxels of a volume are in the world, and back. */
class VolumePlace
{
public:
  using Vector = std::array<double, 3>;

  /** Throws gatun::Error (InvalidInput) if the voxels do not span space. */
  explicit VolumePlace(const VolumeInput& volume);

  /** Of a voxel, (0, 0, 0) being the first one. */
  Vector ToWorld(const Vector& index) const;

  Vector ToIndex(const Vector& world) const;

  /** The same for directions. */
  Vector ToIndexStep(const Vector& step) const;

  /** The middle of the volume, and how far voxels are from it at most; reach: how far what is
   * drawn, which fades away within a voxel beyond. */
  const Vector& GetCentre() const { return this->Centre; }
  double GetRadius() const { return this->Radius; }
  double GetReach() const { return this->Reach; }

  /** The edge of a cube that is as large as what one voxel takes. */
  double GetVoxelEdge() const { return this->VoxelEdge; }

private:
  std::array<Vector, 3> Axes{}; ///< the way from a voxel to the next one along x, y and z
  std::array<Vector, 3> Inverse{};
  Vector First{}; ///< where the first voxel is
  Vector Centre{};
  double Radius = 0;
  double Reach = 0;
  double VoxelEdge = 1;
};

/** Moves a camera, without turning it, so that all of a volume is in its picture; its projection
 * becomes parallel. */
void ShowVolume(vtkCamera* camera, const VolumePlace& place, double aspect);

/** The rays of a picture, and where its pixels are in world units, (0, 0) being where the camera
 * looks. */
struct HartleyFrame
{
  HartleyView View;
  std::array<double, 2> First{};   ///< the middle of pixel (0, 0)
  std::array<double, 2> Spacing{}; ///< of pixels
};

/** Throws gatun::Error (InvalidInput) if the camera's rays are not parallel. SampleDistance: in
 * world units. */
HartleyFrame MakeHartleyFrame(vtkCamera* camera, const std::array<int, 2>& size,
  const VolumePlace& place, double sampleDistance);

/** Fills a table with a property's colours and opacities for values in a range. */
void FillHartleyTable(
  vtkVolumeProperty* property, const Range& range, double sampleDistance, HartleyShading& shading);
}

#endif
