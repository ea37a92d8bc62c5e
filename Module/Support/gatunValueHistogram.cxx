// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunValueHistogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gatun
{
namespace
{
// The inner range must have so many bins to be resolved.
constexpr double LeastInnerBins = 256;

// So that differences do not overflow.
constexpr double LargestValue = std::numeric_limits<double>::max() / 4;

// Smaller values are near 0 on a logarithmic scale.
constexpr double SmallestValue = 1e-300;

double Clamp(double value)
{
  return std::clamp(value, -LargestValue, LargestValue);
}
}

//------------------------------------------------------------------------------
ValueHistogram::ValueHistogram(const Range& range, Scale scale)
  : Values{ Clamp(range.Min), Clamp(range.Max) }
  , BinScale(scale)
  , Steps(Bins + 1, 0)
{
  if (range.IsEmpty())
  {
    this->Values = { 0, 0 };
  }
  this->Scaled = { this->ToScale(this->Values.Min), this->ToScale(this->Values.Max) };
}

//------------------------------------------------------------------------------
double ValueHistogram::ToScale(double value) const
{
  value = Clamp(value);
  return this->BinScale == Scale::Linear
    ? value
    : std::copysign(std::log(std::abs(value) + SmallestValue) - std::log(SmallestValue), value);
}

//------------------------------------------------------------------------------
double ValueHistogram::GetPart(double value) const
{
  if (!this->HasExtent())
  {
    return 0;
  }
  const double part =
    (this->ToScale(value) - this->Scaled.Min) / (this->Scaled.Max - this->Scaled.Min);
  return std::clamp(part, 0., 1.);
}

//------------------------------------------------------------------------------
double ValueHistogram::GetValue(double part) const
{
  if (part <= 0 || part >= 1)
  {
    return part <= 0 ? this->Values.Min : this->Values.Max;
  }
  const double scaled = this->Scaled.Min * (1 - part) + this->Scaled.Max * part;
  const double value = this->BinScale == Scale::Linear
    ? scaled
    : std::copysign(std::exp(std::abs(scaled) + std::log(SmallestValue)) - SmallestValue, scaled);
  return std::clamp(value, this->Values.Min, this->Values.Max);
}

//------------------------------------------------------------------------------
std::size_t ValueHistogram::FindBin(double value) const
{
  const auto bin = static_cast<std::size_t>(this->GetPart(value) * static_cast<double>(Bins));
  return std::min(bin, Bins - 1);
}

//------------------------------------------------------------------------------
void ValueHistogram::Add(double low, double high, std::uint64_t weight)
{
  if (std::isnan(low) || std::isnan(high))
  {
    return;
  }
  const std::size_t first = this->FindBin(low);
  const std::size_t last = std::max(first, this->FindBin(high));
  const std::uint64_t bins = last - first + 1;
  const auto each = static_cast<std::int64_t>(weight / bins);
  const auto rest = static_cast<std::int64_t>(weight % bins);
  // One more in each of the first bins, until all of it is there.
  this->Steps[first] += each + (rest > 0 ? 1 : 0);
  this->Steps[first + static_cast<std::size_t>(rest)] -= rest > 0 ? 1 : 0;
  this->Steps[last + 1] -= each;
  this->Total += weight;
}

//------------------------------------------------------------------------------
void ValueHistogram::Add(const ValueHistogram& other)
{
  for (std::size_t i = 0; i < this->Steps.size(); ++i)
  {
    this->Steps[i] += other.Steps[i];
  }
  this->Total += other.Total;
}

//------------------------------------------------------------------------------
// The fractions of the whole below the borders of the bins.
std::vector<double> ValueHistogram::GetSums() const
{
  std::vector<double> sums(Bins + 1, 0);
  const double total = this->Total > 0 ? static_cast<double>(this->Total) : 1;
  std::int64_t weight = 0;
  std::int64_t sum = 0;
  for (std::size_t bin = 0; bin < Bins; ++bin)
  {
    weight += this->Steps[bin];
    sum += weight;
    sums[bin + 1] = static_cast<double>(sum) / total;
  }
  return sums;
}

//------------------------------------------------------------------------------
std::vector<double> ValueHistogram::GetFractions(const Range& part, std::size_t bins) const
{
  const std::vector<double> sums = this->GetSums();
  const double first = this->GetPart(part.Min);
  const double last = this->GetPart(part.Max);
  const auto getSum = [&](std::size_t border)
  {
    if (border == 0 || border == bins)
    {
      return border == 0 ? 0 : sums.back();
    }
    const double along = static_cast<double>(border) / static_cast<double>(bins);
    const double at = (first * (1 - along) + last * along) * static_cast<double>(Bins);
    const auto bin = std::min(static_cast<std::size_t>(at), Bins - 1);
    const double within = at - static_cast<double>(bin);
    return sums[bin] * (1 - within) + sums[bin + 1] * within;
  };
  std::vector<double> fractions(bins);
  for (std::size_t i = 0; i < bins; ++i)
  {
    fractions[i] = std::max(0., getSum(i + 1) - getSum(i));
  }
  return fractions;
}

//------------------------------------------------------------------------------
Range ValueHistogram::GetInnerRange(double fraction) const
{
  if (!this->HasExtent() || this->Total == 0)
  {
    return this->Values;
  }
  const std::vector<double> sums = this->GetSums();
  const auto first = std::upper_bound(sums.begin(), sums.end(), fraction) - sums.begin() - 1;
  const auto last =
    std::lower_bound(sums.begin(), sums.end(), sums.back() - fraction) - sums.begin();
  const auto bins = static_cast<double>(Bins);
  return { this->GetValue(static_cast<double>(std::max<std::ptrdiff_t>(first, 0)) / bins),
    this->GetValue(static_cast<double>(std::max<std::ptrdiff_t>(last, first + 1)) / bins) };
}

//------------------------------------------------------------------------------
double ValueHistogram::CountBins(const Range& range) const
{
  return (this->GetPart(range.Max) - this->GetPart(range.Min)) * static_cast<double>(Bins);
}

//------------------------------------------------------------------------------
ValueHistogram MakeValueHistogram(
  const Range& range, const std::function<void(ValueHistogram&)>& fill)
{
  ValueHistogram whole(range);
  fill(whole);
  const auto getInner = [](const ValueHistogram& histogram)
  { return histogram.GetInnerRange(ValueHistogram::OuterFraction); };
  const auto isResolved = [&](const ValueHistogram& histogram, double bins)
  { return !histogram.HasExtent() || histogram.CountBins(getInner(histogram)) >= bins; };
  if (isResolved(whole, LeastInnerBins))
  {
    return whole;
  }
  // The range may be wider than the inner one by any number of magnitudes.
  ValueHistogram histogram(whole.GetRange(), ValueHistogram::Scale::Logarithmic);
  fill(histogram);
  for (int narrowed = 0; narrowed < 2; ++narrowed)
  {
    const Range inner = getInner(histogram);
    histogram = ValueHistogram(inner);
    fill(histogram);
    if (isResolved(histogram, LeastInnerBins))
    {
      return histogram;
    }
  }
  // If nearly everything has one value, no range resolves it.
  return isResolved(histogram, 2) ? histogram : whole;
}
}
