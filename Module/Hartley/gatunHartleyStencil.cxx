// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyStencil.h"

#include "gatunHartleyTransform.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
constexpr std::size_t StencilLanes = 8;

// Voxels with a weight in a lattice point or, across, in two neighboring ones: as many as are
// within 2 + |shear|.
constexpr std::size_t Down = 4;
constexpr std::size_t Across = 5;

double GetTent(double distance)
{
  return std::max(0.0, 1 - std::abs(distance));
}

//------------------------------------------------------------------------------
/** The integral of a trilinear basis function along a ray that passes the voxel's plane at a
 * distance from the voxel. Between its kinks the integrand is a cubic polynomial, for which
 * two-point Gauss quadrature is exact. */
double Integrate(const std::array<double, 2>& distance, const std::array<double, 2>& shear)
{
  std::vector<double> breaks{ -1, 0, 1 };
  for (std::size_t i = 0; i < 2; ++i)
  {
    for (const double kink : { -1.0, 0.0, 1.0 })
    {
      const double at = shear[i] != 0 ? (kink - distance[i]) / shear[i] : 2;
      if (std::abs(at) < 1)
      {
        breaks.push_back(at);
      }
    }
  }
  std::sort(breaks.begin(), breaks.end());
  double sum = 0;
  for (std::size_t i = 1; i < breaks.size(); ++i)
  {
    const double half = (breaks[i] - breaks[i - 1]) / 2;
    const double middle = (breaks[i] + breaks[i - 1]) / 2;
    const double offset = half / std::sqrt(3.0);
    for (const double t : { middle - offset, middle + offset })
    {
      sum += half * GetTent(t) * GetTent(distance[0] + shear[0] * t) *
        GetTent(distance[1] + shear[1] * t);
    }
  }
  return sum;
}
}

//------------------------------------------------------------------------------
void HartleyBlockVoxels::Keep(std::size_t block, std::span<const float> voxels)
{
  const auto bytes = static_cast<std::int64_t>(voxels.size_bytes() + Overhead);
  if (this->Left.fetch_sub(bytes) < bytes)
  {
    this->Left += bytes;
    return;
  }
  this->Kept[block].assign(voxels.begin(), voxels.end());
}

//------------------------------------------------------------------------------
class HartleyStencil::StencilBrush : public HartleyPainter::Brush
{
public:
  explicit StencilBrush(const HartleyStencil& stencil)
    : Stencil(stencil)
    , Kernel(GetBestHartleyKernel())
  {
    const auto& size = stencil.Size;
    this->Padded.resize(size[1] * size[2] * (size[0] + stencil.Margin) + 2 * stencil.Margin);
  }

  void Paint(std::span<const Task> tasks) override
  {
    auto& voxels = *this->Stencil.Voxels;
    for (const Task& task : tasks)
    {
      if (voxels.IsKept(task.Block))
      {
        this->PaintVoxels(voxels.Get(task.Block), task.Image);
        continue;
      }
      this->Invert(task.Terms);
      voxels.Keep(task.Block, this->Values);
      this->PaintVoxels(this->Values, task.Image);
    }
  }

  void PaintVoxels(std::span<const float> voxels, float* image)
  {
    this->Arrange(voxels);
    const auto& stencil = this->Stencil;
    const std::size_t width = stencil.Lattice.Points[0];
    float sums[2 * StencilLanes * GroupsAtOnce];
    for (std::size_t row = 0; row < stencil.Lattice.Points[1]; ++row)
    {
      for (std::size_t i = 0; i < stencil.RunsPerRow; ++i)
      {
        const Run& run = stencil.Runs[row * stencil.RunsPerRow + i];
        this->Kernel.Project(this->Padded.data(), stencil.Taps.data() + run.FirstTap,
          run.EndTap - run.FirstTap, run.Groups, sums);
        const std::size_t first = i * 2 * StencilLanes * GroupsAtOnce;
        std::copy_n(sums, std::min(width - first, 2 * StencilLanes * run.Groups),
          image + row * width + first);
      }
    }
  }

private:
  void Invert(std::span<const HartleyTerm> terms)
  {
    if (!this->Transform)
    {
      this->Transform = std::make_unique<HartleyTransform>(this->Stencil.Block);
      const auto& size = this->Stencil.Size;
      this->Exact.resize(size[0] * size[1] * size[2]);
      this->Values.resize(this->Exact.size());
    }
    std::fill(this->Exact.begin(), this->Exact.end(), 0.0);
    for (const HartleyTerm& term : terms)
    {
      this->Exact[term.Index] = static_cast<double>(term.Value);
    }
    this->Transform->Inverse(this->Exact);
    std::transform(this->Exact.begin(), this->Exact.end(), this->Values.begin(),
      [](double value) { return static_cast<float>(value); });
  }

  /** Copies the voxels of a block plane by plane along the rays, with zeros around each row. */
  void Arrange(std::span<const float> voxels)
  {
    const auto& size = this->Stencil.Size;
    const auto& strides = this->Stencil.Strides;
    float* to = this->Padded.data() + this->Stencil.Margin;
    for (std::size_t plane = 0; plane < size[2]; ++plane)
    {
      for (std::size_t row = 0; row < size[1]; ++row, to += size[0] + this->Stencil.Margin)
      {
        const float* from = voxels.data() + static_cast<std::ptrdiff_t>(plane) * strides[2] +
          static_cast<std::ptrdiff_t>(row) * strides[1];
        for (std::size_t i = 0; i < size[0]; ++i, from += strides[0])
        {
          to[i] = *from;
        }
      }
    }
  }

  const HartleyStencil& Stencil;
  const HartleyKernelLoops& Kernel;
  std::vector<float> Padded;
  std::unique_ptr<HartleyTransform> Transform;
  std::vector<double> Exact;
  std::vector<float> Values;
};

//------------------------------------------------------------------------------
HartleyStencil::HartleyStencil(const HartleyLattice& lattice, const HartleyLayout::Triple& block,
  std::shared_ptr<HartleyBlockVoxels> voxels)
  : Lattice(lattice)
  , Block(block)
  , Voxels(std::move(voxels))
{
  const std::array<std::ptrdiff_t, 3> strides{ 1, static_cast<std::ptrdiff_t>(block[0]),
    static_cast<std::ptrdiff_t>(block[0]) * static_cast<std::ptrdiff_t>(block[1]) };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto axis = static_cast<std::size_t>(lattice.Axes[i]);
    this->Size[i] = block[axis];
    this->Strides[i] = strides[axis];
  }
  this->ListTaps();
}

//------------------------------------------------------------------------------
HartleyStencil::Start HartleyStencil::GetStart(
  std::size_t axis, std::size_t point, std::size_t plane) const
{
  const double along = static_cast<double>(plane) - (this->Lattice.Block[2] - 1) / 2;
  const double at = this->Lattice.GetPlace(static_cast<int>(axis), point) +
    this->Lattice.Shear[axis] * along + (this->Lattice.Block[axis] - 1) / 2;
  const double first = std::floor(at) - 1;
  return { static_cast<std::ptrdiff_t>(first), at - first };
}

//------------------------------------------------------------------------------
void HartleyStencil::ListTaps()
{
  const std::size_t pairs = (this->Lattice.Points[0] + 1) / 2;
  const std::size_t groups = (pairs + StencilLanes - 1) / StencilLanes;
  this->RunsPerRow = (groups + GroupsAtOnce - 1) / GroupsAtOnce;
  // Taps without a voxel are left out, so that others begin and end at most so far outside.
  this->Margin = StencilLanes * std::min(groups, GroupsAtOnce);
  for (std::size_t plane = 0; plane < this->Size[2]; ++plane)
  {
    for (std::size_t parity = 0; parity < 2; ++parity)
    {
      const double x = this->GetStart(0, 0, plane).Distance;
      const double y = this->GetStart(1, parity, plane).Distance;
      for (std::size_t j = 0; j < Down; ++j)
      {
        for (std::size_t i = 0; i < 2 * Across; ++i)
        {
          // Of the even and the odd point.
          const double across = x + (i % 2 == 0 ? 0 : HartleyLattice::Spacing);
          this->Weights.push_back(static_cast<float>(this->Lattice.SamplesPerVoxel *
            Integrate({ across - static_cast<double>(i / 2), y - static_cast<double>(j) },
              this->Lattice.Shear)));
        }
      }
    }
  }
  for (std::size_t row = 0; row < this->Lattice.Points[1]; ++row)
  {
    for (std::size_t first = 0; first < groups; first += GroupsAtOnce)
    {
      const std::size_t count = std::min(GroupsAtOnce, groups - first);
      Run run{ this->Taps.size(), 0, count };
      for (std::size_t plane = 0; plane < this->Size[2]; ++plane)
      {
        this->AddTaps(row, plane, first * StencilLanes, count);
      }
      run.EndTap = this->Taps.size();
      this->Runs.push_back(run);
    }
  }
}

//------------------------------------------------------------------------------
void HartleyStencil::AddTaps(
  std::size_t row, std::size_t plane, std::size_t firstPair, std::size_t groups)
{
  static_assert(HartleyLattice::PerVoxel == 2);
  const auto width = static_cast<std::ptrdiff_t>(this->Size[0]);
  const auto height = static_cast<std::ptrdiff_t>(this->Size[1]);
  const auto margin = static_cast<std::ptrdiff_t>(this->Margin);
  // Two rows further the positions are the same, of the next row of voxels.
  const std::ptrdiff_t top =
    this->GetStart(1, row % 2, plane).Voxel + static_cast<std::ptrdiff_t>(row / 2);
  const std::ptrdiff_t left =
    this->GetStart(0, 0, plane).Voxel + static_cast<std::ptrdiff_t>(firstPair);
  const float* weights = this->Weights.data() + (plane * 2 + row % 2) * Down * 2 * Across;
  for (std::ptrdiff_t j = top; j < top + static_cast<std::ptrdiff_t>(Down); ++j)
  {
    for (std::size_t i = 0; i < Across; ++i, weights += 2)
    {
      const std::ptrdiff_t first = left + static_cast<std::ptrdiff_t>(i);
      const std::ptrdiff_t end = first + static_cast<std::ptrdiff_t>(groups * StencilLanes);
      if (j < 0 || j >= height || first >= width || end <= 0 ||
        (weights[0] == 0 && weights[1] == 0))
      {
        continue;
      }
      const std::ptrdiff_t line = static_cast<std::ptrdiff_t>(plane) * height + j;
      this->Taps.push_back({ static_cast<std::int32_t>(margin + line * (width + margin) + first),
        weights[0], weights[1] });
    }
  }
}

//------------------------------------------------------------------------------
std::unique_ptr<HartleyPainter::Brush> HartleyStencil::MakeBrush() const
{
  return std::make_unique<StencilBrush>(*this);
}

//------------------------------------------------------------------------------
std::vector<float> HartleyStencil::PaintUnit(const HartleyLayout::Triple& filled) const
{
  const auto& size = this->Block;
  std::vector<float> values(std::size_t{ size[0] } * size[1] * size[2]);
  for (std::size_t z = 0; z < filled[2]; ++z)
  {
    for (std::size_t y = 0; y < filled[1]; ++y)
    {
      std::fill_n(values.data() + (z * size[1] + y) * size[0], filled[0], 1.0f);
    }
  }
  std::vector<float> image(this->Lattice.GetNumberOfPoints());
  StencilBrush(*this).PaintVoxels(values, image.data());
  return image;
}
}
