// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunHartleyTransfer.h"

#include "gatunError.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gatun
{
namespace
{
constexpr std::size_t Entries = 4096;

//------------------------------------------------------------------------------
double GetRamp(double value, const Range& range)
{
  const double high = range.Min < range.Max ? range.Max : range.Min + 1;
  return std::clamp((value - range.Min) / (high - range.Min), 0., 1.);
}

//------------------------------------------------------------------------------
std::array<double, 3> GetColor(vtkVolumeProperty* property, double value, const Range& range)
{
  std::array<double, 3> color{};
  if (property && property->GetColorChannels() > 1)
  {
    property->GetRGBTransferFunction()->GetColor(value, color.data());
  }
  else
  {
    color.fill(
      property ? property->GetGrayTransferFunction()->GetValue(value) : GetRamp(value, range));
  }
  return color;
}
}

//------------------------------------------------------------------------------
void FillHartleyTable(vtkVolumeProperty* property, double defaultUnit, const Range& range,
  double sampleDistance, HartleyShading& shading)
{
  const double unit = property ? property->GetScalarOpacityUnitDistance() : defaultUnit;
  if (!(unit > 0) || !std::isfinite(unit))
  {
    ThrowInvalid("the unit distance of the opacity is not a positive number");
  }
  vtkPiecewiseFunction* const opacities = property ? property->GetScalarOpacity() : nullptr;
  // The table of a constant volume has a range, too.
  const double margin = range.Min < range.Max ? 0 : std::max(0.5, std::abs(range.Min) / 1000);
  shading.First = range.Min - margin;
  shading.Last = range.Max + margin;
  const double samples = sampleDistance / unit;
  shading.Table.resize(Entries);
  for (std::size_t i = 0; i < Entries; ++i)
  {
    const double part = static_cast<double>(i) / (Entries - 1);
    const double value = shading.First + part * (shading.Last - shading.First);
    const auto color = GetColor(property, value, range);
    const double opacity =
      std::clamp(opacities ? opacities->GetValue(value) : GetRamp(value, range), 0., 1.);
    shading.Table[i] = { static_cast<float>(color[0]), static_cast<float>(color[1]),
      static_cast<float>(color[2]), static_cast<float>(1 - std::pow(1 - opacity, samples)) };
  }
}
}
