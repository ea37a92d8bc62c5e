// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuantizer_h
#define gatunQuantizer_h

// Values that may differ from the original ones by a bounded error. See
// Documentation/format.md, 5.5.

#include "gatunErrorBound.h"
#include "gatunExport.h" // For export macro
#include "gatunPlainKeys.h"
#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>

namespace gatun
{
/** The finite values of a component. */
struct FiniteRange
{
  double Low = 0;
  double High = -1;

  bool IsEmpty() const { return !(this->Low <= this->High); }
  void Include(double number)
  {
    const bool isFirst = this->IsEmpty();
    this->Low = isFirst || number < this->Low ? number : this->Low;
    this->High = isFirst || number > this->High ? number : this->High;
  }

  /** Includes the finite values of a component. */
  void Add(ScalarType type, const void* values, std::size_t count, std::size_t components,
    std::size_t component);
};

/** How the values of a component are rounded. */
struct Quantizer
{
  ErrorBound Bound;       ///< as the user wants it
  bool OnLattice = false; ///< whether all values are rounded to the same places
  double Step = 0;        ///< half the distance of numbers, or the distance of keys, a whole number
  double Reached = 0;     ///< the largest error, in the measure of the bound

  /** Reached tells about the values, not how they are rounded. */
  bool operator==(const Quantizer& other) const
  {
    return this->Bound == other.Bound && this->OnLattice == other.OnLattice &&
      this->Step == other.Step;
  }

  explicit operator bool() const { return static_cast<bool>(this->Bound); }

  /** Whether keys are rounded, not numbers. */
  bool RoundsKeys(ScalarType type) const
  {
    return !IsFloating(type) || this->Bound.Kind == ErrorKind::Pointwise ||
      this->Bound.Kind == ErrorKind::Bits;
  }

  /** Whether there are such values of a type. */
  bool IsValid(ScalarType type) const;

  /** Whether a value may stand for another one. The keys are plain. Exact, but that values that are
   * allowed by less than a millionth of a rounding error may be refused. */
  GATUN_EXPORT bool IsWithin(ScalarType type, Key original, Key stored) const;

  /** The error in the measure of the bound; infinite if NaN or infinity is involved. Keys that are
   * equal have no error. */
  GATUN_EXPORT double Measure(ScalarType type, Key original, Key stored) const;

  /** The largest error allowed, in the same measure. */
  GATUN_EXPORT double GetAllowed(ScalarType type) const;

  /** The place of the lattice for a value, or the value itself if there is none within the bound.
   * The result depends on nothing else. */
  Key ToLattice(ScalarType type, Key original) const;

  static constexpr double MaxKeyStep = 9007199254740992; // 2^53
};

/** The quantizer for a bound, or none if the values have to be exact for it. range: that of the
 * component; only a relative bound needs it. */
GATUN_EXPORT Quantizer MakeQuantizer(
  ScalarType type, const ErrorBound& bound, const FiniteRange& range);

/** The index of the place of a lattice that is closest to a key, and the key of a place modulo
 * 2^64. */
std::int64_t GetKeyIndex(Key key, Key zero, std::uint64_t step);
inline Key GetIndexKey(std::int64_t index, Key zero, std::uint64_t step)
{
  return zero + static_cast<std::uint64_t>(index) * step;
}

/** The index of the place of a lattice closest to a number, or 0 if it is not below 2^51. */
double GetNumberIndex(double number, double width);

/** Whether |a - b| <= bound, in exact arithmetic. The numbers are finite. */
bool IsClose(double a, double b, double bound);
}

#endif
