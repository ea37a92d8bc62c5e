// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBaseMesh.h"

#include "gatunGatherTuples.h"
#include "gatunMeshTets.h"

namespace gatun
{
namespace
{
/** The merges after the first ones. places: the numbers of the remaining points. */
MergeTree MakeRest(const MergeTree& tree, std::size_t merges,
  const std::vector<std::uint32_t>& places, std::size_t points)
{
  std::vector<Merge> rest(
    tree.GetMerges().begin() + static_cast<std::ptrdiff_t>(merges), tree.GetMerges().end());
  for (Merge& merge : rest)
  {
    merge.Point = places[merge.Point];
    merge.Into = places[merge.Into];
  }
  return { static_cast<std::uint32_t>(points), std::move(rest) };
}
}

//------------------------------------------------------------------------------
BaseMesh::BaseMesh(const MeshAccess& mesh, const MergeTree& tree, std::size_t merges)
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
  ForEachTet(mesh,
    [&](std::uint64_t cell, MergeTree::Tet tet)
    {
      if (!Simplify(tet, ancestors))
      {
        return;
      }
      this->Cells.push_back(static_cast<std::uint32_t>(cell));
      for (const auto corner : tet)
      {
        if (this->WideIds)
        {
          this->WideConnectivity.push_back(places[corner]);
        }
        else
        {
          this->Connectivity.push_back(static_cast<std::int32_t>(places[corner]));
        }
      }
    });
  this->Coordinates =
    this->Gather(input.Coordinates, Association::Point, 3 * SizeOf(this->CoordinateType));
  this->Tree = MakeRest(tree, merges, places, this->Points.size());
}

//------------------------------------------------------------------------------
MeshInput BaseMesh::GetInput() const
{
  MeshInput input;
  input.Points = this->Points.size();
  input.CoordinateType = this->CoordinateType;
  input.Coordinates = this->Coordinates.data();
  input.Cells = this->Cells.size();
  input.Connectivity = this->WideIds ? static_cast<const void*>(this->WideConnectivity.data())
                                     : this->Connectivity.data();
  input.WideIds = this->WideIds;
  return input;
}

//------------------------------------------------------------------------------
Bytes BaseMesh::Gather(const void* values, Association where, std::size_t tupleBytes) const
{
  return GatherTuples(values, where == Association::Point ? this->Points : this->Cells, tupleBytes);
}
}
