// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPieceCells.h"

#include <algorithm>

namespace gatun
{
namespace
{
void StoreIds(const std::vector<std::int64_t>& ids, void* to, bool wide)
{
  if (to && wide)
  {
    std::copy(ids.begin(), ids.end(), static_cast<std::int64_t*>(to));
  }
  else if (to)
  {
    std::transform(ids.begin(), ids.end(), static_cast<std::int32_t*>(to),
      [](std::int64_t id) { return static_cast<std::int32_t>(id); });
  }
}
}

//------------------------------------------------------------------------------
PieceCells::PieceCells(
  bool tetrahedra, std::size_t cells, std::size_t connectivity, std::size_t faces)
  : Number(cells)
  , Tetrahedra(tetrahedra)
  , Connectivity(connectivity)
  , Offsets(tetrahedra ? 0 : cells + 1)
  , Types(tetrahedra ? 0 : cells)
  , FaceLocations(faces > 0 ? cells : 0)
  , Faces(faces)
{
}

//------------------------------------------------------------------------------
PieceTarget PieceCells::GetTarget()
{
  PieceTarget target;
  target.Connectivity = this->Connectivity.data();
  if (!this->Tetrahedra)
  {
    target.Offsets = this->Offsets.data();
    target.Types = this->Types.data();
    target.FaceLocations = this->FaceLocations.empty() ? nullptr : this->FaceLocations.data();
    target.Faces = this->Faces.empty() ? nullptr : this->Faces.data();
  }
  return target;
}

//------------------------------------------------------------------------------
std::span<const std::int64_t> PieceCells::GetPoints(std::size_t cell) const
{
  const std::span all(this->Connectivity);
  if (this->Tetrahedra)
  {
    return all.subspan(4 * cell, 4);
  }
  const auto begin = static_cast<std::size_t>(this->Offsets[cell]);
  return all.subspan(begin, static_cast<std::size_t>(this->Offsets[cell + 1]) - begin);
}

//------------------------------------------------------------------------------
std::span<const std::int64_t> PieceCells::GetFaces(std::size_t cell) const
{
  if (this->FaceLocations.empty() || this->FaceLocations[cell] < 0)
  {
    return {};
  }
  const auto begin = static_cast<std::size_t>(this->FaceLocations[cell]);
  auto end = begin + 1;
  for (auto faces = this->Faces[begin]; faces > 0; --faces)
  {
    end += 1 + static_cast<std::size_t>(this->Faces[end]);
  }
  return std::span(this->Faces).subspan(begin, end - begin);
}

//------------------------------------------------------------------------------
PieceCells PieceCells::Select(
  std::span<const std::uint64_t> cells, std::span<const std::int64_t> placeOf) const
{
  PieceCells result(this->Tetrahedra, cells.size(), 0, 0);
  result.FaceLocations.assign(this->FaceLocations.empty() ? 0 : cells.size(), -1);
  const auto place = [&](std::int64_t id) { return placeOf[static_cast<std::size_t>(id)]; };
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const auto cell = static_cast<std::size_t>(cells[i]);
    for (const auto id : this->GetPoints(cell))
    {
      result.Connectivity.push_back(place(id));
    }
    if (this->Tetrahedra)
    {
      continue;
    }
    result.Offsets[i + 1] = static_cast<std::int64_t>(result.Connectivity.size());
    result.Types[i] = this->Types[cell];
    const auto faces = this->GetFaces(cell);
    if (faces.empty())
    {
      continue;
    }
    result.FaceLocations[i] = static_cast<std::int64_t>(result.Faces.size());
    result.Faces.push_back(faces[0]);
    for (std::size_t at = 1; at < faces.size();)
    {
      result.Faces.push_back(faces[at]);
      for (auto points = faces[at++]; points > 0; --points)
      {
        result.Faces.push_back(place(faces[at++]));
      }
    }
  }
  return result;
}

//------------------------------------------------------------------------------
void PieceCells::Store(const PieceTarget& target) const
{
  StoreIds(this->Connectivity, target.Connectivity, target.WideIds);
  if (this->Tetrahedra)
  {
    return;
  }
  StoreIds(this->Offsets, target.Offsets, target.WideIds); // also without cells and types
  if (target.Types)
  {
    std::copy(this->Types.begin(), this->Types.end(), target.Types);
  }
  if (target.FaceLocations)
  {
    std::copy(this->FaceLocations.begin(), this->FaceLocations.end(), target.FaceLocations);
  }
  if (target.Faces)
  {
    std::copy(this->Faces.begin(), this->Faces.end(), target.Faces);
  }
}
}
