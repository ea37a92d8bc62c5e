// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyLookup.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gatun
{
namespace
{
// Upper bound of the opacity of a sample: an opacity of 1 has no finite optical depth.
constexpr double MostOpacity = 1 - 1e-7;

bool IsGray(const HartleyShading& shading)
{
  return std::all_of(shading.Table.begin(), shading.Table.end(),
    [](const auto& entry) { return entry[0] == entry[1] && entry[1] == entry[2]; });
}
}

//------------------------------------------------------------------------------
HartleyLookup::HartleyLookup(const HartleyShading& shading, double base, const Range& range)
{
  auto& opacities = this->Opacity;
  opacities.Model = shading.OpacityModel;
  if (opacities.Model == HartleyOpacityModel::XRay)
  {
    return;
  }
  opacities.Planes = IsGray(shading) ? 2 : 4;
  opacities.Base = static_cast<float>(base);
  opacities.Least = static_cast<float>(range.Min);
  opacities.Most = static_cast<float>(range.Max);
  opacities.First = static_cast<float>(shading.First);
  const double width = shading.Last - shading.First;
  opacities.PerDensity =
    width > 0 ? static_cast<float>((HartleyOpacity::TableSize - 1) / width) : 0.0f;
  opacities.Extinction = static_cast<float>(shading.Extinction);
  opacities.Zero = static_cast<float>(base - shading.Zero);
  this->MakeTable(shading);
  if (opacities.Model == HartleyOpacityModel::Exponential)
  {
    this->BaseClear = shading.Extinction * (base - shading.Zero) <= 0;
    return;
  }
  const float at = (opacities.Base - opacities.First) * opacities.PerDensity + 0.5f;
  const auto entry = static_cast<std::size_t>(
    std::clamp(at, 0.0f, static_cast<float>(HartleyOpacity::TableSize - 1)));
  this->BaseClear =
    opacities.Table[(opacities.Planes - 1) * HartleyOpacity::TableSize + entry] <= 0;
}

//------------------------------------------------------------------------------
void HartleyLookup::MakeTable(const HartleyShading& shading)
{
  constexpr std::size_t size = HartleyOpacity::TableSize;
  const std::size_t colors = this->Opacity.Planes - 1;
  this->Table.resize(this->Opacity.Planes * size);
  for (std::size_t i = 0; i < size; ++i)
  {
    const double at =
      static_cast<double>(i) / (size - 1) * static_cast<double>(shading.Table.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), shading.Table.size() - 2);
    const auto part = static_cast<float>(at - static_cast<double>(below));
    const auto mix = [&](std::size_t channel) {
      return (1 - part) * shading.Table[below][channel] + part * shading.Table[below + 1][channel];
    };
    for (std::size_t color = 0; color < colors; ++color)
    {
      this->Table[color * size + i] = mix(color);
    }
    const double opacity = std::clamp(static_cast<double>(mix(3)), 0.0, MostOpacity);
    this->Table[colors * size + i] = static_cast<float>(-std::log1p(-opacity));
  }
  this->Opacity.Table = this->Table.data();
}
}
