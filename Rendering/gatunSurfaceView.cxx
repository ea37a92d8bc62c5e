// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceView.h"

#include "gatunCellArrays.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gatun
{
namespace
{
// Radians; more than the rounding of coordinates in single precision makes.
constexpr double ConeMargin = 0.01;

using Vector = std::array<double, 3>;

//------------------------------------------------------------------------------
/** The normals of triangles with length 1, or 0 where there is none. Empty if one is not finite. */
template <typename CoordinateT, typename IdT>
std::vector<Vector> FindNormals(
  const CoordinateT* points, const IdT* corners, std::size_t triangles)
{
  std::vector<Vector> normals(triangles);
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const std::array<const CoordinateT*, 3> at{ points + 3 * corners[3 * i],
      points + 3 * corners[3 * i + 1], points + 3 * corners[3 * i + 2] };
    Vector one{};
    Vector other{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      one[axis] = static_cast<double>(at[1][axis]) - static_cast<double>(at[0][axis]);
      other[axis] = static_cast<double>(at[2][axis]) - static_cast<double>(at[0][axis]);
    }
    vtkMath::Cross(one.data(), other.data(), normals[i].data());
    if (!std::isfinite(vtkMath::Normalize(normals[i].data())))
    {
      return {};
    }
  }
  return normals;
}

//------------------------------------------------------------------------------
template <typename IdT>
std::vector<Vector> FindNormals(vtkPoints* points, const IdT* corners, std::size_t triangles)
{
  const void* const places = points->GetData()->GetVoidPointer(0);
  return points->GetDataType() == VTK_DOUBLE
    ? FindNormals(static_cast<const double*>(places), corners, triangles)
    : FindNormals(static_cast<const float*>(places), corners, triangles);
}

//------------------------------------------------------------------------------
Vector TransformPoint(vtkMatrix4x4* matrix, const Vector& point, double w)
{
  const double in[4] = { point[0], point[1], point[2], w };
  double out[4];
  matrix->MultiplyPoint(in, out);
  return { out[0], out[1], out[2] };
}

//------------------------------------------------------------------------------
Vector MiddleOf(const Bounds& box)
{
  Vector middle{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    middle[axis] = 0.5 * box[axis].Min + 0.5 * box[axis].Max;
  }
  return middle;
}

//------------------------------------------------------------------------------
double RadiusOf(const Bounds& box)
{
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double half = 0.5 * box[axis].Max - 0.5 * box[axis].Min;
    sum += half * half;
  }
  return std::sqrt(sum);
}

//------------------------------------------------------------------------------
/** Whether a matrix takes parallel lines to parallel lines. */
bool IsAffine(vtkMatrix4x4* matrix)
{
  return matrix->GetElement(3, 0) == 0 && matrix->GetElement(3, 1) == 0 &&
    matrix->GetElement(3, 2) == 0 && matrix->GetElement(3, 3) > 0;
}
}

//------------------------------------------------------------------------------
NormalCone FindNormalCone(vtkPolyData* part)
{
  vtkCellArray* const polygons = part->GetPolys();
  const vtkIdType count = polygons->GetNumberOfCells();
  if (count == 0 || count != part->GetNumberOfCells() ||
    polygons->GetNumberOfConnectivityIds() != 3 * count || polygons->GetMaxCellSize() != 3)
  {
    return {};
  }
  const int type = part->GetPoints()->GetDataType();
  if (type != VTK_FLOAT && type != VTK_DOUBLE)
  {
    return {};
  }
  const auto triangles = static_cast<std::size_t>(count);
  const auto ids = GetPointIds(polygons);
  const std::vector<Vector> normals = HasWideIds(polygons)
    ? FindNormals(part->GetPoints(), GetIntegers<vtkTypeInt64>(ids.Get()), triangles)
    : FindNormals(part->GetPoints(), GetIntegers<vtkTypeInt32>(ids.Get()), triangles);
  if (normals.empty())
  {
    return {};
  }
  NormalCone cone;
  for (const Vector& normal : normals)
  {
    vtkMath::Add(cone.Axis.data(), normal.data(), cone.Axis.data());
  }
  vtkMath::Normalize(cone.Axis.data());
  double least = 1;
  for (const Vector& normal : normals)
  {
    if (normal != Vector{})
    {
      least = std::min(least, vtkMath::Dot(normal.data(), cone.Axis.data()));
    }
  }
  cone.Angle = std::acos(std::clamp(least, -1.0, 1.0)) + ConeMargin;
  cone.Known = cone.Axis != Vector{} && cone.Angle < vtkMath::Pi() / 2;
  return cone;
}

//------------------------------------------------------------------------------
SurfaceView::SurfaceView(vtkRenderer* renderer, vtkActor* actor)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> toWorld;
  actor->GetMatrix(toWorld);
  vtkNew<vtkMatrix4x4> toClip;
  vtkMatrix4x4::Multiply4x4(
    camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1), toWorld,
    toClip);
  std::copy_n(toClip->GetData(), this->ToClip.size(), this->ToClip.begin());

  vtkProperty* const property = actor->GetProperty();
  const double width = 2 + std::max(property->GetLineWidth(), property->GetPointSize());
  const int* const size = renderer->GetSize();
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    this->Margin[axis] = 2 * width / std::max(1, size[axis]);
  }

  vtkNew<vtkMatrix4x4> toData;
  vtkMatrix4x4::Invert(toWorld, toData);
  Vector eye{};
  Vector direction{};
  camera->GetPosition(eye.data());
  camera->GetDirectionOfProjection(direction.data());
  this->Eye = TransformPoint(toData, eye, 1);
  this->Direction = TransformPoint(toData, direction, 0);
  vtkMath::Normalize(this->Direction.data());
  this->IsParallel = camera->GetParallelProjection() != 0;
  const bool culls =
    (property->GetBackfaceCulling() != 0) != (property->GetFrontfaceCulling() != 0);
  const double volume = toWorld->Determinant();
  // Edges, points and lines are drawn on both sides.
  if (culls && property->GetRepresentation() == VTK_SURFACE && !property->GetVertexVisibility() &&
    IsAffine(toWorld) && volume != 0 && !camera->GetUseOffAxisProjection())
  {
    this->Side = (property->GetBackfaceCulling() != 0) == (volume > 0) ? 1 : -1;
  }
}

//------------------------------------------------------------------------------
bool SurfaceView::Reaches(const Bounds& box) const
{
  if (box.IsEmpty())
  {
    return false;
  }
  // For each plane of the frustum, whether all corners are beyond it.
  std::array<bool, 6> beyond{};
  beyond.fill(true);
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    Vector point{};
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      point[axis] = (corner >> axis & 1u) == 0 ? box[axis].Min : box[axis].Max;
    }
    std::array<double, 4> clip{};
    for (std::size_t row = 0; row < 4; ++row)
    {
      const double* const m = this->ToClip.data() + 4 * row;
      clip[row] = m[0] * point[0] + m[1] * point[1] + m[2] * point[2] + m[3];
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double reach = clip[3] * (1 + (axis < 2 ? this->Margin[axis] : 1e-3));
      beyond[2 * axis] = beyond[2 * axis] && clip[axis] < -reach;
      beyond[2 * axis + 1] = beyond[2 * axis + 1] && clip[axis] > reach;
    }
  }
  return std::none_of(beyond.begin(), beyond.end(), [](bool is) { return is; });
}

//------------------------------------------------------------------------------
bool SurfaceView::Culls(const Bounds& box, const NormalCone& cone) const
{
  if (!cone.Known || this->Side == 0 || box.IsEmpty())
  {
    return false;
  }
  Vector away = this->Direction;
  double radius = 0;
  if (!this->IsParallel)
  {
    const Vector middle = MiddleOf(box);
    vtkMath::Subtract(middle.data(), this->Eye.data(), away.data());
    radius = RadiusOf(box);
  }
  const double distance = vtkMath::Norm(away.data());
  const double cosine =
    this->Side * vtkMath::Dot(away.data(), cone.Axis.data()) / std::max(distance, 1e-300);
  // The least angle at which the normals point away from the eye.
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) + cone.Angle;
  return angle < vtkMath::Pi() / 2 && distance * std::cos(angle) > radius;
}

//------------------------------------------------------------------------------
double SurfaceView::GetDepth(const Bounds& box) const
{
  const Vector middle = MiddleOf(box);
  // In perspective the fourth coordinate is the distance, in parallel projections the third one.
  const double* const m = this->ToClip.data() + (this->IsParallel ? 8 : 12);
  return m[0] * middle[0] + m[1] * middle[1] + m[2] * middle[2] + m[3];
}
}
