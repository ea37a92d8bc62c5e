// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnWords_h
#define gtnWords_h

// Words and numbers of files that are text.

#include "gtnParse.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace gtn
{
/** Takes the next word off a text; empty at its end. */
inline std::string_view TakeWord(std::string_view& text)
{
  constexpr std::string_view blanks = " \t\r\n\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

/** Whether all of a text is a number. */
template <typename T>
bool ParseWord(std::string_view text, T& number)
{
  if (text.starts_with('+') && !text.starts_with("+-"))
  {
    text.remove_prefix(1);
  }
  const std::optional<T> found = Parse<T>(text);
  number = found.value_or(number);
  return found.has_value();
}
}

#endif
