// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnText.h"

#include "gtnFailure.h"

#include "gatunPrintable.h"

#include <fmt/core.h>

#include <algorithm>
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
std::string Printable(std::string_view text)
{
  std::string line(text);
  std::replace_if(
    line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return gatun::MakePrintable(line);
}

//------------------------------------------------------------------------------
std::string Grouped(std::uint64_t number)
{
  const std::string digits = std::to_string(number);
  std::string grouped;
  for (std::size_t i = 0; i < digits.size(); ++i)
  {
    if (i > 0 && (digits.size() - i) % 3 == 0)
    {
      grouped += ',';
    }
    grouped += digits[i];
  }
  return grouped;
}

//------------------------------------------------------------------------------
std::string ByteSize(std::uint64_t bytes)
{
  if (bytes < 1024)
  {
    return fmt::format("{} B", bytes);
  }
  double size = static_cast<double>(bytes) / 1024;
  for (const char* unit : { "KiB", "MiB", "GiB" })
  {
    if (size < 1024)
    {
      return fmt::format("{:.{}f} {}", size, size < 100 ? 1 : 0, unit);
    }
    size /= 1024;
  }
  return fmt::format("{:.1f} TiB", size);
}

//------------------------------------------------------------------------------
std::string Number(double value)
{
  return fmt::format("{}", value);
}

//------------------------------------------------------------------------------
std::string Joined(const std::vector<std::string>& parts, std::string_view separator)
{
  std::string all;
  for (const std::string& part : parts)
  {
    if (&part != &parts.front())
    {
      all += separator;
    }
    all += part;
  }
  return all;
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
