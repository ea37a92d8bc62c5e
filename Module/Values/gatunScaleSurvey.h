// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunScaleSurvey_h
#define gatunScaleSurvey_h

#include "gatunBytes.h"
#include "gatunPlainKeys.h"
#include "gatunScale.h"
#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace gatun
{
/** Finds the scales that have all values of a component whose tuples come in parts. The result does
 * not depend on the order of the parts. */
class ScaleSurvey
{
public:
  explicit ScaleSurvey(ScalarType type);

  /** Returns early if no scale has all values. */
  void Add(const void* values, std::size_t count, std::size_t components, std::size_t component);

  /** The result so far for another process, and its addition to that here. */
  void Put(ByteWriter& out) const;
  void Add(ByteReader& in);

  /** The scale with the fewest keys where the values are, or none if plain keys are as few. */
  Scale Choose() const;

  /** Whether a scale, or none, has all values. */
  bool Holds(const Scale& scale) const;

private:
  /** State of the search for decimal numbers. */
  struct Decimals
  {
    bool IsPossible = true;
    std::uint8_t Digits = 1;
    int First = std::numeric_limits<int>::max(); // decades
    int Last = std::numeric_limits<int>::lowest();
    std::int64_t Sum = 0; // of the decades
  };

  /** State of the search for multiples of a power of two. */
  struct Multiples
  {
    bool IsPossible = true;
    int First = std::numeric_limits<int>::max();   // the lowest bit that is not 0
    int Last = std::numeric_limits<int>::lowest(); // the highest one
  };

  bool HasNumbers() const
  {
    return this->Significant.IsPossible || this->Fixed.IsPossible || this->Binary.IsPossible;
  }
  bool IsDone() const { return !this->HasNumbers() && (this->Union & 1) != 0; }
  double Round(double number) const
  {
    return this->Type == ScalarType::Float32 ? static_cast<float>(number) : number;
  }
  void AddNumber(double number);
  void AddSignificant(double magnitude);
  void AddFixed(double magnitude);
  void AddBinary(double magnitude);
  void CheckBinary();
  unsigned CountZeroBits() const;

  ScalarType Type;
  Key Union = 0; // of the bits of all values
  Decimals Significant;
  Decimals Fixed;
  Multiples Binary;
  double Largest = 0;
  std::int64_t Numbers = 0;   // other than 0
  std::int64_t Exponents = 0; // their sum
};
}

#endif
