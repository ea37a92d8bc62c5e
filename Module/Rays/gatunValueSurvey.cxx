// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunValueSurvey.h"

#include "gatunParallel.h"
#include "gatunSpread.h"
#include "gatunVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace gatun
{
namespace
{
// Blocks that are in memory at the same time; not the number of threads, on which the choice of
// blocks must not depend.
constexpr std::size_t BlocksAtOnce = 4;
constexpr std::size_t LeastBlocks = 16;

// Volumes are counted in these parts of that of the box.
constexpr double VolumeUnits = 17592186044416; // 2^44

bool AllFinite(const std::array<const RayPoint*, 4>& corners)
{
  return std::all_of(corners.begin(), corners.end(),
    [](const RayPoint* p)
    { return std::isfinite(p->X) && std::isfinite(p->Y) && std::isfinite(p->Z); });
}

/** The corners are sorted by coordinates, so that the result is the same in each block. */
double GetVolume(const std::array<const RayPoint*, 4>& corners)
{
  const RayPoint& a = *corners[0];
  const auto fromA = [&](const RayPoint& p) { return glm::dvec3(p.X - a.X, p.Y - a.Y, p.Z - a.Z); };
  return std::abs(GetDeterminant(fromA(*corners[1]), fromA(*corners[2]), fromA(*corners[3]))) / 6;
}

/** ByCount: whether tetrahedra count alike. */
void AddBlock(const RayBlock& block, double unit, bool byCount, ValueHistogram& histogram)
{
  for (std::size_t i = 0; i < block.Tets.size(); ++i)
  {
    std::array<const RayPoint*, 4> corners{};
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      corners[corner] = &block.Points[block.Tets[i][corner]];
    }
    if (!AllFinite(corners))
    {
      continue;
    }
    std::array<double, 4> values{};
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      values[corner] = block.CellValues.empty() ? corners[corner]->Value : block.CellValues[i];
    }
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    {
      continue;
    }
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double units = byCount ? 1 : std::min(GetVolume(corners) / unit, VolumeUnits);
    histogram.Add(*low, *high, static_cast<std::uint64_t>(std::llround(units)));
  }
}

class Surveyor
{
public:
  Surveyor(RaySource& source, const RaySource::Progress& progress, std::uint64_t mostTets)
    : Source(source)
    , Progress(progress)
    , MostTets(mostTets)
    , Blocks(SpreadNumbers(source.GetNumberOfBlocks()))
  {
    for (std::size_t i = 0; i < this->Blocks.size(); ++i)
    {
      this->Box.Include(source.GetBounds(i));
      this->Values.Include(source.GetRange(i));
    }
    double volume = 1;
    for (const Range& range : this->Box)
    {
      volume *= range.Max - range.Min;
    }
    this->ByCount = this->Box.IsEmpty() || !(volume > 0) || !std::isfinite(volume);
    this->Unit = volume / VolumeUnits;
  }

  const Bounds& GetBox() const { return this->Box; }
  const Range& GetRange() const { return this->Values; }

  void Fill(ValueHistogram& histogram)
  {
    this->Surveyed = 0;
    std::uint64_t tets = 0;
    const std::size_t count = this->Blocks.size();
    while (this->Surveyed < count && (tets < this->MostTets || this->Surveyed < LeastBlocks))
    {
      const std::size_t taken = std::min(BlocksAtOnce, count - this->Surveyed);
      const auto blocks = this->Source.GetBlocks(
        std::span(this->Blocks).subspan(this->Surveyed, taken), this->Progress);
      std::vector<ValueHistogram> parts(taken, histogram.MakeEmpty());
      ParallelFor(
        taken, [&](std::size_t i) { AddBlock(*blocks[i], this->Unit, this->ByCount, parts[i]); });
      for (std::size_t i = 0; i < taken; ++i)
      {
        histogram.Add(parts[i]);
        tets += blocks[i]->Tets.size();
      }
      this->Surveyed += taken;
    }
    if (histogram.GetTotal() == 0 && !this->ByCount)
    {
      // All tetrahedra are flat.
      this->ByCount = true;
      this->Fill(histogram);
    }
  }

  /** Of the whole mesh, after Fill. */
  double EstimateVolume(const ValueHistogram& histogram) const
  {
    if (this->ByCount || this->Surveyed == 0)
    {
      return 0;
    }
    const double ofAll =
      static_cast<double>(this->Blocks.size()) / static_cast<double>(this->Surveyed);
    return static_cast<double>(histogram.GetTotal()) * this->Unit * ofAll;
  }

private:
  RaySource& Source;
  const RaySource::Progress& Progress;
  std::uint64_t MostTets;
  std::vector<std::size_t> Blocks;
  std::size_t Surveyed = 0;
  Bounds Box;
  Range Values = Range::MakeEmpty();
  bool ByCount = false;
  double Unit = 0;
};
}

//------------------------------------------------------------------------------
ValueSurvey SurveyValues(RaySource& source, const std::optional<Range>& range,
  const RaySource::Progress& progress, std::uint64_t mostTets)
{
  Surveyor surveyor(source, progress, mostTets);
  ValueSurvey survey;
  survey.Box = surveyor.GetBox();
  if (range)
  {
    survey.Values = ValueHistogram(*range);
    surveyor.Fill(survey.Values);
  }
  else
  {
    survey.Values = MakeValueHistogram(
      surveyor.GetRange(), [&](ValueHistogram& histogram) { surveyor.Fill(histogram); });
  }
  survey.Volume = surveyor.EstimateVolume(survey.Values);
  return survey;
}
}
