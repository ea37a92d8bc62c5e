// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeLinks.h"

#include <algorithm>

namespace gatun
{
namespace
{
// Marks: of the neighbors of the two points that are to become one.
constexpr unsigned IsInto = 1;
constexpr unsigned ByFirstOnBoundary = 2;  // has an edge with the first that is on the boundary
constexpr unsigned BySecond = 4;           // has an edge with the second
constexpr unsigned BySecondOnBoundary = 8; // and it is on the boundary
constexpr unsigned OfEdge = 16;            // has a triangle with both
constexpr unsigned OfEdgeOnBoundary = 32;  // and it is on the boundary

/** Whether a neighbor of both points is not in the link of the edge; or its edges with the outer
 * point are not, which only belongs to the edge if that is on the boundary. */
constexpr bool IsOther(unsigned marks)
{
  constexpr unsigned ofBothOnBoundary = ByFirstOnBoundary | BySecondOnBoundary;
  const bool isOutside =
    (marks & ofBothOnBoundary) == ofBothOnBoundary && (marks & OfEdgeOnBoundary) == 0;
  return (marks & BySecond) != 0 && ((marks & OfEdge) == 0 || isOutside);
}

/** The same of all marks, as branches on them cannot be predicted. */
constexpr std::array<std::uint8_t, 64> Other = []
{
  std::array<std::uint8_t, 64> other{};
  for (unsigned marks = 0; marks < other.size(); ++marks)
  {
    other[marks] = IsOther(marks) ? 1 : 0;
  }
  return other;
}();
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
void MergeLinks::MarkNeighbors(std::uint32_t point, unsigned neighbor)
{
  const auto ring = this->Mesh.GetRing(point);
  std::size_t at = this->Marked.size();
  this->Marked.resize(at + 4 * ring.size());
  for (const auto tet : ring)
  {
    for (const auto corner : this->Mesh.GetTet(tet))
    {
      this->Marked[at++] = corner;
      this->Marks[corner] |= static_cast<std::uint8_t>(neighbor);
    }
  }
}

//------------------------------------------------------------------------------
/** Marks the neighbors that have an edge on the boundary with a point. */
void MergeLinks::MarkBoundary(std::uint32_t point, unsigned boundaryNeighbor)
{
  for (const auto tet : this->Mesh.GetRing(point))
  {
    const unsigned faces = this->Mesh.GetBoundaryFaces(tet);
    if (faces == 0) [[likely]]
    {
      continue;
    }
    const MergeMesh::Tet& corners = this->Mesh.GetTet(tet);
    const unsigned at = MergeMesh::FindKnownCorner(corners, point);
    for (unsigned i = 0; i < 4; ++i)
    {
      // The edge is in the faces opposite to the two other corners.
      const unsigned others = 15u & ~(1u << at) & ~(1u << i);
      if (i != at && (faces & others) != 0)
      {
        this->Mark(corners[i], boundaryNeighbor);
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
    if (!MergeMesh::HasCorner(corners, into))
    {
      continue;
    }
    const auto rest = MergeMesh::FindOthers(
      MergeMesh::FindKnownCorner(corners, point), MergeMesh::FindKnownCorner(corners, into));
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
      return MergeMesh::HasCorner(corners, b) && MergeMesh::HasCorner(corners, c);
    });
}

bool MergeLinks::HasTet(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const
{
  const auto ring = this->Mesh.GetRing(a);
  return std::any_of(ring.begin(), ring.end(),
    [&](std::uint32_t tet)
    {
      const MergeMesh::Tet& corners = this->Mesh.GetTet(tet);
      return MergeMesh::HasCorner(corners, b) && MergeMesh::HasCorner(corners, c) &&
        MergeMesh::HasCorner(corners, d);
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
  bool edgeOnBoundary = false;
  if (this->Mesh.IsOnBoundary(point))
  {
    this->MarkBoundary(point, ByFirstOnBoundary);
    if ((this->Marks[into] & ByFirstOnBoundary) == 0)
    {
      return false;
    }
    edgeOnBoundary = true;
    this->MarkBoundary(into, BySecondOnBoundary);
  }
  this->MarkEdge(point, into);
  this->MarkNeighbors(into, BySecond);
  this->Marks[point] = 0;
  this->Marks[into] = IsInto;
  return this->ShareNoOthers(point, into) &&
    !(edgeOnBoundary && this->ShareBoundaryFace(point, into));
}

//------------------------------------------------------------------------------
/** Points of both links are in that of the edge; so are edges of both links, which make a triangle
 * with each of the two points; and there are no triangles of both. */
bool MergeLinks::ShareNoOthers(std::uint32_t point, std::uint32_t into) const
{
  for (const auto tet : this->Mesh.GetRing(point))
  {
    const MergeMesh::Tet& corners = this->Mesh.GetTet(tet);
    unsigned all = 0;
    unsigned other = 0;
    unsigned common = 0;
    for (const auto corner : corners)
    {
      const unsigned marks = this->Marks[corner];
      all |= marks;
      other |= Other[marks];
      common += marks & BySecond;
    }
    if (other != 0)
    {
      return false;
    }
    if (common > BySecond && (all & IsInto) == 0 && this->ShareTriangle(corners, into))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/** Whether an edge or a triangle of a tetrahedron of the first point, without that point, is also
 * in the link of the second one, and not in that of the edge. */
bool MergeLinks::ShareTriangle(const MergeMesh::Tet& corners, std::uint32_t into) const
{
  std::array<std::uint32_t, 3> common{};
  unsigned n = 0;
  for (const auto corner : corners)
  {
    if ((this->Marks[corner] & BySecond) != 0)
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
        return true;
      }
    }
  }
  return n == 3 && this->HasTet(into, common[0], common[1], common[2]);
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
