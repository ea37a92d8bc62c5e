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

std::filesystem::path PathOf(const std::string& name)
{
  return IsAddress(name) ? name.substr(0, name.find_first_of("?#")) : name;
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
std::string LowerOf(std::string text)
{
  for (char& c : text)
  {
    if (c >= 'A' && c <= 'Z')
    {
      c = static_cast<char>(c - 'A' + 'a');
    }
  }
  return text;
}

//------------------------------------------------------------------------------
bool IsAddress(const std::string& name)
{
  const std::string start = LowerOf(name.substr(0, 8));
  return start.starts_with("http://") || start == "https://";
}

//------------------------------------------------------------------------------
std::string FileOf(const std::string& path)
{
  return PathOf(path).filename().string();
}

//------------------------------------------------------------------------------
std::string StemOf(const std::string& path)
{
  return PathOf(path).replace_extension().string();
}

//------------------------------------------------------------------------------
std::string ExtensionOf(const std::string& path)
{
  return LowerOf(PathOf(path).extension().string());
}
}
