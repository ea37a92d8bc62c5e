// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnNames.h"

#include "gtnText.h"

#include <fmt/core.h>

#include <vector>

namespace gtn
{
//------------------------------------------------------------------------------
std::string ListCells(const gatun::FileReader& file)
{
  if (file.GetNumberOfCells() == 0)
  {
    return "no cells";
  }
  if (file.IsTetrahedral())
  {
    return GroupDigits(file.GetNumberOfTets()) + " tetrahedra";
  }
  std::vector<std::string> types;
  for (const gatun::CellTypeCount& type : file.GetCellTypes())
  {
    types.push_back(GroupDigits(type.Cells) + " " + NameOfCellType(type.Type));
  }
  return fmt::format("{} cells ({})", GroupDigits(file.GetNumberOfCells()), Join(types));
}
}
