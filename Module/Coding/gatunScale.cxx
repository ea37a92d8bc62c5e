// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunScale.h"

#include "gatunBytes.h"
#include "gatunPlainKeys.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gatun
{
namespace
{
constexpr int LowestPower = -22;

// The compiler rounds literals to the nearest number.
constexpr std::array PowersOfTen{ 1e-22, 1e-21, 1e-20, 1e-19, 1e-18, 1e-17, 1e-16, 1e-15, 1e-14,
  1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1e0, 1e1, 1e2,
  1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
  1e20, 1e21, 1e22, 1e23, 1e24, 1e25, 1e26, 1e27, 1e28, 1e29, 1e30, 1e31, 1e32, 1e33, 1e34, 1e35,
  1e36 };

/** Fixed: the largest multiple of the step. */
constexpr Key MaxMultiple = Key{ 1 } << 53;
}

//------------------------------------------------------------------------------
double GetPowerOfTen(int power)
{
  return PowersOfTen[static_cast<std::size_t>(power - LowestPower)];
}

int FindDecade(double magnitude)
{
  constexpr int last = LowestPower + static_cast<int>(PowersOfTen.size()) - 1;
  // At most the decade or the one before, because 10^0.30103 > 2.
  const double guess = std::floor(static_cast<double>(std::ilogb(magnitude)) * 0.30102);
  int decade = guess < LowestPower ? LowestPower - 1
    : guess > last                 ? last
                                   : static_cast<int>(guess);
  while (decade < last && magnitude >= GetPowerOfTen(decade + 1))
  {
    ++decade;
  }
  while (decade >= LowestPower && magnitude < GetPowerOfTen(decade))
  {
    --decade;
  }
  return decade;
}

//------------------------------------------------------------------------------
bool Scale::IsValid(ScalarType type) const
{
  switch (this->Kind)
  {
    case ScaleKind::Shift:
      return this->Digits >= 1 && this->Digits < 8 * SizeOf(type);
    case ScaleKind::Decimal:
      return IsFloating(type) && this->Digits >= 1 && this->Digits <= MaxDigits &&
        this->First - (this->Digits - 1) >= -MaxPower &&
        this->First - (this->Digits - 1) <= MaxPower;
    case ScaleKind::Fixed:
      return IsFloating(type) && this->Digits <= MaxPower;
    case ScaleKind::Binary:
      return IsFloating(type) && this->First >= MinBinary && this->First <= MaxBinary;
    default:
      return false;
  }
}

//------------------------------------------------------------------------------
ScaledKeys::ScaledKeys(ScalarType type, const Scale& scale)
  : Steps(scale)
  , Type(type)
{
  if (scale.Kind == ScaleKind::Shift)
  {
    this->Bits = static_cast<unsigned>(8 * SizeOf(type)) - scale.Digits;
    this->Last = (Key{ 1 } << this->Bits) - 1;
    return;
  }
  this->Zero = MaxMultiple;
  if (scale.Kind == ScaleKind::Binary)
  {
    this->Zero = Key{ 1 } << Scale::GetBinaryDigits(type);
    this->Unit = std::ldexp(1.0, scale.First);
  }
  else if (scale.Kind == ScaleKind::Decimal)
  {
    this->Lowest = static_cast<Key>(GetPowerOfTen(scale.Digits - 1));
    this->Decade = 9 * this->Lowest;
    const int last = Scale::MaxPower + scale.Digits - 1;
    this->Zero = static_cast<Key>(last - scale.First + 1) * this->Decade;
  }
  this->Last = 2 * this->Zero;
  this->Bits = static_cast<unsigned>(std::bit_width(this->Last + 1));
}

//------------------------------------------------------------------------------
Key ScaledKeys::FromPlain(Key plain) const
{
  const Key key = this->Steps.Kind == ScaleKind::Shift
    ? plain >> this->Steps.Digits
    : this->FromNumber(PlainKeys::PlainToNumber(this->Type, plain));
  if (this->ToPlain(key) != plain)
  {
    ThrowInvalid("a value is not on the scale of its array");
  }
  return key;
}

//------------------------------------------------------------------------------
Key ScaledKeys::ToPlain(Key key) const
{
  if (this->Steps.Kind == ScaleKind::Shift)
  {
    // The bits of negative floating-point numbers are inverted in keys.
    const bool isInverted = IsFloating(this->Type) && (key >> (this->Bits - 1)) == 0;
    const Key low = (Key{ 1 } << this->Steps.Digits) - 1;
    return key << this->Steps.Digits | (isInverted ? low : 0);
  }
  return PlainKeys::RoundToFloating(this->Type, this->ToNumber(key));
}

//------------------------------------------------------------------------------
double ScaledKeys::ToNumber(Key key) const
{
  const bool isNegative = key < this->Zero;
  Key rank = isNegative ? this->Zero - key : key - this->Zero;
  double number = 0;
  if (this->Steps.Kind == ScaleKind::Binary)
  {
    number = static_cast<double>(rank) * this->Unit;
  }
  else if (this->Steps.Kind == ScaleKind::Fixed)
  {
    number = ScaleByPower(static_cast<double>(rank), -int{ this->Steps.Digits });
  }
  else if (rank > 0)
  {
    --rank;
    const Key decade = rank / this->Decade;
    const Key mantissa = this->Lowest + (rank - decade * this->Decade);
    number = ScaleByPower(static_cast<double>(mantissa),
      static_cast<int>(decade) + this->Steps.First - (this->Steps.Digits - 1));
  }
  return isNegative ? -number : number;
}

//------------------------------------------------------------------------------
Key ScaledKeys::FromNumber(double number) const
{
  if (this->Steps.Kind == ScaleKind::Shift)
  {
    const unsigned digits = this->Steps.Digits;
    const Key plain = PlainKeys::FromNumber(this->Type, number);
    const Key key = plain >> digits;
    const bool isUpper = ((plain >> (digits - 1)) & 1) != 0;
    const bool isInverted = IsFloating(this->Type) && (key >> (this->Bits - 1)) == 0;
    return isInverted ? key - (!isUpper && key > 0 ? 1 : 0)
                      : key + (isUpper && key < this->Last ? 1 : 0);
  }
  const double magnitude = std::abs(number);
  Key rank = 0;
  if (this->Steps.Kind == ScaleKind::Decimal)
  {
    rank = this->FindDecimal(magnitude);
  }
  else
  {
    const double inUnits = this->Steps.Kind == ScaleKind::Binary
      ? magnitude / this->Unit
      : magnitude * GetPowerOfTen(this->Steps.Digits);
    const double multiple = std::floor(inUnits + 0.5);
    rank = multiple < static_cast<double>(this->Zero) ? static_cast<Key>(multiple) : this->Zero;
  }
  return number < 0 ? this->Zero - rank : this->Zero + rank;
}

//------------------------------------------------------------------------------
/** The place of a decimal number among the positive ones, from 1, or 0 for 0. */
Key ScaledKeys::FindDecimal(double magnitude) const
{
  const int decade = magnitude > 0 ? FindDecade(magnitude) : this->Steps.First - 1;
  if (decade < this->Steps.First)
  {
    return magnitude + magnitude >= GetPowerOfTen(this->Steps.First) ? 1 : 0;
  }
  // At the end of the decade, it is the first number of the next one.
  const int power = this->Steps.Digits - 1 - decade;
  const double lowest = static_cast<double>(this->Lowest);
  const double end = 10 * lowest;
  const double mantissa =
    power >= -Scale::MaxPower ? std::floor(ScaleByPower(magnitude, power) + 0.5) : end;
  const double bounded = mantissa < lowest ? lowest : mantissa < end ? mantissa : end;
  const Key rank = 1 + static_cast<Key>(decade - this->Steps.First) * this->Decade +
    static_cast<Key>(bounded) - this->Lowest;
  return std::min(rank, this->Zero);
}
}
