// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gtnArraySetting.h"

#include "gtnFailure.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <charconv>

namespace gtn
{
namespace
{
/** What is behind the last colon, if there is one with something before it. */
std::optional<std::string_view> LastPart(std::string_view text)
{
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos || colon == 0)
  {
    return {};
  }
  return text.substr(colon + 1);
}

bool IsOneOf(std::string_view word, std::string_view words)
{
  const std::string all = "|" + std::string(words) + "|";
  return !word.empty() && all.find("|" + std::string(word) + "|") != std::string::npos;
}

bool IsNumber(std::string_view text)
{
  return !text.empty() &&
    std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/** A number without sign, or -1 if it is none or too large. */
int NumberOf(std::string_view text)
{
  int number = -1;
  const auto end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, number);
  return IsNumber(text) && last == end && error == std::errc() ? number : -1;
}
}

//------------------------------------------------------------------------------
ArraySetting ParseArraySetting(
  const char* option, const std::string& text, int most, std::string_view words)
{
  ArraySetting choice;
  std::string_view rest = text;
  if (const auto word = LastPart(rest); word && IsOneOf(*word, words))
  {
    choice.Word = *word;
    rest.remove_suffix(word->size() + 1);
  }
  if (const auto count = LastPart(rest); count && IsNumber(*count))
  {
    choice.Count = NumberOf(*count);
    if (*choice.Count < 0 || *choice.Count > most)
    {
      throw UsageError(fmt::format("{} {}: the number must be from 0 to {}", option, text, most));
    }
    rest.remove_suffix(count->size() + 1);
  }
  choice.Name = rest;
  if (choice.Name.empty())
  {
    throw UsageError(fmt::format("{} {}: there is no name of an array", option, text));
  }
  return choice;
}

//------------------------------------------------------------------------------
CLI::Option* AddComponent(
  CLI::App* command, const std::string& name, int& component, const std::string& description)
{
  return command
    ->add_option_function<std::string>(
      name,
      [name, &component](const std::string& text)
      {
        component = text == "magnitude" ? -1 : NumberOf(text);
        if (component < 0 && text != "magnitude")
        {
          throw UsageError(name + " " + text + ": neither a number from 0 nor 'magnitude'");
        }
      },
      description)
    ->option_text("C");
}
}
