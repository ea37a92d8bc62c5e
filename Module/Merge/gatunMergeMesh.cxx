// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeMesh.h"

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

unsigned FindCorner(const MergeMesh::Tet& tet, std::uint32_t point)
{
  return tet[0] == point ? 0 : tet[1] == point ? 1 : tet[2] == point ? 2 : tet[3] == point ? 3 : 4;
}

/** The two corners of a tetrahedron besides two others, as places in it. */
std::array<unsigned, 2> FindOthers(unsigned at, unsigned other)
{
  std::array<unsigned, 2> rest{};
  unsigned n = 0;
  for (unsigned i = 0; i < 4; ++i)
  {
    if (i != at && i != other)
    {
      rest[n++] = i;
    }
  }
  return rest;
}
}

//------------------------------------------------------------------------------
MergeMesh::MergeMesh(std::size_t points, std::span<const Tet> tets)
  : Tets(tets.begin(), tets.end())
  , BoundaryFaces(tets.size(), 0)
  , OnBoundary(points, 0)
  , Rings(points)
{
  // A tetrahedron with a point twice is none.
  for (Tet& tet : this->Tets)
  {
    auto sorted = tet;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    {
      tet[0] = None;
      continue;
    }
    for (const auto corner : tet)
    {
      ++this->Rings[corner].Count;
    }
  }
  for (Ring& ring : this->Rings)
  {
    ring.First = this->Used;
    this->Used += ring.Count;
    ring.Count = 0;
  }
  this->Pool.resize(this->Used);
  for (std::uint32_t tet = 0; tet < this->Tets.size(); ++tet)
  {
    if (this->Tets[tet][0] == None)
    {
      continue;
    }
    for (const auto corner : this->Tets[tet])
    {
      Ring& ring = this->Rings[corner];
      this->Pool[ring.First + ring.Count++] = tet;
    }
  }
  this->FindBoundary();
}

//------------------------------------------------------------------------------
void MergeMesh::FindBoundary()
{
  // Of each face, its corner of the lowest number knows all who have it.
  struct Face
  {
    std::uint32_t Second, Third, Tet;
    unsigned Side;
  };
  std::vector<Face> faces;
  for (std::uint32_t point = 0; point < this->Rings.size(); ++point)
  {
    faces.clear();
    for (const auto tet : this->GetRing(point))
    {
      const Tet& corners = this->Tets[tet];
      for (unsigned side = 0; side < 4; ++side)
      {
        std::array<std::uint32_t, 3> face{};
        unsigned n = 0;
        for (unsigned i = 0; i < 4; ++i)
        {
          if (i != side)
          {
            face[n++] = corners[i];
          }
        }
        std::sort(face.begin(), face.end());
        if (face[0] == point)
        {
          faces.push_back({ face[1], face[2], tet, side });
        }
      }
    }
    std::sort(faces.begin(), faces.end(),
      [](const Face& a, const Face& b)
      {
        return a.Second != b.Second ? a.Second < b.Second
          : a.Third != b.Third      ? a.Third < b.Third
                                    : a.Tet < b.Tet;
      });
    for (std::size_t i = 0; i < faces.size();)
    {
      auto next = i + 1;
      while (next < faces.size() && faces[next].Second == faces[i].Second &&
        faces[next].Third == faces[i].Third)
      {
        ++next;
      }
      if (next == i + 1)
      {
        const Face& face = faces[i];
        this->BoundaryFaces[face.Tet] |= static_cast<std::uint8_t>(1u << face.Side);
        this->OnBoundary[point] = this->OnBoundary[face.Second] = this->OnBoundary[face.Third] = 1;
      }
      i = next;
    }
  }
}

//------------------------------------------------------------------------------
std::span<const std::uint32_t> MergeMesh::GetRing(std::uint32_t point)
{
  // Those that are gone are left out when somebody asks.
  Ring& ring = this->Rings[point];
  std::uint32_t* const first = this->Pool.data() + ring.First;
  if (!ring.HasGone)
  {
    return { first, ring.Count };
  }
  std::uint32_t* const last = std::remove_if(
    first, first + ring.Count, [this](std::uint32_t tet) { return this->Tets[tet][0] == None; });
  const auto count = static_cast<std::uint32_t>(last - first);
  this->Used -= ring.Count - count;
  ring.Count = count;
  ring.HasGone = false;
  return { first, count };
}

//------------------------------------------------------------------------------
void MergeMesh::MarkNeighbors(
  std::uint32_t point, std::uint8_t neighbor, std::uint8_t boundaryNeighbor)
{
  for (const auto tet : this->GetRing(point))
  {
    const Tet& corners = this->Tets[tet];
    const unsigned at = FindCorner(corners, point);
    const unsigned faces = this->BoundaryFaces[tet];
    for (unsigned i = 0; i < 4; ++i)
    {
      if (i != at)
      {
        // The edge is in the faces opposite to the two other corners.
        const unsigned others = 15u & ~(1u << at) & ~(1u << i);
        this->Marks[corners[i]] |= neighbor | ((faces & others) != 0 ? boundaryNeighbor : 0u);
      }
    }
  }
}

//------------------------------------------------------------------------------
void MergeMesh::MarkEdge(std::uint32_t point, std::uint32_t into)
{
  this->EdgeLink.clear();
  for (const auto tet : this->GetRing(point))
  {
    const Tet& corners = this->Tets[tet];
    const unsigned other = FindCorner(corners, into);
    if (other == 4)
    {
      continue;
    }
    const auto rest = FindOthers(FindCorner(corners, point), other);
    this->EdgeLink.push_back({ corners[rest[0]], corners[rest[1]] });
    for (unsigned i = 0; i < 2; ++i)
    {
      // The triangle is the face opposite to the last corner.
      const bool onBoundary = (this->BoundaryFaces[tet] >> rest[1 - i] & 1) != 0;
      this->Marks[corners[rest[i]]] |= OfEdge | (onBoundary ? OfEdgeOnBoundary : 0u);
    }
  }
}

//------------------------------------------------------------------------------
bool MergeMesh::IsInEdgeLink(std::uint32_t a, std::uint32_t b) const
{
  return std::any_of(this->EdgeLink.begin(), this->EdgeLink.end(),
    [&](const auto& edge)
    { return (edge[0] == a && edge[1] == b) || (edge[0] == b && edge[1] == a); });
}

bool MergeMesh::HaveTet(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  const auto ring = this->GetRing(a);
  return std::any_of(ring.begin(), ring.end(),
    [&](std::uint32_t tet)
    {
      const Tet& corners = this->Tets[tet];
      return FindCorner(corners, b) < 4 && FindCorner(corners, c) < 4;
    });
}

bool MergeMesh::HasTet(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
  const auto ring = this->GetRing(a);
  return std::any_of(ring.begin(), ring.end(),
    [&](std::uint32_t tet)
    {
      const Tet& corners = this->Tets[tet];
      return FindCorner(corners, b) < 4 && FindCorner(corners, c) < 4 && FindCorner(corners, d) < 4;
    });
}

bool MergeMesh::IsBoundaryFace(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  for (const auto tet : this->GetRing(a))
  {
    const Tet& corners = this->Tets[tet];
    for (unsigned side = 0; side < 4; ++side)
    {
      const bool onBoundary = (this->BoundaryFaces[tet] >> side & 1) != 0;
      if (onBoundary && corners[side] != a && corners[side] != b && corners[side] != c &&
        FindCorner(corners, b) < 4 && FindCorner(corners, c) < 4)
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool MergeMesh::MayMerge(std::uint32_t point, std::uint32_t into)
{
  this->Marks.Clear();
  this->MarkNeighbors(point, ByFirst, ByFirstOnBoundary);
  const bool edgeOnBoundary = (this->Marks.Get(into) & ByFirstOnBoundary) != 0;
  if (this->IsOnBoundary(point) && !edgeOnBoundary)
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
bool MergeMesh::ShareNoOtherPoint(std::uint32_t point, std::uint32_t into, bool edgeOnBoundary)
{
  constexpr unsigned ofBoth = ByFirst | BySecond;
  constexpr unsigned ofBothOnBoundary = ByFirstOnBoundary | BySecondOnBoundary;
  for (const auto tet : this->GetRing(point))
  {
    for (const auto corner : this->Tets[tet])
    {
      const unsigned marks = this->Marks.Get(corner);
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
bool MergeMesh::ShareNoOtherTriangle(std::uint32_t point, std::uint32_t into)
{
  for (const auto tet : this->GetRing(point))
  {
    const Tet corners = this->Tets[tet];
    if (FindCorner(corners, into) < 4)
    {
      continue;
    }
    std::array<std::uint32_t, 3> common{};
    unsigned n = 0;
    for (const auto corner : corners)
    {
      if (corner != point && (this->Marks.Get(corner) & BySecond) != 0)
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
bool MergeMesh::ShareBoundaryFace(std::uint32_t point, std::uint32_t into)
{
  for (const auto tet : this->GetRing(point))
  {
    const Tet corners = this->Tets[tet];
    const unsigned at = FindCorner(corners, point);
    for (unsigned side = 0; side < 4; ++side)
    {
      if (side == at || (this->BoundaryFaces[tet] >> side & 1) == 0)
      {
        continue;
      }
      const auto rest = FindOthers(at, side);
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

//------------------------------------------------------------------------------
/** Of a tetrahedron that vanishes, two faces become one; if one of them was on the boundary, who is
 * on the other side of the other one is there now. */
void MergeMesh::PassBoundaryOn(std::uint32_t tet, std::uint32_t point, std::uint32_t into)
{
  const Tet corners = this->Tets[tet];
  const unsigned at = FindCorner(corners, point);
  const unsigned other = FindCorner(corners, into);
  const auto rest = FindOthers(at, other);
  const std::array<std::uint32_t, 2> edge{ corners[rest[0]], corners[rest[1]] };
  const auto faces = this->BoundaryFaces[tet];
  const auto pass = [&](std::uint32_t owner)
  {
    for (const auto next : this->GetRing(owner))
    {
      const Tet& c = this->Tets[next];
      const unsigned a = FindCorner(c, owner);
      const unsigned b = FindCorner(c, edge[0]);
      const unsigned d = FindCorner(c, edge[1]);
      if (next != tet && b < 4 && d < 4)
      {
        this->BoundaryFaces[next] |= static_cast<std::uint8_t>(1u << (6 - a - b - d));
      }
    }
  };
  if ((faces >> other & 1) != 0) // the face of the point
  {
    pass(into);
  }
  if ((faces >> at & 1) != 0)
  {
    pass(point);
  }
}

//------------------------------------------------------------------------------
void MergeMesh::Merge(std::uint32_t point, std::uint32_t into)
{
  const auto ring = this->GetRing(point);
  this->Moved.clear();
  for (const auto tet : ring)
  {
    if (FindCorner(this->Tets[tet], into) < 4)
    {
      this->PassBoundaryOn(tet, point, into);
    }
  }
  for (const auto tet : ring)
  {
    Tet& corners = this->Tets[tet];
    if (FindCorner(corners, into) < 4)
    {
      for (const auto corner : corners)
      {
        this->Rings[corner].HasGone = true;
      }
      corners[0] = None;
    }
    else
    {
      corners[FindCorner(corners, point)] = into;
      this->Moved.push_back(tet);
    }
  }
  const auto rest = this->GetRing(into);
  this->Moved.insert(this->Moved.end(), rest.begin(), rest.end());
  this->Used += this->Moved.size() - rest.size();
  this->Used -= this->Rings[point].Count;
  this->Rings[point].Count = 0;
  this->Rings[into] = { this->Pool.size(), static_cast<std::uint32_t>(this->Moved.size()), false };
  this->Pool.insert(this->Pool.end(), this->Moved.begin(), this->Moved.end());
  if (this->Pool.size() > 2 * this->Used + 1024)
  {
    this->Compact();
  }
}

//------------------------------------------------------------------------------
void MergeMesh::Compact()
{
  std::vector<std::uint32_t> pool;
  for (std::uint32_t point = 0; point < this->Rings.size(); ++point)
  {
    const auto ring = this->GetRing(point);
    this->Rings[point].First = pool.size();
    pool.insert(pool.end(), ring.begin(), ring.end());
  }
  this->Pool = std::move(pool);
  this->Used = this->Pool.size();
}
}
