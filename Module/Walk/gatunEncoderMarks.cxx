// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunEncoderMarks.h"

#include "gatunCellNodes.h"
#include "gatunVertexHash.h"

#include <limits>
#include <utility>

namespace gatun
{
namespace
{
constexpr auto NoCell = std::numeric_limits<std::uint32_t>::max();
}

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
  , Earlier(cells.GetNumber(), NoCell)
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
      auto& last =
        this->Found.try_emplace(HashVertices(corners.first(degree)), NoCell).first->second;
      this->Earlier[cell] = std::exchange(last, cell);
    }
  }
}

bool EncoderMarks::FindCell(std::span<const std::uint32_t> face)
{
  const auto last = this->Found.find(HashVertices(face));
  for (auto cell = last == this->Found.end() ? NoCell : last->second; cell != NoCell;
       cell = this->Earlier[cell])
  {
    if (!this->Taken[cell] && this->FindTurn(cell, face))
    {
      this->Taken[cell] = 1;
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
