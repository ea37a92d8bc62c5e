// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnArraySetting_h
#define gtnArraySetting_h

// An array with settings behind its name, as in "T:8:uniform".

#include "gtnCommandLine.h"

#include <optional>
#include <string>
#include <string_view>

namespace gtn
{
struct ArraySetting
{
  std::string Name;
  std::optional<int> Count;
  std::string Word; ///< one of those that are known, or empty
};

/**
 * Takes NAME[:COUNT][:WORD] apart. Names may have colons: only what is a number, or a word out of
 * "a|b|c", is taken for a setting. Throws UsageError, naming the option, unless there is a name and
 * the count is from 0 to most.
 */
ArraySetting ParseArraySetting(
  const char* option, const std::string& text, int most, std::string_view words);

/** A component from 0, or "magnitude", which is -1. Returns the option. */
CLI::Option* AddComponent(
  CLI::App* command, const std::string& name, int& component, const std::string& description);
}

#endif
