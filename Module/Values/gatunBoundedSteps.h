// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBoundedSteps_h
#define gatunBoundedSteps_h

#include "gatunDomain.h"
#include "gatunGuess.h"
#include "gatunQuantizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Whether exact values take fewer bits than steps: these are finer than most numbers. */
inline bool AreStepsTooFine(const Domain& domain, std::span<const Key> keys)
{
  std::vector<double> magnitudes;
  for (const auto key : keys)
  {
    const double number = std::abs(domain.ToNumber(key));
    if (std::isfinite(number) && number > 0)
    {
      magnitudes.push_back(number);
    }
  }
  if (magnitudes.empty() || domain.GetQuantizer().RoundsKeys(domain.GetType()))
  {
    return false;
  }
  const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
  std::nth_element(magnitudes.begin(), middle, magnitudes.end());
  const Key key = domain.FromNumber(*middle);
  return domain.ToNumber(key + 1) - domain.ToNumber(key) > 2 * domain.GetQuantizer().Step;
}

/**
 * The values that are a number of steps away from the prediction. See Documentation/format.md,
 * 10.7. AnyDomain: Domain, or one of its special cases.
 */
template <typename AnyDomain>
class BoundedSteps
{
public:
  /** The magnitude of steps is less than this. */
  static constexpr std::int64_t End = std::int64_t{ 1 } << 46;

  /** The value from which steps are counted. */
  struct Origin
  {
    double Number = 0;
    double Index = 0; // on a lattice of numbers
    Key Plain = 0;
    std::int64_t KeyIndex = 0; // on a lattice of keys
  };

  /** onLattice: whether values are places of the lattice already. */
  BoundedSteps(const AnyDomain& domain, const Quantizer& rounding, bool onLattice)
    : Values(domain)
    , Rounding(rounding)
    , OnLattice(onLattice)
    , RoundsKeys(rounding.RoundsKeys(domain.GetType()))
    , Zero(domain.FromNumber(0))
    , KeyStep(this->RoundsKeys ? static_cast<std::uint64_t>(rounding.Step) : 0)
    , Width(2 * rounding.Step)
  {
  }

  /** The key of the number 0. */
  Key GetZero() const { return this->Zero; }

  Origin FindOrigin(const Guess& guess) const
  {
    Origin origin;
    if (this->RoundsKeys)
    {
      origin.Plain = guess.GetKey(this->Values);
      origin.KeyIndex = this->OnLattice ? GetKeyIndex(origin.Plain, this->Zero, this->KeyStep) : 0;
    }
    else
    {
      origin.Number = guess.GetNumber(this->Values);
      origin.Index = this->OnLattice ? GetNumberIndex(origin.Number, this->Width) : 0;
    }
    return origin;
  }

  Key GetKey(const Origin& origin, std::int64_t steps) const
  {
    if (this->RoundsKeys)
    {
      const auto index = static_cast<std::int64_t>(
        static_cast<std::uint64_t>(origin.KeyIndex) + static_cast<std::uint64_t>(steps));
      return this->Values.Add(0,
        static_cast<std::int64_t>(this->OnLattice
            ? GetIndexKey(index, this->Zero, this->KeyStep)
            : GetIndexKey(steps, origin.Plain, this->KeyStep)));
    }
    const auto number = static_cast<double>(steps);
    return this->Values.FromNumber(this->OnLattice ? (origin.Index + number) * this->Width
                                                   : origin.Number + number * this->Width);
  }

  /** Finds the steps to a value, or to one within the bound, and its key. Returns false if there
   * are none. */
  bool FindSteps(const Origin& origin, Key actual, std::int64_t& steps, Key& key) const
  {
    const auto type = this->Values.GetType();
    std::int64_t best = 0;
    if (this->RoundsKeys)
    {
      const auto unit = this->OnLattice ? this->Zero : origin.Plain;
      best = static_cast<std::int64_t>(
        static_cast<std::uint64_t>(GetKeyIndex(actual, unit, this->KeyStep)) -
        static_cast<std::uint64_t>(origin.KeyIndex));
    }
    else
    {
      const double number = this->Values.ToNumber(actual);
      const double away = this->OnLattice ? number / this->Width - origin.Index
                                          : (number - origin.Number) / this->Width;
      if (!(std::abs(away) < static_cast<double>(End)))
      {
        return false;
      }
      best = static_cast<std::int64_t>(away < 0 ? -std::floor(0.5 - away) : std::floor(away + 0.5));
    }
    for (const auto other : std::array{ best, best + 1, best - 1 })
    {
      if (other <= -End || other >= End)
      {
        continue;
      }
      steps = other;
      key = this->GetKey(origin, other);
      if (this->OnLattice ? key == actual : this->Rounding.IsWithin(type, actual, key))
      {
        return true;
      }
    }
    return false;
  }

private:
  const AnyDomain Values; // a copy: small, and so the compiler knows that it does not change
  const Quantizer Rounding;
  const bool OnLattice;
  const bool RoundsKeys;
  const Key Zero;
  const std::uint64_t KeyStep;
  const double Width;
};
}

#endif
