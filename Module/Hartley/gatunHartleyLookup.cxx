// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyLookup.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
constexpr std::size_t TableSize = 4096;

// Rays with fewer samples in a block do not determine its mean density.
constexpr float FewestSamples = 0.005f;

// Upper bound of the opacity of a sample: an opacity of 1 has no finite optical depth.
constexpr double MostOpacity = 1 - 1e-7;
}

//------------------------------------------------------------------------------
HartleyLookup::HartleyLookup(const HartleyShading& shading, double base, const Range& range)
  : Shading(shading)
  , Base(static_cast<float>(base))
  , Least(static_cast<float>(range.Min))
  , Most(static_cast<float>(range.Max))
  , First(static_cast<float>(shading.First))
{
  if (shading.OpacityModel == HartleyOpacityModel::XRay)
  {
    return;
  }
  const double width = shading.Last - shading.First;
  this->PerDensity = width > 0 ? static_cast<float>((TableSize - 1) / width) : 0.0f;
  this->Table.resize(TableSize);
  for (std::size_t i = 0; i < TableSize; ++i)
  {
    const double at =
      static_cast<double>(i) / (TableSize - 1) * static_cast<double>(shading.Table.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), shading.Table.size() - 2);
    const auto part = static_cast<float>(at - static_cast<double>(below));
    for (std::size_t channel = 0; channel < 4; ++channel)
    {
      this->Table[i][channel] =
        (1 - part) * shading.Table[below][channel] + part * shading.Table[below + 1][channel];
    }
    const double opacity = std::clamp(static_cast<double>(this->Table[i][3]), 0.0, MostOpacity);
    this->Table[i][3] = static_cast<float>(-std::log1p(-opacity));
  }
  this->BaseClear = shading.OpacityModel == HartleyOpacityModel::Exponential
    ? shading.Extinction * (base - shading.Zero) <= 0
    : this->Find(this->Base)[3] <= 0;
}

//------------------------------------------------------------------------------
const std::array<float, 4>& HartleyLookup::Find(float density) const
{
  const float at = (density - this->First) * this->PerDensity + 0.5f;
  return this
    ->Table[static_cast<std::size_t>(std::clamp(at, 0.0f, static_cast<float>(TableSize - 1)))];
}

//------------------------------------------------------------------------------
void HartleyLookup::Add(float first, float samples, std::array<float, 4>& channels) const
{
  if (this->Shading.OpacityModel == HartleyOpacityModel::XRay)
  {
    channels[0] += first;
    channels[1] += samples;
    return;
  }
  if (samples < FewestSamples)
  {
    return;
  }
  const float mean = std::clamp(first / samples + this->Base, this->Least, this->Most);
  const auto& found = this->Find(mean);
  float depth = 0;
  float through = 1; // transmittance of the blocks in front
  if (this->Shading.OpacityModel == HartleyOpacityModel::Exponential)
  {
    // Equation 6: the opacity does not depend on the mean.
    const auto zero = static_cast<float>(this->Shading.Zero);
    depth = static_cast<float>(this->Shading.Extinction) *
      std::max(0.0f, first + samples * (this->Base - zero));
    through = channels[3] > 0 ? std::exp(-channels[3]) : 1.0f;
  }
  else
  {
    depth = samples * found[3]; // equation 7: 1 - (1 - O)^n
    through = 1 - channels[3];
  }
  if (depth <= 0)
  {
    return;
  }
  // Equations 8 to 10.
  const float opacity = -std::expm1(-depth);
  for (std::size_t i = 0; i < 3; ++i)
  {
    channels[i] += through * opacity * found[i];
  }
  // The exponential model accumulates the optical depth, which is linear in the densities.
  channels[3] +=
    this->Shading.OpacityModel == HartleyOpacityModel::Exponential ? depth : through * opacity;
}

//------------------------------------------------------------------------------
void HartleyLookup::AddSlab(const std::array<float, 4>& channels, std::array<float, 4>& pixel) const
{
  if (this->Shading.OpacityModel == HartleyOpacityModel::XRay)
  {
    pixel[0] += channels[0];
    pixel[1] += channels[1];
    return;
  }
  const float opaque = std::max(0.0f, channels[3]);
  const float opacity = this->Shading.OpacityModel == HartleyOpacityModel::Exponential
    ? -std::expm1(-opaque)
    : std::min(1.0f, opaque);
  for (std::size_t i = 0; i < 3; ++i)
  {
    // The interpolation overshoots at edges; a premultiplied color must not exceed the opacity.
    pixel[i] += pixel[3] * std::clamp(channels[i], 0.0f, opacity);
  }
  pixel[3] *= 1 - opacity;
}
}
