// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPlainResiduals_h
#define gatunPlainResiduals_h

#include "gatunPlainKeys.h"
#include "gatunResidual.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace gatun
{
/**
 * The residuals of a component in the mode PlainQuadratic: differences of keys, or numbers of steps
 * if there is a bound of errors. They are coded without regard to predictions, so all of them are
 * decoded before the values. Only lengths have a model: that is fast. See Documentation/format.md,
 * 10.11.
 */
class PlainResiduals
{
public:
  /** Stands for a value that has no number of steps. Its key is the next one of Keys. */
  static constexpr std::int64_t NoSteps = std::numeric_limits<std::int64_t>::min();

  /** bits: those of keys. zero: the key of the number 0. */
  PlainResiduals(unsigned bits, Key zero)
    : Bits(bits)
    , Zero(zero)
  {
  }

  /** Codes a number of residuals. */
  template <typename Coder>
  void Code(Coder& coder, std::size_t count)
  {
    this->Residuals.resize(count);
    std::array<LengthModel, Contexts> lengths;
    RunningSpread running;
    for (auto& residual : this->Residuals)
    {
      const bool isSpecial = this->IsBounded && residual == NoSteps;
      const auto magnitude = residual < 0 ? 0 - static_cast<std::uint64_t>(residual)
                                          : static_cast<std::uint64_t>(residual);
      const auto spread = running.Get();
      const auto length = lengths[std::min(spread, Contexts - 1)].Code(coder,
        static_cast<int>(spread),
        isSpecial ? static_cast<int>(SpecialLength) : static_cast<int>(std::bit_width(magnitude)));
      if (this->IsBounded && length > MostSteps)
      {
        this->CodeSpecial(coder, length);
        residual = NoSteps;
        continue;
      }
      residual = CodeRest(coder, length, residual, magnitude);
      running.Add(residual);
    }
  }

  bool IsBounded = false; ///< whether residuals are numbers of steps
  std::vector<std::int64_t> Residuals;
  std::vector<Key> Keys;

private:
  static constexpr unsigned Contexts = 16;
  static constexpr unsigned MostSteps = 46; // bits of their number
  static constexpr unsigned SpecialLength = 64;

  // The kinds of values that have no number of steps.
  static constexpr unsigned IsZero = 0;
  static constexpr unsigned Again = 1; // the last raw one
  static constexpr unsigned Raw = 2;

  /** Codes the sign, as the lowest bit, and the bits below the highest one of the magnitude. */
  template <typename Coder>
  static std::int64_t CodeRest(
    Coder& coder, unsigned length, std::int64_t residual, std::uint64_t magnitude)
  {
    const std::uint64_t top = length == 0 ? 0 : std::uint64_t{ 1 } << (length - 1);
    const std::uint64_t rest =
      coder.Raw((magnitude & (top - 1)) << 1 | static_cast<std::uint64_t>(residual < 0), length);
    const std::uint64_t sign = rest & 1;
    // The two's complement without a branch, because signs are unpredictable.
    return static_cast<std::int64_t>(((top | rest >> 1) ^ (0 - sign)) + sign);
  }

  template <typename Coder>
  void CodeSpecial(Coder& coder, unsigned length)
  {
    if (length != SpecialLength)
    {
      ThrowCorrupt("a value is too many steps away");
    }
    const Key key = Coder::Encoding ? this->Keys[this->Specials++] : 0;
    const auto kind = static_cast<unsigned>(coder.Raw(key == this->Zero ? IsZero
        : key == this->Last                                             ? Again
                                                                        : Raw,
      2));
    if (kind > Raw)
    {
      ThrowCorrupt("a value is of an unknown kind");
    }
    if (kind == Raw)
    {
      this->Last = coder.Raw(key, this->Bits);
    }
    if constexpr (!Coder::Encoding)
    {
      this->Keys.push_back(kind == IsZero ? this->Zero : this->Last);
    }
  }

  const unsigned Bits;
  const Key Zero;
  std::size_t Specials = 0; // that are encoded
  Key Last = 0;             // the last raw key
};
}

#endif
