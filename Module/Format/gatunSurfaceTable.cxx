// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceTable.h"

#include "gatunSurfaceCells.h"
#include "gatunTableParts.h"

#include <algorithm>

namespace gatun
{
namespace
{
constexpr std::uint8_t KindPolyData = 1;
}

//------------------------------------------------------------------------------
Bytes WriteSurfaceMark()
{
  return { KindPolyData };
}

//------------------------------------------------------------------------------
void CheckSurfaceMark(std::span<const std::uint8_t> bytes, const std::vector<CellTypeCount>& types)
{
  Check(bytes.size() == 1 && bytes.front() == KindPolyData, "the kind of surface is unknown");
  Check(std::all_of(types.begin(), types.end(),
          [](const CellTypeCount& type) { return IsSurfaceCell(type.Type); }),
    "there are cells that are no part of a surface");
}
}
