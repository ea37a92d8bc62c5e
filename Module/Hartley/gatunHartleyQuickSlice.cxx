// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyQuickSlice.h"

#include "gatunHartleyFourier.h"
#include "gatunHartleyTent.h"
#include "gatunHartleyTransform.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
constexpr std::size_t Lanes = ComplexLanes::Count;

// Points at which the spectrum of the trilinear basis function is smaller are left out.
constexpr double Negligible = 1e-3;

// Frequencies above 1 / HartleyLattice::Spacing / 2 alias to lower ones. Those of so many cycles
// per voxel are summed.
constexpr std::ptrdiff_t HighestCycles = 3;

std::shared_ptr<const HartleyVolumeSpectrum> MakeSpectrum(
  const VolumeSpectrumPlan& plan, std::span<const double> values)
{
  const std::vector<float> voxels(values.begin(), values.end());
  return std::make_shared<const HartleyVolumeSpectrum>(plan, voxels);
}
}

//------------------------------------------------------------------------------
HartleyBlockSpectra::HartleyBlockSpectra(const HartleyLayout::Triple& block, std::uint64_t bytes)
  : Plan(VolumeSpectrumPlan::Make(block, 0.5))
  , Kept(std::make_shared<CacheBudget>(bytes), CachePolicy::KeepFirst)
{
}

//------------------------------------------------------------------------------
std::shared_ptr<const HartleyVolumeSpectrum> HartleyBlockSpectra::Get(
  std::size_t block, std::span<const HartleyTerm> terms)
{
  if (auto found = this->Kept.Find(block))
  {
    return found;
  }
  const auto& size = this->Plan.Size;
  std::vector<double> values(std::size_t{ size[0] } * size[1] * size[2]);
  for (const HartleyTerm& term : terms)
  {
    values[term.Index] = static_cast<double>(term.Value);
  }
  HartleyTransform(size).Inverse(values);
  auto made = MakeSpectrum(this->Plan, values);
  this->Kept.Keep(block, made, this->Plan.GetBytes());
  return made;
}

//------------------------------------------------------------------------------
class HartleyQuickSlice::QuickBrush : public HartleyPainter::Brush
{
public:
  explicit QuickBrush(const HartleyQuickSlice& slice)
    : Slice(slice)
    , Column(slice.Sides[0])
    , Row(slice.Sides[1])
    , Groups(ComplexLanes::CountGroups(slice.Samples.size()))
    , AlongColumn(Column.Points)
    , AlongRow(Row.Points)
    , Line(std::max(Column.Points, Row.Points))
    , Room(Line.size())
    , Some(Lanes)
    , Columns(ComplexLanes::CountGroups(Row.Count) * Groups * Lanes)
    , Loops(GetBestHartleyLanes())
  {
  }

  void Paint(std::span<const Task> tasks) override
  {
    for (const Task& task : tasks)
    {
      this->PaintSpectrum(*this->Slice.Spectra->Get(task.Block, task.Terms), task.Image);
    }
  }

  void PaintSpectrum(const HartleyVolumeSpectrum& spectrum, float* image)
  {
    for (std::size_t group = 0; group < this->Groups; ++group)
    {
      this->PaintColumns(spectrum, group);
    }
    const std::size_t groups = ComplexLanes::CountGroups(this->Row.Count);
    const std::size_t width = this->Groups * Lanes;
    const std::size_t half = this->Column.Points / 2;
    const auto scale = static_cast<float>(spectrum.GetScale());
    // Two real rows at a time.
    for (std::size_t group = 0; group < groups; group += 2)
    {
      const ComplexLanes* const first = this->Columns.data() + group * width;
      const ComplexLanes* const second = group + 1 < groups ? first + width : first;
      this->Loops.Join(first, second, half, this->Column.Points, this->Line.data());
      std::copy_n(first[half].Re, Lanes, this->Line[half].Re);
      std::copy_n(second[half].Re, Lanes, this->Line[half].Im);
      const ComplexLanes* const found =
        this->AlongColumn.Inverse(this->Line.data(), this->Room.data());
      for (std::size_t x = 0; x < this->Column.Count; ++x)
      {
        const ComplexLanes& values = found[this->Column.GetIndex(x)];
        this->Store(values.Re, scale, x, group * Lanes, image);
        if (group + 1 < groups)
        {
          this->Store(values.Im, scale, x, (group + 1) * Lanes, image);
        }
      }
    }
  }

private:
  void PaintColumns(const HartleyVolumeSpectrum& spectrum, std::size_t group)
  {
    std::fill(this->Line.begin(), this->Line.end(), ComplexLanes{});
    for (std::size_t lane = 0; lane < Lanes; ++lane)
    {
      const std::size_t u = group * Lanes + lane;
      if (u < this->Slice.Samples.size())
      {
        const auto& samples = this->Slice.Samples[u];
        this->Loops.Sample(samples.data(), samples.size(), spectrum.GetValues(),
          HartleyVolumeSpectrum::GetWeights(), this->Slice.Stride, this->Line[0].Re + lane);
      }
    }
    const ComplexLanes* const found = this->AlongRow.Inverse(this->Line.data(), this->Room.data());
    for (std::size_t first = 0; first < this->Row.Count; first += Lanes)
    {
      for (std::size_t i = 0; i < Lanes; ++i)
      {
        this->Some[i] = found[this->Row.GetIndex(std::min(first + i, this->Row.Count - 1))];
      }
      ComplexLanes* const to =
        this->Columns.data() + (first / Lanes * this->Groups + group) * Lanes;
      this->Loops.Transpose(this->Some[0].Re, 2 * Lanes, to[0].Re, 2 * Lanes);
      this->Loops.Transpose(this->Some[0].Im, 2 * Lanes, to[0].Im, 2 * Lanes);
    }
  }

  /** Stores a column of eight rows of the image. */
  void Store(const float* values, float scale, std::size_t x, std::size_t first, float* image) const
  {
    const std::size_t count = std::min(Lanes, this->Row.Count - first);
    const bool across = this->Slice.Lattice.Axes[0] == static_cast<int>(this->Column.Axis);
    const std::size_t next = across ? this->Column.Count : 1;
    float* const to = image + (across ? first * next + x : x * this->Row.Count + first);
    for (std::size_t i = 0; i < count; ++i)
    {
      to[i * next] = values[i] * scale;
    }
  }

  const HartleyQuickSlice& Slice;
  const Side& Column;
  const Side& Row;
  std::size_t Groups; // of columns of the slice
  LaneFourier AlongColumn, AlongRow;
  std::vector<ComplexLanes> Line, Room, Some;
  std::vector<ComplexLanes> Columns; // by groups of rows and frequency
  const HartleyLaneLoops& Loops;
};

//------------------------------------------------------------------------------
HartleyQuickSlice::HartleyQuickSlice(const HartleyLattice& lattice,
  const HartleyLayout::Triple& block, std::shared_ptr<HartleyBlockSpectra> spectra)
  : Lattice(lattice)
  , Block(block)
  , Spectra(std::move(spectra))
  , Along(static_cast<std::size_t>(lattice.Axes[2]))
{
  const auto& plan = this->Spectra->GetPlan();
  const std::array<std::size_t, 2> axes{ this->Along == 0 ? 1u : 0u, this->Along == 2 ? 1u : 2u };
  for (std::size_t i = 0; i < 2; ++i)
  {
    Side& side = this->Sides[i];
    const std::size_t which = static_cast<std::size_t>(lattice.Axes[0]) == axes[i] ? 0 : 1;
    side.Axis = axes[i];
    side.Shear = lattice.Shear[which];
    side.Period = static_cast<std::ptrdiff_t>(plan.Points[axes[i]]);
    side.Even = block[axes[i]] % 2 == 0;
    side.Points = plan.Points[axes[i]] * HartleyLattice::PerVoxel;
    side.Count = lattice.Points[which];
  }
  this->List(plan);
}

//------------------------------------------------------------------------------
void HartleyQuickSlice::List(const VolumeSpectrumPlan& plan)
{
  const Side& column = this->Sides[0];
  const Side& row = this->Sides[1];
  const auto points = static_cast<double>(plan.Points[this->Along]);
  const bool even = this->Block[this->Along] % 2 == 0;
  const double scale =
    this->Lattice.SamplesPerVoxel / static_cast<double>(column.Period * row.Period);
  const auto width = static_cast<std::ptrdiff_t>(column.Points);
  const auto height = static_cast<std::ptrdiff_t>(row.Points);
  const auto wrap = [](const Side& side, std::ptrdiff_t u, bool& turned)
  {
    const auto period = static_cast<std::ptrdiff_t>(
      std::floor(static_cast<double>(u) / static_cast<double>(side.Period) + 0.5));
    turned = turned != (side.Even && period % 2 != 0);
    return u - period * side.Period;
  };
  this->Stride = plan.GetStrides()[this->Along];
  this->Samples.resize(column.Points / 2 + 1);
  std::vector<double> tents; // of rows
  for (std::ptrdiff_t v = -HighestCycles * row.Period; v <= HighestCycles * row.Period; ++v)
  {
    tents.push_back(GetTent(static_cast<double>(v) / static_cast<double>(row.Period)));
  }
  ParallelFor(this->Samples.size(),
    [&](std::size_t target)
    {
      const std::ptrdiff_t cycles = HighestCycles * column.Period;
      for (auto u = static_cast<std::ptrdiff_t>(target) - 2 * width; u <= cycles; u += width)
      {
        const double fu = static_cast<double>(u) / static_cast<double>(column.Period);
        const double tentU = GetTent(fu);
        for (std::ptrdiff_t v = -HighestCycles * row.Period;
             tentU >= Negligible && v <= HighestCycles * row.Period; ++v)
        {
          const double fv = static_cast<double>(v) / static_cast<double>(row.Period);
          const double tentV =
            tentU * tents[static_cast<std::size_t>(v + HighestCycles * row.Period)];
          const double frequency = -(column.Shear * fu + row.Shear * fv);
          const double tent = tentV < Negligible ? 0 : tentV * GetTent(frequency);
          if (tent < Negligible)
          {
            continue;
          }
          bool turned = false;
          std::array<std::ptrdiff_t, 3> place{};
          place[column.Axis] = wrap(column, u, turned);
          place[row.Axis] = wrap(row, v, turned);
          const double period = std::floor(frequency + 0.5);
          turned = turned != (even && std::fmod(period, 2) != 0);
          double along = (frequency - period) * points;
          const bool mirrored = this->Along == 0 ? along < 0 : place[0] < 0;
          if (mirrored)
          {
            place[column.Axis] = -place[column.Axis];
            place[row.Axis] = -place[row.Axis];
            along = -along;
          }
          const double below = std::floor(along);
          place[this->Along] = static_cast<std::ptrdiff_t>(below) - HartleyVolumeSpectrum::Before;
          HartleySample sample;
          sample.First = static_cast<std::uint32_t>(plan.GetPoint(place));
          sample.To = static_cast<std::uint32_t>(((v % height) + height) % height) * 2 * Lanes;
          sample.Position = static_cast<float>((along - below) * HartleyVolumeSpectrum::Steps);
          sample.Scale = static_cast<float>(turned ? -tent * scale : tent * scale);
          sample.ImaginaryScale = mirrored ? -sample.Scale : sample.Scale;
          this->Samples[target].push_back(sample);
        }
      }
    });
}

//------------------------------------------------------------------------------
std::unique_ptr<HartleyPainter::Brush> HartleyQuickSlice::MakeBrush() const
{
  return std::make_unique<QuickBrush>(*this);
}

//------------------------------------------------------------------------------
std::vector<float> HartleyQuickSlice::PaintUnit(const HartleyLayout::Triple& filled) const
{
  const auto& size = this->Block;
  std::vector<double> values(std::size_t{ size[0] } * size[1] * size[2]);
  for (std::size_t z = 0; z < filled[2]; ++z)
  {
    for (std::size_t y = 0; y < filled[1]; ++y)
    {
      std::fill_n(values.data() + (z * size[1] + y) * size[0], filled[0], 1.0);
    }
  }
  std::vector<float> image(this->Lattice.GetNumberOfPoints());
  QuickBrush(*this).PaintSpectrum(*MakeSpectrum(this->Spectra->GetPlan(), values), image.data());
  return image;
}
}
