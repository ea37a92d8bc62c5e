// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunErrorBound.h"

#include "gatunError.h"
#include "gatunNumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace gatun
{
namespace
{
constexpr std::string_view KeepsZeros = ",zeros";
}

//------------------------------------------------------------------------------
void CheckError(const ArrayError& error)
{
  const auto& bound = error.Bound;
  const auto fail = [&](const std::string& what)
  { ThrowInvalid("the tolerance of array '" + error.Array + "' " + what); };
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
std::optional<ErrorBound> ParseBound(std::string_view text)
{
  struct Kind
  {
    std::string_view Name;
    ErrorKind Value;
  };
  constexpr std::array kinds{ Kind{ "abs:", ErrorKind::Absolute },
    Kind{ "rel:", ErrorKind::Relative }, Kind{ "pw:", ErrorKind::Pointwise },
    Kind{ "bits:", ErrorKind::Bits } };
  ErrorBound bound;
  bound.KeepZeros = text.ends_with(KeepsZeros);
  text.remove_suffix(bound.KeepZeros ? KeepsZeros.size() : 0);
  const auto* const kind = std::find_if(
    kinds.begin(), kinds.end(), [&](const Kind& k) { return text.starts_with(k.Name); });
  if (kind == kinds.end())
  {
    return std::nullopt;
  }
  bound.Kind = kind->Value;
  return ParseNumber(text.substr(kind->Name.size()), bound.Bound) ? std::optional(bound)
                                                                  : std::nullopt;
}

//------------------------------------------------------------------------------
ArrayError ParseError(const std::string& text)
{
  const auto sign = text.rfind('='); // names of arrays may have equal signs
  if (sign != std::string::npos)
  {
    if (const auto bound = ParseBound(std::string_view(text).substr(sign + 1)))
    {
      ArrayError error{ text.substr(0, sign), *bound };
      CheckError(error);
      return error;
    }
  }
  ThrowInvalid("the tolerance '" + text +
    "' is not NAME=abs:E, NAME=rel:E, NAME=pw:E or NAME=bits:N with a number E or N, and ',zeros' "
    "behind it or not");
}

//------------------------------------------------------------------------------
std::string ToString(const ErrorBound& bound)
{
  constexpr std::array names{ "exact", "abs:", "rel:", "pw:", "bits:" };
  return names.at(static_cast<std::size_t>(bound.Kind)) +
    (bound ? FormatNumber(bound.Bound) : std::string()) +
    (bound && bound.KeepZeros ? std::string(KeepsZeros) : std::string());
}
}
