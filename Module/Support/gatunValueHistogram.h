// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunValueHistogram_h
#define gatunValueHistogram_h

#include "gatunExport.h"
#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace gatun
{
/**
 * How much of an object has which values, in equal bins of a scale. Weights are integers, so that
 * the result does not depend on the order of the additions.
 */
class GATUN_EXPORT ValueHistogram
{
public:
  static constexpr std::size_t Bins = 4096;

  /** Fraction of the whole at each end of the range that may be outliers. */
  static constexpr double OuterFraction = 0.0005;

  enum class Scale
  {
    Linear,
    Logarithmic ///< of both signs, for all magnitudes
  };

  /** Range: of the values. If it is one value, or empty, everything is in one place. Scale: on
   * which the bins are equal. */
  explicit ValueHistogram(const Range& range, Scale scale = Scale::Linear);

  /** Adds a part of the object whose values are evenly distributed from low to high. Values beyond
   * the range count at its ends. NaN is left out. */
  void Add(double low, double high, std::uint64_t weight);

  /** An empty one with the same bins. */
  ValueHistogram MakeEmpty() const { return ValueHistogram(this->Values, this->BinScale); }

  /** Adds another one with the same bins. */
  void Add(const ValueHistogram& other);

  const Range& GetRange() const { return this->Values; }
  std::uint64_t GetTotal() const { return this->Total; }

  /** Whether the range has more than one value. */
  bool HasExtent() const { return this->Values.Min < this->Values.Max; }

  /** The value at a part of the range, from 0 to 1. */
  double GetValue(double part) const;

  /** The fractions of the whole in a number of equal bins over a part of the range. Values beyond
   * that part count at its ends. All zero if there is nothing. */
  std::vector<double> GetFractions(const Range& part, std::size_t bins) const;

  /** The number of bins over a range. */
  double CountBins(const Range& range) const;

  /** The range of values without a fraction of the whole below and the same fraction above. */
  Range GetInnerRange(double fraction) const;

private:
  std::size_t FindBin(double value) const;
  double GetPart(double value) const;
  double ToScale(double value) const;
  std::vector<double> GetSums() const;

  Range Values;
  Scale BinScale;
  Range Scaled;                    // the same on the scale
  std::vector<std::int64_t> Steps; // of the weight from each bin to the next
  std::uint64_t Total = 0;
};

/** Makes a histogram that resolves the values of nearly the whole object. Range: of all values.
 * Values that are not finite do not count. Fill adds the object to a histogram; it is called again,
 * at most three times, if a few values are far from all others. */
GATUN_EXPORT ValueHistogram MakeValueHistogram(
  const Range& range, const std::function<void(ValueHistogram&)>& fill);
}

#endif
