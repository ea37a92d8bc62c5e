// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunDomain_h
#define gatunDomain_h

// Conversion of values to keys. Keys are unsigned integers in the order of the values, so that
// close values have close keys, for every type.

#include "gatunPlainKeys.h"
#include "gatunQuantizer.h"
#include "gatunScale.h"
#include "gatunTypes.h"

#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace gatun
{
/** Distinct keys, ascending. With a palette, the key of a value is its rank in the palette. */
using Palette = std::vector<Key>;

/** Maps the values of a component to keys, and keys to numbers for prediction. */
class Domain : public PlainKeys
{
public:
  Domain() = default;

  explicit Domain(ScalarType type, std::shared_ptr<const Palette> palette = {})
    : Type(type)
    , Ranks(std::move(palette))
    , Bits(this->Ranks ? static_cast<unsigned>(std::bit_width(this->Ranks->size()))
                       : static_cast<unsigned>(8 * SizeOf(type)))
    , Mask(MakeMask(Bits))
  {
  }

  /** A scale must be valid for the type. Without one, keys are plain. */
  Domain(ScalarType type, const Scale& scale)
    : Domain(type)
  {
    if (scale)
    {
      this->Scaled = ScaledKeys(type, scale);
      this->Bits = this->Scaled.GetBits();
      this->Mask = MakeMask(this->Bits);
    }
  }

  /** Keys are plain, but streams of them have the steps of a quantizer, which must be valid. */
  Domain(ScalarType type, const Quantizer& rounding)
    : Domain(type)
  {
    this->Rounding = rounding;
  }

  ScalarType GetType() const { return this->Type; }
  unsigned GetBits() const { return this->Bits; }
  const std::shared_ptr<const Palette>& GetPalette() const { return this->Ranks; }
  const Scale& GetScale() const { return this->Scaled.GetScale(); }

  /** None if values are exact. */
  const Quantizer& GetQuantizer() const { return this->Rounding; }

  /** Whether keys are plain ones. */
  bool IsPlain() const { return !this->Ranks && !this->GetScale(); }

  /** The key of a value. The palette or scale, if there is one, must contain it. */
  Key Read(const void* value) const { return this->FromPlain(ReadPlain(this->Type, value)); }

  /** The same for a plain key. */
  Key FromPlain(Key plain) const
  {
    if (!this->Ranks)
    {
      return this->GetScale() ? this->Scaled.FromPlain(plain) : plain;
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

  void Write(Key key, void* value) const { WritePlain(this->Type, this->ToPlain(key), value); }

  /** The plain key of the value. */
  Key ToPlain(Key key) const
  {
    return this->Ranks ? (*this->Ranks)[key] : this->GetScale() ? this->Scaled.ToPlain(key) : key;
  }

  /** Whether a key is valid: any key, a rank within the palette, or a place on the scale. */
  bool IsValid(Key key) const
  {
    return this->Ranks ? key < this->Ranks->size() : !this->GetScale() || this->Scaled.IsValid(key);
  }

  /** The number for prediction: the value, or its rank. */
  double ToNumber(Key key) const
  {
    return this->Ranks ? static_cast<double>(key) : this->ToValue(key);
  }

  /** The value as a number, with or without palette. */
  double ToValue(Key key) const { return PlainToNumber(this->Type, this->ToPlain(key)); }

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
    if (this->GetScale())
    {
      return this->Scaled.FromNumber(number);
    }
    return PlainKeys::FromNumber(this->Type, number);
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
  static constexpr Key MakeMask(unsigned bits)
  {
    return bits == 64 ? ~Key{ 0 } : (Key{ 1 } << bits) - 1;
  }

  ScalarType Type = ScalarType::UInt8;
  std::shared_ptr<const Palette> Ranks;
  ScaledKeys Scaled;
  Quantizer Rounding;
  unsigned Bits = 8;
  Key Mask = 0xff;
};

/** A Domain of Float32 with plain keys, for code that is compiled for it. */
class Float32Domain
{
public:
  Float32Domain() = default;
  explicit Float32Domain(const Domain&) {}

  static bool Matches(const Domain& domain)
  {
    return domain.GetType() == ScalarType::Float32 && domain.IsPlain();
  }

  static constexpr ScalarType GetType() { return ScalarType::Float32; }
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

/** The same with the scale Shift, or without a scale. */
class ShiftedFloat32Domain
{
public:
  explicit ShiftedFloat32Domain(const Domain& domain)
    : Digits(domain.GetScale() ? domain.GetScale().Digits : 0)
    , Low((std::uint32_t{ 1 } << this->Digits) - 1)
    , Half((this->Low >> 1) + (this->Digits > 0 ? 1 : 0))
    , Last(~std::uint32_t{ 0 } >> this->Digits)
  {
  }

  static bool Matches(const Domain& domain)
  {
    return domain.GetType() == ScalarType::Float32 && !domain.GetPalette() &&
      (!domain.GetScale() || domain.GetScale().Kind == ScaleKind::Shift);
  }

  static constexpr ScalarType GetType() { return ScalarType::Float32; }
  unsigned GetBits() const { return 32 - this->Digits; }
  bool IsValid(Key key) const { return key <= this->Last; }

  double ToNumber(Key key) const
  {
    const auto plain = static_cast<std::uint32_t>(key) << this->Digits;
    return Float32Domain::ToNumber(plain | (IsInverted(plain) ? this->Low : 0));
  }

  Key FromNumber(double number) const
  {
    const auto plain = static_cast<std::uint32_t>(Float32Domain::FromNumber(number));
    const std::uint32_t key = plain >> this->Digits;
    const bool isUpper = (plain & this->Half) != 0;
    return IsInverted(plain) ? key - (this->Half != 0 && !isUpper && key > 0 ? 1 : 0)
                             : key + (isUpper && key < this->Last ? 1 : 0);
  }

  std::int64_t Subtract(Key key, Key predicted) const
  {
    const auto difference = static_cast<std::uint32_t>(key) - static_cast<std::uint32_t>(predicted);
    return static_cast<std::int32_t>(difference << this->Digits) >> this->Digits;
  }

  Key Add(Key predicted, std::int64_t residual) const
  {
    return static_cast<std::uint32_t>(predicted + static_cast<Key>(residual)) & this->Last;
  }

private:
  /** Whether a number is negative: the bits of such numbers are inverted in keys. */
  static bool IsInverted(std::uint32_t plain) { return plain >> 31 == 0; }

  unsigned Digits;
  std::uint32_t Low;  // the bits that are 0 in values
  std::uint32_t Half; // the highest one of them
  std::uint32_t Last;
};

/** Keys of fewer than 64 bits, which wrap around. */
class WrappingKeys
{
public:
  explicit WrappingKeys(unsigned bits)
    : Bits(bits)
  {
  }

  unsigned GetBits() const { return this->Bits; }

  std::int64_t Subtract(Key key, Key predicted) const
  {
    const unsigned unused = 64 - this->Bits;
    return static_cast<std::int64_t>((key - predicted) << unused) >> unused;
  }

  Key Add(Key predicted, std::int64_t residual) const
  {
    return (predicted + static_cast<Key>(residual)) & ((Key{ 1 } << this->Bits) - 1);
  }

private:
  unsigned Bits;
};

/** The same for the scale Binary, of any type. */
class BinaryDomain : public WrappingKeys
{
public:
  explicit BinaryDomain(const Domain& domain)
    : WrappingKeys(domain.GetBits())
    , Type(domain.GetType())
    , Zero(std::int64_t{ 1 } << Scale::GetBinaryDigits(this->Type))
    , Unit(std::ldexp(1.0, domain.GetScale().First))
    , PerUnit(1 / this->Unit)
  {
  }

  static bool Matches(const Domain& domain)
  {
    return !domain.GetPalette() && domain.GetScale().Kind == ScaleKind::Binary;
  }

  ScalarType GetType() const { return this->Type; }
  bool IsValid(Key key) const { return key <= 2 * static_cast<Key>(this->Zero); }

  double ToNumber(Key key) const
  {
    return static_cast<double>(static_cast<std::int64_t>(key) - this->Zero) * this->Unit;
  }

  Key FromNumber(double number) const
  {
    const bool isFinite = std::abs(number) <= std::numeric_limits<double>::max();
    const double inUnits = isFinite ? number * this->PerUnit : 0;
    const auto end = static_cast<double>(this->Zero);
    const double bounded = inUnits > end ? end : inUnits < -end ? -end : inUnits;
    // Toward 0, which is as Domain does it.
    const auto multiple = static_cast<std::int64_t>(bounded + std::copysign(0.5, bounded));
    return static_cast<Key>(this->Zero + multiple);
  }

private:
  ScalarType Type;
  std::int64_t Zero; // its key
  double Unit;       // the distance of values
  double PerUnit;
};

/** The same with a palette, of any type. */
class RankDomain : public WrappingKeys
{
public:
  explicit RankDomain(const Domain& domain)
    : WrappingKeys(domain.GetBits())
    , Count(domain.GetPalette()->size())
    , Last(static_cast<double>(this->Count - 1))
  {
  }

  static bool Matches(const Domain& domain) { return static_cast<bool>(domain.GetPalette()); }

  bool IsValid(Key key) const { return key < this->Count; }

  static double ToNumber(Key key) { return static_cast<double>(static_cast<std::int64_t>(key)); }

  Key FromNumber(double number) const
  {
    const bool isFinite = std::abs(number) <= std::numeric_limits<double>::max();
    const double rank = isFinite ? number : 0;
    const double bounded = rank > this->Last ? this->Last : rank < 0 ? 0 : rank;
    return static_cast<Key>(static_cast<std::int64_t>(bounded + 0.5));
  }

private:
  std::size_t Count;
  double Last;
};
}

#endif
