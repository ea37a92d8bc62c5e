// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellSubset.h"

#include "gatunError.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace gatun
{
namespace
{
std::vector<bool> MarkAll(
  std::span<const std::uint64_t> numbers, std::uint64_t count, const char* what)
{
  std::vector<bool> marks(static_cast<std::size_t>(count), false);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (numbers[i] >= count || (i > 0 && numbers[i] <= numbers[i - 1]))
    {
      ThrowInvalid(std::string("the numbers of remaining ") + what + " do not ascend");
    }
    marks[static_cast<std::size_t>(numbers[i])] = true;
  }
  return marks;
}
}

//------------------------------------------------------------------------------
CellSubset::CellSubset(const MeshAccess& mesh, const RemainingCells& remaining)
  : Cells(MarkAll(remaining.Cells, mesh.GetMesh().Cells, "cells"))
  , DropsPoints(remaining.DropsPoints)
{
  const auto count = static_cast<std::size_t>(mesh.GetMesh().Points);
  if (!this->DropsPoints)
  {
    this->Points.assign(count, true);
    return;
  }
  this->Points.assign(count, false);
  for (const auto cell : remaining.Cells)
  {
    mesh.ForEachPoint(
      cell, [&](std::uint64_t point) { this->Points[static_cast<std::size_t>(point)] = true; });
  }
  if (this->Points != MarkAll(remaining.Points, mesh.GetMesh().Points, "points"))
  {
    ThrowInvalid("the remaining points are not those of the remaining cells");
  }
}

//------------------------------------------------------------------------------
Bytes CellSubset::Spread(
  const void* values, Association where, std::size_t tupleSize, const Bytes& before) const
{
  const auto& isAlive = this->Get(where);
  Bytes all(before);
  all.resize(isAlive.size() * tupleSize);
  const auto* from = static_cast<const std::uint8_t*>(values);
  for (std::size_t i = 0; i < isAlive.size(); ++i)
  {
    if (isAlive[i])
    {
      std::memcpy(all.data() + i * tupleSize, from, tupleSize);
      from += tupleSize;
    }
  }
  return all;
}

//------------------------------------------------------------------------------
CellMask CellSubset::MakeMask(const WriterPart& part) const
{
  CellMask mask;
  mask.DropsPoints = this->DropsPoints;
  mask.IsAlive.reserve(this->Cells.size());
  std::array<std::uint64_t, 256> remaining{};
  std::array<bool, 256> isThere{};
  for (const auto& chunk : part.Chunks)
  {
    for (const auto cell : chunk.CellOf)
    {
      const auto type = part.Mesh.GetType(cell);
      mask.IsAlive.push_back(this->Cells[cell]);
      isThere[type] = true;
      remaining[type] += this->Cells[cell] ? 1 : 0;
    }
  }
  for (std::size_t type = 0; type < remaining.size(); ++type)
  {
    if (isThere[type])
    {
      mask.Types.push_back({ static_cast<std::uint8_t>(type), remaining[type] });
      mask.Cells += remaining[type];
    }
  }
  mask.Points =
    static_cast<std::uint64_t>(std::count(this->Points.begin(), this->Points.end(), true));
  return mask;
}
}
