// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunNumberStream_h
#define gatunNumberStream_h

// Unsigned numbers as their lengths in bits, which are packed, and the bits below the highest one.

#include "gatunBytes.h"
#include "gatunInline.h"
#include "gatunPackedBytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace gatun
{
/** 0, -1, 1, -2, ... as 0, 1, 2, 3, ... */
constexpr std::uint64_t FromSigned(std::int64_t number)
{
  return static_cast<std::uint64_t>(number) << 1 ^ static_cast<std::uint64_t>(number >> 63);
}

constexpr std::int64_t ToSigned(std::uint64_t number)
{
  return static_cast<std::int64_t>(number >> 1 ^ (0 - (number & 1)));
}

/** The bits of a number of this length that are stored: those below the highest one. */
constexpr unsigned GetLowBits(unsigned length)
{
  return length - (length > 0 ? 1 : 0);
}

/** Appends runs of bits, the lowest ones first. */
class BitWriter
{
public:
  /** Appends the count lowest bits, at most 63. */
  void Put(std::uint64_t bits, unsigned count)
  {
    bits &= (std::uint64_t{ 1 } << count) - 1;
    this->Held |= bits << this->Count;
    if (this->Count + count >= 64)
    {
      this->Out.Put(this->Held);
      // The shift is by less than 64, as count is.
      this->Held = this->Count > 0 ? bits >> (64 - this->Count) : 0;
      this->Count = this->Count + count - 64;
    }
    else
    {
      this->Count += count;
    }
  }

  Bytes Finish()
  {
    for (; this->Count > 0; this->Count -= std::min(this->Count, 8u), this->Held >>= 8)
    {
      this->Out.Data.push_back(static_cast<std::uint8_t>(this->Held));
    }
    return std::move(this->Out.Data);
  }

private:
  ByteWriter Out;
  std::uint64_t Held = 0;
  unsigned Count = 0;
};

/** How a number of some length is made of bits that follow. A table, as conditions on lengths would
 * be branches, which are unpredictable. */
struct NumberShape
{
  std::uint64_t Mask; ///< of the bits that are stored
  std::uint64_t High; ///< the highest bit
  unsigned Bits;      ///< how many are stored
};

constexpr auto NumberShapes = []
{
  std::array<NumberShape, 65> shapes{};
  for (unsigned length = 1; length < shapes.size(); ++length)
  {
    const auto high = std::uint64_t{ 1 } << (length - 1);
    shapes[length] = { high - 1, high, GetLowBits(length) };
  }
  return shapes;
}();

/** Reads what BitWriter wrote. The bytes must be long enough, and Padding more that may be read. */
class BitReader
{
public:
  static constexpr std::size_t Padding = 16;

  explicit BitReader(const std::uint8_t* bytes)
    : Data(bytes)
  {
  }

  /** The next number of a length up to Longest. */
  template <unsigned Longest = 64>
  GATUN_INLINE std::uint64_t GetNumber(unsigned length)
  {
    const auto& shape = NumberShapes[length];
    std::uint64_t low;
    std::memcpy(&low, this->Data + (this->Position >> 3), sizeof(low));
    const unsigned shift = this->Position & 7;
    low >>= shift;
    if constexpr (Longest > 57)
    {
      if (shape.Bits > 56)
      {
        const std::uint64_t next = this->Data[(this->Position >> 3) + 8];
        low |= shift > 0 ? next << (64 - shift) : 0;
      }
    }
    this->Position += shape.Bits;
    return (low & shape.Mask) | shape.High;
  }

private:
  const std::uint8_t* Data;
  std::size_t Position = 0;
};

/** Collects numbers. */
class NumberWriter
{
public:
  void Put(std::uint64_t number)
  {
    const auto length = static_cast<unsigned>(std::bit_width(number));
    this->PutLength(length);
    this->Bits.Put(number, GetLowBits(length));
  }

  /** Appends a length that stands for something else than a number. */
  void PutLength(unsigned length) { this->Lengths.push_back(static_cast<std::uint8_t>(length)); }

  bool IsEmpty() const { return this->Lengths.empty(); }

  void Finish(ByteWriter& out)
  {
    PutPacked(out, this->Lengths);
    const auto bits = this->Bits.Finish();
    out.PutVarint(bits.size());
    out.PutBytes(bits);
  }

private:
  Bytes Lengths;
  BitWriter Bits;
};

/** Reads a length in bytes and a run of bits, with what BitReader may read behind them. */
inline Bytes GetBits(ByteReader& in)
{
  const auto stored = in.GetBytes(in.GetVarint());
  Bytes bits(stored.size() + BitReader::Padding, 0);
  std::copy(stored.begin(), stored.end(), bits.begin());
  return bits;
}

/** The largest byte, or 0. */
inline std::uint8_t FindLargest(std::span<const std::uint8_t> bytes)
{
  std::uint8_t largest = 0;
  for (const auto byte : bytes)
  {
    largest = std::max(largest, byte);
  }
  return largest;
}

/** The sum of GetLowBits of the lengths up to one. In runs whose sums fit 16 bits, so that the loop
 * has many lanes. */
inline std::size_t CountLowBits(std::span<const std::uint8_t> lengths, unsigned longest)
{
  constexpr std::size_t run = 1024;
  const auto most = static_cast<std::uint8_t>(longest);
  std::size_t bits = 0;
  while (!lengths.empty())
  {
    const auto part = lengths.first(std::min(run, lengths.size()));
    std::uint16_t sum = 0;
    for (const auto length : part)
    {
      const auto low = static_cast<std::uint8_t>(length - (length > 0 ? 1 : 0));
      sum = static_cast<std::uint16_t>(sum + (length <= most ? low : 0));
    }
    bits += sum;
    lengths = lengths.subspan(part.size());
  }
  return bits;
}

/** Reads what NumberWriter collected. Lengths may be followed by some that stand for something else
 * than a number and have no bits. */
class NumberReader
{
public:
  /** bits: the length of the largest number, at most 64; longest: the largest length. Throws
   * Error(Corrupt) for a larger one, and if bits are missing. */
  NumberReader(ByteReader& in, std::size_t count, unsigned bits, unsigned longest)
    : Lengths(count)
  {
    GetPacked(in, this->Lengths);
    this->Stored = GetBits(in);
    this->Bits = BitReader(this->Stored.data());
    if (FindLargest(this->Lengths) > longest ||
      CountLowBits(this->Lengths, bits) > 8 * (this->Stored.size() - BitReader::Padding))
    {
      ThrowCorrupt("numbers are longer than they may be");
    }
  }

  NumberReader(ByteReader& in, std::size_t count, unsigned bits)
    : NumberReader(in, count, bits, bits)
  {
  }

  NumberReader(const NumberReader&) = delete;
  NumberReader& operator=(const NumberReader&) = delete;

  /** The next length, and the number with it. To be called as often as there are numbers. */
  unsigned GetLength() { return this->Lengths[this->Next++]; }
  GATUN_INLINE std::uint64_t GetNumber(unsigned length) { return this->Bits.GetNumber(length); }

  std::uint64_t Get() { return this->GetNumber(this->GetLength()); }

  /** All lengths, and the bits, for those who read them otherwise. */
  const std::uint8_t* GetLengths() const { return this->Lengths.data(); }
  BitReader GetBitReader() const { return this->Bits; }

private:
  Bytes Lengths;
  Bytes Stored;
  BitReader Bits{ nullptr };
  std::size_t Next = 0;
};
}

#endif
