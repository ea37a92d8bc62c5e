// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunScaleSurvey.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace gatun
{
namespace
{
constexpr double BitsOfDigit = 3.321928094887362;

// Decimal numbers of more digits are closer to each other than those of the type, or not exact.
constexpr int MaxDigitsOfFloat = 7;
constexpr double MaxMultipleOfFloat = 16777216;
constexpr double MaxMultipleOfDouble = 1125899906842624; // 2^50: products are off by less than 1/2
}

//------------------------------------------------------------------------------
ScaleSurvey::ScaleSurvey(ScalarType type)
  : Type(type)
{
  this->Significant.IsPossible = IsFloating(type);
  this->Fixed.IsPossible = IsFloating(type);
  this->Fixed.Digits = 0;
  this->Binary.IsPossible = IsFloating(type);
}

//------------------------------------------------------------------------------
void ScaleSurvey::Add(
  const void* values, std::size_t count, std::size_t components, std::size_t component)
{
  const auto size = SizeOf(this->Type);
  // No values may have no address.
  const auto* next =
    count == 0 ? nullptr : static_cast<const std::uint8_t*>(values) + component * size;
  for (std::size_t i = 0; i < count && !this->IsDone(); ++i, next += components * size)
  {
    Key raw = 0;
    std::memcpy(&raw, next, size);
    this->Union |= raw;
    if (this->HasNumbers())
    {
      this->AddNumber(this->Type == ScalarType::Float32
          ? std::bit_cast<float>(static_cast<std::uint32_t>(raw))
          : std::bit_cast<double>(raw));
    }
  }
}

//------------------------------------------------------------------------------
void ScaleSurvey::AddNumber(double number)
{
  const bool isOther = !std::isfinite(number) || (number == 0 && std::signbit(number));
  if (isOther)
  {
    this->Significant.IsPossible = false;
    this->Fixed.IsPossible = false;
    this->Binary.IsPossible = false;
    return;
  }
  if (number == 0)
  {
    return;
  }
  const double magnitude = std::abs(number);
  this->Largest = std::max(this->Largest, magnitude);
  ++this->Numbers;
  this->Exponents += std::ilogb(magnitude);
  this->AddSignificant(magnitude);
  this->AddFixed(magnitude);
  this->AddBinary(magnitude);
}

//------------------------------------------------------------------------------
void ScaleSurvey::AddSignificant(double magnitude)
{
  auto& all = this->Significant;
  const int most = this->Type == ScalarType::Float32 ? MaxDigitsOfFloat : Scale::MaxDigits;
  const int decade = all.IsPossible ? FindDecade(magnitude) : 0;
  for (; all.IsPossible; ++all.Digits)
  {
    const int power = all.Digits - 1 - decade;
    all.IsPossible = all.Digits <= most && std::abs(power) <= Scale::MaxPower;
    if (!all.IsPossible)
    {
      return;
    }
    const double mantissa = std::floor(ScaleByPower(magnitude, power) + 0.5);
    if (this->Round(ScaleByPower(mantissa, -power)) == magnitude)
    {
      const int rounded = decade + (mantissa >= GetPowerOfTen(all.Digits) ? 1 : 0);
      all.First = std::min(all.First, rounded);
      all.Last = std::max(all.Last, rounded);
      all.Sum += rounded;
      return;
    }
  }
}

//------------------------------------------------------------------------------
void ScaleSurvey::AddFixed(double magnitude)
{
  auto& all = this->Fixed;
  const double end = this->Type == ScalarType::Float32 ? MaxMultipleOfFloat : MaxMultipleOfDouble;
  for (; all.IsPossible; ++all.Digits)
  {
    const double multiple =
      all.Digits <= Scale::MaxPower ? std::floor(magnitude * GetPowerOfTen(all.Digits) + 0.5) : end;
    all.IsPossible = multiple < end;
    if (all.IsPossible && this->Round(ScaleByPower(multiple, -all.Digits)) == magnitude)
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
void ScaleSurvey::AddBinary(double magnitude)
{
  if (!this->Binary.IsPossible)
  {
    return;
  }
  constexpr int digits = std::numeric_limits<double>::digits;
  const int last = std::ilogb(magnitude);
  const auto multiple = static_cast<std::uint64_t>(std::scalbn(magnitude, digits - 1 - last));
  this->Binary.First =
    std::min(this->Binary.First, last - (digits - 1) + std::countr_zero(multiple));
  this->Binary.Last = std::max(this->Binary.Last, last);
  this->CheckBinary();
}

//------------------------------------------------------------------------------
void ScaleSurvey::CheckBinary()
{
  auto& all = this->Binary;
  // Nothing is known yet if First is above Last.
  all.IsPossible = all.IsPossible &&
    (all.First > all.Last || all.Last - all.First < Scale::GetBinaryDigits(this->Type));
}

//------------------------------------------------------------------------------
void ScaleSurvey::Put(ByteWriter& out) const
{
  out.Put(this->Union);
  for (const auto* decimals : { &this->Significant, &this->Fixed })
  {
    out.Put<std::uint8_t>(decimals->IsPossible);
    out.Put(decimals->Digits);
    out.Put(static_cast<std::int32_t>(decimals->First));
    out.Put(static_cast<std::int32_t>(decimals->Last));
    out.Put(decimals->Sum);
  }
  out.Put<std::uint8_t>(this->Binary.IsPossible);
  out.Put(static_cast<std::int32_t>(this->Binary.First));
  out.Put(static_cast<std::int32_t>(this->Binary.Last));
  out.Put(this->Largest);
  out.Put(this->Numbers);
  out.Put(this->Exponents);
}

//------------------------------------------------------------------------------
void ScaleSurvey::Add(ByteReader& in)
{
  this->Union |= in.Get<Key>();
  for (auto* decimals : { &this->Significant, &this->Fixed })
  {
    decimals->IsPossible = in.Get<std::uint8_t>() != 0 && decimals->IsPossible;
    decimals->Digits = std::max(decimals->Digits, in.Get<std::uint8_t>());
    decimals->First = std::min<int>(decimals->First, in.Get<std::int32_t>());
    decimals->Last = std::max<int>(decimals->Last, in.Get<std::int32_t>());
    decimals->Sum += in.Get<std::int64_t>();
  }
  this->Binary.IsPossible = in.Get<std::uint8_t>() != 0 && this->Binary.IsPossible;
  this->Binary.First = std::min<int>(this->Binary.First, in.Get<std::int32_t>());
  this->Binary.Last = std::max<int>(this->Binary.Last, in.Get<std::int32_t>());
  this->CheckBinary();
  this->Largest = std::max(this->Largest, in.Get<double>());
  this->Numbers += in.Get<std::int64_t>();
  this->Exponents += in.Get<std::int64_t>();
}

//------------------------------------------------------------------------------
unsigned ScaleSurvey::CountZeroBits() const
{
  return this->Union != 0 ? static_cast<unsigned>(std::countr_zero(this->Union)) : 0;
}

//------------------------------------------------------------------------------
bool ScaleSurvey::Holds(const Scale& scale) const
{
  switch (scale.Kind)
  {
    case ScaleKind::Shift:
      return this->Union == 0 || scale.Digits <= this->CountZeroBits();
    case ScaleKind::Decimal:
    {
      const auto& all = this->Significant;
      return all.IsPossible &&
        (this->Numbers == 0 ||
          (scale.Digits >= all.Digits && scale.First <= all.First &&
            all.Last - (scale.Digits - 1) <= Scale::MaxPower));
    }
    case ScaleKind::Fixed:
      return this->Fixed.IsPossible && scale.Digits >= this->Fixed.Digits &&
        this->Largest * GetPowerOfTen(scale.Digits) < MaxMultipleOfDouble;
    case ScaleKind::Binary:
    {
      const auto& all = this->Binary;
      return all.IsPossible &&
        (this->Numbers == 0 ||
          (scale.First <= all.First &&
            all.Last - scale.First < Scale::GetBinaryDigits(this->Type)));
    }
    default:
      return true;
  }
}

//------------------------------------------------------------------------------
Scale ScaleSurvey::Choose() const
{
  Scale best;
  if (const auto zeros = this->CountZeroBits(); zeros > 0)
  {
    best = { ScaleKind::Shift, static_cast<std::uint8_t>(zeros), 0 };
  }
  if (this->Numbers == 0)
  {
    return best;
  }
  // The bits of the number of keys per unit, for a typical value, which tell how long residuals
  // are.
  const auto count = static_cast<double>(this->Numbers);
  const int mantissa = this->Type == ScalarType::Float32 ? 23 : 52;
  double least = mantissa - best.Digits - static_cast<double>(this->Exponents) / count;
  const auto consider = [&](const Scale& scale, double bits, double leastGain = 1)
  {
    if (scale.IsValid(this->Type) && this->Holds(scale) && bits + leastGain < least)
    {
      best = scale;
      least = bits;
    }
  };
  if (const auto& all = this->Binary; all.IsPossible && all.First >= Scale::MinBinary)
  {
    const int first = std::min(all.First, Scale::MaxBinary);
    consider({ ScaleKind::Binary, 0, static_cast<std::int8_t>(first) }, -first, 0.25);
  }
  if (this->Significant.IsPossible)
  {
    const auto& all = this->Significant;
    consider({ ScaleKind::Decimal, all.Digits, static_cast<std::int8_t>(all.First) },
      BitsOfDigit * (all.Digits - 1 - static_cast<double>(all.Sum) / count));
  }
  if (this->Fixed.IsPossible)
  {
    consider({ ScaleKind::Fixed, this->Fixed.Digits, 0 }, BitsOfDigit * this->Fixed.Digits);
  }
  return best;
}
}
