// SPDX-License-Identifier: BSD-3-Clause
#include "gatunSharedSearch.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace gatun
{
SharedSearch::SharedSearch(std::span<const SharedVertex> vertices)
  : PlaceOf(vertices.size())
  , Entries(vertices.size())
{
  // About two vertices a cell where they lie on the six sides of a box.
  const auto bits = std::clamp((static_cast<int>(std::bit_width(vertices.size())) - 4) / 2, 0, 6);
  this->Shift = static_cast<unsigned>(16 - bits);
  this->Count = 1 << bits;
  this->CellStart.assign((std::size_t{ 1 } << (3 * bits)) + 1, 0);
  for (const auto& v : vertices)
  {
    ++this->CellStart[this->CellOf(v.Place) + 1];
  }
  for (std::size_t i = 1; i < this->CellStart.size(); ++i)
  {
    this->CellStart[i] += this->CellStart[i - 1];
  }
  auto next = this->CellStart;
  for (std::uint32_t i = 0; i < vertices.size(); ++i)
  {
    const auto& place = vertices[i].Place;
    this->PlaceOf[i] = next[this->CellOf(place)]++;
    this->Entries[this->PlaceOf[i]] = { place, i };
  }
}

void SharedSearch::Remove(std::uint32_t index)
{
  this->Entries[this->PlaceOf[index]].Index = Gone;
  this->PlaceOf[index] = Gone;
}

struct SharedSearch::Query
{
  const GatePlane& Plane;
  Vec3 ThreeCentroids;
  double Limit; // of 9 times the squared distance
  unsigned Patience = SharedSearch::Patience;
  Hits Found{};

  /** False when it runs out of patience. */
  bool Look(std::span<const Entry> cell)
  {
    const auto count = std::min<std::size_t>(cell.size(), this->Patience - 1);
    for (const auto& entry : cell.first(count))
    {
      this->Look(entry);
    }
    this->Patience -= static_cast<unsigned>(count) + 1;
    return this->Patience > 0;
  }

private:
  void Look(const Entry& entry)
  {
    const auto& p = entry.Place;
    const Vec3 d{ 3.0 * p.X - this->ThreeCentroids.X, 3.0 * p.Y - this->ThreeCentroids.Y,
      3.0 * p.Z - this->ThreeCentroids.Z };
    const RankedVertex hit{ Dot(d, d), entry.Index };
    auto& list = this->Found.List;
    auto& count = this->Found.Count;
    if (hit.Rank > this->Limit || hit.Id == Gone || (count == Most && !(hit < list[Most - 1])) ||
      !(this->Plane.GetHeight(p) > 0))
    {
      return;
    }
    unsigned at = count < Most ? count++ : Most - 1;
    for (; at > 0 && hit < list[at - 1]; --at)
    {
      list[at] = list[at - 1];
    }
    list[at] = hit;
  }
};

SharedSearch::Hits SharedSearch::Find(const GatePlane& plane, const LatticePoint& a,
  const LatticePoint& b, const LatticePoint& c, double reach) const
{
  const Vec3 w = c - b;
  const double longest = std::max({ Dot(plane.U, plane.U), Dot(plane.V, plane.V), Dot(w, w) });
  const Vec3 sum{ a.X + b.X + c.X, a.Y + b.Y + c.Y, a.Z + b.Z + c.Z };
  Query query{ plane, sum, 9.0 * reach * reach * longest };
  const int cx = this->CellOf(sum.X / 3);
  const int cy = this->CellOf(sum.Y / 3);
  const int cz = this->CellOf(sum.Z / 3);
  const int last = this->Count - 1;
  for (int ring = 0; ring <= last; ++ring)
  {
    // What lies in this ring is at least ring - 1 cells away.
    const double away = 3.0 * std::max(0, ring - 1) * static_cast<double>(1u << this->Shift);
    const auto& found = query.Found;
    if (away * away > query.Limit ||
      (found.Count == Most && away * away > found.List[Most - 1].Rank))
    {
      break;
    }
    for (int z = std::max(0, cz - ring); z <= std::min(last, cz + ring); ++z)
    {
      for (int y = std::max(0, cy - ring); y <= std::min(last, cy + ring); ++y)
      {
        const bool inside = std::abs(z - cz) < ring && std::abs(y - cy) < ring;
        const int step = inside ? 2 * ring : 1;
        for (int x = cx - ring; x <= cx + ring; x += step)
        {
          if (x < 0 || x > last)
          {
            continue;
          }
          const auto cell = this->CellOf(x, y, z);
          const auto begin = this->CellStart[cell];
          if (!query.Look({ this->Entries.data() + begin, this->CellStart[cell + 1] - begin }))
          {
            return query.Found;
          }
        }
      }
    }
  }
  return query.Found;
}
}
