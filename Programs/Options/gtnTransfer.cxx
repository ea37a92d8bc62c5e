// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnTransfer.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace gtn
{
//------------------------------------------------------------------------------
bool IsNormalized(const Transfer& transfer)
{
  return transfer.Colors.front().Value == 0 && transfer.Colors.back().Value == 1;
}

//------------------------------------------------------------------------------
void Stretch(Transfer& transfer, const gatun::Range& range)
{
  const double first = transfer.Colors.front().Value;
  const double extent = transfer.Colors.back().Value - first;
  const auto move = [&](double& value)
  {
    // Exact at both ends, and without overflow where the range is as wide as numbers go.
    const double t = (value - first) / extent;
    value = range.Min * (1 - t) + range.Max * t;
  };
  for (ColorNode& node : transfer.Colors)
  {
    move(node.Value);
  }
  for (OpacityNode& node : transfer.Opacities)
  {
    move(node.Value);
  }
}

//------------------------------------------------------------------------------
void ScaleOpacity(Transfer& transfer, double factor)
{
  for (OpacityNode& node : transfer.Opacities)
  {
    node.Opacity = std::min(node.Opacity * factor, 1.0);
  }
}

//------------------------------------------------------------------------------
void ScaleOpacity(vtkPiecewiseFunction* opacity, double factor)
{
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    double node[4]; // value, opacity, midpoint, sharpness
    opacity->GetNodeValue(i, node);
    node[1] = std::min(node[1] * factor, 1.0);
    opacity->SetNodeValue(i, node);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolumeProperty> MakeProperty(const Transfer& transfer, double unitDistance)
{
  vtkNew<vtkColorTransferFunction> colors;
  colors->SetAllowDuplicateScalars(1);
  switch (transfer.Space)
  {
    case ColorSpace::RGB:
      colors->SetColorSpaceToRGB();
      break;
    case ColorSpace::HSV:
      colors->SetColorSpaceToHSV();
      break;
    case ColorSpace::Lab:
      colors->SetColorSpaceToLab();
      break;
    case ColorSpace::LabCIEDE2000:
      colors->SetColorSpaceToLabCIEDE2000();
      break;
    case ColorSpace::Diverging:
      colors->SetColorSpaceToDiverging();
      break;
    case ColorSpace::Step:
      colors->SetColorSpaceToStep();
      break;
  }
  for (const ColorNode& node : transfer.Colors)
  {
    colors->AddRGBPoint(node.Value, node.Red, node.Green, node.Blue);
  }
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AllowDuplicateScalarsOn();
  for (const OpacityNode& node : transfer.Opacities)
  {
    opacity->AddPoint(node.Value, node.Opacity, node.Midpoint, node.Sharpness);
  }
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(colors);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(unitDistance);
  return property;
}
}
