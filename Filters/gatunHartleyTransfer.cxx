// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunHartleyTransfer.h"

#include "vtkPiecewiseFunction.h"
#include "vtkScalarsToColors.h"

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
std::array<double, 3> GetColor(vtkScalarsToColors* colors, double value, const Range& range)
{
  const double gray = colors ? 0 : GetRamp(value, range);
  std::array<double, 3> color{ gray, gray, gray };
  if (colors)
  {
    colors->GetColor(value, color.data());
  }
  return color;
}
}

//------------------------------------------------------------------------------
void FillHartleyTable(const TransferFunctions& functions, const Range& range, double sampleDistance,
  HartleyShading& shading)
{
  // The table of a constant volume has a range, too.
  const double margin = range.Min < range.Max ? 0 : std::max(0.5, std::abs(range.Min) / 1000);
  shading.First = range.Min - margin;
  shading.Last = range.Max + margin;
  if (functions.Colors)
  {
    functions.Colors->Build();
  }
  const double samples = sampleDistance / functions.UnitDistance;
  shading.Table.resize(Entries);
  for (std::size_t i = 0; i < Entries; ++i)
  {
    const double part = static_cast<double>(i) / (Entries - 1);
    const double value = shading.First + part * (shading.Last - shading.First);
    const auto color = GetColor(functions.Colors, value, range);
    const double opacity = std::clamp(
      functions.Opacity ? functions.Opacity->GetValue(value) : GetRamp(value, range), 0., 1.);
    shading.Table[i] = { static_cast<float>(color[0]), static_cast<float>(color[1]),
      static_cast<float>(color[2]), static_cast<float>(1 - std::pow(1 - opacity, samples)) };
  }
}
}
