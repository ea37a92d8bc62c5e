// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunErrorBound.h"

#include "gatunError.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <system_error>

namespace gatun
{
//------------------------------------------------------------------------------
void CheckError(const ArrayError& error)
{
  const auto& bound = error.Bound;
  const auto fail = [&](const std::string& what)
  { ThrowInvalid("the error of array '" + error.Array + "' " + what); };
  if (bound.Kind < ErrorKind::Absolute || bound.Kind > ErrorKind::Bits)
  {
    fail("is of an unknown kind");
  }
  if (!(bound.Bound > 0) || !std::isfinite(bound.Bound))
  {
    fail("must be a number above 0");
  }
  if (bound.Kind == ErrorKind::Relative && bound.Bound > 1)
  {
    fail("must be at most 1, which is the whole range");
  }
  if (bound.Kind == ErrorKind::Pointwise && bound.Bound >= 1)
  {
    fail("must be below 1, which is the whole value");
  }
  if (bound.Kind == ErrorKind::Bits && (bound.Bound > 52 || bound.Bound != std::floor(bound.Bound)))
  {
    fail("must be a whole number of bits from 1 to 52");
  }
}

//------------------------------------------------------------------------------
ArrayError ParseError(const std::string& text, bool keepZeros)
{
  struct Kind
  {
    std::string_view Name;
    ErrorKind Value;
  };
  constexpr std::array kinds{ Kind{ "abs:", ErrorKind::Absolute },
    Kind{ "rel:", ErrorKind::Relative }, Kind{ "pw:", ErrorKind::Pointwise },
    Kind{ "bits:", ErrorKind::Bits } };
  // Names of arrays may have equal signs.
  const auto sign = text.rfind('=');
  const std::string_view bound =
    sign == std::string::npos ? std::string_view() : std::string_view(text).substr(sign + 1);
  const auto kind = std::find_if(
    kinds.begin(), kinds.end(), [&](const Kind& k) { return bound.starts_with(k.Name); });
  double number = 0;
  if (kind != kinds.end())
  {
    const auto digits = bound.substr(kind->Name.size());
    const auto* const end = digits.data() + digits.size();
    const auto [stop, code] = std::from_chars(digits.data(), end, number);
    if (code == std::errc() && stop == end)
    {
      ArrayError error{ text.substr(0, sign), { kind->Value, number, keepZeros } };
      CheckError(error);
      return error;
    }
  }
  ThrowInvalid("the error '" + text +
    "' is not NAME=abs:E, NAME=rel:E, NAME=pw:E or NAME=bits:N with a number E or N");
}

//------------------------------------------------------------------------------
std::string ToString(const ErrorBound& bound)
{
  constexpr std::array names{ "exact", "abs:", "rel:", "pw:", "bits:" };
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), bound.Bound).ptr;
  return names.at(static_cast<std::size_t>(bound.Kind)) +
    (bound ? std::string(digits.data(), end) : std::string()) +
    (bound && bound.KeepZeros ? ", zeros kept" : "");
}
}
