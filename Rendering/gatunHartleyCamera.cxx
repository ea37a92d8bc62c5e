// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunHartleyCamera.h"

#include "gatunError.h"
#include "gatunRayRendering.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gatun
{
namespace
{
using Vector = std::array<double, 3>;

// Relative tolerance of angles and lengths.
constexpr double Tolerance = 1e-6;

//------------------------------------------------------------------------------
// Column of the matrix from eye coordinates to those of the world.
Vector GetColumn(vtkMatrix4x4* toWorld, int column)
{
  return { toWorld->GetElement(0, column), toWorld->GetElement(1, column),
    toWorld->GetElement(2, column) };
}

//------------------------------------------------------------------------------
bool AreOrthogonal(const Vector& a, const Vector& b)
{
  return std::abs(vtkMath::Dot(a.data(), b.data())) <=
    Tolerance * vtkMath::Norm(a.data()) * vtkMath::Norm(b.data());
}

//------------------------------------------------------------------------------
bool AreSimilar(double a, double b)
{
  return std::abs(a - b) <= Tolerance * std::max(std::abs(a), std::abs(b));
}

}

//------------------------------------------------------------------------------
HartleyEye MakeHartleyEye(vtkCamera* camera, int widthOfImage, int heightOfImage)
{
  if (!camera->GetParallelProjection())
  {
    ThrowInvalid("the camera has a perspective projection, to which the projection-slice theorem "
                 "does not apply. Call ParallelProjectionOn");
  }
  const RayEye eye = MakeRayEye(camera, { widthOfImage, heightOfImage }, nullptr);
  const RayFrustum& frustum = eye.Frustum;
  vtkNew<vtkMatrix4x4> toWorld;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      toWorld->SetElement(
        i, j, eye.FromWorld[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
    }
  }
  const double determinant = toWorld->Determinant();
  if (!(determinant != 0) || !std::isfinite(determinant))
  {
    ThrowInvalid("the directions of the camera do not define a view");
  }
  toWorld->Invert();
  const Vector right = GetColumn(toWorld, 0);
  const Vector up = GetColumn(toWorld, 1);
  const Vector back = GetColumn(toWorld, 2);
  const double height = (frustum.Top - frustum.Bottom) * vtkMath::Norm(up.data());
  const double width = (frustum.Right - frustum.Left) * vtkMath::Norm(right.data());
  if (!AreOrthogonal(right, up) || !AreOrthogonal(up, back) || !AreOrthogonal(back, right) ||
    !AreSimilar(width * heightOfImage, height * widthOfImage))
  {
    ThrowInvalid("the camera is sheared or scales the image unevenly, which is not supported");
  }
  HartleyEye view;
  view.Focus = GetColumn(toWorld, 3);
  for (std::size_t i = 0; i < 3; ++i)
  {
    view.Direction[i] = -back[i];
    view.Focus[i] += (frustum.Left + frustum.Right) / 2 * right[i] +
      (frustum.Bottom + frustum.Top) / 2 * up[i] - camera->GetDistance() * back[i];
  }
  view.Up = up;
  view.ParallelScale = height / 2;
  return view;
}
}
