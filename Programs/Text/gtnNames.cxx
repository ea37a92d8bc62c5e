// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnNames.h"

#include "gtnText.h"

#include <vector>

namespace gtn
{
//------------------------------------------------------------------------------
const char* NameOf(gatun::ScalarType type)
{
  switch (type)
  {
    case gatun::ScalarType::Int8:
      return "int8";
    case gatun::ScalarType::UInt8:
      return "uint8";
    case gatun::ScalarType::Int16:
      return "int16";
    case gatun::ScalarType::UInt16:
      return "uint16";
    case gatun::ScalarType::Int32:
      return "int32";
    case gatun::ScalarType::UInt32:
      return "uint32";
    case gatun::ScalarType::Int64:
      return "int64";
    case gatun::ScalarType::UInt64:
      return "uint64";
    case gatun::ScalarType::Float32:
      return "float32";
    case gatun::ScalarType::Float64:
      return "float64";
  }
  return "unknown";
}

//------------------------------------------------------------------------------
std::string NameOfOrder(std::uint8_t kept)
{
  std::vector<std::string> parts;
  if (kept & gatun::KeepPoints)
  {
    parts.emplace_back("points");
  }
  if (kept & gatun::KeepCells)
  {
    parts.emplace_back("cells");
  }
  if (kept & gatun::KeepCorners)
  {
    parts.emplace_back("corners");
  }
  return parts.empty() ? "none" : Joined(parts);
}
}
