// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunPVProjection.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <limits>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunPVProjection);

namespace
{
using Node = std::array<double, 4>; // position, red, green, blue

//------------------------------------------------------------------------------
std::vector<Node> GetNodes(int map)
{
  switch (map)
  {
    case vtkGatunPVProjection::MAP_BONE:
      return { { 0, 0.35, 0.10, 0.05 }, { 0.35, 0.80, 0.42, 0.30 }, { 0.55, 0.95, 0.80, 0.62 },
        { 1, 1.00, 0.99, 0.95 } };
    case vtkGatunPVProjection::MAP_HEAT:
      return { { 0, 0.10, 0.00, 0.02 }, { 0.35, 0.70, 0.06, 0.02 }, { 0.7, 1.00, 0.55, 0.05 },
        { 1, 1.00, 0.98, 0.80 } };
    case vtkGatunPVProjection::MAP_COOL_WARM:
      return { { 0, 0.20, 0.28, 0.78 }, { 0.5, 0.88, 0.87, 0.86 }, { 1, 0.74, 0.04, 0.14 } };
    default:
      return { { 0, 0, 0, 0 }, { 1, 1, 1, 1 } };
  }
}
}

//------------------------------------------------------------------------------
vtkGatunPVProjection::vtkGatunPVProjection() = default;

vtkGatunPVProjection::~vtkGatunPVProjection() = default;

//------------------------------------------------------------------------------
void vtkGatunPVProjection::SetUseZero(bool on)
{
  this->UseZero = on;
  this->UpdateZero();
}

//------------------------------------------------------------------------------
void vtkGatunPVProjection::SetZeroValue(double value)
{
  this->ZeroValue = value;
  this->UpdateZero();
}

//------------------------------------------------------------------------------
void vtkGatunPVProjection::UpdateZero()
{
  this->SetZero(this->UseZero ? this->ZeroValue : std::numeric_limits<double>::quiet_NaN());
}

//------------------------------------------------------------------------------
void vtkGatunPVProjection::SetUseBackground(bool on)
{
  this->UseBackground = on;
  this->UpdateBackground();
}

//------------------------------------------------------------------------------
void vtkGatunPVProjection::SetBackgroundColor(double red, double green, double blue)
{
  this->BackgroundColor[0] = std::clamp(red, 0., 1.);
  this->BackgroundColor[1] = std::clamp(green, 0., 1.);
  this->BackgroundColor[2] = std::clamp(blue, 0., 1.);
  this->UpdateBackground();
}

//------------------------------------------------------------------------------
void vtkGatunPVProjection::UpdateBackground()
{
  if (this->UseBackground)
  {
    this->SetBackground(this->BackgroundColor);
  }
  else
  {
    this->SetBackground(-1, -1, -1);
  }
}

//------------------------------------------------------------------------------
void vtkGatunPVProjection::SetNumberOfOpacityPoints(int number)
{
  const auto points = static_cast<std::size_t>(std::max(0, number));
  if (points != this->OpacityPoints.size())
  {
    this->OpacityPoints.resize(points);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkGatunPVProjection::GetNumberOfOpacityPoints()
{
  return static_cast<int>(this->OpacityPoints.size());
}

//------------------------------------------------------------------------------
void vtkGatunPVProjection::SetOpacityPoint(int index, double position, double opacity)
{
  if (index < 0)
  {
    return;
  }
  const auto place = static_cast<std::size_t>(index);
  if (place >= this->OpacityPoints.size())
  {
    this->OpacityPoints.resize(place + 1);
  }
  const std::array<double, 2> point{ position, opacity };
  if (this->OpacityPoints[place] != point)
  {
    this->OpacityPoints[place] = point;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkInformation* vtkGatunPVProjection::GetCoefficientsInformation()
{
  // ParaView puts this filter behind every source. It does not change images.
  vtkAlgorithm* const input = this->GetInputAlgorithm(0, 0);
  return input && input->IsA("vtkPVPostFilter") && input->GetNumberOfInputConnections(0) == 1
    ? input->GetInputInformation(0, 0)
    : this->Superclass::GetCoefficientsInformation();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCamera> vtkGatunPVProjection::MakeCamera(
  const double center[3], double parallelScale)
{
  const double* const direction = this->ViewDirection;
  // The superclass reports directions that do not define a view.
  const double distance = 2 * parallelScale / vtkMath::Norm(direction);
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] - distance * direction[0], center[1] - distance * direction[1],
    center[2] - distance * direction[2]);
  camera->SetViewUp(this->ViewUp);
  camera->SetParallelScale(parallelScale / this->Zoom);
  camera->ParallelProjectionOn();
  return camera;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolumeProperty> vtkGatunPVProjection::MakeProperty(
  const double range[2], double diagonal)
{
  const bool isGiven = this->ValueRange[0] < this->ValueRange[1];
  const double low = isGiven ? this->ValueRange[0] : range[0];
  const double extent = isGiven ? this->ValueRange[1] - low
    : range[0] < range[1]       ? range[1] - range[0]
                                : 1;
  vtkNew<vtkColorTransferFunction> colors;
  for (const Node& node : GetNodes(this->ColorMap))
  {
    colors->AddRGBPoint(low + node[0] * extent, node[1], node[2], node[3]);
  }
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& point : this->OpacityPoints)
  {
    opacity->AddPoint(low + point[0] * extent, std::clamp(point[1], 0., 1.));
  }
  if (this->OpacityPoints.empty())
  {
    opacity->AddPoint(low, 0);
    opacity->AddPoint(low + extent, 1);
  }
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(colors);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(this->OpacityUnit * diagonal / 100);
  return property;
}

//------------------------------------------------------------------------------
void vtkGatunPVProjection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ViewDirection: " << this->ViewDirection[0] << " " << this->ViewDirection[1]
     << " " << this->ViewDirection[2] << "\n";
  os << indent << "ViewUp: " << this->ViewUp[0] << " " << this->ViewUp[1] << " " << this->ViewUp[2]
     << "\n";
  os << indent << "Zoom: " << this->Zoom << "\n";
  os << indent << "UseZero: " << (this->UseZero ? "On" : "Off") << "\n";
  os << indent << "ZeroValue: " << this->ZeroValue << "\n";
  os << indent << "UseBackground: " << (this->UseBackground ? "On" : "Off") << "\n";
  os << indent << "BackgroundColor: " << this->BackgroundColor[0] << " " << this->BackgroundColor[1]
     << " " << this->BackgroundColor[2] << "\n";
  os << indent << "ColorMap: " << this->ColorMap << "\n";
  os << indent << "ValueRange: " << this->ValueRange[0] << " " << this->ValueRange[1] << "\n";
  os << indent << "OpacityUnit: " << this->OpacityUnit << "\n";
  os << indent << "NumberOfOpacityPoints: " << this->OpacityPoints.size() << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
