// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnNames.h"

#include "gtnText.h"

#include "gatunDescriptionText.h"

#include <fmt/core.h>

#include <vector>

namespace gtn
{
//------------------------------------------------------------------------------
const char* NameOf(gatun::ScalarType type)
{
  return gatun::NameOfType(type);
}

//------------------------------------------------------------------------------
std::string NameOfCell(int type)
{
  return gatun::NameOfCellType(type);
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
  return gatun::NameOfKeptOrder(kept);
}
}
