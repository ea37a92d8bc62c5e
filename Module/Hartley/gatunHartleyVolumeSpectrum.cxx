// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyVolumeSpectrum.h"

#include "gatunBessel.h"
#include "gatunHartleyFourier.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace gatun
{
namespace
{
// The largest absolute value in half precision. Values far below 1 lose digits.
constexpr double LargestHalf = 32768;

//------------------------------------------------------------------------------
/** One axis: transforms lines of voxels about their middle, and picks the stored frequencies. */
class AxisTransform
{
public:
  AxisTransform(std::size_t voxels, std::size_t points, std::ptrdiff_t first, std::ptrdiff_t last)
    : Voxels(voxels)
    , Fourier(points)
    , First(first)
    , Last(last)
  {
    const double middle = (static_cast<double>(voxels) - 1) / 2;
    for (std::ptrdiff_t u = first; u <= last; ++u)
    {
      const double angle =
        2 * std::numbers::pi * static_cast<double>(u) * middle / static_cast<double>(points);
      this->Turns.push_back(static_cast<float>(std::cos(angle)));
      this->Turns.push_back(static_cast<float>(std::sin(angle)));
    }
  }

  /** The memory of a line, with that of its transform. */
  std::size_t GetLength() const
  {
    return std::max(this->Fourier.GetSize(), this->Voxels + ComplexLanes::Count);
  }

  std::size_t GetStored() const { return static_cast<std::size_t>(this->Last - this->First + 1); }

  const float* GetTurn(std::size_t stored) const { return this->Turns.data() + 2 * stored; }

  /** The index of a stored frequency, or of its opposite, in the transform. */
  std::size_t GetIndex(std::size_t stored) const
  {
    return this->Wrap(this->First + static_cast<std::ptrdiff_t>(stored));
  }
  std::size_t GetOpposite(std::size_t stored) const
  {
    return this->Wrap(-this->First - static_cast<std::ptrdiff_t>(stored));
  }

  /** Transforms lines of which the voxels are given; the origin is the first voxel. */
  const ComplexLanes* Run(ComplexLanes* line, ComplexLanes* room) const
  {
    std::fill(line + this->Voxels, line + this->Fourier.GetSize(), ComplexLanes{});
    return this->Fourier.Forward(line, room);
  }

  /** The same about the middle; to: the stored frequencies. */
  void Run(ComplexLanes* line, ComplexLanes* room, ComplexLanes* to) const
  {
    const ComplexLanes* const found = this->Run(line, room);
    const std::size_t stored = this->GetStored();
    for (std::size_t i = 0; i < stored;)
    {
      const std::size_t index = this->GetIndex(i);
      const std::size_t count = std::min(stored - i, this->Fourier.GetSize() - index);
      std::copy_n(found + index, count, to + i);
      i += count;
    }
    GetBestHartleyLanes().Turn(to, this->Turns.data(), stored);
  }

private:
  std::size_t Wrap(std::ptrdiff_t u) const
  {
    const auto points = static_cast<std::ptrdiff_t>(this->Fourier.GetSize());
    return static_cast<std::size_t>(((u % points) + points) % points);
  }

  std::size_t Voxels;
  LaneFourier Fourier;
  std::ptrdiff_t First, Last;
  std::vector<float> Turns;
};
}

//------------------------------------------------------------------------------
VolumeSpectrumPlan VolumeSpectrumPlan::Make(const HartleyLayout::Triple& size, double cut)
{
  VolumeSpectrumPlan plan;
  plan.Size = size;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    // Along the rays, the windowed sinc needs twice the voxels. Across, the image must fit for
    // every shear; otherwise it would wrap around.
    const std::size_t own = size[axis];
    const std::size_t other = std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]);
    plan.Points[axis] = GetEvenFastSize(own + std::max(own, other + 2));
    plan.Highest[axis] = std::min(static_cast<std::ptrdiff_t>(plan.Points[axis] / 2),
      static_cast<std::ptrdiff_t>(std::ceil(cut * static_cast<double>(plan.Points[axis]))));
  }
  return plan;
}

//------------------------------------------------------------------------------
std::array<std::ptrdiff_t, 3> VolumeSpectrumPlan::GetStrides() const
{
  constexpr std::ptrdiff_t more = HartleyVolumeSpectrum::Before + HartleyVolumeSpectrum::After + 1;
  const std::ptrdiff_t depth = 2 * this->Highest[2] + more;
  return { (2 * this->Highest[1] + more) * depth, depth, 1 };
}

//------------------------------------------------------------------------------
std::ptrdiff_t VolumeSpectrumPlan::GetPoint(const std::array<std::ptrdiff_t, 3>& at) const
{
  constexpr std::ptrdiff_t before = HartleyVolumeSpectrum::Before;
  const auto strides = this->GetStrides();
  return (at[0] + before) * strides[0] + (at[1] + this->Highest[1] + before) * strides[1] + at[2] +
    this->Highest[2] + before;
}

//------------------------------------------------------------------------------
std::uint64_t VolumeSpectrumPlan::GetBytes() const
{
  constexpr std::uint64_t more = HartleyVolumeSpectrum::Before + HartleyVolumeSpectrum::After + 1;
  const auto get = [&](std::size_t axis)
  { return static_cast<std::uint64_t>(this->Highest[axis]); };
  return (get(0) + more) * (2 * get(1) + more) * (2 * get(2) + more) * 2 * sizeof(std::uint16_t);
}

//------------------------------------------------------------------------------
std::uint64_t VolumeSpectrumPlan::GetWorkingBytes() const
{
  constexpr std::uint64_t more = HartleyVolumeSpectrum::Before + HartleyVolumeSpectrum::After + 1;
  const auto get = [&](std::size_t axis)
  { return static_cast<std::uint64_t>(this->Highest[axis]); };
  return (get(0) + more) * (2 * get(1) + more) * ComplexLanes::CountGroups(this->Size[2]) * 2 *
    ComplexLanes::Count * sizeof(std::uint16_t);
}

//------------------------------------------------------------------------------
/** Transforms along x and y, eight slices of voxels at a time, and then along z. */
class HartleyVolumeSpectrum::Builder
{
public:
  Builder(HartleyVolumeSpectrum& spectrum, std::span<const float> voxels)
    : Spectrum(spectrum)
    , Size{ spectrum.Plan.Size[0], spectrum.Plan.Size[1], spectrum.Plan.Size[2] }
    , Voxels(voxels)
    , X(Size[0], spectrum.Plan.Points[0], -Before, spectrum.Plan.Highest[0] + After)
    , Y(Size[1], spectrum.Plan.Points[1], -spectrum.Plan.Highest[1] - Before,
        spectrum.Plan.Highest[1] + After)
    , Z(Size[2], spectrum.Plan.Points[2], -spectrum.Plan.Highest[2] - Before,
        spectrum.Plan.Highest[2] + After)
    , Loops(GetBestHartleyLanes())
  {
  }

  /** The numbers of the stored frequencies. */
  std::array<std::size_t, 3> GetStored() const
  {
    return { this->X.GetStored(), this->Y.GetStored(), this->Z.GetStored() };
  }

  /** No value of a transform is larger than the sum of the absolute values of its voxels. */
  void FindBounds()
  {
    const std::size_t slice = this->Size[0] * this->Size[1];
    std::vector<double> sums(this->Size[2]);
    ParallelFor(this->Size[2],
      [&](std::size_t z)
      {
        double sum = 0;
        for (const float value : this->Voxels.subspan(z * slice, slice))
        {
          sum += std::abs(static_cast<double>(value));
        }
        sums[z] = sum;
      });
    double all = 0;
    double most = 0;
    for (const double sum : sums)
    {
      all += sum;
      most = std::max(most, sum);
    }
    this->SliceScale = most > 0 ? most / LargestHalf : 1;
    this->Spectrum.Scale = all > 0 ? all / LargestHalf : 1;
  }

  void TransformSlices(const std::function<bool(double)>& progress)
  {
    const std::size_t groups = ComplexLanes::CountGroups(this->Size[2]);
    this->Slices.resize(
      groups * this->X.GetStored() * this->Y.GetStored() * 2 * ComplexLanes::Count);
    ParallelFor(
      groups, [&](std::size_t group) { this->TransformSlicesOf(group); }, progress);
  }

  void TransformAlong(const std::function<bool(double)>& progress)
  {
    ParallelFor(
      this->X.GetStored(), [&](std::size_t u) { this->TransformAlongOf(u); }, progress);
  }

private:
  using Line = std::vector<ComplexLanes>;

  /** Eight rows of voxels, one of each slice of a group. */
  void LoadRows(std::size_t group, std::size_t y, float* to) const
  {
    constexpr std::size_t next = 2 * ComplexLanes::Count;
    const std::size_t slice = this->Size[0] * this->Size[1];
    const std::size_t first = group * ComplexLanes::Count;
    const std::size_t count = std::min(ComplexLanes::Count, this->Size[2] - first);
    const float* const from = this->Voxels.data() + first * slice + y * this->Size[0];
    std::size_t x = 0;
    if (count == ComplexLanes::Count)
    {
      for (; x + ComplexLanes::Count <= this->Size[0]; x += ComplexLanes::Count)
      {
        this->Loops.Transpose(from + x, slice, to + x * next, next);
      }
    }
    for (; x < this->Size[0]; ++x)
    {
      for (std::size_t i = 0; i < ComplexLanes::Count; ++i)
      {
        to[x * next + i] = i < count ? from[i * slice + x] : 0;
      }
    }
  }

  void TransformSlicesOf(std::size_t group)
  {
    const std::size_t height = this->Size[1];
    const std::size_t columns = this->X.GetStored();
    const std::size_t rows = this->Y.GetStored();
    Line line(std::max(this->X.GetLength(), this->Y.GetLength())), room(line.size());
    Line plane(columns * (height + 1)), out(rows);
    for (std::size_t y = 0; y < height; y += 2)
    {
      // Two real rows at a time.
      this->LoadRows(group, y, line[0].Re);
      if (y + 1 < height)
      {
        this->LoadRows(group, y + 1, line[0].Im);
      }
      else
      {
        for (std::size_t x = 0; x < this->Size[0]; ++x)
        {
          std::fill_n(line[x].Im, ComplexLanes::Count, 0.0f);
        }
      }
      const ComplexLanes* const found = this->X.Run(line.data(), room.data());
      for (std::size_t u = 0; u < columns; ++u)
      {
        ComplexLanes* const to = plane.data() + u * (height + 1) + y;
        this->Loops.Separate(found[this->X.GetIndex(u)], found[this->X.GetOpposite(u)],
          this->X.GetTurn(u), to[0], to[1]);
      }
    }
    const auto scale = static_cast<float>(1 / this->SliceScale);
    for (std::size_t u = 0; u < columns; ++u)
    {
      std::copy_n(plane.data() + u * (height + 1), height, line.data());
      this->Y.Run(line.data(), room.data(), out.data());
      this->Loops.ToHalf(out[0].Re, rows * 2 * ComplexLanes::Count, scale,
        this->Slices.data() + (group * columns + u) * rows * 2 * ComplexLanes::Count);
    }
  }

  void TransformAlongOf(std::size_t u)
  {
    constexpr std::size_t next = 2 * ComplexLanes::Count;
    const std::size_t groups = ComplexLanes::CountGroups(this->Size[2]);
    const std::size_t columns = this->X.GetStored();
    const std::size_t rows = this->Y.GetStored();
    const std::size_t depth = this->Z.GetStored();
    Line line(this->Z.GetLength()), room(line.size());
    Line out(ComplexLanes::CountGroups(depth) * ComplexLanes::Count), loaded(ComplexLanes::Count);
    const auto scale = static_cast<float>(this->SliceScale / this->Spectrum.Scale);
    for (std::size_t from = 0; from < rows; from += ComplexLanes::Count)
    {
      // The last lines may overlap those before.
      const std::size_t v = std::min(from, rows - ComplexLanes::Count);
      for (std::size_t group = 0; group < groups; ++group)
      {
        this->Loops.FromHalf(this->Slices.data() + ((group * columns + u) * rows + v) * next,
          ComplexLanes::Count * next, loaded[0].Re);
        this->Loops.Transpose(loaded[0].Re, next, line[group * ComplexLanes::Count].Re, next);
        this->Loops.Transpose(loaded[0].Im, next, line[group * ComplexLanes::Count].Im, next);
      }
      this->Z.Run(line.data(), room.data(), out.data());
      std::uint16_t* const to =
        this->Spectrum.Values.data() + 2 * static_cast<std::size_t>(u * rows + v) * depth;
      for (std::size_t w = 0; w < depth; w += ComplexLanes::Count)
      {
        this->Loops.StoreRows(out.data() + w, scale, ComplexLanes::Count,
          std::min(ComplexLanes::Count, depth - w), to + 2 * w, 2 * depth);
      }
    }
  }

  HartleyVolumeSpectrum& Spectrum;
  std::array<std::size_t, 3> Size;
  std::span<const float> Voxels;
  AxisTransform X, Y, Z;
  const HartleyLaneLoops& Loops;
  double SliceScale = 1;
  LargeArray<std::uint16_t> Slices; // transformed along x and y, by group, x, y and lane
};

//------------------------------------------------------------------------------
HartleyVolumeSpectrum::HartleyVolumeSpectrum(const VolumeSpectrumPlan& plan,
  std::span<const float> voxels, const std::function<bool(double)>& progress)
  : Plan(plan)
{
  // An estimate of the work along x and y.
  constexpr double slices = 0.5;
  const auto getPart = [&](double begin, double end) -> std::function<bool(double)>
  {
    if (!progress)
    {
      return {};
    }
    return [=, &progress](double done) { return progress(begin + done * (end - begin)); };
  };
  Builder builder(*this, voxels);
  const auto stored = builder.GetStored();
  this->Strides = plan.GetStrides();
  this->Middle = plan.GetPoint({});
  builder.FindBounds();
  builder.TransformSlices(getPart(0, slices));
  this->Values.resize(2 * stored[0] * stored[1] * stored[2]);
  builder.TransformAlong(getPart(slices, 1));
}

//------------------------------------------------------------------------------
const float* HartleyVolumeSpectrum::GetWeights()
{
  static const std::vector<float> table = []
  {
    constexpr double shape = 5; // of Kaiser's window
    std::vector<float> weights;
    for (std::size_t step = 0; step <= Steps + 1; ++step)
    {
      for (std::size_t tap = 0; tap < Taps; ++tap)
      {
        const double x = static_cast<double>(step) / Steps + static_cast<double>(Before) -
          static_cast<double>(tap);
        const double inside = x / (Taps / 2);
        const double angle = std::numbers::pi * x;
        const double sinc = std::abs(x) < 1e-9 ? 1 : std::sin(angle) / angle;
        const double window = inside * inside < 1
          ? GetBessel(shape * std::sqrt(1 - inside * inside)) / GetBessel(shape)
          : 0;
        weights.insert(weights.end(), 2, static_cast<float>(sinc * window));
      }
    }
    return weights;
  }();
  return table.data();
}
}
