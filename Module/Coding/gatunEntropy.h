// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunEntropy_h
#define gatunEntropy_h

// Entropy coding of binary decisions: adaptive probabilities and an asymmetric numeral system
// (range variant, rANS). J. Duda, "Asymmetric numeral systems", arXiv:1311.2540, 2013.
// The streams are specified in Documentation/format.md, "Entropy coding".

#include "gatunBytes.h"
#include "gatunInline.h"
#include "gatunLanes.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/** A stream has at least one byte for this number of tetrahedra, of points of a shared block, or of
 * values of a palette. This bounds the memory that a short file can request. */
constexpr std::uint32_t MaxItemsPerByte = 256;

/**
 * Adaptive probability that a decision is 1: 22 bits of probability and a count. The first
 * decisions have more weight than later ones.
 */
class BitModel
{
public:
  static constexpr unsigned Bits = 16; // of the probabilities
  static constexpr unsigned CountBits = 10;
  static constexpr unsigned Limit = 250;

  /** In units of 2^-16, from 1 to 65535. */
  std::uint32_t GetProbability() const
  {
    const std::uint32_t p = this->State >> 16;
    return p + (p == 0);
  }

  void Update(bool bit)
  {
    const std::uint32_t count = this->State & ((1u << CountBits) - 1);
    const auto p = static_cast<std::int64_t>(this->State >> CountBits);
    const std::int64_t target = static_cast<std::int64_t>(bit) << 22;
    const std::int64_t moved = p + (((target - p) * Rates[count]) >> 16);
    this->State =
      (static_cast<std::uint32_t>(moved) << CountBits) | (count + (count < Limit ? 1 : 0));
  }

private:
  static constexpr auto Rates = []
  {
    std::array<std::int32_t, Limit + 1> rates{};
    for (unsigned n = 0; n <= Limit; ++n)
    {
      rates[n] = static_cast<std::int32_t>(131072u / (2 * n + 3)); // 1 / (n + 1.5)
    }
    return rates;
  }();

  std::uint32_t State = 1u << 31;
};

/**
 * Adaptive probabilities of 16 symbols in units of 2^-15. Symbol s has the interval from Starts[s]
 * to Starts[s + 1], or to 2^15 for the last symbol.
 */
class SymbolModel
{
public:
  static constexpr unsigned Symbols = 16;
  static constexpr unsigned Bits = 15;

  std::uint32_t GetStart(unsigned symbol) const { return this->Read(symbol); }
  std::uint32_t GetWidth(unsigned symbol) const
  {
    const std::uint32_t end = symbol + 1 < Symbols ? this->Read(symbol + 1) : 1u << Bits;
    return end - this->Read(symbol);
  }

  /** The symbol whose interval contains a number below 2^15. */
  unsigned Find(std::uint32_t number) const
  {
    return CountUpTo(this->Starts[0], this->Starts[1], static_cast<std::int16_t>(number)) - 1;
  }

  void Update(unsigned symbol)
  {
    const auto& target = Targets[symbol];
    const int rate = Rates[this->Count];
    this->Starts[0] = Approach(this->Starts[0], target[0], rate);
    this->Starts[1] = Approach(this->Starts[1], target[1], rate);
    this->Count += this->Count < Limit;
  }

private:
  static constexpr unsigned Limit = 63;
  static constexpr int Least = 4; // width of a symbol that does not occur

  using Row = std::array<Short8, 2>;

  std::uint32_t Read(unsigned symbol) const
  {
    return static_cast<std::uint32_t>(this->Starts[symbol / 8][symbol % 8]);
  }

  // The limits of the starts if only one symbol occurs.
  static constexpr auto Targets = []
  {
    constexpr auto row = [](int symbol) -> Row
    {
      const auto at = [&](int i)
      {
        const int low = Least * i;
        const int high = (1 << Bits) - Least * (static_cast<int>(Symbols) - i);
        return static_cast<std::int16_t>(i <= symbol ? low : high);
      };
      return { Short8{ at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7) },
        Short8{ at(8), at(9), at(10), at(11), at(12), at(13), at(14), at(15) } };
    };
    return std::array<Row, Symbols>{ row(0), row(1), row(2), row(3), row(4), row(5), row(6), row(7),
      row(8), row(9), row(10), row(11), row(12), row(13), row(14), row(15) };
  }();

  static constexpr auto Rates = []
  {
    std::array<std::uint8_t, Limit + 1> rates{};
    for (unsigned n = 0; n <= Limit; ++n)
    {
      rates[n] = static_cast<std::uint8_t>(n < 2 ? 2 : n < 6 ? 3 : n < 16 ? 4 : n < 48 ? 5 : 6);
    }
    return rates;
  }();

  // All symbols are equally likely at first.
  Row Starts{ Short8{ 0, 2048, 4096, 6144, 8192, 10240, 12288, 14336 },
    Short8{ 16384, 18432, 20480, 22528, 24576, 26624, 28672, 30720 } };
  std::uint32_t Count = 0;
};

/**
 * Collects decisions, symbols and raw bits, and writes them as one stream at the end, because rANS
 * encodes the last decision first.
 */
class EntropyEncoder
{
public:
  static constexpr bool Encoding = true;

  bool Bit(BitModel& model, bool bit)
  {
    const auto p = model.GetProbability();
    this->Parts.push_back(
      { bit ? 0 : p, static_cast<std::uint16_t>(bit ? p : 65536 - p), BitModel::Bits });
    model.Update(bit);
    return bit;
  }

  unsigned Symbol(SymbolModel& model, unsigned symbol)
  {
    this->Parts.push_back({ model.GetStart(symbol),
      static_cast<std::uint16_t>(model.GetWidth(symbol)), SymbolModel::Bits });
    model.Update(symbol);
    return symbol;
  }

  /** Adds the low bits of a value without modeling; count is 0 to 64. */
  std::uint64_t Raw(std::uint64_t value, unsigned count);

  /** The approximate length of the stream in bits. */
  double EstimateBits() const;

  /** Returns the length of the rANS part as a varint, the rANS part, and the raw bits. */
  Bytes Finish();

private:
  /** The interval of 2^Bits that represents a decision. */
  struct Part
  {
    std::uint32_t Start;
    std::uint16_t Width;
    std::uint16_t Bits;
  };

  std::vector<Part> Parts;
  Bytes RawBytes;
  std::uint64_t Pending = 0;
  unsigned PendingBits = 0;
};

/** Reads the output of EntropyEncoder. Safe on hostile input: a damaged stream yields wrong values
 * or throws Error(Corrupt). */
class EntropyDecoder
{
public:
  static constexpr bool Encoding = false;

  explicit EntropyDecoder(std::span<const std::uint8_t> stream);

  GATUN_INLINE bool Bit(BitModel& model, bool = false)
  {
    const std::uint64_t p = model.GetProbability();
    const std::uint64_t slot = this->State & 0xffff;
    const bool bit = slot < p;
    // Without branches, because many decisions are unpredictable.
    const std::uint64_t mask = std::uint64_t{ 0 } - bit;
    const std::uint64_t part = p * (this->State >> 16);
    const std::uint64_t one = part + slot;
    const std::uint64_t zero = this->State - part - p;
    this->State = zero ^ ((one ^ zero) & mask);
    if (this->State < (std::uint64_t{ 1 } << 32))
    {
      this->Refill();
    }
    model.Update(bit);
    return bit;
  }

  GATUN_INLINE unsigned Symbol(SymbolModel& model, unsigned = 0)
  {
    const auto slot = static_cast<std::uint32_t>(this->State) & ((1u << SymbolModel::Bits) - 1);
    const unsigned symbol = model.Find(slot);
    this->State =
      model.GetWidth(symbol) * (this->State >> SymbolModel::Bits) + slot - model.GetStart(symbol);
    if (this->State < (std::uint64_t{ 1 } << 32))
    {
      this->Refill();
    }
    model.Update(symbol);
    return symbol;
  }

  std::uint64_t Raw(std::uint64_t, unsigned count)
  {
    if (count > 32)
    {
      const auto low = this->Take(32);
      return low | (this->Take(count - 32) << 32);
    }
    return this->Take(count);
  }

private:
  void Refill()
  {
    std::uint32_t word = 0;
    if (this->WordEnd - this->Word >= 4)
    {
      std::memcpy(&word, this->Word, 4);
      this->Word += 4;
    }
    else
    {
      ThrowEnd();
    }
    this->State = (this->State << 32) | word;
  }

  /** count is at most 32. */
  std::uint64_t Take(unsigned count)
  {
    if (this->RawEnd - this->RawNext >= 8)
    {
      // Fills up to at least 56 bits without a branch.
      std::uint64_t next = 0;
      std::memcpy(&next, this->RawNext, 8);
      this->Pending |= next << this->PendingBits;
      this->RawNext += (63 - this->PendingBits) >> 3;
      this->PendingBits |= 56;
    }
    else
    {
      this->FillAtEnd(count);
    }
    const std::uint64_t value = this->Pending & ((std::uint64_t{ 1 } << count) - 1);
    this->Pending >>= count;
    this->PendingBits -= count;
    return value;
  }

  void FillAtEnd(unsigned count);
  [[noreturn]] static void ThrowEnd();

  std::uint64_t State = 0;
  std::uint64_t Pending = 0;
  const std::uint8_t* Word = nullptr;
  const std::uint8_t* WordEnd = nullptr;
  const std::uint8_t* RawNext = nullptr;
  const std::uint8_t* RawEnd = nullptr;
  unsigned PendingBits = 0;
};
}

#endif
