// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartSurface.h"

#include "gatunBoundaryFaces.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
bool PartSurface::Wall::operator<(const Wall& other) const
{
  return std::tie(this->Least, this->Rest, this->Size, this->Cell, this->Number) <
    std::tie(other.Least, other.Rest, other.Size, other.Cell, other.Number);
}

bool PartSurface::Wall::IsSame(const Wall& other) const
{
  return this->Least == other.Least && this->Rest == other.Rest && this->Size == other.Size;
}

//------------------------------------------------------------------------------
void PartSurface::List::Add(
  std::uint32_t cell, std::uint16_t number, std::span<const std::uint32_t> corners)
{
  const auto begin = this->Corners.size();
  this->Corners.insert(this->Corners.end(), corners.begin(), corners.end());
  this->Faces.push_back({ cell, number, begin, this->Corners.size() });
}

//------------------------------------------------------------------------------
void PartSurface::Add(const WriterPart& part, std::span<const std::uint32_t> numbers,
  std::span<const std::uint8_t> isJoined)
{
  this->AddFaces(part, numbers, isJoined);
  if (!part.Mesh.IsTetrahedral())
  {
    this->AddCells(part, numbers);
  }
}

//------------------------------------------------------------------------------
void PartSurface::AddFaces(const WriterPart& part, std::span<const std::uint32_t> numbers,
  std::span<const std::uint8_t> isJoined)
{
  std::vector<bool> isShared(numbers.size(), false); // by chunks
  for (const auto point : part.SharedPoints)
  {
    isShared[point] = true;
  }
  auto faces = FindFacesOfChunks(
    part.Mesh, part.Layout, [&](std::uint32_t point) { return numbers[point]; },
    [&](std::uint32_t point) -> bool { return isShared[point]; });
  std::vector<std::uint32_t> corners;
  for (BoundaryFace& face : faces)
  {
    FindCorners(part.Mesh, face, corners);
    face.IsShared = std::all_of(
      corners.begin(), corners.end(), [&](std::uint32_t corner) { return isJoined[corner] != 0; });
  }
  KeepOpenFaces(faces);
  for (const BoundaryFace& face : faces)
  {
    FindCorners(part.Mesh, face, corners);
    for (auto& corner : corners)
    {
      corner = numbers[corner];
    }
    const auto cell = static_cast<std::uint32_t>(part.Place.FirstCell + face.Cell);
    if (face.IsShared)
    {
      this->AddWall(face, cell, corners);
    }
    else
    {
      this->Faces.Add(cell, face.Number, corners);
    }
  }
}

//------------------------------------------------------------------------------
void PartSurface::AddWall(
  const BoundaryFace& face, std::uint32_t cell, std::span<const std::uint32_t> corners)
{
  Wall wall{ face.Least, face.Rest, cell, face.Number, face.Size,
    static_cast<std::uint32_t>(corners.size()), {}, this->MoreCorners.size() };
  if (corners.size() <= Wall::Most)
  {
    std::copy(corners.begin(), corners.end(), wall.Corners.begin());
  }
  else
  {
    this->MoreCorners.insert(this->MoreCorners.end(), corners.begin(), corners.end());
  }
  this->Walls.Add(wall);
}

//------------------------------------------------------------------------------
void PartSurface::AddCells(const WriterPart& part, std::span<const std::uint32_t> numbers)
{
  std::vector<std::uint32_t> corners;
  for (std::uint64_t cell = 0; cell < part.Mesh.GetMesh().Cells; ++cell)
  {
    if (const auto list = FindSurfaceCell(part.Mesh, cell, corners))
    {
      for (auto& corner : corners)
      {
        corner = numbers[corner];
      }
      this->Lists[static_cast<std::size_t>(*list)].Add(
        static_cast<std::uint32_t>(part.Place.FirstCell + cell), 0, corners);
    }
  }
}

//------------------------------------------------------------------------------
/** Adds the faces that one part has alone, though all of their corners are in several parts. */
void PartSurface::TakeWalls()
{
  this->Walls.Sort();
  while (this->Walls.Get())
  {
    const Wall wall = *this->Walls.Get();
    std::size_t count = 0;
    for (; this->Walls.Get() && this->Walls.Get()->IsSame(wall); this->Walls.Next())
    {
      ++count;
    }
    if (count == 1)
    {
      const bool isSmall = wall.Count <= Wall::Most;
      this->Faces.Add(wall.Cell, wall.Number,
        { isSmall ? wall.Corners.data() : this->MoreCorners.data() + wall.More, wall.Count });
    }
  }
  this->MoreCorners = {};
}

//------------------------------------------------------------------------------
BoundaryMesh PartSurface::Finish(const WriterState& state, const PartValues& values)
{
  this->TakeWalls();
  std::sort(this->Faces.Faces.begin(), this->Faces.Faces.end(),
    [](const Face& a, const Face& b)
    { return std::tie(a.Cell, a.Number) < std::tie(b.Cell, b.Number); });
  BoundaryCells cells;
  const auto add = [&](SurfaceList list, const List& some)
  {
    for (const Face& face : some.Faces)
    {
      cells.Add(list, face.Cell,
        std::span(some.Corners)
          .subspan(
            static_cast<std::size_t>(face.Begin), static_cast<std::size_t>(face.End - face.Begin)));
    }
  };
  for (std::size_t i = 0; i < this->Lists.size(); ++i)
  {
    const auto list = static_cast<SurfaceList>(i);
    add(list, this->Lists[i]);
    if (list == SurfaceList::Polygons)
    {
      add(list, this->Faces);
    }
    this->Lists[i] = {};
  }
  this->Faces = {};
  return { std::move(cells), state.Meta.Points, state.Meta.CoordinateType,
    [&](std::span<const std::uint32_t> points) { return values.GetCoordinates(points); } };
}
}
