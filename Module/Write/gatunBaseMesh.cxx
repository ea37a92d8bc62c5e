// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBaseMesh.h"

#include "gatunCellShapes.h"
#include "gatunGatherTuples.h"
#include "gatunMeshTets.h"

#include <span>

namespace gatun
{
namespace
{
/** Calls use(cell, type, corners) for each tetrahedron of a mesh, or for each cell of a surface. */
template <typename Use>
void ForEachCell(const MeshAccess& mesh, PieceForm form, Use&& use)
{
  if (form == PieceForm::Tetrahedra)
  {
    ForEachTet(mesh,
      [&](std::uint64_t cell, const MergeTree::Tet& tet)
      { use(cell, TetraType, std::span<const std::uint32_t>(tet)); });
    return;
  }
  std::vector<std::uint32_t> corners;
  for (std::uint64_t cell = 0; cell < mesh.GetMesh().Cells; ++cell)
  {
    corners.clear();
    mesh.ForEachPoint(
      cell, [&](std::uint64_t point) { corners.push_back(static_cast<std::uint32_t>(point)); });
    use(cell, mesh.GetType(cell), std::span<const std::uint32_t>(corners));
  }
}
}

//------------------------------------------------------------------------------
WriterOptions MakeLevelOptions(const WriterOptions& whole)
{
  WriterOptions options = whole;
  options.Keep = KeepNone;
  options.Tree = nullptr;
  options.Levels = 0;
  options.LevelMerges.clear();
  options.Boundary = false;
  return options;
}

//------------------------------------------------------------------------------
BaseMesh::BaseMesh(
  const MeshAccess& mesh, const MergeTree& tree, std::size_t merges, PieceForm form)
  : CoordinateType(mesh.GetMesh().CoordinateType)
  , WideIds(mesh.GetMesh().WideIds)
{
  const MeshInput& input = mesh.GetMesh();
  const auto ancestors = tree.FindAncestors(merges);
  std::vector<std::uint32_t> places(ancestors.size(), 0);
  for (std::uint32_t i = 0; i < ancestors.size(); ++i)
  {
    if (ancestors[i] == i)
    {
      places[i] = static_cast<std::uint32_t>(this->Points.size());
      this->Points.push_back(i);
    }
  }
  CoarseCells cells(form);
  ForEachCell(mesh, form,
    [&](std::uint64_t cell, std::uint8_t type, std::span<const std::uint32_t> corners)
    {
      if (cells.AddSimplified(type, corners, ancestors))
      {
        this->Cells.push_back(static_cast<std::uint32_t>(cell));
      }
    });
  for (auto& corner : cells.GetAllCorners())
  {
    corner = places[corner];
  }
  this->MakeCells(cells);
  this->Coordinates =
    this->Gather(input.Coordinates, Association::Point, 3 * SizeOf(this->CoordinateType));
}

//------------------------------------------------------------------------------
void BaseMesh::MakeCells(const CoarseCells& cells)
{
  const std::size_t ids = this->WideIds ? sizeof(std::int64_t) : sizeof(std::int32_t);
  PieceTarget target;
  target.WideIds = this->WideIds;
  this->Connectivity.resize(cells.GetAllCorners().size() * ids);
  target.Connectivity = this->Connectivity.data();
  if (!cells.IsTetrahedral())
  {
    this->Types.resize(cells.GetCount());
    this->Offsets.resize((cells.GetCount() + 1) * ids);
    target.Types = this->Types.data();
    target.Offsets = this->Offsets.data();
  }
  cells.Store(target);
}

//------------------------------------------------------------------------------
MeshInput BaseMesh::GetInput() const
{
  MeshInput input;
  input.Points = this->Points.size();
  input.CoordinateType = this->CoordinateType;
  input.Coordinates = this->Coordinates.data();
  input.Cells = this->Cells.size();
  input.Connectivity = this->Connectivity.data();
  input.WideIds = this->WideIds;
  input.Types = this->Types.empty() ? nullptr : this->Types.data();
  input.Offsets = this->Types.empty() ? nullptr : this->Offsets.data();
  return input;
}

//------------------------------------------------------------------------------
Bytes BaseMesh::Gather(const void* values, Association where, std::size_t tupleBytes) const
{
  return GatherTuples(values, where == Association::Point ? this->Points : this->Cells, tupleBytes);
}
}
