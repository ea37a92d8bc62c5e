// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPaths_h
#define gatunPaths_h

// Names of files are UTF-8 on Windows and any bytes elsewhere. std::filesystem takes a std::string
// for text of the current code page on Windows.

#include "gatunError.h"

#include <filesystem>
#include <string>
#include <system_error>

namespace gatun
{
inline std::filesystem::path ToPath(const std::string& name)
{
  try
  {
    return { std::u8string(name.begin(), name.end()) };
  }
  catch (const std::system_error&)
  {
    ThrowInvalid("the name is not UTF-8", name);
  }
}

inline std::string ToText(const std::filesystem::path& path)
{
  const auto name = path.u8string();
  return { name.begin(), name.end() };
}
}

#endif
