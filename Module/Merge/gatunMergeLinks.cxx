// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeLinks.h"

#include <algorithm>

namespace gatun
{
namespace
{
// Marks: of the neighbors of the two points that are to become one.
constexpr std::uint8_t ByFirst = 1;           // has an edge with the first
constexpr std::uint8_t ByFirstOnBoundary = 2; // and it is on the boundary
constexpr std::uint8_t BySecond = 4;
constexpr std::uint8_t BySecondOnBoundary = 8;
constexpr std::uint8_t OfEdge = 16;           // has a triangle with both
constexpr std::uint8_t OfEdgeOnBoundary = 32; // and it is on the boundary
}

//------------------------------------------------------------------------------
void MergeLinks::Mark(std::uint32_t point, unsigned marks)
{
  // Points are listed once for each of their marks, as asking whether they are new takes longer.
  this->Marked.push_back(point);
  this->Marks[point] |= static_cast<std::uint8_t>(marks);
}

//------------------------------------------------------------------------------
/** Marks the neighbors of a point, and the point itself. */
void MergeLinks::MarkNeighbors(
  std::uint32_t point, std::uint8_t neighbor, std::uint8_t boundaryNeighbor)
{
  for (const auto tet : this->Mesh.GetRing(point))
  {
    const MergeMesh::Tet& corners = this->Mesh.GetTet(tet);
    for (const auto corner : corners)
    {
      this->Mark(corner, neighbor);
    }
    const unsigned faces = this->Mesh.GetBoundaryFaces(tet);
    if (faces == 0) [[likely]]
    {
      continue;
    }
    const unsigned at = MergeMesh::FindKnownCorner(corners, point);
    for (unsigned i = 0; i < 4; ++i)
    {
      // The edge is in the faces opposite to the two other corners.
      const unsigned others = 15u & ~(1u << at) & ~(1u << i);
      if (i != at && (faces & others) != 0)
      {
        this->Marks[corners[i]] |= boundaryNeighbor;
      }
    }
  }
}

//------------------------------------------------------------------------------
void MergeLinks::MarkEdge(std::uint32_t point, std::uint32_t into)
{
  this->EdgeLink.clear();
  for (const auto tet : this->Mesh.GetRing(point))
  {
    const MergeMesh::Tet& corners = this->Mesh.GetTet(tet);
    const unsigned other = MergeMesh::FindCorner(corners, into);
    if (other == 4)
    {
      continue;
    }
    const auto rest = MergeMesh::FindOthers(MergeMesh::FindCorner(corners, point), other);
    this->EdgeLink.push_back({ corners[rest[0]], corners[rest[1]] });
    for (unsigned i = 0; i < 2; ++i)
    {
      // The triangle is the face opposite to the last corner.
      const bool onBoundary = (this->Mesh.GetBoundaryFaces(tet) >> rest[1 - i] & 1) != 0;
      this->Mark(corners[rest[i]], OfEdge | (onBoundary ? OfEdgeOnBoundary : 0u));
    }
  }
}

//------------------------------------------------------------------------------
bool MergeLinks::IsInEdgeLink(std::uint32_t a, std::uint32_t b) const
{
  return std::any_of(this->EdgeLink.begin(), this->EdgeLink.end(),
    [&](const auto& edge)
    { return (edge[0] == a && edge[1] == b) || (edge[0] == b && edge[1] == a); });
}

bool MergeLinks::HaveTet(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
{
  const auto ring = this->Mesh.GetRing(a);
  return std::any_of(ring.begin(), ring.end(),
    [&](std::uint32_t tet)
    {
      const MergeMesh::Tet& corners = this->Mesh.GetTet(tet);
      return MergeMesh::FindCorner(corners, b) < 4 && MergeMesh::FindCorner(corners, c) < 4;
    });
}

bool MergeLinks::HasTet(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const
{
  const auto ring = this->Mesh.GetRing(a);
  return std::any_of(ring.begin(), ring.end(),
    [&](std::uint32_t tet)
    {
      const MergeMesh::Tet& corners = this->Mesh.GetTet(tet);
      return MergeMesh::FindCorner(corners, b) < 4 && MergeMesh::FindCorner(corners, c) < 4 &&
        MergeMesh::FindCorner(corners, d) < 4;
    });
}

bool MergeLinks::IsBoundaryFace(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
{
  for (const auto tet : this->Mesh.GetRing(a))
  {
    const MergeMesh::Tet& corners = this->Mesh.GetTet(tet);
    for (unsigned side = 0; side < 4; ++side)
    {
      const bool onBoundary = (this->Mesh.GetBoundaryFaces(tet) >> side & 1) != 0;
      if (onBoundary && corners[side] != a && corners[side] != b && corners[side] != c &&
        MergeMesh::FindCorner(corners, b) < 4 && MergeMesh::FindCorner(corners, c) < 4)
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool MergeLinks::MayMerge(std::uint32_t point, std::uint32_t into)
{
  for (const auto marked : this->Marked)
  {
    this->Marks[marked] = 0;
  }
  this->Marked.clear();
  this->Mesh.PrefetchCells(into);
  this->MarkNeighbors(point, ByFirst, ByFirstOnBoundary);
  const bool edgeOnBoundary = (this->Marks[into] & ByFirstOnBoundary) != 0;
  if (this->Mesh.IsOnBoundary(point) && !edgeOnBoundary)
  {
    return false;
  }
  this->MarkNeighbors(into, BySecond, BySecondOnBoundary);
  this->MarkEdge(point, into);
  return this->ShareNoOtherPoint(point, into, edgeOnBoundary) &&
    this->ShareNoOtherTriangle(point, into) &&
    !(edgeOnBoundary && this->ShareBoundaryFace(point, into));
}

//------------------------------------------------------------------------------
/** Points of both links are in that of the edge; and so are edges of both with the outer point,
 * which only belongs to the edge if that is on the boundary. */
bool MergeLinks::ShareNoOtherPoint(
  std::uint32_t point, std::uint32_t into, bool edgeOnBoundary) const
{
  constexpr unsigned ofBoth = ByFirst | BySecond;
  constexpr unsigned ofBothOnBoundary = ByFirstOnBoundary | BySecondOnBoundary;
  for (const auto tet : this->Mesh.GetRing(point))
  {
    for (const auto corner : this->Mesh.GetTet(tet))
    {
      const unsigned marks = this->Marks[corner];
      if (corner == point || corner == into || (marks & ofBoth) != ofBoth)
      {
        continue;
      }
      const bool isOutside = edgeOnBoundary && (marks & ofBothOnBoundary) == ofBothOnBoundary &&
        (marks & OfEdgeOnBoundary) == 0;
      if ((marks & OfEdge) == 0 || isOutside)
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/** Edges of both links, which make a triangle with each of the two points, are in that of the edge;
 * and there are no triangles of both. */
bool MergeLinks::ShareNoOtherTriangle(std::uint32_t point, std::uint32_t into) const
{
  for (const auto tet : this->Mesh.GetRing(point))
  {
    const MergeMesh::Tet corners = this->Mesh.GetTet(tet);
    if (MergeMesh::FindCorner(corners, into) < 4)
    {
      continue;
    }
    std::array<std::uint32_t, 3> common{};
    unsigned n = 0;
    for (const auto corner : corners)
    {
      if (corner != point && (this->Marks[corner] & BySecond) != 0)
      {
        common[n++] = corner;
      }
    }
    for (unsigned i = 0; i < n; ++i)
    {
      for (unsigned j = i + 1; j < n; ++j)
      {
        if (!this->IsInEdgeLink(common[i], common[j]) && this->HaveTet(into, common[i], common[j]))
        {
          return false;
        }
      }
    }
    if (n == 3 && this->HasTet(into, common[0], common[1], common[2]))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/** Triangles of both links with the outer point: two boundary faces that would become one. */
bool MergeLinks::ShareBoundaryFace(std::uint32_t point, std::uint32_t into) const
{
  for (const auto tet : this->Mesh.GetRing(point))
  {
    const MergeMesh::Tet corners = this->Mesh.GetTet(tet);
    const unsigned at = MergeMesh::FindCorner(corners, point);
    for (unsigned side = 0; side < 4; ++side)
    {
      if (side == at || (this->Mesh.GetBoundaryFaces(tet) >> side & 1) == 0)
      {
        continue;
      }
      const auto rest = MergeMesh::FindOthers(at, side);
      const auto a = corners[rest[0]];
      const auto b = corners[rest[1]];
      if (a != into && b != into && this->IsBoundaryFace(into, a, b))
      {
        return true;
      }
    }
  }
  return false;
}

}
