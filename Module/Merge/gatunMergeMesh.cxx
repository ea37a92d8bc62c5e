// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeMesh.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
MergeMesh::MergeMesh(std::size_t points, std::span<const Tet> tets)
  : MergeRings(points, tets)
  , BoundaryFaces(tets.size(), 0)
  , OnBoundary(points, 0)
{
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
    unsigned Tets; // that have it; an empty slot if 0
  };
  std::vector<Face> faces; // a hash table
  std::vector<std::size_t> used;
  for (std::uint32_t point = 0; point < this->GetNumberOfPoints(); ++point)
  {
    const auto ring = this->GetRing(point);
    const std::size_t least = 6 * ring.size(); // twice as many slots as faces
    while (faces.size() < least)
    {
      faces.assign(std::max<std::size_t>(64, 2 * faces.size()), {});
    }
    const std::size_t mask = faces.size() - 1;
    for (const auto tet : ring)
    {
      const Tet& corners = this->GetTet(tet);
      const unsigned at = FindKnownCorner(corners, point);
      for (unsigned i = 1; i < 4; ++i)
      {
        const unsigned side = (at + i) % 4;
        const std::uint32_t one = corners[(at + i % 3 + 1) % 4];
        const std::uint32_t other = corners[(at + (i + 1) % 3 + 1) % 4];
        const auto [second, third] = std::minmax(one, other);
        if (second < point)
        {
          continue;
        }
        const std::uint64_t key = std::uint64_t{ second } << 32 | third;
        std::size_t slot = key * 0x9e3779b97f4a7c15u >> 32 & mask;
        while (faces[slot].Tets > 0 && (faces[slot].Second != second || faces[slot].Third != third))
        {
          slot = (slot + 1) & mask;
        }
        Face& face = faces[slot];
        if (face.Tets++ == 0)
        {
          face = { second, third, tet, side, 1 };
          used.push_back(slot);
        }
      }
    }
    for (const auto slot : used)
    {
      Face& face = faces[slot];
      if (face.Tets == 1)
      {
        this->BoundaryFaces[face.Tet] |= static_cast<std::uint8_t>(1u << face.Side);
        this->OnBoundary[point] = this->OnBoundary[face.Second] = this->OnBoundary[face.Third] = 1;
      }
      face.Tets = 0;
    }
    used.clear();
  }
}

//------------------------------------------------------------------------------
/** Of a tetrahedron that vanishes, two faces become one; if one of them was on the boundary, who is
 * on the other side of the other one is there now. */
void MergeMesh::PassBoundaryOn(std::uint32_t tet, std::uint32_t point, std::uint32_t into)
{
  const Tet corners = this->GetTet(tet);
  const unsigned at = FindCorner(corners, point);
  const unsigned other = FindCorner(corners, into);
  const auto rest = FindOthers(at, other);
  const std::array<std::uint32_t, 2> edge{ corners[rest[0]], corners[rest[1]] };
  const auto faces = this->BoundaryFaces[tet];
  const auto pass = [&](std::uint32_t owner)
  {
    for (const auto next : this->GetRing(owner))
    {
      const Tet& c = this->GetTet(next);
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
  for (const auto tet : this->GetRing(point))
  {
    if (FindCorner(this->GetTet(tet), into) < 4)
    {
      this->PassBoundaryOn(tet, point, into);
    }
  }
  this->MergeRings::Merge(point, into);
}
}
