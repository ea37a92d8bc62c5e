// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunScale_h
#define gatunScale_h

// Keys of values that are coarser than their type.

#include "gatunTypes.h"

#include <cstdint>

namespace gatun
{
enum class ScaleKind : std::uint8_t
{
  None = 0,
  Shift = 1,   ///< the lowest bits of all values are 0
  Decimal = 2, ///< decimal numbers with a number of significant digits
  Fixed = 3,   ///< decimal numbers with a number of decimal places
  Binary = 4   ///< multiples of a power of two
};

/** Which values of a type a component may have. See Documentation/format.md, 5.2. */
struct Scale
{
  ScaleKind Kind = ScaleKind::None;
  std::uint8_t Digits = 0; ///< or the bits that are 0
  std::int8_t First = 0;   ///< Decimal: values other than 0 are at least 10^First; Binary: 2^First

  bool operator==(const Scale&) const = default;

  explicit operator bool() const { return this->Kind != ScaleKind::None; }

  /** Whether there are keys of it for a type. */
  bool IsValid(ScalarType type) const;

  // Powers of ten up to 10^22 are numbers of binary64.
  static constexpr int MaxPower = 22;
  static constexpr int MaxDigits = 15; // of Decimal

  /** Of Binary: values are less than 2^(First + this). float32 has all such multiples; of 52
   * digits, 0.5 can be added exactly. */
  static constexpr int GetBinaryDigits(ScalarType type)
  {
    return type == ScalarType::Float32 ? 24 : 52;
  }
  // Of Binary, so that float32 has all multiples.
  static constexpr int MinBinary = -126;
  static constexpr int MaxBinary = 103;
};

/** The keys of a scale, which must be valid, and the plain keys of the same values. */
class ScaledKeys
{
public:
  ScaledKeys() = default;
  ScaledKeys(ScalarType type, const Scale& scale);

  const Scale& GetScale() const { return this->Steps; }
  unsigned GetBits() const { return this->Bits; }

  /** Whether a key of GetBits() bits is one of the scale. */
  bool IsValid(std::uint64_t key) const { return key <= this->Last; }

  /** The key of a value. Throws Error(InvalidInput) if it is not on the scale. */
  std::uint64_t FromPlain(std::uint64_t plain) const;

  std::uint64_t ToPlain(std::uint64_t key) const;

  /** The key closest to a finite number. */
  std::uint64_t FromNumber(double number) const;

private:
  double ToNumber(std::uint64_t key) const;
  std::uint64_t FindDecimal(double magnitude) const;

  Scale Steps;
  ScalarType Type = ScalarType::UInt8;
  unsigned Bits = 0;
  std::uint64_t Last = 0;
  std::uint64_t Zero = 0;   // the key of 0
  double Unit = 1;          // Binary: the distance of values
  std::uint64_t Decade = 0; // keys of a decade
  std::uint64_t Lowest = 0; // 10^(Digits - 1)
};

/** The binary64 number closest to 10^power, from -22 to 36. */
double GetPowerOfTen(int power);

/** The decade of a positive number: the largest power of ten that is no larger. From -23, which
 * stands for all below, to 36. */
int FindDecade(double magnitude);

/** mantissa * 10^power with one rounding. |power| <= 22. */
inline double ScaleByPower(double mantissa, int power)
{
  return power >= 0 ? mantissa * GetPowerOfTen(power) : mantissa / GetPowerOfTen(-power);
}
}

#endif
