// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnParse.h"

#include "gtnText.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <cmath>

namespace gtn
{
//------------------------------------------------------------------------------
void Refuse(const char* option, const std::string& value, const std::string& wanted)
{
  throw CLI::ValidationError(
    option, fmt::format("'{}' is not {}", MakePrintableLine(value), wanted));
}

//------------------------------------------------------------------------------
CLI::Validator Between(double low, double high)
{
  return CLI::Validator(
    [low, high](const std::string& text)
    {
      const double number = Parse<double>(text).value_or(std::nan(""));
      return number >= low && number <= high
        ? std::string()
        : fmt::format("'{}' is not a number from {} to {}", MakePrintableLine(text), low, high);
    },
    "");
}

//------------------------------------------------------------------------------
CLI::Validator Positive()
{
  return CLI::Validator(
    [](const std::string& text)
    {
      const double number = Parse<double>(text).value_or(0);
      return number > 0 && std::isfinite(number)
        ? std::string()
        : fmt::format("'{}' is not a number above 0", MakePrintableLine(text));
    },
    "");
}
}
