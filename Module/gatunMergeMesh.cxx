// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeMesh.h"

#include <algorithm>

namespace gatun
{
namespace
{
// Marks: of the neighbours of the two points that are to become one.
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
}

//------------------------------------------------------------------------------
MergeMesh::MergeMesh(std::size_t points, std::span<const Tet> tets)
  : Tets(tets.begin(), tets.end())
  , BoundaryFaces(tets.size(), 0)
  , OnBoundary(points, 0)
  , Rings(points)
  , Marks(points)
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
std::uint8_t MergeMesh::GetMark(std::uint32_t point) const
{
  const Mark& mark = this->Marks[point];
  return mark.Stamp == this->Stamp ? mark.Bits : std::uint8_t{ 0 };
}

void MergeMesh::AddMark(std::uint32_t point, std::uint8_t bits)
{
  Mark& mark = this->Marks[point];
  mark.Bits = static_cast<std::uint8_t>((mark.Stamp == this->Stamp ? mark.Bits : 0) | bits);
  mark.Stamp = this->Stamp;
}

//------------------------------------------------------------------------------
void MergeMesh::MarkNeighbours(
  std::uint32_t point, std::uint8_t neighbour, std::uint8_t boundaryNeighbour)
{
  for (const auto tet : this->GetRing(point))
  {
    const Tet& corners = this->Tets[tet];
    const unsigned at = FindCorner(corners, point);
    for (unsigned i = 0; i < 4; ++i)
    {
      if (i != at)
      {
        // The edge is in the faces opposite to the two other corners.
        const unsigned others = 15u & ~(1u << at) & ~(1u << i);
        const bool onBoundary = (this->BoundaryFaces[tet] & others) != 0;
        this->AddMark(
          corners[i], static_cast<std::uint8_t>(neighbour | (onBoundary ? boundaryNeighbour : 0)));
      }
    }
  }
}

//------------------------------------------------------------------------------
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
  ++this->Stamp;
  this->MarkNeighbours(point, ByFirst, ByFirstOnBoundary);
  this->MarkNeighbours(into, BySecond, BySecondOnBoundary);

  // The outer point is a neighbour of both, but only belongs to the edge if that is on the
  // boundary.
  const bool edgeOnBoundary = (this->GetMark(into) & ByFirstOnBoundary) != 0;
  if (this->IsOnBoundary(point) && !edgeOnBoundary)
  {
    return false;
  }
  for (const auto tet : this->GetRing(point))
  {
    const Tet& corners = this->Tets[tet];
    const unsigned at = FindCorner(corners, point);
    const unsigned other = FindCorner(corners, into);
    for (unsigned i = 0; other < 4 && i < 4; ++i)
    {
      if (i != at && i != other)
      {
        // The triangle is the face opposite to the last corner.
        const unsigned last = 6 - at - other - i;
        const bool onBoundary = (this->BoundaryFaces[tet] >> last & 1) != 0;
        this->AddMark(
          corners[i], static_cast<std::uint8_t>(OfEdge | (onBoundary ? OfEdgeOnBoundary : 0)));
      }
    }
  }

  constexpr unsigned ofBoth = ByFirst | BySecond;
  constexpr unsigned ofBothOnBoundary = ByFirstOnBoundary | BySecondOnBoundary;
  for (const auto tet : this->GetRing(point))
  {
    const Tet corners = this->Tets[tet];
    const bool hasEdge = FindCorner(corners, into) < 4;
    std::array<std::uint32_t, 3> common{};
    unsigned n = 0;
    for (const auto corner : corners)
    {
      const unsigned mark = this->GetMark(corner);
      if (corner == point || corner == into || (mark & ofBoth) != ofBoth)
      {
        continue;
      }
      // Points of both links, and edges with the outer point.
      const bool isOutside = (mark & ofBothOnBoundary) == ofBothOnBoundary && edgeOnBoundary &&
        (mark & OfEdgeOnBoundary) == 0;
      if ((mark & OfEdge) == 0 || isOutside)
      {
        return false;
      }
      common[n++] = corner;
    }
    if (hasEdge)
    {
      continue;
    }
    // Edges of both links.
    for (unsigned i = 0; i < n; ++i)
    {
      for (unsigned j = i + 1; j < n; ++j)
      {
        const auto ring = this->GetRing(into);
        const bool isShared = std::any_of(ring.begin(), ring.end(),
          [&](std::uint32_t t)
          {
            const Tet& c = this->Tets[t];
            return FindCorner(c, common[i]) < 4 && FindCorner(c, common[j]) < 4;
          });
        if (isShared && !this->HasTet(point, into, common[i], common[j]))
        {
          return false;
        }
      }
    }
    // Triangles of both links.
    if (n == 3 && this->HasTet(into, common[0], common[1], common[2]))
    {
      return false;
    }
  }

  // Triangles of both links with the outer point: two boundary faces that would become one.
  if (edgeOnBoundary)
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
        std::array<std::uint32_t, 2> edge{};
        unsigned n = 0;
        for (unsigned i = 0; i < 4; ++i)
        {
          if (i != at && i != side)
          {
            edge[n++] = corners[i];
          }
        }
        if (edge[0] != into && edge[1] != into && this->IsBoundaryFace(into, edge[0], edge[1]))
        {
          return false;
        }
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/** Of a tetrahedron that vanishes, two faces become one; if one of them was on the boundary, who is
 * on the other side of the other one is there now. */
void MergeMesh::PassBoundaryOn(std::uint32_t tet, std::uint32_t point, std::uint32_t into)
{
  const Tet corners = this->Tets[tet];
  const unsigned at = FindCorner(corners, point);
  const unsigned other = FindCorner(corners, into);
  std::array<std::uint32_t, 2> edge{};
  unsigned n = 0;
  for (unsigned i = 0; i < 4; ++i)
  {
    if (i != at && i != other)
    {
      edge[n++] = corners[i];
    }
  }
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
  const auto old = this->GetRing(point);
  const std::vector<std::uint32_t> ring(old.begin(), old.end());
  std::vector<std::uint32_t> moved;
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
      moved.push_back(tet);
    }
  }
  const auto rest = this->GetRing(into);
  std::vector<std::uint32_t> all(rest.begin(), rest.end());
  all.insert(all.end(), moved.begin(), moved.end());
  this->Used += moved.size();
  this->Used -= this->Rings[point].Count;
  this->Rings[point].Count = 0;
  Ring& target = this->Rings[into];
  target.HasGone = false;
  target.First = this->Pool.size();
  target.Count = static_cast<std::uint32_t>(all.size());
  this->Pool.insert(this->Pool.end(), all.begin(), all.end());
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
