// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayColoring.h"

#include "gatunVector.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
//------------------------------------------------------------------------------
RayColoring::Color RayColoring::Get(std::span<const double> values) const
{
  Color color{};
  if (this->Table.empty())
  {
    for (std::size_t c = 0; c < color.size() && c < values.size(); ++c)
    {
      const double value = (values[c] - this->Low) * this->Scale;
      color[c] = value > 0 ? static_cast<float>(std::min(value, 1.0)) : 0.0f; // NaN, too
    }
    return color;
  }
  const double place = (values[0] - this->Low) * this->Scale;
  if (std::isnan(place))
  {
    return this->NotANumber;
  }
  const auto last = static_cast<double>(this->Table.size() - 1);
  const double inTable = std::clamp(place, 0.0, last);
  const auto first = static_cast<std::size_t>(inTable);
  const auto next = std::min(first + 1, this->Table.size() - 1);
  const auto part = static_cast<float>(inTable - static_cast<double>(first));
  for (std::size_t c = 0; c < color.size(); ++c)
  {
    color[c] = this->Table[first][c] + part * (this->Table[next][c] - this->Table[first][c]);
  }
  return color;
}

//------------------------------------------------------------------------------
std::vector<RayColoring::Color> GetHueColors(const RayColoring& coloring, const RayHues& hues)
{
  std::vector<RayColoring::Color> colors;
  if (hues.Channels == 0)
  {
    return colors;
  }
  const std::span<const double> values(hues.Values);
  colors.reserve(values.size() / hues.Channels);
  for (std::size_t i = 0; i + hues.Channels <= values.size(); i += hues.Channels)
  {
    colors.push_back(coloring.Get(values.subspan(i, hues.Channels)));
  }
  return colors;
}

//------------------------------------------------------------------------------
RayHue GetHue(const RayBlock& block, std::span<const RayPoint> points,
  std::span<const RayColoring::Color> colors, std::size_t tet)
{
  RayHue hue;
  if (block.Hues.OfCells)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      hue.T[c] = hue.Low[c] = hue.High[c] = colors[tet][c];
    }
    return hue;
  }
  const RayBlock::Tet& corners = block.Tets[tet];
  const auto place = [&](std::size_t corner)
  {
    const RayPoint& point = points[corners[corner]];
    return glm::dvec3(point.X, point.Y, point.Z);
  };
  const glm::dvec3 origin = place(0);
  const glm::dvec3 u = place(1) - origin;
  const glm::dvec3 v = place(2) - origin;
  const glm::dvec3 w = place(3) - origin;
  const double volume = GetDeterminant(u, v, w);
  const double perVolume = volume != 0 && std::isfinite(volume) ? 1 / volume : 0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto get = [&](std::size_t corner)
    { return static_cast<double>(colors[corners[corner]][c]); };
    glm::dvec3 gradient = perVolume *
      ((get(1) - get(0)) * glm::cross(v, w) + (get(2) - get(0)) * glm::cross(w, u) +
        (get(3) - get(0)) * glm::cross(u, v));
    double shift = glm::dot(gradient, origin);
    if (!std::isfinite(shift))
    {
      gradient = glm::dvec3(0.0); // nothing of such a tetrahedron is drawn
      shift = 0;
    }
    hue.X[c] = gradient.x;
    hue.Y[c] = gradient.y;
    hue.Z[c] = gradient.z;
    hue.T[c] = get(0) - shift;
    const auto [low, high] = std::minmax({ get(0), get(1), get(2), get(3) });
    hue.Low[c] = static_cast<float>(low);
    hue.High[c] = static_cast<float>(high);
  }
  return hue;
}
}
