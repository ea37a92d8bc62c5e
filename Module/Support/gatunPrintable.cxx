// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPrintable.h"

#include <cstddef>
#include <cstdint>

namespace gatun
{
namespace
{
std::uint8_t ByteOf(std::string_view text, std::size_t i)
{
  return i < text.size() ? static_cast<std::uint8_t>(text[i]) : 0;
}

/** The length of the character of UTF-8 at the beginning of a text, or 0 if there is none. See
 * RFC 3629. */
std::size_t GetLengthOfCharacter(std::string_view text)
{
  const auto first = ByteOf(text, 0);
  const std::size_t length = first < 0x80 ? 1
    : first >= 0xc2 && first < 0xe0       ? 2
    : first >= 0xe0 && first < 0xf0       ? 3
    : first >= 0xf0 && first < 0xf5       ? 4
                                          : 0;
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((ByteOf(text, i) & 0xc0) != 0x80)
    {
      return 0;
    }
  }
  // Characters that are longer than need be, surrogates, and numbers above U+10FFFF.
  const auto second = ByteOf(text, 1);
  const bool isInvalid = (first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0) ||
    (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90);
  return isInvalid ? 0 : length;
}

bool IsControl(std::string_view character)
{
  const auto first = ByteOf(character, 0);
  return (first < 0x20 && first != '\t' && first != '\n') || first == 0x7f ||
    (first == 0xc2 && ByteOf(character, 1) < 0xa0);
}
}

//------------------------------------------------------------------------------
std::string MakePrintable(std::string_view text)
{
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result;
  while (!text.empty())
  {
    const std::size_t length = GetLengthOfCharacter(text);
    const auto character = text.substr(0, length > 0 ? length : 1);
    if (length == 0 || IsControl(character))
    {
      for (const char byte : character)
      {
        const auto number = static_cast<std::uint8_t>(byte);
        result += "\\x";
        result += digits[number / 16];
        result += digits[number % 16];
      }
    }
    else
    {
      result += character;
    }
    text.remove_prefix(character.size());
  }
  return result;
}
}
