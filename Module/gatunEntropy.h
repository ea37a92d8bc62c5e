// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunEntropy_h
#define gatunEntropy_h

// Entropy coding of binary decisions: adaptive probabilities and an asymmetric numeral system
// (range variant, rANS). J. Duda, "Asymmetric numeral systems", arXiv:1311.2540, 2013.
// The streams are specified in Documentation/format.md, "Entropy coding".

#include "gatunBytes.h"
#include "gatunInline.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * The probability that a decision is 1, learnt from the decisions seen so far: 22 bits of
 * probability and a count that makes the first decisions weigh more than the later ones.
 */
class BitModel
{
public:
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
 * Collects decisions and raw bits, and writes them as one stream when all are there.
 * The rANS part has to be written last decision first, hence the collecting.
 */
class EntropyEncoder
{
public:
  static constexpr bool Encoding = true;

  bool Bit(BitModel& model, bool bit)
  {
    const auto p = model.GetProbability();
    this->Decisions.push_back((p << 1) | static_cast<std::uint32_t>(bit));
    model.Update(bit);
    return bit;
  }

  /** The low count bits of value as they are; count from 0 to 64. */
  std::uint64_t Raw(std::uint64_t value, unsigned count);

  /** Length of the stream in bits, nearly. */
  double EstimateBits() const;

  /** Length of the rANS part as a varint, the rANS part, the raw bits. */
  Bytes Finish();

private:
  std::vector<std::uint32_t> Decisions;
  Bytes RawBytes;
  std::uint64_t Pending = 0;
  unsigned PendingBits = 0;
};

/** Reads what EntropyEncoder wrote. A damaged stream gives wrong values or throws; never more. */
class EntropyDecoder
{
public:
  static constexpr bool Encoding = false;

  explicit EntropyDecoder(std::span<const std::uint8_t> stream);

  GATUN_INLINE bool Bit(BitModel& model, bool = false)
  {
    const std::uint64_t p = model.GetProbability();
    const std::uint64_t slot = this->State & 0xffff;
    const std::uint64_t rest = this->State >> 16;
    const bool bit = slot < p;
    // Without branches, as many decisions are as good as random.
    const std::uint64_t mask = std::uint64_t{ 0 } - bit;
    const std::uint64_t frequency = (p & mask) | ((65536 - p) & ~mask);
    this->State = frequency * rest + slot - (p & ~mask);
    if (this->State < (std::uint64_t{ 1 } << 32))
    {
      this->Refill();
    }
    model.Update(bit);
    return bit;
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

  std::uint64_t Take(unsigned count)
  {
    while (this->PendingBits < count)
    {
      std::uint32_t word = 0;
      const auto left = this->RawEnd - this->RawNext;
      if (left >= 4)
      {
        std::memcpy(&word, this->RawNext, 4);
        this->RawNext += 4;
      }
      else
      {
        std::memcpy(&word, this->RawNext, static_cast<std::size_t>(left));
        this->RawNext = this->RawEnd;
        if (left == 0)
        {
          ThrowEnd();
        }
      }
      this->Pending |= static_cast<std::uint64_t>(word) << this->PendingBits;
      this->PendingBits += 32;
    }
    const std::uint64_t value = this->Pending & ((std::uint64_t{ 1 } << count) - 1);
    this->Pending >>= count;
    this->PendingBits -= count;
    return value;
  }

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
