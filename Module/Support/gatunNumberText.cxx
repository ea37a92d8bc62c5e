// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunNumberText.h"

#include <array>
#include <charconv>
#include <limits>
#include <locale>
#include <sstream>
#include <system_error>

namespace gatun
{
#if defined(__cpp_lib_to_chars)
//------------------------------------------------------------------------------
bool ParseNumber(std::string_view text, double& number)
{
  const auto* const end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, number);
  return code == std::errc() && stop == end;
}

//------------------------------------------------------------------------------
std::string FormatNumber(double number)
{
  std::array<char, 32> digits{};
  return { digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr };
}

namespace
{
constexpr std::size_t Longest = 400; // the largest number has 309 digits before the point

template <typename... Digits>
std::string ToText(double number, NumberForm form, Digits... digits)
{
  const auto format = form == NumberForm::Fixed ? std::chars_format::fixed
    : form == NumberForm::Scientific            ? std::chars_format::scientific
                                                : std::chars_format::general;
  std::array<char, Longest> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, format, digits...);
  return end.ec == std::errc() ? std::string(text.data(), end.ptr) : std::string();
}
}

//------------------------------------------------------------------------------
std::string FormatNumber(double number, NumberForm form)
{
  return ToText(number, form);
}

//------------------------------------------------------------------------------
std::string FormatNumber(double number, NumberForm form, int digits)
{
  return ToText(number, form, digits);
}
#else
// libc++ had none of these functions for floating-point numbers for long.
//------------------------------------------------------------------------------
bool ParseNumber(std::string_view text, double& number)
{
  std::istringstream in{ std::string(text) };
  in.imbue(std::locale::classic());
  return !text.starts_with('+') && in >> std::noskipws >> number &&
    in.peek() == std::istringstream::traits_type::eof();
}

//------------------------------------------------------------------------------
std::string FormatNumber(double number)
{
  constexpr int enough = std::numeric_limits<double>::max_digits10;
  for (int digits = 1;; ++digits)
  {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(digits);
    out << number;
    double same = 0;
    if (digits == enough || (ParseNumber(out.str(), same) && same == number))
    {
      return out.str();
    }
  }
}

//------------------------------------------------------------------------------
std::string FormatNumber(double number, NumberForm form)
{
  constexpr int enough = std::numeric_limits<double>::max_digits10;
  for (int digits = 0;; ++digits)
  {
    auto text = FormatNumber(number, form, digits);
    double same = 0;
    if (digits == enough || (ParseNumber(text, same) && same == number))
    {
      return text;
    }
  }
}

//------------------------------------------------------------------------------
std::string FormatNumber(double number, NumberForm form, int digits)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(digits);
  if (form != NumberForm::General)
  {
    out.setf(
      form == NumberForm::Fixed ? std::ios::fixed : std::ios::scientific, std::ios::floatfield);
  }
  out << number;
  return out.str();
}
#endif
}
