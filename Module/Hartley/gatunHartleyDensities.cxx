// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyDensities.h"

#include "gatunHartleyBlocks.h"
#include "gatunHartleyFourier.h"
#include "gatunHartleyTransform.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gatun
{
namespace
{
using Triple = HartleyLayout::Triple;

//------------------------------------------------------------------------------
/**
 * The inverse transform of one block, by way of its Fourier spectrum: eight lines at a time along
 * z, along y, and along x, where the frequencies from 0 determine the others.
 */
class BlockInverse
{
public:
  BlockInverse(const Triple& block, const Triple& size, std::span<const HartleyTerm> terms,
    std::span<float> voxels)
    : Block{ block[0], block[1], block[2] }
    , Size{ size[0], size[1], size[2] }
    , Groups(ComplexLanes::CountGroups(Block[0] / 2 + 1))
    , Loops(GetBestHartleyLanes())
    , Voxels(voxels)
  {
    const std::size_t count = this->Block[0] * this->Block[1] * this->Block[2];
    this->Coefficients.resize(count, 0);
    for (const HartleyTerm& term : terms)
    {
      this->Coefficients[term.Index] = term.Value;
    }
    this->Scale = static_cast<float>(0.5 / std::sqrt(static_cast<double>(count)));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto length = static_cast<double>(this->Block[axis]);
      for (std::size_t k = 0; k < this->Block[axis]; ++k)
      {
        const double wave =
          2 * k <= this->Block[axis] ? static_cast<double>(k) : static_cast<double>(k) - length;
        const double angle = -std::numbers::pi * wave * (length - 1) / length;
        this->Turns[axis].push_back(static_cast<float>(std::cos(angle)));
        this->Turns[axis].push_back(static_cast<float>(std::sin(angle)));
      }
    }
  }

  void Run(const std::function<bool(double)>& progress)
  {
    this->Lines.resize(this->Block[1] * this->Block[2] * this->Groups);
    const LaneFourier z(this->Block[2]);
    ParallelFor(this->Block[1], [&](std::size_t k) { this->TransformAlongZ(z, k); });
    LargeArray<float>().swap(this->Coefficients);
    const LaneFourier y(this->Block[1]);
    const LaneFourier x(this->Block[0]);
    ParallelFor(
      this->Size[2], [&](std::size_t slice) { this->TransformSlice(y, x, slice); }, progress);
  }

private:
  using Line = std::vector<ComplexLanes>;

  std::size_t GetOpposite(std::size_t axis, std::size_t k) const
  {
    return k == 0 ? 0 : this->Block[axis] - k;
  }

  /** The Fourier spectrum at eight frequencies: the even part of the Hartley spectrum minus i times
   * the odd part. Returns whether it is not 0. */
  bool Load(std::size_t group, std::size_t ky, std::size_t kz, ComplexLanes& to) const
  {
    const auto [nx, ny, nz] = this->Block;
    const float* const here = this->Coefficients.data() + (kz * ny + ky) * nx;
    const float* const there =
      this->Coefficients.data() + (this->GetOpposite(2, kz) * ny + this->GetOpposite(1, ky)) * nx;
    // Half of an even size is its own opposite up to the sign.
    const float sign = (2 * kz == nz) != (2 * ky == ny) ? -1.0f : 1.0f;
    bool any = false;
    for (std::size_t i = 0; i < ComplexLanes::Count; ++i)
    {
      const std::size_t kx = group * ComplexLanes::Count + i;
      if (2 * kx > nx)
      {
        to.Re[i] = to.Im[i] = 0;
        continue;
      }
      const float one = here[kx];
      const float other = there[this->GetOpposite(0, kx)] * (2 * kx == nx ? -sign : sign);
      to.Re[i] = (one + other) * this->Scale;
      to.Im[i] = (other - one) * this->Scale;
      any = any || one != 0 || other != 0;
    }
    return any;
  }

  void TransformAlongZ(const LaneFourier& fourier, std::size_t ky)
  {
    const std::size_t length = this->Block[2];
    Line line(length), room(length);
    for (std::size_t group = 0; group < this->Groups; ++group)
    {
      bool any = false;
      for (std::size_t kz = 0; kz < length; ++kz)
      {
        any = this->Load(group, ky, kz, line[kz]) || any;
      }
      const ComplexLanes* found = line.data(); // 0, and so is its transform
      if (any)
      {
        this->Loops.Turn(line.data(), this->Turns[2].data(), length);
        found = fourier.Inverse(line.data(), room.data());
      }
      for (std::size_t z = 0; z < length; ++z)
      {
        this->Lines[(ky * length + z) * this->Groups + group] = found[z];
      }
    }
  }

  void TransformSlice(const LaneFourier& alongY, const LaneFourier& alongX, std::size_t z)
  {
    const std::size_t height = this->Block[1];
    const std::size_t stored = ComplexLanes::CountGroups(height) * ComplexLanes::Count;
    Line line(std::max(height, this->Block[0] + ComplexLanes::Count)), room(line.size());
    Line plane(this->Groups * (stored + ComplexLanes::Count));
    for (std::size_t group = 0; group < this->Groups; ++group)
    {
      for (std::size_t ky = 0; ky < height; ++ky)
      {
        line[ky] = this->Lines[(ky * this->Block[2] + z) * this->Groups + group];
      }
      this->Loops.Turn(line.data(), this->Turns[1].data(), height);
      const ComplexLanes* const found = alongY.Inverse(line.data(), room.data());
      std::copy_n(found, height, plane.data() + group * (stored + ComplexLanes::Count));
    }
    // Two real rows at a time in each lane.
    Line first(this->Groups * ComplexLanes::Count), second(first.size());
    for (std::size_t y = 0; y < this->Size[1]; y += 2 * ComplexLanes::Count)
    {
      this->LoadRows(plane, stored, y, first);
      this->LoadRows(plane, stored, y + ComplexLanes::Count, second);
      const std::size_t width = this->Block[0];
      this->Loops.Join(first.data(), second.data(), (width + 1) / 2, width, line.data());
      if (width % 2 == 0)
      {
        std::copy_n(first[width / 2].Re, ComplexLanes::Count, line[width / 2].Re);
        std::copy_n(second[width / 2].Re, ComplexLanes::Count, line[width / 2].Im);
      }
      const ComplexLanes* const found = alongX.Inverse(line.data(), room.data());
      this->StoreRows(found->Re, y, z);
      this->StoreRows(found->Im, y + ComplexLanes::Count, z);
    }
  }

  /** The frequencies along x of eight rows. */
  void LoadRows(const Line& plane, std::size_t stored, std::size_t y, Line& to) const
  {
    constexpr std::size_t next = 2 * ComplexLanes::Count;
    for (std::size_t group = 0; group < this->Groups; ++group)
    {
      const ComplexLanes* const from = plane.data() + group * (stored + ComplexLanes::Count) + y;
      this->Loops.Transpose(from->Re, next, to[group * ComplexLanes::Count].Re, next);
      this->Loops.Transpose(from->Im, next, to[group * ComplexLanes::Count].Im, next);
    }
    this->Loops.Turn(to.data(), this->Turns[0].data(), this->Block[0] / 2 + 1);
  }

  /** Stores the voxels of eight rows. */
  void StoreRows(const float* from, std::size_t y, std::size_t z)
  {
    constexpr std::size_t next = 2 * ComplexLanes::Count;
    const std::size_t width = this->Size[0];
    const std::size_t rows =
      y < this->Size[1] ? std::min(ComplexLanes::Count, this->Size[1] - y) : 0;
    float* const to = this->Voxels.data() + (z * this->Size[1] + y) * width;
    std::size_t x = 0;
    if (rows == ComplexLanes::Count)
    {
      for (; x + ComplexLanes::Count <= width; x += ComplexLanes::Count)
      {
        this->Loops.Transpose(from + x * next, next, to + x, width);
      }
    }
    for (; x < width; ++x)
    {
      for (std::size_t i = 0; i < rows; ++i)
      {
        to[i * width + x] = from[x * next + i];
      }
    }
  }

  std::array<std::size_t, 3> Block;
  std::array<std::size_t, 3> Size;
  std::size_t Groups; // of frequencies along x
  const HartleyLaneLoops& Loops;
  std::span<float> Voxels;
  LargeArray<float> Coefficients;
  float Scale = 1;
  std::array<std::vector<float>, 3> Turns; // that move the origin to the first voxel
  LargeArray<ComplexLanes> Lines;          // by y, z and group
};

//------------------------------------------------------------------------------
/** Inverts the blocks of a chunk. */
void DecodeChunk(const HartleySource& source, std::size_t number, std::span<float> voxels)
{
  const HartleyLayout& layout = source.GetLayout();
  const auto chunk = source.GetChunk(number);
  HartleyTransform transform(layout.Block);
  std::vector<double> values(layout.GetVoxelsPerBlock());
  ForEachHartleyBlock(layout, number,
    [&](std::size_t block, const Triple& place)
    {
      const auto terms = chunk->GetBlock(block);
      if (terms.empty())
      {
        return;
      }
      std::fill(values.begin(), values.end(), 0.0);
      for (const HartleyTerm& term : terms)
      {
        values[term.Index] = static_cast<double>(term.Value);
      }
      transform.Inverse(values);
      const Triple filled = layout.GetFilled(place);
      for (std::size_t z = 0; z < filled[2]; ++z)
      {
        for (std::size_t y = 0; y < filled[1]; ++y)
        {
          const std::size_t row = place[1] * std::size_t{ layout.Block[1] } + y;
          const std::size_t slice = place[2] * std::size_t{ layout.Block[2] } + z;
          const double* const from = values.data() + (z * layout.Block[1] + y) * layout.Block[0];
          std::transform(from, from + filled[0],
            voxels.data() + (slice * layout.Size[1] + row) * layout.Size[0] +
              place[0] * std::size_t{ layout.Block[0] },
            [](double value) { return static_cast<float>(value); });
        }
      }
    });
}

//------------------------------------------------------------------------------
double GetBorderMean(const Triple& size, std::span<const float> voxels)
{
  double sum = 0;
  std::size_t count = 0;
  const auto isEnd = [](std::size_t i, std::size_t end) { return i == 0 || i + 1 == end; };
  for (std::size_t z = 0; z < size[2]; ++z)
  {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      const float* const row = voxels.data() + (z * size[1] + y) * size[0];
      const bool all = isEnd(z, size[2]) || isEnd(y, size[1]);
      const std::size_t step = all ? 1 : std::max<std::size_t>(1, size[0] - 1);
      for (std::size_t x = 0; x < size[0]; x += step)
      {
        sum += static_cast<double>(row[x]);
        ++count;
      }
    }
  }
  return sum / static_cast<double>(count);
}

//------------------------------------------------------------------------------
/** The sums of a volume along an axis, the lower one of the others fastest. */
std::vector<float> SumAlong(const Triple& size, std::span<const float> voxels, std::size_t axis)
{
  const std::size_t across = axis == 0 ? 1 : 0;
  const std::size_t down = axis == 2 ? 1 : 2;
  const std::array<std::size_t, 3> strides{ 1, size[0], std::size_t{ size[0] } * size[1] };
  std::vector<float> sums(std::size_t{ size[across] } * size[down]);
  ParallelFor(size[down],
    [&](std::size_t j)
    {
      float* const row = sums.data() + j * size[across];
      for (std::size_t k = 0; k < size[axis]; ++k)
      {
        const float* const from = voxels.data() + j * strides[down] + k * strides[axis];
        for (std::size_t i = 0; i < size[across]; ++i)
        {
          row[i] += from[i * strides[across]];
        }
      }
    });
  return sums;
}

//------------------------------------------------------------------------------
/** The energy of an image of the trilinear volume, by its highest frequency along an axis, in
 * PerCycle parts of a cycle per voxel up to one half. Image: width by height voxels. */
class Energies
{
public:
  static constexpr int PerCycle = 20;

  Energies(std::span<const float> image, std::size_t width, std::size_t height)
    : Width(GetEvenFastSize(width))
    , Height(GetEvenFastSize(height))
    , Plane(ComplexLanes::CountGroups(this->Width) * this->Height)
  {
    this->TransformRows(image, width, height);
    this->AddColumns();
  }

  /** The sum of the squares of an image without the frequencies up to one. */
  double GetBeyond(int cut) const
  {
    double sum = 0;
    for (std::size_t i = static_cast<std::size_t>(cut); i < this->Sums.size(); ++i)
    {
      sum += this->Sums[i];
    }
    return sum;
  }

private:
  void TransformRows(std::span<const float> image, std::size_t width, std::size_t height)
  {
    const LaneFourier fourier(this->Width);
    std::vector<ComplexLanes> line(ComplexLanes::CountGroups(this->Width) * ComplexLanes::Count),
      room(line.size());
    for (std::size_t first = 0; first < height; first += ComplexLanes::Count)
    {
      std::fill(line.begin(), line.end(), ComplexLanes{});
      for (std::size_t i = 0; i < ComplexLanes::Count && first + i < height; ++i)
      {
        for (std::size_t x = 0; x < width; ++x)
        {
          line[x].Re[i] = image[(first + i) * width + x];
        }
      }
      const ComplexLanes* const found = fourier.Forward(line.data(), room.data());
      for (std::size_t u = 0; u < this->Width; ++u)
      {
        for (std::size_t i = 0; i < ComplexLanes::Count && first + i < height; ++i)
        {
          ComplexLanes& to = this->Plane[u / ComplexLanes::Count * this->Height + first + i];
          to.Re[u % ComplexLanes::Count] = found[u].Re[i];
          to.Im[u % ComplexLanes::Count] = found[u].Im[i];
        }
      }
    }
  }

  void AddColumns()
  {
    const LaneFourier fourier(this->Height);
    std::vector<ComplexLanes> room(this->Height);
    this->Sums.resize(PerCycle / 2 + 1);
    const double scale = 1 / static_cast<double>(this->Width * this->Height);
    for (std::size_t group = 0; group < ComplexLanes::CountGroups(this->Width); ++group)
    {
      const ComplexLanes* const found =
        fourier.Forward(this->Plane.data() + group * this->Height, room.data());
      for (std::size_t v = 0; v < this->Height; ++v)
      {
        for (std::size_t i = 0;
             i < ComplexLanes::Count && group * ComplexLanes::Count + i < this->Width; ++i)
        {
          const double fu = GetFrequency(group * ComplexLanes::Count + i, this->Width);
          const double fv = GetFrequency(v, this->Height);
          const double square = static_cast<double>(found[v].Re[i]) * found[v].Re[i] +
            static_cast<double>(found[v].Im[i]) * found[v].Im[i];
          this->Sums[static_cast<std::size_t>(std::max(fu, fv) * PerCycle)] +=
            scale * square * GetSquaredTent(fu) * GetSquaredTent(fv);
        }
      }
    }
  }

  static double GetFrequency(std::size_t index, std::size_t size)
  {
    return static_cast<double>(std::min(index, size - index)) / static_cast<double>(size);
  }

  /** The square of the spectrum of the tent function. */
  static double GetSquaredTent(double frequency)
  {
    const double angle = std::numbers::pi * frequency;
    return angle < 1e-6 ? 1 : std::pow(std::sin(angle) / angle, 4);
  }

  std::size_t Width, Height;
  std::vector<ComplexLanes> Plane; // by groups of columns and row
  std::vector<double> Sums;
};
}

//------------------------------------------------------------------------------
LargeArray<float> DecodeHartleyDensities(
  const HartleySource& source, const std::function<bool(double)>& progress)
{
  const HartleyLayout& layout = source.GetLayout();
  LargeArray<float> voxels(std::size_t{ layout.Size[0] } * layout.Size[1] * layout.Size[2], 0);
  if (!layout.IsWhole())
  {
    ParallelFor(
      layout.GetNumberOfChunks(), [&](std::size_t chunk) { DecodeChunk(source, chunk, voxels); },
      progress);
    return voxels;
  }
  const auto chunk = source.GetChunk(0);
  BlockInverse(layout.Block, layout.Size, chunk->GetBlock(0), voxels).Run(progress);
  return voxels;
}

//------------------------------------------------------------------------------
HartleyDetail HartleyDetail::Take(
  const HartleyLayout::Triple& size, std::span<float> voxels, double meanSquareError)
{
  HartleyDetail detail;
  detail.Border = GetBorderMean(size, voxels);
  const std::size_t slice = std::size_t{ size[0] } * size[1];
  ParallelFor(size[2],
    [&](std::size_t z)
    {
      for (float& value : voxels.subspan(z * slice, slice))
      {
        value -= static_cast<float>(detail.Border);
      }
    });
  std::array<int, 3> cuts{};
  std::array<std::vector<float>, 3> images;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    images[axis] = SumAlong(size, voxels, axis);
  }
  ParallelFor(3,
    [&](std::size_t axis)
    {
      const auto& image = images[axis];
      for (const float sum : image)
      {
        detail.Largest[axis] = std::max(
          detail.Largest[axis], std::abs(static_cast<double>(sum) + detail.Border * size[axis]));
      }
      const Energies energies(image, size[axis == 0 ? 1 : 0], size[axis == 2 ? 1 : 2]);
      const double most = meanSquareError / 4 * detail.Largest[axis] * detail.Largest[axis] *
        static_cast<double>(image.size());
      cuts[axis] = 2;
      while (2 * cuts[axis] < Energies::PerCycle && energies.GetBeyond(cuts[axis]) > most)
      {
        ++cuts[axis];
      }
    });
  detail.Cut =
    static_cast<double>(*std::max_element(cuts.begin(), cuts.end())) / Energies::PerCycle;
  return detail;
}
}
