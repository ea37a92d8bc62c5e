// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunEncoderMarks.h"

#include "gatunCellNodes.h"
#include "gatunVertexHash.h"

namespace gatun
{
unsigned CountMarkCorners(std::uint8_t type, unsigned degree)
{
  switch (type)
  {
    case 5: // triangles
    case 22:
    case 34:
    case 69: // Lagrange
    case 76: // Bezier
      return 3;
    case 7: // polygon
      return degree;
    case 8: // quads
    case 9:
    case 23:
    case 28:
    case 30:
    case 70:
    case 77:
      return 4;
    default:
      return 0;
  }
}

bool HasAllNodes(std::uint8_t type, unsigned degree, std::size_t points)
{
  return HasNodes(type) ? CanFindCellNodes(type, points) : points == degree;
}

EncoderMarks::EncoderMarks(const CellList& cells, std::span<const std::uint32_t> candidates)
  : Cells(cells)
  , Taken(cells.GetNumber(), 0)
{
  constexpr std::size_t most = 100; // so that turns fit a byte
  for (const auto cell : candidates)
  {
    const auto corners = cells.GetCorners(cell);
    const auto type = cells.Types[cell];
    const auto degree = CountMarkCorners(type, static_cast<unsigned>(corners.size()));
    if (degree >= 3 && degree <= most && HasAllNodes(type, degree, corners.size()))
    {
      this->Found.emplace(HashVertices(corners.first(degree)), cell);
    }
  }
}

bool EncoderMarks::FindCell(std::span<const std::uint32_t> face)
{
  const auto [begin, end] = this->Found.equal_range(HashVertices(face));
  for (auto it = begin; it != end; ++it)
  {
    if (!this->Taken[it->second] && this->FindTurn(it->second, face))
    {
      this->Taken[it->second] = 1;
      return true;
    }
  }
  return false;
}

bool EncoderMarks::FindTurn(std::uint32_t cell, std::span<const std::uint32_t> face)
{
  const auto corners = this->Cells.GetCorners(cell);
  const auto degree = static_cast<unsigned>(face.size());
  this->Cell = cell;
  this->Type = this->Cells.Types[cell];
  if (CountMarkCorners(this->Type, static_cast<unsigned>(corners.size())) != degree)
  {
    return false;
  }
  for (unsigned turn = 0; turn < 2 * degree; ++turn)
  {
    unsigned same = 0;
    while (same < degree &&
      corners[GetMarkCorner(this->Type, same)] == face[GetMarkPlace(turn, same, degree)])
    {
      ++same;
    }
    if (same == degree)
    {
      this->Turn = static_cast<std::uint8_t>(turn);
      return true;
    }
  }
  return false;
}
}
