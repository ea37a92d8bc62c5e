// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleySlab.h"

#include "gatunHartleyKernel.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
// Pixels that transmit less than this count as opaque.
constexpr float Opaque = 1.0f / 1024;

//------------------------------------------------------------------------------
/** Restricts the columns [first, end) to those where start + column * step is in a range. */
void ClipColumns(double start, double step, double low, double high, double& first, double& end)
{
  if (step == 0)
  {
    if (start < low || start > high)
    {
      end = first;
    }
    return;
  }
  const double one = (low - start) / step;
  const double two = (high - start) / step;
  first = std::max(first, std::ceil(std::min(one, two)));
  end = std::min(end, std::floor(std::max(one, two)) + 1);
}
}

//------------------------------------------------------------------------------
void HartleySlab::Start(const HartleyLattice& lattice, const std::array<std::uint32_t, 2>& first,
  const std::array<std::uint32_t, 2>& end, double middleAlong)
{
  this->First = first;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double middle =
      first[i] * lattice.Block[i] + (lattice.Block[i] - 1) / 2 - lattice.Shear[i] * middleAlong;
    this->Origin[i] =
      middle - static_cast<double>(lattice.Points[i] / 2 + Margin) * HartleyLattice::Spacing;
    this->Points[i] = static_cast<std::size_t>(end[i] - first[i] - 1) *
        static_cast<std::size_t>(lattice.Block[i]) * HartleyLattice::PerVoxel +
      lattice.Points[i] + 2 * Margin;
  }
  this->Channels.assign(this->Points[0] * this->Points[1], {});
}

//------------------------------------------------------------------------------
std::array<std::size_t, 2> HartleySlab::GetCorner(
  const HartleyLattice& lattice, const std::array<std::uint32_t, 2>& place) const
{
  std::array<std::size_t, 2> corner;
  for (std::size_t i = 0; i < 2; ++i)
  {
    corner[i] = static_cast<std::size_t>(place[i] - this->First[i]) *
        static_cast<std::size_t>(lattice.Block[i]) * HartleyLattice::PerVoxel +
      Margin;
  }
  return corner;
}

//------------------------------------------------------------------------------
void HartleySlab::Add(
  const HartleyLattice& lattice, const HartleyLookup& lookup, std::span<const Part> parts)
{
  constexpr std::size_t rowsAtOnce = 8;
  std::size_t top = this->Points[1];
  std::size_t bottom = 0;
  for (const Part& part : parts)
  {
    const std::size_t corner = this->GetCorner(lattice, part.Place)[1];
    top = std::min(top, corner);
    bottom = std::max(bottom, corner + lattice.Points[1]);
  }
  if (top >= bottom)
  {
    return;
  }
  ParallelFor((bottom - top + rowsAtOnce - 1) / rowsAtOnce,
    [&](std::size_t band)
    {
      const std::size_t begin = top + band * rowsAtOnce;
      const std::size_t end = std::min(begin + rowsAtOnce, bottom);
      for (const Part& part : parts)
      {
        const auto corner = this->GetCorner(lattice, part.Place);
        const std::size_t last = std::min(end, corner[1] + lattice.Points[1]);
        for (std::size_t row = std::max(begin, corner[1]); row < last; ++row)
        {
          const std::size_t from = (row - corner[1]) * lattice.Points[0];
          auto* const to = this->Channels.data() + row * this->Points[0] + corner[0];
          for (std::size_t i = 0; i < lattice.Points[0]; ++i)
          {
            const float samples = part.Unit[from + i];
            if (samples > 0)
            {
              lookup.Add(part.Image ? part.Image[from + i] : 0, samples, to[i]);
            }
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
bool HartleySlab::AddTo(const HartleyLattice& lattice, const HartleyView& view,
  const HartleyLookup& lookup, std::vector<std::array<float, 4>>& pixels) const
{
  constexpr unsigned rowsAtOnce = 4;
  const auto origin = lattice.Project(view.Origin);
  const auto column = lattice.Project(view.ColumnStep);
  const auto row = lattice.Project(view.RowStep);
  const auto& kernel = GetBestHartleyKernel();
  const std::size_t groups = (view.Height + rowsAtOnce - 1) / rowsAtOnce;
  std::vector<std::uint8_t> clear(groups);
  ParallelFor(groups,
    [&](std::size_t group)
    {
      const auto begin = static_cast<unsigned>(group) * rowsAtOnce;
      float most = 0;
      for (unsigned y = begin; y < std::min(begin + rowsAtOnce, view.Height); ++y)
      {
        // In lattice points. Interpolation needs one point before and two after a position.
        std::array<double, 2> start, step;
        double first = 0;
        double end = view.Width;
        for (std::size_t i = 0; i < 2; ++i)
        {
          start[i] = (origin[i] + y * row[i] - this->Origin[i]) / HartleyLattice::Spacing;
          step[i] = column[i] / HartleyLattice::Spacing;
          ClipColumns(start[i], step[i], 1, static_cast<double>(this->Points[i]) - 3, first, end);
        }
        auto* const pixelsOfRow = pixels.data() + std::size_t{ y } * view.Width;
        for (double x = first; x < end; ++x)
        {
          const double across = start[0] + x * step[0];
          const double down = start[1] + x * step[1];
          // Rounding may put the first and last column just outside of the range.
          const std::size_t left =
            std::clamp<std::size_t>(static_cast<std::size_t>(across), 1, this->Points[0] - 3);
          const std::size_t top =
            std::clamp<std::size_t>(static_cast<std::size_t>(down), 1, this->Points[1] - 3);
          std::array<float, 4> channels;
          kernel.Interpolate(this->Channels[(top - 1) * this->Points[0] + left - 1].data(),
            this->Points[0] * 4, static_cast<float>(across - static_cast<double>(left)),
            static_cast<float>(down - static_cast<double>(top)), channels.data());
          lookup.AddSlab(channels, pixelsOfRow[static_cast<std::size_t>(x)]);
        }
        for (unsigned x = 0; x < view.Width; ++x)
        {
          most = std::max(most, pixelsOfRow[x][3]);
        }
      }
      clear[group] = most > Opaque;
    });
  return std::any_of(clear.begin(), clear.end(), [](std::uint8_t one) { return one != 0; });
}
}
