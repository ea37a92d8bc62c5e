// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunDomain_h
#define gatunDomain_h

// Conversion of values to keys. Keys are unsigned integers in the order of the values, so that
// close values have close keys, for every type.

#include "gatunTypes.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

namespace gatun
{
using Key = std::uint64_t;

/** Distinct keys, ascending. With a palette, the key of a value is its rank in the palette. */
using Palette = std::vector<Key>;

/** Maps the values of a component to keys, and keys to numbers for prediction. */
class Domain
{
public:
  Domain() = default;

  explicit Domain(ScalarType type, std::shared_ptr<const Palette> palette = {})
    : Type(type)
    , Ranks(std::move(palette))
    , Bits(this->Ranks ? static_cast<unsigned>(std::bit_width(this->Ranks->size()))
                       : static_cast<unsigned>(8 * SizeOf(type)))
    , Mask(Bits == 64 ? ~Key{ 0 } : (Key{ 1 } << Bits) - 1)
  {
  }

  ScalarType GetType() const { return this->Type; }
  unsigned GetBits() const { return this->Bits; }
  const std::shared_ptr<const Palette>& GetPalette() const { return this->Ranks; }

  /** The key of the value at an address, regardless of the palette. */
  static Key ReadPlain(ScalarType type, const void* value)
  {
    Key raw = 0;
    std::memcpy(&raw, value, SizeOf(type));
    return FromRaw(type, raw);
  }

  /** The key of a value given by its bits. */
  static Key FromRaw(ScalarType type, Key raw)
  {
    const unsigned bits = static_cast<unsigned>(8 * SizeOf(type));
    const Key sign = Key{ 1 } << (bits - 1);
    switch (type)
    {
      case ScalarType::Int8:
      case ScalarType::Int16:
      case ScalarType::Int32:
      case ScalarType::Int64:
        return raw ^ sign;
      case ScalarType::Float32:
        return (raw & sign) ? ~raw & 0xffffffffu : raw | sign;
      case ScalarType::Float64:
        return (raw & sign) ? ~raw : raw | sign;
      default:
        return raw;
    }
  }

  /** The inverse of ReadPlain. */
  static void WritePlain(ScalarType type, Key key, void* value)
  {
    const unsigned bits = static_cast<unsigned>(8 * SizeOf(type));
    const Key sign = Key{ 1 } << (bits - 1);
    switch (type)
    {
      case ScalarType::Int8:
      case ScalarType::Int16:
      case ScalarType::Int32:
      case ScalarType::Int64:
        key ^= sign;
        break;
      case ScalarType::Float32:
      case ScalarType::Float64:
        key = (key & sign) ? key ^ sign : ~key;
        break;
      default:
        break;
    }
    std::memcpy(value, &key, SizeOf(type));
  }

  /** The key of a value. The palette, if there is one, must contain it. */
  Key Read(const void* value) const
  {
    const Key plain = ReadPlain(this->Type, value);
    if (!this->Ranks)
    {
      return plain;
    }
    // Branch-free binary search.
    const Key* low = this->Ranks->data();
    for (std::size_t count = this->Ranks->size(); count > 1;)
    {
      const std::size_t half = count / 2;
      low += low[half] <= plain ? half : 0;
      count -= half;
    }
    return static_cast<Key>(low - this->Ranks->data());
  }

  void Write(Key key, void* value) const
  {
    WritePlain(this->Type, this->Ranks ? (*this->Ranks)[key] : key, value);
  }

  /** Whether a key is valid: any key, or a rank within the palette. */
  bool IsValid(Key key) const { return !this->Ranks || key < this->Ranks->size(); }

  /** The number for prediction: the value, or its rank. */
  double ToNumber(Key key) const
  {
    return this->Ranks ? static_cast<double>(key) : PlainToNumber(this->Type, key);
  }

  /** The value as a number, with or without palette. */
  double ToValue(Key key) const
  {
    return PlainToNumber(this->Type, this->Ranks ? (*this->Ranks)[key] : key);
  }

  static double PlainToNumber(ScalarType type, Key key)
  {
    switch (type)
    {
      case ScalarType::Float32:
      {
        float value;
        WritePlain(type, key, &value);
        return value;
      }
      case ScalarType::Float64:
      {
        double value;
        WritePlain(type, key, &value);
        return value;
      }
      case ScalarType::Int8:
      case ScalarType::Int16:
      case ScalarType::Int32:
      case ScalarType::Int64:
        return static_cast<double>(
          static_cast<std::int64_t>(key - (Key{ 1 } << (8 * SizeOf(type) - 1))));
      default:
        return static_cast<double>(key);
    }
  }

  /** The key closest to a predicted number. Numbers that are not finite count as 0. */
  Key FromNumber(double number) const
  {
    if (!std::isfinite(number))
    {
      number = 0;
    }
    if (this->Ranks)
    {
      const double last = static_cast<double>(this->Ranks->size() - 1);
      const double rank = std::floor(number + 0.5);
      return rank <= 0 ? 0 : static_cast<Key>(rank < last ? rank : last);
    }
    switch (this->Type)
    {
      case ScalarType::Float32:
      {
        constexpr double largest = std::numeric_limits<float>::max();
        const float value = static_cast<float>(number > largest ? largest
            : number < -largest                                 ? -largest
                                                                : number);
        return FromRaw(ScalarType::Float32, std::bit_cast<std::uint32_t>(value));
      }
      case ScalarType::Float64:
        return FromRaw(ScalarType::Float64, std::bit_cast<std::uint64_t>(number));
      case ScalarType::Int8:
      case ScalarType::Int16:
      case ScalarType::Int32:
      case ScalarType::Int64:
      {
        const double half = std::ldexp(1.0, static_cast<int>(this->Bits) - 1);
        const double whole = std::floor(number + 0.5);
        return whole <= -half ? 0
          : whole >= half
          ? this->Mask
          : static_cast<Key>(static_cast<std::int64_t>(whole)) + (Key{ 1 } << (this->Bits - 1));
      }
      default:
      {
        const double end = std::ldexp(1.0, static_cast<int>(this->Bits));
        const double whole = std::floor(number + 0.5);
        return whole <= 0 ? 0 : whole >= end ? this->Mask : static_cast<Key>(whole);
      }
    }
  }

  /** key - predicted as a signed number of GetBits() bits. */
  std::int64_t Subtract(Key key, Key predicted) const
  {
    const unsigned unused = 64 - this->Bits;
    return static_cast<std::int64_t>((key - predicted) << unused) >> unused;
  }

  /** The key with Subtract(key, predicted) == residual. */
  Key Add(Key predicted, std::int64_t residual) const
  {
    return (predicted + static_cast<Key>(residual)) & this->Mask;
  }

private:
  ScalarType Type = ScalarType::UInt8;
  std::shared_ptr<const Palette> Ranks;
  unsigned Bits = 8;
  Key Mask = 0xff;
};

/** A Domain of Float32 without a palette, for code that is compiled for it. */
class Float32Domain
{
public:
  static bool Matches(const Domain& domain)
  {
    return domain.GetType() == ScalarType::Float32 && !domain.GetPalette();
  }

  static constexpr unsigned GetBits() { return 32; }
  static constexpr bool IsValid(Key) { return true; }

  static double ToNumber(Key key)
  {
    const auto bits = static_cast<std::uint32_t>(key);
    // The highest bit is that of positive numbers.
    const auto negative = static_cast<std::uint32_t>(static_cast<std::int32_t>(~bits) >> 31);
    return std::bit_cast<float>(bits ^ (negative | Sign));
  }

  static Key FromNumber(double number)
  {
    constexpr double largest = std::numeric_limits<float>::max();
    number = std::abs(number) <= std::numeric_limits<double>::max() ? number : 0;
    const double bounded = number > largest ? largest : number < -largest ? -largest : number;
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(bounded));
    const auto negative = static_cast<std::uint32_t>(static_cast<std::int32_t>(bits) >> 31);
    return bits ^ (negative | Sign);
  }

  static std::int64_t Subtract(Key key, Key predicted)
  {
    return static_cast<std::int32_t>(
      static_cast<std::uint32_t>(key) - static_cast<std::uint32_t>(predicted));
  }

  static Key Add(Key predicted, std::int64_t residual)
  {
    return static_cast<std::uint32_t>(predicted + static_cast<Key>(residual));
  }

private:
  static constexpr std::uint32_t Sign = 0x80000000u;
};
}

#endif
