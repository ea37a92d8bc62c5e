// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellStore.h"

#include "gatunCellSplitter.h"

#include <algorithm>
#include <type_traits>

namespace gatun
{
//------------------------------------------------------------------------------
CellList MakeTetList(std::vector<std::array<Vertex, 4>> tets)
{
  CellList cells;
  cells.Types.assign(tets.size(), TetraType);
  cells.Starts.resize(tets.size() + 1);
  cells.Corners.reserve(4 * tets.size());
  for (std::size_t t = 0; t < tets.size(); ++t)
  {
    cells.Corners.insert(cells.Corners.end(), tets[t].begin(), tets[t].end());
    cells.Starts[t + 1] = static_cast<std::uint32_t>(cells.Corners.size());
  }
  return cells;
}

//------------------------------------------------------------------------------
std::uint64_t CountFaceValues(const CellList& cells, std::size_t cell)
{
  // VTK stores the number of faces before them.
  return cells.Types[cell] == PolyhedronType ? 1 + cells.GetFaces(cell).size() : 0;
}

//------------------------------------------------------------------------------
void CellStore::SetOffset(std::uint64_t cell, std::uint64_t value) const
{
  if (this->Target.WideIds)
  {
    static_cast<std::int64_t*>(this->Target.Offsets)[cell] = static_cast<std::int64_t>(value);
  }
  else
  {
    static_cast<std::int32_t*>(this->Target.Offsets)[cell] = static_cast<std::int32_t>(value);
  }
}

//------------------------------------------------------------------------------
std::uint64_t CellStore::GetOffset(std::uint64_t cell) const
{
  return this->Target.WideIds
    ? static_cast<std::uint64_t>(static_cast<const std::int64_t*>(this->Target.Offsets)[cell])
    : static_cast<std::uint64_t>(static_cast<const std::int32_t*>(this->Target.Offsets)[cell]);
}

//------------------------------------------------------------------------------
void CellStore::StoreCorners(std::span<const std::uint32_t> corners,
  std::span<const std::uint64_t> ids, std::uint64_t first) const
{
  const auto store = [&](auto* connectivity)
  {
    using Id = std::remove_pointer_t<decltype(connectivity)>;
    std::transform(corners.begin(), corners.end(), connectivity + first,
      [ids](std::uint32_t point) { return static_cast<Id>(ids[point]); });
  };
  if (this->Target.WideIds)
  {
    store(static_cast<std::int64_t*>(this->Target.Connectivity));
  }
  else
  {
    store(static_cast<std::int32_t*>(this->Target.Connectivity));
  }
}

//------------------------------------------------------------------------------
void CellStore::StoreFaces(const CellList& list, std::size_t cell,
  std::span<const std::uint64_t> ids, std::uint64_t faceValue) const
{
  if (list.Types[cell] != PolyhedronType)
  {
    return;
  }
  std::int64_t* const count = this->Target.Faces + faceValue;
  std::int64_t* to = count + 1;
  const auto faces = list.GetFaces(cell);
  *count = 0;
  for (std::size_t at = 0; at < faces.size(); ++*count)
  {
    *to++ = faces[at];
    for (auto points = faces[at++]; points > 0; --points)
    {
      *to++ = static_cast<std::int64_t>(ids[faces[at++]]);
    }
  }
}

//------------------------------------------------------------------------------
void CellStore::Store(const CellList& list, std::span<const std::uint64_t> ids,
  std::uint64_t firstCell, std::uint64_t firstCorner, std::uint64_t firstFaceValue) const
{
  this->StoreCorners(list.Corners, ids, firstCorner);
  std::copy(list.Types.begin(), list.Types.end(), this->Target.Types + firstCell);
  for (std::size_t cell = 0; cell < list.GetNumber(); ++cell)
  {
    this->SetOffset(firstCell + cell, firstCorner + list.Starts[cell]);
  }
  for (std::size_t cell = 0; this->Target.FaceLocations && cell < list.GetNumber(); ++cell)
  {
    const auto faceValues = CountFaceValues(list, cell);
    this->Target.FaceLocations[firstCell + cell] =
      faceValues > 0 ? static_cast<std::int64_t>(firstFaceValue) : -1;
    this->StoreFaces(list, cell, ids, firstFaceValue);
    firstFaceValue += faceValues;
  }
}

//------------------------------------------------------------------------------
void CellStore::Finish(std::uint64_t cells, std::uint64_t corners) const
{
  this->SetOffset(cells, corners);
}

//------------------------------------------------------------------------------
void CellStore::Add(const PlacedCells& cells) const
{
  const CellList& list = cells.Cells;
  for (std::size_t cell = 0; cell < list.GetNumber(); ++cell)
  {
    const std::uint64_t place = (*cells.Places)[cell];
    this->SetOffset(place + 1, list.GetCorners(cell).size());
    this->Target.Types[place] = list.Types[cell];
    if (this->Target.FaceLocations)
    {
      this->Target.FaceLocations[place] = static_cast<std::int64_t>(CountFaceValues(list, cell));
    }
  }
}

//------------------------------------------------------------------------------
void CellStore::AddUp(std::uint64_t cells) const
{
  std::uint64_t corners = 0;
  std::int64_t faceValues = 0;
  this->SetOffset(0, 0);
  for (std::uint64_t cell = 0; cell < cells; ++cell)
  {
    corners += this->GetOffset(cell + 1);
    this->SetOffset(cell + 1, corners);
    if (this->Target.FaceLocations)
    {
      auto& location = this->Target.FaceLocations[cell];
      const auto values = location;
      location = values > 0 ? faceValues : -1;
      faceValues += values;
    }
  }
}

//------------------------------------------------------------------------------
void CellStore::StoreAdded(const PlacedCells& cells) const
{
  for (std::size_t cell = 0; cell < cells.Cells.GetNumber(); ++cell)
  {
    const std::uint64_t place = (*cells.Places)[cell];
    const std::int64_t location =
      this->Target.FaceLocations ? this->Target.FaceLocations[place] : 0;
    this->StoreCorners(cells.Cells.GetCorners(cell), cells.Ids, this->GetOffset(place));
    this->StoreFaces(cells.Cells, cell, cells.Ids, static_cast<std::uint64_t>(location));
  }
}
}
