// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunErrorBound_h
#define gatunErrorBound_h

#include "gatunExport.h" // For export macro

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gatun
{
/** The measure of the error of a value. */
enum class ErrorKind : std::uint8_t
{
  None = 0,      ///< values are exact
  Absolute = 1,  ///< the difference
  Relative = 2,  ///< the difference, by the range of the finite values of the component at the step
  Pointwise = 3, ///< the difference, by the magnitude of the value
  Bits = 4       ///< the significant bits, the first one included, that are right after rounding
};

/** The largest error that a value may have. */
struct ErrorBound
{
  ErrorKind Kind = ErrorKind::None;
  double Bound = 0;       ///< or the number of bits
  bool KeepZeros = false; ///< whether values that are 0 stay 0

  bool operator==(const ErrorBound&) const = default;

  explicit operator bool() const { return this->Kind != ErrorKind::None; }
};

/** The bound of the arrays of a name. */
struct ArrayError
{
  std::string Array; ///< or "*" for all arrays of floating-point numbers that no other entry names
  ErrorBound Bound;
};

/** Throws Error(InvalidInput) if a number is not in its range: above 0, for relative bounds at most
 * 1, for pointwise ones below 1; bits from 1 to 52. */
GATUN_EXPORT void CheckError(const ArrayError& error);

/** The bound in a text "abs:E", "rel:E", "pw:E" or "bits:N", with ",zeros" at its end if values of
 * 0 stay 0. Nothing if it is another text. */
GATUN_EXPORT std::optional<ErrorBound> ParseBound(std::string_view text);

/** The bound in a text "NAME=BOUND". Throws Error(InvalidInput) if it is another text, or the
 * number is not in its range. */
GATUN_EXPORT ArrayError ParseError(const std::string& text);

/** The text of a bound, as ParseBound has it; "exact" if there is none. */
GATUN_EXPORT std::string ToString(const ErrorBound& bound);
}

#endif
