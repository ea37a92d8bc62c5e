// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunPVProjection.h"

#include "vtkColorTransferFunction.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>

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
vtkGatunHartleyProjection::TransferFunction vtkGatunPVProjection::MakeTransferFunction(
  const double range[2], double diagonal)
{
  const bool isGiven = this->ValueRange[0] < this->ValueRange[1];
  const double low = isGiven ? this->ValueRange[0] : range[0];
  const double extent = isGiven ? this->ValueRange[1] - low
    : range[0] < range[1]       ? range[1] - range[0]
                                : 1;
  const auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (const Node& node : GetNodes(this->ColorMap))
  {
    colors->AddRGBPoint(low + node[0] * extent, node[1], node[2], node[3]);
  }
  const auto opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  for (const auto& point : this->OpacityPoints)
  {
    opacity->AddPoint(low + point[0] * extent, std::clamp(point[1], 0., 1.));
  }
  if (this->OpacityPoints.empty())
  {
    opacity->AddPoint(low, 0);
    opacity->AddPoint(low + extent, 1);
  }
  return { colors, opacity, this->OpacityUnit * diagonal / 100 };
}

//------------------------------------------------------------------------------
void vtkGatunPVProjection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ColorMap: " << this->ColorMap << "\n";
  os << indent << "ValueRange: " << this->ValueRange[0] << " " << this->ValueRange[1] << "\n";
  os << indent << "OpacityUnit: " << this->OpacityUnit << "\n";
  os << indent << "NumberOfOpacityPoints: " << this->OpacityPoints.size() << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
