// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunDescriptionText.h"

#include "gatunCellShapes.h"
#include "gatunFileReader.h"
#include "gatunNumberText.h"
#include "gatunPrintable.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
//------------------------------------------------------------------------------
std::string MakePrintableLine(std::string_view text)
{
  std::string line(text);
  std::replace_if(
    line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return gatun::MakePrintable(line);
}

//------------------------------------------------------------------------------
std::string GroupDigits(std::uint64_t number)
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
std::string DescribeByteSize(std::uint64_t bytes)
{
  if (bytes < 1024)
  {
    return std::to_string(bytes) + " B";
  }
  double size = static_cast<double>(bytes) / 1024;
  for (const char* unit : { " KiB", " MiB", " GiB" })
  {
    if (size < 1024)
    {
      return DescribeFixed(size, size < 100 ? 1 : 0) + unit;
    }
    size /= 1024;
  }
  return DescribeFixed(size, 1) + " TiB";
}

//------------------------------------------------------------------------------
std::string DescribeNumber(double value)
{
  // Not simply the shorter one of both notations, which would be 1e+05.
  const double size = std::abs(value);
  const bool isFixed = size == 0 || (size >= 1e-4 && size < 1e16);
  return FormatNumber(value, isFixed ? NumberForm::Fixed : NumberForm::Scientific);
}

//------------------------------------------------------------------------------
std::string DescribeNumber(double value, int digits)
{
  return FormatNumber(value, NumberForm::General, digits);
}

//------------------------------------------------------------------------------
std::string DescribeFixed(double value, int digits)
{
  return FormatNumber(value, NumberForm::Fixed, digits);
}

//------------------------------------------------------------------------------
std::string Join(const std::vector<std::string>& parts, std::string_view separator)
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
const char* NameOfType(ScalarType type)
{
  switch (type)
  {
    case ScalarType::Int8:
      return "int8";
    case ScalarType::UInt8:
      return "uint8";
    case ScalarType::Int16:
      return "int16";
    case ScalarType::UInt16:
      return "uint16";
    case ScalarType::Int32:
      return "int32";
    case ScalarType::UInt32:
      return "uint32";
    case ScalarType::Int64:
      return "int64";
    case ScalarType::UInt64:
      return "uint64";
    case ScalarType::Float32:
      return "float32";
    case ScalarType::Float64:
      return "float64";
  }
  return "unknown";
}

//------------------------------------------------------------------------------
std::string NameOfCellType(int type)
{
  const char* const name = GetCellTypeName(type);
  return name ? name : "of type " + std::to_string(type);
}

//------------------------------------------------------------------------------
std::string NameOfProfile(Profile profile)
{
  return profile == Profile::Fast ? "fast" : "small";
}

//------------------------------------------------------------------------------
std::string NameOfKeptOrder(std::uint8_t kept)
{
  std::vector<std::string> parts;
  if (kept & KeepPoints)
  {
    parts.emplace_back("points");
  }
  if (kept & KeepCells)
  {
    parts.emplace_back("cells");
  }
  if (kept & KeepCorners)
  {
    parts.emplace_back("corners");
  }
  return parts.empty() ? "none" : Join(parts);
}
}
