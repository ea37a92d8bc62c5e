// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleySlab.h"

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
  const std::array<std::uint32_t, 2>& end, double middleAlong, std::size_t planes)
{
  this->Clear();
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
  this->Stride = RoundUp(this->Points[0]) + Lanes;
  this->Values.resize(std::max(this->Values.size(), planes * this->GetPlane()));
  this->Planes = planes;
  for (std::size_t i = 0; i < 2; ++i)
  {
    this->Cells[i] = (this->Points[i] + CellSize - 1) / CellSize;
  }
  this->HasContent.assign(this->Cells[0] * this->Cells[1], 0);
}

//------------------------------------------------------------------------------
void HartleySlab::Clear()
{
  for (std::size_t cell = 0; cell < this->HasContent.size(); ++cell)
  {
    if (this->HasContent[cell] == 0)
    {
      continue;
    }
    const std::size_t column = cell % this->Cells[0] * CellSize;
    const std::size_t row = cell / this->Cells[0] * CellSize;
    for (std::size_t plane = 0; plane < this->Planes; ++plane)
    {
      for (std::size_t y = row; y < std::min(row + CellSize, this->Points[1]); ++y)
      {
        std::fill_n(this->Values.data() + plane * this->GetPlane() + y * this->Stride + column,
          CellSize, 0.0f);
      }
    }
  }
}

//------------------------------------------------------------------------------
void HartleySlab::Mark(const HartleyLattice& lattice, std::span<const Part> parts)
{
  for (const Part& part : parts)
  {
    const auto corner = this->GetCorner(lattice, part.Place);
    for (std::size_t y = corner[1] / CellSize; y * CellSize < corner[1] + lattice.Points[1]; ++y)
    {
      for (std::size_t x = corner[0] / CellSize; x * CellSize < corner[0] + lattice.Points[0]; ++x)
      {
        this->HasContent[y * this->Cells[0] + x] = 1;
      }
    }
  }
}

//------------------------------------------------------------------------------
bool HartleySlab::IsEmpty(double left, double right, double top, double bottom) const
{
  const auto getCell = [this](double at, std::size_t axis) {
    return std::min(this->Cells[axis] - 1, static_cast<std::size_t>(std::max(0.0, at)) / CellSize);
  };
  for (std::size_t y = getCell(top, 1); y <= getCell(bottom, 1); ++y)
  {
    for (std::size_t x = getCell(left, 0); x <= getCell(right, 0); ++x)
    {
      if (this->HasContent[y * this->Cells[0] + x] != 0)
      {
        return false;
      }
    }
  }
  return true;
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
  const HartleyLattice& lattice, const HartleyOpacity& opacities, std::span<const Part> parts)
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
  this->Mark(lattice, parts);
  const auto& kernel = GetBestHartleyKernel();
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
          const std::size_t line = row - corner[1];
          kernel.AddBlock(opacities, part.Image ? part.Image + line * lattice.Points[0] : nullptr,
            part.Unit + line * RoundUp(lattice.Points[0]), lattice.Points[0],
            this->Values.data() + row * this->Stride + corner[0], this->GetPlane());
        }
      }
    });
}

//------------------------------------------------------------------------------
bool HartleySlab::AddTo(const HartleyLattice& lattice, const HartleyView& view,
  const HartleyOpacity& opacities, std::vector<float>& pixels) const
{
  constexpr unsigned rowsAtOnce = 4;
  const auto origin = lattice.Project(view.Origin);
  const auto column = lattice.Project(view.ColumnStep);
  const auto row = lattice.Project(view.RowStep);
  const auto& kernel = GetBestHartleyKernel();
  const std::size_t groups = (view.Height + rowsAtOnce - 1) / rowsAtOnce;
  const std::size_t plane = std::size_t{ view.Width } * view.Height;
  const HartleyPlanes planes{ this->Values.data(), this->Stride, this->GetPlane(),
    static_cast<double>(this->Points[0]) - 3, static_cast<double>(this->Points[1]) - 3 };
  std::vector<std::uint8_t> clear(groups);
  ParallelFor(groups,
    [&](std::size_t group)
    {
      const auto begin = static_cast<unsigned>(group) * rowsAtOnce;
      bool isClear = false;
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
        float* const pixelsOfRow = pixels.data() + std::size_t{ y } * view.Width;
        const auto add = [&](double from, double to)
        {
          if (from < to)
          {
            kernel.AddSlab(opacities, planes,
              { start[0] + from * step[0], start[1] + from * step[1], step[0], step[1],
                static_cast<std::size_t>(to - from) },
              pixelsOfRow + static_cast<std::size_t>(from), plane);
          }
        };
        double from = first;
        for (double x = first; x < end; x += Lanes)
        {
          const double last = std::min(x + Lanes, end) - 1;
          const auto reach = std::array{ std::minmax({ x * step[0], last * step[0] }),
            std::minmax({ x * step[1], last * step[1] }) };
          if (this->IsEmpty(start[0] + reach[0].first - 1, start[0] + reach[0].second + 3,
                start[1] + reach[1].first - 1, start[1] + reach[1].second + 3))
          {
            add(from, x);
            from = x + Lanes;
          }
        }
        add(from, end);
        const float* const through = pixelsOfRow + (opacities.Planes - 1) * plane;
        isClear = isClear ||
          std::any_of(through, through + view.Width, [](float one) { return one > Opaque; });
      }
      clear[group] = isClear;
    });
  return std::any_of(clear.begin(), clear.end(), [](std::uint8_t one) { return one != 0; });
}
}
