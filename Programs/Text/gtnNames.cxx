// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnNames.h"

#include "gtnText.h"

#include "vtkCellTypes.h"

#include <fmt/core.h>

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
std::string NameOfCell(int type)
{
  const std::string name = vtkCellTypes::GetClassNameFromTypeId(type);
  return name == "UnknownClass" ? fmt::format("of type {}", type) : name;
}

//------------------------------------------------------------------------------
std::string ListCells(const gatun::FileReader& file)
{
  if (file.IsTetrahedral())
  {
    return Grouped(file.GetNumberOfTets()) + " tetrahedra";
  }
  std::vector<std::string> types;
  for (const gatun::CellTypeCount& type : file.GetCellTypes())
  {
    types.push_back(Grouped(type.Cells) + " " + NameOfCell(type.Type));
  }
  return fmt::format("{} cells ({})", Grouped(file.GetNumberOfCells()), Joined(types));
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
