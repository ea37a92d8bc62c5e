// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyXRay.h"

#include "gatunBessel.h"
#include "gatunFourier.h"
#include "gatunHartleyFourier.h"
#include "gatunHartleyLattice.h"
#include "gatunHartleyTent.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace gatun
{
namespace
{
// Lattice points for each period of the highest frequency, divided by 2.
constexpr double Oversampling = 2;

// Resolution of the table of the tent function's spectrum.
constexpr double TentSteps = 1024;

// Points of the slice at which the spectrum of the trilinear basis function is less than this part
// of that of the tent function at the highest frequency are left out.
constexpr float LeastOfCut = 0.5f;

// Points where it is less than this do not count when the cut is chosen.
constexpr double Negligible = 0.01;

//------------------------------------------------------------------------------
/** Of numbers above -2^16. Faster than floor, which is a function on older processors. */
std::ptrdiff_t RoundDown(double number)
{
  constexpr std::int32_t offset = 1 << 16;
  return static_cast<std::int32_t>(number + offset) - offset;
}

//------------------------------------------------------------------------------
/** The kernel that resamples images: Kaiser-Bessel, with the shape of Beatty, Nishimura and Pauly;
 * see KaiserBessel. */
class ResamplingKernel
{
public:
  static constexpr std::size_t Steps = 512;

  ResamplingKernel()
  {
    const double reach = taps / Oversampling * (Oversampling - 0.5);
    this->Shape = std::numbers::pi * std::sqrt(std::max(reach * reach - 0.8, 1.0));
    for (std::size_t step = 0; step <= Steps + 1; ++step)
    {
      for (int tap = 0; tap < taps; ++tap)
      {
        const double x = (static_cast<double>(step) / Steps - (tap - taps / 2 + 1)) / (taps / 2.0);
        this->Weights.push_back(
          x * x <= 1 ? static_cast<float>(GetBessel(this->Shape * std::sqrt(1 - x * x))) : 0.0f);
      }
    }
  }

  /** At a frequency in cycles per point. */
  double GetTransform(double frequency) const
  {
    const double angle = std::numbers::pi * taps * frequency;
    const double square = this->Shape * this->Shape - angle * angle;
    const double root = std::sqrt(std::abs(square));
    return root < 1e-9 ? taps : taps * (square > 0 ? std::sinh(root) : std::sin(root)) / root;
  }

  const float* GetWeights() const { return this->Weights.data(); }

  static const ResamplingKernel& Get()
  {
    static const ResamplingKernel kernel;
    return kernel;
  }

private:
  static constexpr int taps = HartleyResampling::Taps;

  double Shape;
  std::vector<float> Weights;
};
}

//------------------------------------------------------------------------------
/**
 * One call of Draw. The lattice of the image has columns along one axis of the volume, of which
 * only frequencies from 0 are needed as the image is real, and rows along another. Along x there
 * are columns, if it is not the axis along the rays.
 */
class HartleyXRay::Drawing
{
public:
  Drawing(const HartleyXRay& xray, const HartleyView& view)
    : Spectrum(*xray.Spectrum)
    , View(view)
    , Lattice(HartleyLattice::Make(this->Spectrum.GetPlan().Size, view.Step))
    , Along(static_cast<std::size_t>(this->Lattice.Axes[2]))
    , Loops(GetBestHartleyLanes())
  {
    const double most = xray.Largest[this->Along] * this->Lattice.SamplesPerVoxel;
    this->Cut = this->FindCut(most * most * xray.MeanSquareError);
    this->Even = this->Spectrum.GetPlan().Size[this->Along] % 2 == 0;
    this->Set(this->Sides[0], this->GetSideAxis(0));
    this->Set(this->Sides[1], this->GetSideAxis(1));
    // Of frequencies along the rays up to the cut.
    this->PerTent = TentSteps / this->Cut;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(TentSteps) + 1; ++i)
    {
      this->Tents.push_back(
        static_cast<float>(GetTentSpectrum(static_cast<double>(i) / this->PerTent)));
    }
    this->Least = static_cast<float>(GetTentSpectrum(this->Cut)) * LeastOfCut;
  }

  /** From the slice to columns of the image, of which only the frequencies along the rows are
   * transformed. */
  void DrawColumns()
  {
    const Side& column = this->Sides[0];
    const Side& row = this->Sides[1];
    const std::size_t groups =
      ComplexLanes::CountGroups(static_cast<std::size_t>(column.Highest) + 1);
    this->Columns.resize(ComplexLanes::CountGroups(row.Count) * groups * ComplexLanes::Count);
    const LaneFourier fourier(row.Points);
    ParallelFor(groups,
      [&](std::size_t group)
      {
        std::vector<ComplexLanes> line(row.Points), room(row.Points), some(ComplexLanes::Count);
        std::vector<HartleySample> samples(2 * static_cast<std::size_t>(row.Highest) + 1);
        for (std::size_t lane = 0; lane < ComplexLanes::Count; ++lane)
        {
          const auto u = static_cast<std::ptrdiff_t>(group * ComplexLanes::Count + lane);
          if (u <= column.Highest)
          {
            this->Loops.Sample(samples.data(), this->List(u, lane, samples),
              this->Spectrum.GetValues(), HartleyVolumeSpectrum::GetWeights(),
              this->Spectrum.GetStride(this->Along), line[0].Re);
          }
        }
        const ComplexLanes* const found = fourier.Inverse(line.data(), room.data());
        for (std::size_t first = 0; first < row.Count; first += ComplexLanes::Count)
        {
          for (std::size_t i = 0; i < ComplexLanes::Count; ++i)
          {
            some[i] = found[row.GetIndex(first + i)];
          }
          ComplexLanes* const to = this->Columns.data() +
            (first / ComplexLanes::Count * groups + group) * ComplexLanes::Count;
          this->Loops.Transpose(
            some[0].Re, 2 * ComplexLanes::Count, to[0].Re, 2 * ComplexLanes::Count);
          this->Loops.Transpose(
            some[0].Im, 2 * ComplexLanes::Count, to[0].Im, 2 * ComplexLanes::Count);
        }
      });
  }

  void DrawRows()
  {
    const Side& column = this->Sides[0];
    const Side& row = this->Sides[1];
    const std::size_t width =
      ComplexLanes::CountGroups(static_cast<std::size_t>(column.Highest) + 1) * ComplexLanes::Count;
    const std::size_t groups = ComplexLanes::CountGroups(row.Count);
    this->Stride = ComplexLanes::CountGroups(column.Count) * ComplexLanes::Count;
    this->Image.resize((groups + 1) * ComplexLanes::Count * this->Stride);
    const LaneFourier fourier(column.Points);
    // Two real rows at a time.
    ParallelFor((groups + 1) / 2,
      [&](std::size_t pair)
      {
        const bool both = 2 * pair + 1 < groups;
        const ComplexLanes* const first = this->Columns.data() + 2 * pair * width;
        std::vector<ComplexLanes> line(column.Points), room(column.Points),
          some(ComplexLanes::Count);
        this->Loops.Join(first, both ? first + width : first,
          static_cast<std::size_t>(column.Highest) + 1, column.Points, line.data());
        const ComplexLanes* const found = fourier.Inverse(line.data(), room.data());
        float* const to = this->Image.data() + 2 * pair * ComplexLanes::Count * this->Stride;
        for (std::size_t x = 0; x < column.Count; x += ComplexLanes::Count)
        {
          for (std::size_t i = 0; i < ComplexLanes::Count; ++i)
          {
            some[i] = found[column.GetIndex(x + i)];
          }
          this->Loops.Transpose(some[0].Re, 2 * ComplexLanes::Count, to + x, this->Stride);
          if (both)
          {
            this->Loops.Transpose(some[0].Im, 2 * ComplexLanes::Count,
              to + ComplexLanes::Count * this->Stride + x, this->Stride);
          }
        }
      });
  }

  void DrawPixels(std::span<float> sums) const
  {
    constexpr std::size_t rowsAtOnce = 8;
    const auto origin = this->GetPlace(this->View.Origin);
    const auto acrossPixels = this->GetStep(this->View.ColumnStep);
    const auto downPixels = this->GetStep(this->View.RowStep);
    const HartleyResampling resampling{ this->Image.data(), this->Stride, this->Kernel.GetWeights(),
      static_cast<float>(ResamplingKernel::Steps) };
    const std::size_t width = this->View.Width;
    ParallelFor((this->View.Height + rowsAtOnce - 1) / rowsAtOnce,
      [&](std::size_t group)
      {
        const std::size_t end = std::min<std::size_t>((group + 1) * rowsAtOnce, this->View.Height);
        for (std::size_t y = group * rowsAtOnce; y < end; ++y)
        {
          std::array<double, 2> start{};
          double first = 0;
          double last = static_cast<double>(width) - 1;
          for (std::size_t i = 0; i < 2; ++i)
          {
            start[i] = origin[i] + static_cast<double>(y) * downPixels[i];
            // All taps are in the lattice, and rounding does not change that.
            Clip(start[i], acrossPixels[i], 1.001,
              static_cast<double>(this->Sides[i].Count) - 3.001, first, last);
          }
          float* const row = sums.data() + y * width;
          const auto from = static_cast<std::size_t>(first);
          const std::size_t count = first <= last ? static_cast<std::size_t>(last) - from + 1 : 0;
          std::fill(row, row + (count > 0 ? from : width), 0.0f);
          if (count > 0)
          {
            this->Loops.Resample(resampling, start[0] + first * acrossPixels[0],
              start[1] + first * acrossPixels[1], acrossPixels[0], acrossPixels[1], count,
              row + from);
            std::fill(row + from + count, row + width, 0.0f);
          }
        }
      });
  }

private:
  /** An axis across the rays. */
  struct Side
  {
    std::size_t Axis = 0;
    double Shear = 0;                  // voxels for each voxel along the rays
    double Period = 0;                 // in voxels, of the image
    bool Even = false;                 // whether the sign changes from each period to the next
    std::ptrdiff_t Highest = 0;        // frequency
    std::size_t Points = 0;            // of a period of the image
    std::ptrdiff_t First = 0;          // point of the image that is needed, from its middle
    std::size_t Count = 0;             // of the needed points
    std::vector<float> Scales;         // of frequencies from -Highest
    std::vector<float> Tents;          // the tent function's spectrum, of the same
    std::vector<std::int32_t> Wrapped; // frequencies in the first period, from -Highest

    /** The index in a transform of the needed points. */
    std::size_t GetIndex(std::size_t needed) const
    {
      const auto points = static_cast<std::ptrdiff_t>(this->Points);
      const std::ptrdiff_t at = this->First + static_cast<std::ptrdiff_t>(needed);
      return static_cast<std::size_t>(at < 0 ? at + points : at >= points ? at - points : at);
    }
  };

  /** An axis across the rays, in the order of Sides. */
  std::size_t GetSideAxis(std::size_t side) const
  {
    return side == 0 ? (this->Along == 0 ? 1 : 0) : (this->Along == 2 ? 1 : 2);
  }

  double GetShear(std::size_t axis) const
  {
    return this->Lattice.Shear[static_cast<std::size_t>(this->Lattice.Axes[0]) == axis ? 0 : 1];
  }

  /** The stored value of the point closest to a frequency of a slice. */
  double GetSquare(std::array<std::ptrdiff_t, 3> place) const
  {
    const auto& plan = this->Spectrum.GetPlan();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto points = static_cast<std::ptrdiff_t>(plan.Points[axis]);
      place[axis] -=
        points * RoundDown(static_cast<double>(place[axis]) / static_cast<double>(points) + 0.5);
      if (std::abs(place[axis]) > plan.Highest[axis])
      {
        return 0;
      }
    }
    if (place[0] < 0)
    {
      std::transform(place.begin(), place.end(), place.begin(), std::negate<>());
    }
    std::array<std::uint16_t, ComplexLanes::Count> stored{};
    std::array<float, ComplexLanes::Count> value{};
    std::copy_n(this->Spectrum.GetValues() + 2 * this->Spectrum.GetPoint(place), 2, stored.begin());
    this->Loops.FromHalf(stored.data(), stored.size(), value.data());
    return static_cast<double>(value[0] * value[0] + value[1] * value[1]);
  }

  /** The lowest frequency beyond which the mean square of an image is not above the given one. */
  double FindCut(double meanSquare) const
  {
    constexpr std::ptrdiff_t shift = 5;
    constexpr std::ptrdiff_t enough = 4096;
    constexpr double perCycle = 20;
    constexpr double highest = 1.5;
    const auto& plan = this->Spectrum.GetPlan();
    const std::array<std::size_t, 2> axes{ this->GetSideAxis(0), this->GetSideAxis(1) };
    const auto getPoints = [&](std::size_t axis) { return static_cast<double>(plan.Points[axis]); };
    const std::array<double, 2> period{ getPoints(axes[0]), getPoints(axes[1]) };
    const double most = this->IsCut() ? this->GetStoredCut() : highest;
    const auto columns = static_cast<std::ptrdiff_t>(most * period[0]);
    const auto rows = static_cast<std::ptrdiff_t>(most * period[1]);
    // Of the points of the slice, one of so many along each row and along each column: all of a
    // small volume.
    std::ptrdiff_t apart = 16;
    while (apart > 1 && 2 * columns * rows < enough * apart)
    {
      apart /= 2;
    }
    const auto bins = static_cast<std::size_t>(std::ceil(most * perCycle)) + 1;
    std::vector<std::vector<double>> sums(static_cast<std::size_t>(columns) + 1);
    ParallelFor(sums.size(),
      [&](std::size_t column)
      {
        sums[column].resize(bins);
        const auto u = static_cast<std::ptrdiff_t>(column);
        const double fu = static_cast<double>(u) / period[0];
        const double tentU = GetTentSpectrum(fu);
        for (std::ptrdiff_t v = (u * shift) % apart - rows; v <= rows; v += apart)
        {
          const double fv = static_cast<double>(v) / period[1];
          const double along = -(this->GetShear(axes[0]) * fu + this->GetShear(axes[1]) * fv);
          const double tent = tentU * GetTentSpectrum(fv) * GetTentSpectrum(along);
          const double cut = std::max({ fu, std::abs(fv), std::abs(along) });
          if (cut >= most || tent < Negligible)
          {
            continue;
          }
          std::array<std::ptrdiff_t, 3> place{};
          place[axes[0]] = u;
          place[axes[1]] = v;
          place[this->Along] = RoundDown(along * getPoints(this->Along) + 0.5);
          sums[column][static_cast<std::size_t>(cut * perCycle)] +=
            tent * tent * this->GetSquare(place) * (u == 0 ? 1 : 2);
        }
      });
    // Of the squares at the points of an image with the distance of voxels, Parseval.
    const double scale = this->Lattice.SamplesPerVoxel * this->Spectrum.GetScale();
    const double factor = scale * scale * apart / (period[0] * period[1]) /
      (static_cast<double>(plan.Size[axes[0]]) * plan.Size[axes[1]]);
    std::size_t bin = bins;
    for (double rest = 0; bin > 2; --bin)
    {
      for (const auto& sum : sums)
      {
        rest += sum[bin - 1] * factor;
      }
      if (rest > meanSquare)
      {
        break;
      }
    }
    return std::min(most, static_cast<double>(bin) / perCycle);
  }

  /** Whether less than a period of the spectrum is stored; up to which frequency. */
  bool IsCut() const
  {
    const auto& plan = this->Spectrum.GetPlan();
    return 2 * plan.Highest[0] < static_cast<std::ptrdiff_t>(plan.Points[0]);
  }
  double GetStoredCut() const
  {
    const auto& plan = this->Spectrum.GetPlan();
    double cut = 0.5;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      cut = std::min(
        cut, static_cast<double>(plan.Highest[axis]) / static_cast<double>(plan.Points[axis]));
    }
    return cut;
  }

  void Set(Side& side, std::size_t axis)
  {
    const auto& plan = this->Spectrum.GetPlan();
    const double size = plan.Size[axis];
    side.Axis = axis;
    side.Shear = this->GetShear(axis);
    side.Period = static_cast<double>(plan.Points[axis]);
    side.Even = plan.Size[axis] % 2 == 0;
    side.Highest = static_cast<std::ptrdiff_t>(std::ceil(this->Cut * side.Period));
    side.Points = GetFastSize(
      static_cast<std::size_t>(std::ceil(2 * Oversampling * static_cast<double>(side.Highest))) +
      2);
    const double spacing = side.Period / static_cast<double>(side.Points);
    const double reach =
      (size + 1 + std::abs(side.Shear) * (plan.Size[this->Along] + 1)) / 2 / spacing;
    // Points for the taps of pixels on the border; all of a period at most.
    const std::size_t half =
      std::min(static_cast<std::size_t>(std::ceil(reach)) + 3, (side.Points - 1) / 2);
    side.First = -static_cast<std::ptrdiff_t>(half);
    side.Count = 2 * half + 1;
    for (std::ptrdiff_t u = -side.Highest; u <= side.Highest; ++u)
    {
      const double frequency = static_cast<double>(u) / side.Period;
      const std::ptrdiff_t period = RoundDown(frequency + 0.5);
      const bool turned = side.Even && period % 2 != 0;
      side.Tents.push_back(static_cast<float>(GetTentSpectrum(frequency)));
      const double scale = GetTentSpectrum(frequency) / side.Period /
        this->Kernel.GetTransform(static_cast<double>(u) / static_cast<double>(side.Points));
      side.Scales.push_back(static_cast<float>(turned ? -scale : scale));
      side.Wrapped.push_back(
        static_cast<std::int32_t>(u - period * static_cast<std::ptrdiff_t>(side.Period)));
    }
  }

  /** Lists the points of a column of the slice. */
  std::size_t List(std::ptrdiff_t u, std::size_t lane, std::vector<HartleySample>& samples) const
  {
    const Side& column = this->Sides[0];
    const Side& row = this->Sides[1];
    const double points = static_cast<double>(this->Spectrum.GetPlan().Points[this->Along]);
    const auto at = static_cast<std::size_t>(u + column.Highest);
    const auto scaleOfColumn = static_cast<float>(static_cast<double>(column.Scales[at]) *
      this->Lattice.SamplesPerVoxel * this->Spectrum.GetScale());
    const double start = -column.Shear * static_cast<double>(u) / column.Period;
    const double step = -row.Shear / row.Period;
    std::array<std::ptrdiff_t, 3> place{};
    std::size_t count = 0;
    for (std::ptrdiff_t v = -row.Highest; v <= row.Highest; ++v)
    {
      const double frequency = start + step * static_cast<double>(v);
      const auto tentAt = static_cast<float>(std::abs(frequency) * this->PerTent);
      const auto j = static_cast<std::size_t>(v + row.Highest);
      if (tentAt >= static_cast<float>(this->Tents.size() - 1))
      {
        continue;
      }
      const auto tent = static_cast<std::size_t>(tentAt);
      const float between = tentAt - static_cast<float>(tent);
      const float hat = this->Tents[tent] + between * (this->Tents[tent + 1] - this->Tents[tent]);
      if (hat * row.Tents[j] * column.Tents[at] < this->Least)
      {
        continue;
      }
      const std::ptrdiff_t period = RoundDown(frequency + 0.5);
      double along = (frequency - static_cast<double>(period)) * points;
      place[column.Axis] = column.Wrapped[at];
      place[row.Axis] = row.Wrapped[j];
      // The half with negative frequencies along x is the mirror image of the other.
      const bool mirrored = this->Along == 0 ? along < 0 : place[0] < 0;
      if (mirrored)
      {
        place[column.Axis] = -place[column.Axis];
        place[row.Axis] = -place[row.Axis];
        along = -along;
      }
      const std::ptrdiff_t below = RoundDown(along);
      place[this->Along] = below - HartleyVolumeSpectrum::Before;
      HartleySample& sample = samples[count++];
      sample.First = static_cast<std::uint32_t>(this->Spectrum.GetPoint(place));
      // What one column needs of the spectrum is far apart in memory.
      __builtin_prefetch(this->Spectrum.GetValues() + 2 * std::size_t{ sample.First });
      sample.Position = static_cast<float>(along - static_cast<double>(below)) *
        static_cast<float>(HartleyVolumeSpectrum::Steps);
      sample.Scale = scaleOfColumn * row.Scales[j] * (this->Even && period % 2 != 0 ? -hat : hat);
      sample.ImaginaryScale = mirrored ? -sample.Scale : sample.Scale;
      sample.To = static_cast<std::uint32_t>(
        static_cast<std::size_t>(v < 0 ? v + static_cast<std::ptrdiff_t>(row.Points) : v) * 2 *
          ComplexLanes::Count +
        lane);
    }
    return count;
  }

  /** The points of the lattice for a step in index coordinates. */
  std::array<double, 2> GetStep(const HartleyView::Vector& step) const
  {
    std::array<double, 2> found{};
    for (std::size_t i = 0; i < 2; ++i)
    {
      const Side& side = this->Sides[i];
      found[i] = (step[side.Axis] - side.Shear * step[this->Along]) / side.Period *
        static_cast<double>(side.Points);
    }
    return found;
  }

  /** The position of a point in index coordinates on the lattice. */
  std::array<double, 2> GetPlace(const HartleyView::Vector& point) const
  {
    HartleyView::Vector fromMiddle{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      fromMiddle[axis] = point[axis] - (this->Spectrum.GetPlan().Size[axis] - 1.0) / 2;
    }
    auto place = this->GetStep(fromMiddle);
    for (std::size_t i = 0; i < 2; ++i)
    {
      place[i] -= static_cast<double>(this->Sides[i].First);
    }
    return place;
  }

  /** Restricts [first, last] to the pixels with start + pixel * step from low to high. */
  static void Clip(double start, double step, double low, double high, double& first, double& last)
  {
    if (step == 0)
    {
      last = start < low || start > high ? first - 1 : last;
      return;
    }
    const double one = (low - start) / step;
    const double two = (high - start) / step;
    first = std::max(first, std::ceil(std::min(one, two)));
    last = std::min(last, std::floor(std::max(one, two)));
  }

  const HartleyVolumeSpectrum& Spectrum;
  const HartleyView& View;
  HartleyLattice Lattice;
  double Cut = 0.5;
  std::size_t Along; // axis of the volume
  const HartleyLaneLoops& Loops;
  const ResamplingKernel& Kernel = ResamplingKernel::Get();
  std::array<Side, 2> Sides; // of columns, of rows
  std::vector<float> Tents;
  double PerTent = 1;
  float Least = 0;
  bool Even = false;                 // as in Side, along the rays
  std::vector<ComplexLanes> Columns; // by groups of rows and frequency
  std::size_t Stride = 0;            // from one row of the image to the next
  std::vector<float> Image;
};

//------------------------------------------------------------------------------
HartleyXRay::HartleyXRay(std::shared_ptr<const HartleyVolumeSpectrum> spectrum,
  const std::array<double, 3>& largest, double meanSquareError)
  : Spectrum(std::move(spectrum))
  , Largest(largest)
  , MeanSquareError(meanSquareError)
{
}

//------------------------------------------------------------------------------
void HartleyXRay::Draw(const HartleyView& view, std::span<float> sums) const
{
  Drawing drawing(*this, view);
  drawing.DrawColumns();
  drawing.DrawRows();
  drawing.DrawPixels(sums);
}
}
