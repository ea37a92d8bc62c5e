// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSharedSearch.h"

#include <bit>

namespace gatun
{
SharedSearch::SharedSearch(std::span<const LatticePoint> vertices)
  : PlaceOf(vertices.size())
  , Entries(vertices.size() + 3)
{
  // About two vertices in each cell if the vertices are on the six sides of a box.
  this->Bits = static_cast<unsigned>(
    std::clamp((static_cast<int>(std::bit_width(vertices.size())) - 4) / 2, 0, 6));
  this->CellsPerUnit = static_cast<float>(1u << this->Bits) * (1.0F / 256.0F);
  this->CellStart.assign((std::size_t{ 1 } << (3 * this->Bits)) + 1, 0);
  for (const auto& v : vertices)
  {
    ++this->CellStart[this->CellOf(v) + 1];
  }
  for (std::size_t i = 1; i < this->CellStart.size(); ++i)
  {
    this->CellStart[i] += this->CellStart[i - 1];
  }
  auto next = this->CellStart;
  for (std::uint32_t i = 0; i < vertices.size(); ++i)
  {
    this->PlaceOf[i] = next[this->CellOf(vertices[i])]++;
    this->Entries[this->PlaceOf[i]] = { vertices[i].X, vertices[i].Y, vertices[i].Z, i };
  }
}

void SharedSearch::Remove(std::uint32_t index)
{
  constexpr float away = 1.0e6F;
  this->Entries[this->PlaceOf[index]] = { away, away, away, index };
  this->PlaceOf[index] = Gone;
}

SharedSearch::Area::Area(const SharedSearch& search, const GatePlane& plane, float reach)
{
  const auto w = ToVector(plane.C) - ToVector(plane.B);
  const float longest = std::max({ Dot(plane.U, plane.U), Dot(plane.V, plane.V), Dot(w, w) });
  const Vec3 sum{ ToVector(plane.A).Lanes + ToVector(plane.B).Lanes + ToVector(plane.C).Lanes };
  this->Center = { sum.Lanes * Splat(1.0F / 3.0F) };
  this->Limit = reach * reach * longest;
  const float radius = std::sqrt(this->Limit);
  for (unsigned i = 0; i < 3; ++i)
  {
    this->Low[i] = search.CellOf(this->Center[i] - radius);
    this->High[i] = search.CellOf(this->Center[i] + radius);
  }
}
}
