// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBoundedValues_h
#define gatunBoundedValues_h

#include "gatunBoundedSteps.h"
#include "gatunDomain.h"
#include "gatunEntropy.h"
#include "gatunGuess.h"
#include "gatunNumberModel.h"
#include "gatunResidual.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Codes the values of a component that may have an error, as numbers of steps away from the
 * prediction. See Documentation/format.md, 10.7.
 */
class BoundedValues
{
public:
  static constexpr bool IsBounded = true;

  /** count: the number of places of values. onLattice: whether values are places of the lattice
   * already, and are to be coded as they are. */
  BoundedValues(const Domain& domain, std::size_t count, bool onLattice)
    : Values(domain)
    , Rule(domain, domain.GetQuantizer(), onLattice)
    , Steps(count, Unknown)
  {
  }

  const Domain& GetDomain() const { return this->Values; }

  /** The number of a key for predictions: the last finite one before it stands for NaN and
   * infinity. */
  double ToNumber(Key key)
  {
    const double number = this->Values.ToNumber(key);
    this->LastNumber = std::isfinite(number) ? number : this->LastNumber;
    return this->LastNumber;
  }

  /** Adds a place around the next value, if that has a guess without an error. Its own value may be
   * unknown. */
  void AddNeighbor(std::size_t place)
  {
    const auto steps = this->Steps[place];
    if (steps != Unknown)
    {
      ++this->Neighbors;
      this->Magnitudes += static_cast<std::uint64_t>(steps < 0 ? -std::int64_t{ steps } : steps);
      this->Sum += steps;
    }
  }

  /** Codes the value at a place. Returns the key of the value that readers will have. */
  template <typename Coder>
  Key Code(Coder& coder, const Guess& guess, std::size_t place, Key actual)
  {
    const auto context = this->TakeContext(guess);
    const auto origin = this->Rule.FindOrigin(guess);
    std::int64_t steps = 0;
    bool isSpecial = false;
    Key key = actual;
    if constexpr (Coder::Encoding)
    {
      isSpecial = !this->Rule.FindSteps(origin, actual, steps, key);
    }
    isSpecial = coder.Bit(this->Special[this->WasSpecial], isSpecial);
    this->WasSpecial = isSpecial;
    if (isSpecial)
    {
      return this->CodeSpecial(coder, guess, actual);
    }
    steps = this->CodeSteps(coder, context, steps);
    const auto kept = std::clamp<std::int64_t>(steps, -MaxKept, MaxKept);
    this->Steps[place] = static_cast<std::int32_t>(kept);
    const auto magnitude = static_cast<std::uint64_t>(kept < 0 ? -kept : kept);
    this->Mean += (magnitude << 4) - (this->Mean >> 4);
    return Coder::Encoding ? key : this->Rule.GetKey(origin, steps);
  }

private:
  static constexpr std::int32_t Unknown = INT32_MIN;
  static constexpr std::int64_t MaxKept = 1 << 30;
  static constexpr unsigned Classes = 32;
  static constexpr unsigned Signs = 3;
  static constexpr unsigned Ones = 14; // decisions of a number of steps that have a model each

  /** Context of a number of steps. */
  struct Context
  {
    unsigned Class = 0;
    unsigned Sign = 0;
    unsigned Shift = 0;
  };

  Context TakeContext(const Guess& guess)
  {
    std::uint64_t mean = 0; // of the magnitudes to expect, in sixteenths
    Context context;
    if (guess.Error >= 0)
    {
      mean = this->ToSixteenths(guess);
    }
    else
    {
      // The running mean counts half a neighbor.
      const std::uint64_t all = 32 * this->Magnitudes + (this->Mean >> 4);
      mean = all / (2 * this->Neighbors + 1);
      context.Sign = this->Sum < 0 ? 1 : this->Sum > 0 ? 2 : 0;
    }
    const auto length = static_cast<unsigned>(std::bit_width(mean));
    const auto half = length > 1 ? static_cast<unsigned>(mean >> (length - 2)) & 1u : 0u;
    context.Class = length > 1 ? std::min(2 * length - 2 + half, Classes - 1) : length;
    context.Shift = length > 6 ? length - 6 : 0;
    this->Neighbors = 0;
    this->Magnitudes = 0;
    this->Sum = 0;
    return context;
  }

  /** The error of a guess in sixteenths of a step. */
  std::uint64_t ToSixteenths(const Guess& guess) const
  {
    constexpr double most = 1ull << 40;
    const auto& rounding = this->Values.GetQuantizer();
    const bool roundsKeys = rounding.RoundsKeys(this->Values.GetType());
    const double error = roundsKeys
      ? static_cast<double>(guess.GetErrorInKeys(this->Values, guess.GetKey(this->Values)))
      : guess.Error;
    const double count = error * 16 / (roundsKeys ? rounding.Step : 2 * rounding.Step);
    return static_cast<std::uint64_t>((count < most ? count : most) + 0.5);
  }

  template <typename Coder>
  std::int64_t CodeSteps(Coder& coder, const Context& context, std::int64_t steps)
  {
    // The high part is rounded down, so that the low bits are the same for both signs.
    const std::int64_t high = steps >> context.Shift;
    auto magnitude = static_cast<std::uint64_t>(high < 0 ? -high : high);
    std::int64_t coded = 0;
    if (coder.Bit(this->NotZero[context.Class][context.Sign], magnitude != 0))
    {
      const bool negative = coder.Bit(this->Negative[context.Class][context.Sign], high < 0);
      coded = static_cast<std::int64_t>(this->CodeMagnitude(coder, context.Class, magnitude));
      coded = negative ? -coded : coded;
    }
    const auto mask = (std::uint64_t{ 1 } << context.Shift) - 1;
    const auto low = coder.Raw(static_cast<std::uint64_t>(steps) & mask, context.Shift);
    return static_cast<std::int64_t>((static_cast<std::uint64_t>(coded) << context.Shift) + low);
  }

  /** A number of 1 and more. */
  template <typename Coder>
  std::uint64_t CodeMagnitude(Coder& coder, unsigned kind, std::uint64_t magnitude)
  {
    for (unsigned i = 0; i < Ones; ++i)
    {
      if (!coder.Bit(this->More[kind][i], magnitude > i + 1))
      {
        return i + 1;
      }
    }
    const std::uint64_t rest = magnitude - Ones; // 1 and more
    const auto length = this->Length.Code(coder, static_cast<unsigned>(std::bit_width(rest)));
    if (length == 0 || length > 47)
    {
      ThrowCorrupt("a value is too many steps away");
    }
    const auto top = std::uint64_t{ 1 } << (length - 1);
    return Ones + (top | coder.Raw(rest & (top - 1), length - 1));
  }

  /** A value that has no number of steps: exact. */
  template <typename Coder>
  Key CodeSpecial(Coder& coder, const Guess& guess, Key actual)
  {
    const auto& domain = this->Values;
    const auto number = [&](Key key) { return domain.ToNumber(key); };
    unsigned kind = Nearby;
    if constexpr (Coder::Encoding)
    {
      kind = actual == this->Rule.GetZero() ? IsZero
        : actual == this->LastRaw           ? Again
        : std::isfinite(number(actual))     ? Nearby
                                            : Raw;
    }
    kind = this->Kind.Code(coder, kind);
    if (kind == IsZero)
    {
      return this->Rule.GetZero();
    }
    if (kind == Nearby)
    {
      const Key predicted = guess.GetKey(domain);
      const auto residual = this->Exact.Code(
        coder, this->Spread.Get(), Coder::Encoding ? domain.Subtract(actual, predicted) : 0);
      this->Spread.Add(residual);
      return domain.Add(predicted, residual);
    }
    if (kind == Raw)
    {
      this->LastRaw = coder.Raw(actual, domain.GetBits());
    }
    return this->LastRaw;
  }

  // The kinds of values that have no number of steps.
  static constexpr unsigned IsZero = 0;
  static constexpr unsigned Nearby = 1; // a residual follows
  static constexpr unsigned Raw = 2;
  static constexpr unsigned Again = 3; // the last raw one

  const Domain& Values;
  const BoundedSteps<Domain> Rule;

  std::vector<std::int32_t> Steps; // of each place
  double LastNumber = 0;
  std::uint64_t Neighbors = 0;
  std::uint64_t Magnitudes = 0;
  std::int64_t Sum = 0;
  std::uint64_t Mean = 256; // running, of 256 times the magnitude

  bool WasSpecial = false;
  std::array<BitModel, 2> Special;
  BitTree<2> Kind;
  Key LastRaw = 0;
  ResidualModel Exact;
  RunningSpread Spread;

  std::array<std::array<BitModel, Signs>, Classes> NotZero;
  std::array<std::array<BitModel, Signs>, Classes> Negative;
  std::array<std::array<BitModel, Ones>, Classes> More;
  BitTree<6> Length;
};
}

#endif
