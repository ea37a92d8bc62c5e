// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayPixel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace gatun
{
//------------------------------------------------------------------------------
Fragment CompositeFragments(std::vector<Fragment>& fragments)
{
  std::sort(fragments.begin(), fragments.end(),
    [](const Fragment& a, const Fragment& b) { return a.Begin < b.Begin; });
  Fragment sum = NoFragment();
  for (const Fragment& fragment : fragments)
  {
    sum.Append(fragment);
  }
  return sum;
}

//------------------------------------------------------------------------------
void ToPixel(const RayTable& table, const Fragment& sum, float largest, float* rgba)
{
  std::array<float, 4> color{};
  switch (table.Mode)
  {
    case RayMode::Composite:
    case RayMode::Sampled:
      color[3] = 1 - sum.Sum[3];
      for (std::size_t c = 0; c < 3; ++c)
      {
        color[c] = std::clamp(sum.Sum[c], 0.0f, color[3]); // but for rounding, it is within
      }
      break;
    case RayMode::Maximum:
      if (largest != RayTile::Never)
      {
        const RayTable::Cell& cell = table.Cells[static_cast<std::size_t>(largest)];
        const float fraction = largest - std::floor(largest);
        for (std::size_t c = 0; c < 4; ++c)
        {
          color[c] = cell.Value[c] + fraction * cell.Change[c];
        }
        color[3] = -color[3];
      }
      break;
    case RayMode::XRay:
      if (const float depth = sum.Sum[3] - 1; depth > 0)
      {
        const float opacity = -std::expm1(-depth);
        color[3] = opacity;
        for (std::size_t c = 0; c < 3; ++c)
        {
          color[c] = std::clamp(sum.Sum[c] / depth * opacity, 0.0f, opacity);
        }
      }
      break;
  }
  std::copy(color.begin(), color.end(), rgba);
}
}
