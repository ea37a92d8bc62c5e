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
  return transfer.Colours.front().Value == 0 && transfer.Colours.back().Value == 1;
}

//------------------------------------------------------------------------------
void Stretch(Transfer& transfer, const gatun::Range& range)
{
  const double first = transfer.Colours.front().Value;
  const double extent = transfer.Colours.back().Value - first;
  const auto move = [&](double& value)
  {
    // Exact at both ends, and without overflow where the range is as wide as numbers go.
    const double t = (value - first) / extent;
    value = range.Min * (1 - t) + range.Max * t;
  };
  for (ColourNode& node : transfer.Colours)
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
vtkSmartPointer<vtkVolumeProperty> MakeProperty(const Transfer& transfer, double unitDistance)
{
  vtkNew<vtkColorTransferFunction> colours;
  colours->SetAllowDuplicateScalars(1);
  switch (transfer.Space)
  {
    case ColourSpace::RGB:
      colours->SetColorSpaceToRGB();
      break;
    case ColourSpace::HSV:
      colours->SetColorSpaceToHSV();
      break;
    case ColourSpace::Lab:
      colours->SetColorSpaceToLab();
      break;
    case ColourSpace::LabCIEDE2000:
      colours->SetColorSpaceToLabCIEDE2000();
      break;
    case ColourSpace::Diverging:
      colours->SetColorSpaceToDiverging();
      break;
    case ColourSpace::Step:
      colours->SetColorSpaceToStep();
      break;
  }
  for (const ColourNode& node : transfer.Colours)
  {
    colours->AddRGBPoint(node.Value, node.Red, node.Green, node.Blue);
  }
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AllowDuplicateScalarsOn();
  for (const OpacityNode& node : transfer.Opacities)
  {
    opacity->AddPoint(node.Value, node.Opacity, node.Midpoint, node.Sharpness);
  }
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(colours);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(unitDistance);
  return property;
}
}
