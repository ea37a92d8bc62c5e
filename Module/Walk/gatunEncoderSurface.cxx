// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunEncoderSurface.h"

#include "gatunCellShapes.h"
#include "gatunEncoderMarks.h"

#include <algorithm>
#include <bit>

namespace gatun
{
namespace
{
/** The number of corners of a cell that may be part of a surface, otherwise 0. */
std::uint32_t CountCorners(const CellList& cells, std::uint32_t cell)
{
  const auto points = cells.GetCorners(cell).size();
  const auto degree = CountMarkCorners(cells.Types[cell], static_cast<unsigned>(points));
  const bool fits = HasAllNodes(cells.Types[cell], degree, points);
  return fits && degree >= 3 && degree <= MaxWalkedCorners ? degree : 0;
}
}

//------------------------------------------------------------------------------
EncoderSurface::EncoderSurface(
  const CellList& cells, std::span<const std::uint32_t> candidates, bool keepCorners)
  : Cells(cells)
  , KeepCorners(keepCorners)
  , States(cells.GetNumber(), State::Never)
{
  std::size_t edges = 0;
  for (const auto cell : candidates)
  {
    const auto degree = CountCorners(cells, cell);
    if (degree > 0 && !HasTwice(cells.GetCorners(cell).first(degree)))
    {
      this->States[cell] = State::Waiting;
      this->Seeds.push_back(cell);
      edges += degree;
    }
  }
  this->Heads.assign(std::bit_ceil(edges + 1), None);
  this->Edges.reserve(edges);
  for (auto cell = this->Seeds.rbegin(); cell != this->Seeds.rend(); ++cell)
  {
    this->AddEdges(*cell);
  }
  std::erase_if(this->Seeds, [&](std::uint32_t cell) { return !this->HasNeighbor(cell); });
  std::fill(this->States.begin(), this->States.end(), State::Never);
  for (const auto cell : this->Seeds)
  {
    this->States[cell] = State::Waiting;
  }
  this->Number = this->Seeds.size();
}

std::size_t EncoderSurface::GetPlaceOfHead(std::uint32_t a, std::uint32_t b) const
{
  auto hash = (std::uint64_t{ std::min(a, b) } << 32 | std::max(a, b)) * 0x9e3779b97f4a7c15u;
  hash ^= hash >> 32;
  return hash & (this->Heads.size() - 1);
}

/** The corner at a place of a cell's cycle. */
std::uint32_t EncoderSurface::GetCorner(std::uint32_t cell, std::uint32_t place) const
{
  const auto degree = CountCorners(this->Cells, cell);
  return this->Cells.GetCorners(
    cell)[GetMarkCorner(this->Cells.Types[cell], place < degree ? place : place - degree)];
}

void EncoderSurface::AddEdges(std::uint32_t cell)
{
  const auto degree = CountCorners(this->Cells, cell);
  for (std::uint32_t i = 0; i < degree; ++i)
  {
    auto& head = this->GetHead(this->GetCorner(cell, i), this->GetCorner(cell, i + 1));
    this->Edges.push_back({ cell, i, head });
    head = static_cast<std::uint32_t>(this->Edges.size() - 1);
  }
}

bool EncoderSurface::HasNeighbor(std::uint32_t cell)
{
  const auto degree = CountCorners(this->Cells, cell);
  for (std::uint32_t i = 0; i < degree; ++i)
  {
    const auto a = this->GetCorner(cell, i);
    const auto b = this->GetCorner(cell, i + 1);
    for (auto e = this->GetHead(a, b); e != None; e = this->Edges[e].Next)
    {
      const auto& edge = this->Edges[e];
      const auto c = this->GetCorner(edge.Cell, edge.Place);
      const auto d = this->GetCorner(edge.Cell, edge.Place + 1);
      if (edge.Cell != cell && ((a == c && b == d) || (a == d && b == c)))
      {
        return true;
      }
    }
  }
  return false;
}

bool EncoderSurface::IsUniform() const
{
  const auto isOther = [&](std::uint32_t cell) { return this->Cells.Types[cell] != TriangleType; };
  if (this->KeepCorners || std::any_of(this->Seeds.begin(), this->Seeds.end(), isOther))
  {
    return false;
  }
  // An edge that runs twice in the same direction is that of a cell that is turned, or may be.
  for (const auto& edge : this->Edges)
  {
    const auto a = this->GetCorner(edge.Cell, edge.Place);
    const auto b = this->GetCorner(edge.Cell, edge.Place + 1);
    for (auto e = edge.Next; e != None; e = this->Edges[e].Next)
    {
      const auto& other = this->Edges[e];
      if (this->GetCorner(other.Cell, other.Place) == a &&
        this->GetCorner(other.Cell, other.Place + 1) == b)
      {
        return false;
      }
    }
  }
  return true;
}

bool EncoderSurface::FindCell(std::uint32_t begin, std::uint32_t end, bool turned)
{
  constexpr unsigned most = 16; // where many polygons meet
  auto found = None;
  auto* next = &this->GetHead(begin, end);
  for (unsigned count = 0; *next != None && count < most;)
  {
    auto& edge = this->Edges[*next];
    if (this->States[edge.Cell] != State::Waiting)
    {
      *next = edge.Next; // never looked at again
      continue;
    }
    const auto a = this->GetCorner(edge.Cell, edge.Place);
    const auto b = this->GetCorner(edge.Cell, edge.Place + 1);
    const bool with = a == begin && b == end;
    const bool against = a == end && b == begin;
    if (with || against)
    {
      const bool wanted = against == turned;
      found = wanted || found == None ? *next : found;
      count = wanted ? most : count + 1;
    }
    next = &edge.Next;
  }
  if (found == None)
  {
    return false;
  }
  const auto& edge = this->Edges[found];
  const bool against = this->GetCorner(edge.Cell, edge.Place) != begin;
  this->Begin(edge.Cell, against ? edge.Place + 1 : edge.Place, against);
  return true;
}

bool EncoderSurface::FindSeed()
{
  while (this->NextSeed < this->Seeds.size() &&
    this->States[this->Seeds[this->NextSeed]] == State::Taken)
  {
    ++this->NextSeed;
  }
  if (this->NextSeed == this->Seeds.size())
  {
    return false;
  }
  this->Begin(this->Seeds[this->NextSeed], 0, false);
  return true;
}

void EncoderSurface::Begin(std::uint32_t cell, std::uint32_t place, bool turned)
{
  const auto degree = CountCorners(this->Cells, cell);
  place %= degree;
  this->States[cell] = State::Taken;
  this->Cell = cell;
  this->Type = this->Cells.Types[cell];
  const auto turn = turned ? 2 * place + 1 : 2 * ((degree - place) % degree);
  // Always the same turn, but for the orientation, costs nothing.
  this->Turn = this->KeepCorners || this->Type != TriangleType ? turn : turn % 2;
  this->Corners.resize(degree);
  for (std::uint32_t i = 0; i < degree; ++i)
  {
    this->Corners[i] = this->GetCorner(cell, place + (turned ? degree - i : i) % degree);
  }
}
}
