// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunHartleyView.h"

#include "gatunRayRendering.h"
#include "vtkGatunHartleyProjection.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunHartleyView);

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

//------------------------------------------------------------------------------
// A vtkPiecewiseFunction of gray levels as colors.
vtkNew<vtkColorTransferFunction> MakeColors(vtkPiecewiseFunction* gray)
{
  vtkNew<vtkColorTransferFunction> colors;
  for (int i = 0; i < gray->GetSize(); ++i)
  {
    std::array<double, 4> node{}; // value, level, midpoint, sharpness
    gray->GetNodeValue(i, node.data());
    colors->AddRGBPoint(node[0], node[1], node[1], node[1], node[2], node[3]);
  }
  colors->SetClamping(gray->GetClamping());
  return colors;
}
}

//------------------------------------------------------------------------------
bool vtkGatunHartleyView::SetView(vtkGatunHartleyProjection* projection, vtkCamera* camera)
{
  if (!projection || !camera)
  {
    return false;
  }
  if (!camera->GetParallelProjection())
  {
    vtkErrorWithObjectMacro(projection,
      "The camera has a perspective projection, to which the projection-slice theorem does not "
      "apply. Call ParallelProjectionOn.");
    return false;
  }
  const int* const size = projection->GetSize();
  const gatun::RayEye eye = gatun::MakeRayEye(camera, { size[0], size[1] }, nullptr);
  const gatun::RayFrustum& frustum = eye.Frustum;
  vtkNew<vtkMatrix4x4> toWorld;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      toWorld->SetElement(
        i, j, eye.FromWorld[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
    }
  }
  toWorld->Invert();
  const Vector right = GetColumn(toWorld, 0);
  const Vector up = GetColumn(toWorld, 1);
  const Vector back = GetColumn(toWorld, 2);
  const double height = (frustum.Top - frustum.Bottom) * vtkMath::Norm(up.data());
  const double width = (frustum.Right - frustum.Left) * vtkMath::Norm(right.data());
  if (!AreOrthogonal(right, up) || !AreOrthogonal(up, back) || !AreOrthogonal(back, right) ||
    !AreSimilar(width * size[1], height * size[0]))
  {
    vtkErrorWithObjectMacro(
      projection, "The camera is sheared or scales the image unevenly, which is not supported.");
    return false;
  }
  Vector focus = GetColumn(toWorld, 3);
  for (std::size_t i = 0; i < 3; ++i)
  {
    focus[i] += (frustum.Left + frustum.Right) / 2 * right[i] +
      (frustum.Bottom + frustum.Top) / 2 * up[i] - camera->GetDistance() * back[i];
  }
  projection->SetViewDirection(-back[0], -back[1], -back[2]);
  projection->SetViewUp(up[0], up[1], up[2]);
  projection->SetFocalPoint(focus[0], focus[1], focus[2]);
  projection->UseFocalPointOn();
  projection->SetParallelScale(height / 2);
  projection->SetZoom(1);
  return true;
}

//------------------------------------------------------------------------------
void vtkGatunHartleyView::SetProperty(
  vtkGatunHartleyProjection* projection, vtkVolumeProperty* property)
{
  if (!projection)
  {
    return;
  }
  if (!property)
  {
    projection->SetColorTransferFunction(nullptr);
    projection->SetScalarOpacity(nullptr);
    projection->SetScalarOpacityUnitDistance(0);
    return;
  }
  if (property->GetColorChannels() == 1)
  {
    projection->SetColorTransferFunction(MakeColors(property->GetGrayTransferFunction()));
  }
  else
  {
    projection->SetColorTransferFunction(property->GetRGBTransferFunction());
  }
  projection->SetScalarOpacity(property->GetScalarOpacity());
  projection->SetScalarOpacityUnitDistance(property->GetScalarOpacityUnitDistance());
}

//------------------------------------------------------------------------------
bool vtkGatunHartleyView::ResetCamera(vtkGatunHartleyProjection* projection, vtkCamera* camera)
{
  if (!projection || !camera || projection->GetNumberOfInputConnections(0) < 1)
  {
    return false;
  }
  projection->UpdateInformation();
  const double scale = projection->GetFittingParallelScale();
  if (!(scale > 0))
  {
    return false;
  }
  const double* const center = projection->GetVolumeCenter();
  const double* const direction = camera->GetDirectionOfProjection();
  const double distance = 2 * scale;
  camera->SetPosition(center[0] - distance * direction[0], center[1] - distance * direction[1],
    center[2] - distance * direction[2]);
  camera->SetFocalPoint(center[0], center[1], center[2]);
  camera->SetParallelScale(scale);
  camera->SetClippingRange(scale, 3 * scale);
  camera->ParallelProjectionOn();
  return true;
}

//------------------------------------------------------------------------------
void vtkGatunHartleyView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
