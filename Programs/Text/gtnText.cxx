// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnText.h"

#include "gtnFailure.h"

#include "gatunPrintable.h"

#include <filesystem>
#include <new>

namespace gtn
{
//------------------------------------------------------------------------------
namespace
{
/** A reason that begins with the name of the file. */
std::string MakeReason(const std::string& file, const std::string& reason)
{
  const std::string name = gatun::MakePrintable(file) + ": ";
  const std::string text = gatun::MakePrintable(reason);
  return text.starts_with(name) ? text : name + text;
}
}

//------------------------------------------------------------------------------
Failure::Failure(const std::string& file, const std::string& reason)
  : std::runtime_error(MakeReason(file, reason))
{
}

//------------------------------------------------------------------------------
const char* ReasonOf(const std::exception& error) noexcept
{
  return dynamic_cast<const std::bad_alloc*>(&error) ? "not enough memory" : error.what();
}

//------------------------------------------------------------------------------
std::string FileOf(const std::string& path)
{
  return std::filesystem::path(path).filename().string();
}

//------------------------------------------------------------------------------
std::string StemOf(const std::string& path)
{
  return std::filesystem::path(path).replace_extension().string();
}

//------------------------------------------------------------------------------
std::string ExtensionOf(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
  {
    if (c >= 'A' && c <= 'Z')
    {
      c = static_cast<char>(c - 'A' + 'a');
    }
  }
  return extension;
}
}
