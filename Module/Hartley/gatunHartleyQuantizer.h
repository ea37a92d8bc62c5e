// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyQuantizer_h
#define gatunHartleyQuantizer_h

#include "gatunHartleyLayout.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The parameters of the quantizer, as stored in a file. */
struct HartleySteps
{
  double Step = 1;   ///< of the lowest frequencies
  double Weight = 0; ///< HartleyRateControl::FrequencyWeight

  /** The mean difference, in steps, between the integers 1, 2, 3 and more and the values that were
   * quantized to them. Not used for frequency 0. */
  std::array<double, 3> Shifts{};

  /** Whether all values are rounded to the nearest integer, which limits errors to half a step.
   * Otherwise rounding is biased toward 0. */
  bool Nearest = false;

  bool operator==(const HartleySteps&) const = default;
};

/** Quantizes and restores blocks of one size. Immutable. */
class HartleyQuantizer
{
public:
  HartleyQuantizer(const HartleyLayout::Triple& block, const HartleySteps& steps);

  const HartleySteps& GetSteps() const { return this->Steps; }

  /** Quantizes the coefficients of a block to integers of at most 2^62. */
  void Quantize(std::span<const double> coefficients, std::span<std::int64_t> integers) const;

  /** Restores a coefficient. Index: as in HartleyTransform. */
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

  /** Restores the coefficients of a block. */
  void Restore(std::span<const std::int64_t> integers, std::span<double> coefficients) const;

  double GetStep(std::size_t index) const
  {
    return this->PerIndex.empty() ? this->Steps.Step : this->PerIndex[index];
  }

private:
  HartleySteps Steps;
  std::vector<double> PerIndex; ///< steps; empty if they are equal
};

/** Measures HartleySteps::Shifts. */
struct HartleyShiftSums
{
  std::array<double, 3> Sums{};
  std::array<std::uint64_t, 3> Counts{};

  void Add(const HartleyQuantizer& quantizer, std::span<const double> coefficients,
    std::span<const std::int64_t> integers);
  void Add(const HartleyShiftSums& other);
  std::array<double, 3> Get() const;
};
}

#endif
