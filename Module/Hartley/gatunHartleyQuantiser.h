// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyQuantiser_h
#define gatunHartleyQuantiser_h

#include "gatunHartleyLayout.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** What turns coefficients into integers, and back. Part of a file. */
struct HartleySteps
{
  double Step = 1;   ///< of the lowest frequencies
  double Weight = 0; ///< HartleyQuality::FrequencyWeight

  /** By how much of a step values that became 1, 2, and 3 or more are smaller than that, on the
   * average; not used for frequency 0. */
  std::array<double, 3> Shifts{};

  /** Whether all values are rounded to the nearest, so that no error is larger than half a step;
   * otherwise those between two integers rather become the smaller one. */
  bool Nearest = false;

  bool operator==(const HartleySteps&) const = default;
};

/** Quantises blocks of one size. Immutable. */
class HartleyQuantiser
{
public:
  HartleyQuantiser(const HartleyLayout::Triple& block, const HartleySteps& steps);

  const HartleySteps& GetSteps() const { return this->Steps; }

  /** The coefficients of a block as integers, of at most 2^62. */
  void Quantise(std::span<const double> coefficients, std::span<std::int64_t> integers) const;

  /** An integer as a coefficient again, index as HartleyTransform has it. */
  double Restore(std::size_t index, std::int64_t integer) const
  {
    if (integer == 0)
    {
      return 0;
    }
    const double step = this->GetStep(index);
    if (index == 0)
    {
      return static_cast<double>(integer) * step;
    }
    const auto size = integer < 0 ? -integer : integer;
    const double shift = this->Steps.Shifts[size > 2 ? 2 : static_cast<std::size_t>(size) - 1];
    const double value = (static_cast<double>(size) - shift) * step;
    return integer < 0 ? -value : value;
  }

  /** All of a block. */
  void Restore(std::span<const std::int64_t> integers, std::span<double> coefficients) const;

  double GetStep(std::size_t index) const
  {
    return this->PerIndex.empty() ? this->Steps.Step : this->PerIndex[index];
  }

private:
  HartleySteps Steps;
  std::vector<double> PerIndex; ///< steps, if they differ
};

/** Collects the shifts of HartleySteps. */
struct HartleyShiftSums
{
  std::array<double, 3> Sums{};
  std::array<std::uint64_t, 3> Counts{};

  void Add(const HartleyQuantiser& quantiser, std::span<const double> coefficients,
    std::span<const std::int64_t> integers);
  void Add(const HartleyShiftSums& other);
  std::array<double, 3> Get() const;
};
}

#endif
