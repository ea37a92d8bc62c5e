// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunResidual_h
#define gatunResidual_h

#include "gatunEntropy.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace gatun
{
/** A running mean of the lengths of residuals in bits. */
class RunningSpread
{
public:
  unsigned Get() const { return this->Sum >> 2; }
  void Add(std::int64_t residual)
  {
    const auto magnitude = residual < 0 ? 0 - static_cast<std::uint64_t>(residual)
                                        : static_cast<std::uint64_t>(residual);
    this->Sum += static_cast<unsigned>(std::bit_width(magnitude)) - this->Get();
  }

private:
  unsigned Sum = 4 * 20;
};

/** Models the lengths of residuals in bits, relative to the length of a typical one. */
class LengthModel
{
public:
  /** Codes a length from 0 to 64. spread: that of a typical residual. */
  template <typename Coder>
  unsigned Code(Coder& coder, int spread, int length)
  {
    int symbol = length - spread + NearShift;
    symbol = length == 0 ? 0 : symbol >= 1 && symbol < static_cast<int>(Escape) ? symbol : Escape;
    const auto near = coder.Symbol(this->Near, static_cast<unsigned>(symbol));
    this->Kind = near;
    if (near == 0)
    {
      return 0;
    }
    int coded = static_cast<int>(near) + spread - NearShift;
    if (near == Escape)
    {
      symbol = length - spread + FarShift;
      symbol = symbol >= 1 && symbol < static_cast<int>(SymbolModel::Symbols) ? symbol : 0;
      const auto far = coder.Symbol(this->Far, static_cast<unsigned>(symbol));
      coded = far != 0 ? static_cast<int>(far) + spread - FarShift
                       : static_cast<int>(coder.Raw(static_cast<unsigned>(length), 7));
      this->Kind = Escape + far;
    }
    if (coded < 1 || coded > 64)
    {
      ThrowCorrupt("a residual has an impossible length");
    }
    return static_cast<unsigned>(coded);
  }

  static constexpr unsigned Kinds = 2 * SymbolModel::Symbols;

  /** The symbols of the last length, as a number below Kinds. */
  unsigned GetKind() const { return this->Kind; }

private:
  // Symbols of Near: 0 is a residual of 0, 1 to 14 are lengths around the spread, 15 is an escape.
  // Symbols of Far: 0 is a raw length, 1 to 15 are lengths far below the spread.
  static constexpr int NearShift = 12;
  static constexpr int FarShift = 27;
  static constexpr unsigned Escape = SymbolModel::Symbols - 1;

  SymbolModel Near;
  unsigned Kind = 0;
  SymbolModel Far;
};

/** Models residuals in one context. */
class ResidualModel
{
public:
  /**
   * Codes a residual: its length in bits relative to spread (the length of a typical difference),
   * its sign, its second bit, and the raw remaining bits. Returns the residual.
   */
  template <typename Coder>
  std::int64_t Code(Coder& coder, unsigned spread, std::int64_t residual)
  {
    std::uint64_t magnitude = static_cast<std::uint64_t>(residual);
    magnitude = residual < 0 ? 0 - magnitude : magnitude;
    const auto length = this->Length.Code(
      coder, static_cast<int>(spread), static_cast<int>(std::bit_width(magnitude)));
    if (length == 0)
    {
      this->Grade = 0;
      return 0;
    }
    const auto relative = static_cast<int>(length) - static_cast<int>(spread);
    this->Grade = relative < -7 ? 1 : relative < -3 ? 2 : 3;
    const std::uint64_t sign = coder.Bit(this->Sign, residual < 0);
    magnitude = this->CodeMagnitude(coder, length, magnitude);
    // The two's complement without a branch, because signs are unpredictable.
    return static_cast<std::int64_t>((magnitude ^ (0 - sign)) + sign);
  }

  /** Grades the last residual from 0 (it was 0) to 3. */
  unsigned Grade = 0;

private:
  template <typename Coder>
  std::uint64_t CodeMagnitude(Coder& coder, unsigned length, std::uint64_t magnitude)
  {
    if (length == 1)
    {
      return 1;
    }
    const unsigned low = length - 2;
    const std::uint64_t second =
      coder.Bit(this->Second[this->Length.GetKind()], (magnitude >> low) & 1);
    const std::uint64_t rest = coder.Raw(magnitude & ((std::uint64_t{ 1 } << low) - 1), low);
    return (std::uint64_t{ 2 } | second) << low | rest;
  }

  LengthModel Length;
  BitModel Sign;
  std::array<BitModel, LengthModel::Kinds> Second;
};
}

#endif
