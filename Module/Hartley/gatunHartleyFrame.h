// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyFrame_h
#define gatunHartleyFrame_h

// Between world coordinates and the index coordinates of a volume.

#include "gatunExport.h"
#include "gatunHartleyInput.h"
#include "gatunHartleyView.h"

#include <array>

namespace gatun
{
/** The position of a volume in the world. */
class GATUN_EXPORT VolumePlace
{
public:
  using Vector = std::array<double, 3>;

  /** Throws Error(InvalidInput) if origin, spacing or direction are not finite, or if the axes of
   * the volume are linearly dependent. */
  explicit VolumePlace(const VolumeInput& volume);

  /** Points. Index (0, 0, 0) is the first voxel. */
  Vector ToWorld(const Vector& index) const;
  Vector ToIndex(const Vector& world) const;

  /** Directions. */
  Vector ToIndexStep(const Vector& step) const;

  const Vector& GetCenter() const { return this->Center; }

  /** Largest distance of a voxel from the center. */
  double GetRadius() const { return this->Radius; }

  /** The same for the drawn volume, which falls to zero one voxel beyond the outermost voxels. */
  double GetReach() const { return this->Reach; }

  /** Edge of a cube of the same volume as a voxel's cell. */
  double GetVoxelEdge() const { return this->VoxelEdge; }

  /** Diameter of the volume; of a single voxel, VoxelEdge. Above 0. */
  double GetDiagonal() const;

private:
  std::array<Vector, 3> Axes{};    ///< from one voxel to the next along x, y and z
  std::array<Vector, 3> Inverse{}; ///< columns
  Vector First{};                  ///< of the first voxel
  Vector Center{};
  double Radius = 0;
  double Reach = 0;
  double VoxelEdge = 1;
};

/** A parallel projection in world coordinates. */
struct HartleyEye
{
  std::array<double, 3> Direction{ 0, 0, -1 }; ///< of the rays; any length above 0
  std::array<double, 3> Up{ 0, 1, 0 };         ///< not along Direction
  std::array<double, 3> Focus{};               ///< in the middle of the image
  double ParallelScale = 1;                    ///< half the height of the image
};

/** The ParallelScale that shows all of a volume. Aspect: width by height of the image. */
GATUN_EXPORT double GetFittingScale(const VolumePlace& place, double aspect);

/** The rays of an image. First and Spacing locate its pixels relative to Focus, in world units. */
struct HartleyFrame
{
  HartleyView View;
  std::array<double, 2> First{}; ///< the middle of pixel (0, 0), at the lower left
  double Spacing = 1;            ///< of pixels, which are square
};

/** SampleDistance: in world units. Throws Error(InvalidInput) if Direction and Up are zero, not
 * finite or collinear, or if a number is not finite. */
GATUN_EXPORT HartleyFrame MakeHartleyFrame(const HartleyEye& eye, const std::array<int, 2>& size,
  const VolumePlace& place, double sampleDistance);
}

#endif
