// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyFrame.h"

#include "gatunError.h"
#include "gatunVector.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace gatun
{
namespace
{
using Vec = glm::dvec3;
using Mat = glm::dmat3;

// Axes count as dependent if their determinant is less than this part of the product of their
// lengths, and directions as collinear if their sine is less.
constexpr double LeastDeterminant = 1e-9;
constexpr double LeastSine = 1e-6;

//------------------------------------------------------------------------------
Mat ToMat(const std::array<std::array<double, 3>, 3>& columns)
{
  return { ToVector(columns[0]), ToVector(columns[1]), ToVector(columns[2]) };
}

//------------------------------------------------------------------------------
std::array<std::array<double, 3>, 3> ToArrays(const Mat& matrix)
{
  return { ToArray(matrix[0]), ToArray(matrix[1]), ToArray(matrix[2]) };
}

//------------------------------------------------------------------------------
bool IsFinite(const Vec& vector)
{
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}
}

//------------------------------------------------------------------------------
VolumePlace::VolumePlace(const VolumeInput& volume)
{
  Mat axes(1);
  double length = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto i = static_cast<std::size_t>(axis);
    const double spacing = volume.Spacing[i];
    if (!std::isfinite(spacing) || spacing == 0)
    {
      ThrowInvalid(
        "the spacing along " + std::string(1, "xyz"[i]) + " is " + std::to_string(spacing));
    }
    axes[axis] =
      Vec(volume.Direction[i], volume.Direction[3 + i], volume.Direction[6 + i]) * spacing;
    length *= glm::length(axes[axis]);
  }
  const double determinant = glm::determinant(axes);
  if (!std::isfinite(determinant) || !IsFinite(ToVector(volume.Origin)))
  {
    ThrowInvalid("origin, spacing and direction are not all finite numbers");
  }
  if (!(std::abs(determinant) > LeastDeterminant * length))
  {
    ThrowInvalid("the direction matrix is singular, so that the voxels span no space");
  }
  this->Axes = ToArrays(axes);
  this->Inverse = ToArrays(glm::inverse(axes));
  const Vec first(volume.FirstIndex[0], volume.FirstIndex[1], volume.FirstIndex[2]);
  const Vec middle = (Vec(volume.Size[0], volume.Size[1], volume.Size[2]) - 1.0) / 2.0;
  this->First = ToArray(ToVector(volume.Origin) + axes * first);
  this->Center = this->ToWorld(ToArray(middle));
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const Vec side((corner & 1u) ? 1 : -1, (corner & 2u) ? 1 : -1, (corner & 4u) ? 1 : -1);
    this->Radius = std::max(this->Radius, glm::length(axes * (side * middle)));
    this->Reach = std::max(this->Reach, glm::length(axes * (side * (middle + 1.0))));
  }
  this->VoxelEdge = std::cbrt(std::abs(determinant));
}

//------------------------------------------------------------------------------
VolumePlace::Vector VolumePlace::ToWorld(const Vector& index) const
{
  return ToArray(ToVector(this->First) + ToMat(this->Axes) * ToVector(index));
}

//------------------------------------------------------------------------------
VolumePlace::Vector VolumePlace::ToIndex(const Vector& world) const
{
  return ToArray(ToMat(this->Inverse) * (ToVector(world) - ToVector(this->First)));
}

//------------------------------------------------------------------------------
VolumePlace::Vector VolumePlace::ToIndexStep(const Vector& step) const
{
  return ToArray(ToMat(this->Inverse) * ToVector(step));
}

//------------------------------------------------------------------------------
double VolumePlace::GetDiagonal() const
{
  return std::max(2 * this->Radius, this->VoxelEdge);
}

//------------------------------------------------------------------------------
double GetFittingScale(const VolumePlace& place, double aspect)
{
  return place.GetReach() / std::min(1.0, aspect);
}

//------------------------------------------------------------------------------
HartleyFrame MakeHartleyFrame(const HartleyEye& eye, const std::array<int, 2>& size,
  const VolumePlace& place, double sampleDistance)
{
  const double lengths = glm::length(ToVector(eye.Direction)) * glm::length(ToVector(eye.Up));
  const Vec across = glm::cross(ToVector(eye.Direction), ToVector(eye.Up));
  if (!(lengths > 0) || !std::isfinite(lengths) || !(glm::length(across) > LeastSine * lengths))
  {
    ThrowInvalid("ViewDirection and ViewUp do not define a view: they are zero, not finite, or "
                 "collinear");
  }
  if (!(eye.ParallelScale > 0) || !std::isfinite(eye.ParallelScale) ||
    !IsFinite(ToVector(eye.Focus)))
  {
    ThrowInvalid("the parallel scale or the focal point is not a finite number");
  }
  const Vec forward = glm::normalize(ToVector(eye.Direction));
  const Vec right = glm::normalize(across);
  const Vec up = glm::cross(right, forward);

  HartleyFrame frame;
  frame.Spacing = 2 * eye.ParallelScale / size[1];
  frame.First = { (1 - size[0]) * frame.Spacing / 2, (1 - size[1]) * frame.Spacing / 2 };
  const Vec first = ToVector(eye.Focus) + right * frame.First[0] + up * frame.First[1];
  frame.View.Width = static_cast<unsigned>(size[0]);
  frame.View.Height = static_cast<unsigned>(size[1]);
  frame.View.Origin = place.ToIndex(ToArray(first));
  frame.View.ColumnStep = place.ToIndexStep(ToArray(right * frame.Spacing));
  frame.View.RowStep = place.ToIndexStep(ToArray(up * frame.Spacing));
  frame.View.Step = place.ToIndexStep(ToArray(forward * sampleDistance));
  return frame;
}
}
