// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnParse_h
#define gtnParse_h

// Numbers on the command line.

#include "gtnCommandLine.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace gtn
{
/** All of a text as a number, or nothing. */
template <typename Number>
std::optional<Number> Parse(std::string_view text, int base = 10)
{
  Number number{};
  std::from_chars_result result{};
  if constexpr (std::is_integral_v<Number>)
  {
    result = std::from_chars(text.data(), text.data() + text.size(), number, base);
  }
  else
  {
    result = std::from_chars(text.data(), text.data() + text.size(), number);
  }
  const bool good = result.ec == std::errc() && result.ptr == text.data() + text.size();
  return good ? std::optional(number) : std::nullopt;
}

/** Throws CLI11's error for the value of an option. */
[[noreturn]] void Refuse(const char* option, const std::string& value, const std::string& wanted);

/** So many finite numbers with commas in between, or nothing. */
template <std::size_t Count>
std::optional<std::array<double, Count>> ParseList(std::string_view text)
{
  std::array<double, Count> numbers{};
  for (std::size_t i = 0; i < Count; ++i)
  {
    const std::size_t end = i + 1 < Count ? text.find(',') : text.size();
    const auto number = end == text.npos ? std::nullopt : Parse<double>(text.substr(0, end));
    if (!number || !std::isfinite(*number))
    {
      return {};
    }
    numbers[i] = *number;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return numbers;
}

/** A finite number within limits; CLI::Range lets NaN pass. */
CLI::Validator Between(double low, double high);

/** A finite number above 0. */
CLI::Validator Positive();
}

#endif
