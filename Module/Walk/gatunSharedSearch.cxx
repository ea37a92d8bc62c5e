// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSharedSearch.h"

#include <bit>

namespace gatun
{
SharedSearch::SharedSearch(std::span<const LatticePoint> vertices)
  : Vertices(vertices)
  , Gone(vertices.size(), 0)
  , FirstPlace(vertices.size())
  , Entries(vertices.size() + 3)
{
  // About two vertices in each cell if the vertices are on the six sides of a box.
  this->Bits = static_cast<unsigned>(
    std::clamp((static_cast<int>(std::bit_width(vertices.size())) - 4) / 2, 0, 6));
  this->CellsPerUnit = static_cast<float>(1u << this->Bits) * (1.0F / 256.0F);
  this->CellStart.assign((this->GetStride() << (2 * this->Bits)) + 1, 0);
  for (const auto& v : vertices)
  {
    ++this->CellStart[this->CellOf(v) + 1];
  }
  for (std::size_t i = 1; i < this->CellStart.size(); ++i)
  {
    this->CellStart[i] += this->CellStart[i - 1];
  }
  this->LiveStart = this->CellStart;
  for (std::uint32_t i = 0; i < vertices.size(); ++i)
  {
    this->FirstPlace[i] = this->LiveStart[this->CellOf(vertices[i])]++;
    this->Entries[this->FirstPlace[i]] = { vertices[i].X, vertices[i].Y, vertices[i].Z, i };
  }
  this->PlaceOf = this->FirstPlace;
  this->LiveStart = this->CellStart;
  this->GoneInRow.resize(std::size_t{ 1 } << (2 * this->Bits));
}

void SharedSearch::Remove(std::uint32_t index)
{
  constexpr float away = 1.0e6F;
  this->Gone[index] = 1;
  this->Entries[this->PlaceOf[index]] = { away, away, away, index };
  const auto stride = this->GetStride();
  const auto row = this->CellOf(this->Vertices[index]) / stride;
  const auto entries = this->LiveStart[row * stride + stride - 1] - this->LiveStart[row * stride];
  // So rarely that a vertex is moved about once for each one that is met.
  if (++this->GoneInRow[row] > entries / 2 + 4)
  {
    this->Compact(row);
  }
}

void SharedSearch::Compact(std::size_t row)
{
  const auto begin = row * this->GetStride();
  auto to = this->LiveStart[begin];
  auto from = to;
  for (auto cell = begin; cell + 1 < begin + this->GetStride(); ++cell)
  {
    for (const auto end = this->LiveStart[cell + 1]; from < end; ++from)
    {
      const auto index = this->Entries[from].Users;
      this->Entries[to] = this->Entries[from];
      this->PlaceOf[index] = to;
      to += this->Gone[index] == 0;
    }
    this->LiveStart[cell + 1] = to;
  }
  this->GoneInRow[row] = 0;
}

std::uint32_t SharedSearch::TakeNext()
{
  LeastOfGroups least;
  for (std::uint32_t i = 0; i < this->RankCount; i += 4)
  {
    Float4 group;
    std::memcpy(&group, &this->Ranks[i], sizeof(group));
    least.Compare(group, static_cast<std::int32_t>(i));
  }
  const auto position = least.GetPosition();
  if (position < 0)
  {
    return NoVertex;
  }
  const auto at = static_cast<std::uint32_t>(position);
  this->Ranks[at] = NeverRank;
  auto row = this->RowCount - 1;
  while (this->Rows[row].FirstRank > at)
  {
    --row;
  }
  return this->Entries[this->Rows[row].FirstEntry + at - this->Rows[row].FirstRank].Users;
}

std::uint32_t SharedSearch::FindEnd(
  std::uint32_t first, std::uint32_t end, std::uint32_t position) const
{
  const auto row = std::span(this->Entries).subspan(first, end - first);
  const auto found = std::partition_point(row.begin(), row.end(),
    [&](const LatticePoint& e) { return this->FirstPlace[e.Users] < position; });
  return first + static_cast<std::uint32_t>(found - row.begin());
}

SharedSearch::Area::Area(const SharedSearch& search, const Vec3& center, float limit)
  : Center(center)
  , Limit(limit)
{
  const float radius = std::sqrt(this->Limit);
  for (unsigned i = 0; i < 3; ++i)
  {
    this->Low[i] = search.CellOf(this->Center[i] - radius);
    this->High[i] = search.CellOf(this->Center[i] + radius);
  }
}
}
