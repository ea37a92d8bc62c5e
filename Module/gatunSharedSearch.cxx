// SPDX-License-Identifier: BSD-3-Clause
#include "gatunSharedSearch.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gatun
{
SharedSearch::SharedSearch(std::span<const SharedVertex> vertices)
  : Vertices(vertices)
  , Gone(vertices.size(), 0)
{
  // About two vertices a cell where they lie on the six sides of a box.
  const int bits = std::max(0, static_cast<int>(std::bit_width(vertices.size())) - 3) / 2;
  this->Shift = static_cast<unsigned>(16 - std::min(bits, 6));
  this->Cells = 1 << (16 - this->Shift);
  const auto cellOf = [&](const LatticePoint& p)
  {
    return (static_cast<std::size_t>(this->CellOf(p.Z)) * static_cast<std::size_t>(this->Cells) +
             this->CellOf(p.Y)) *
      static_cast<std::size_t>(this->Cells) +
      this->CellOf(p.X);
  };
  const auto cells = static_cast<std::size_t>(this->Cells);
  this->CellStart.assign(cells * cells * cells + 1, 0);
  for (const auto& v : vertices)
  {
    ++this->CellStart[cellOf(v.Place) + 1];
  }
  for (std::size_t i = 1; i < this->CellStart.size(); ++i)
  {
    this->CellStart[i] += this->CellStart[i - 1];
  }
  this->Sorted.resize(vertices.size());
  auto next = this->CellStart;
  for (std::uint32_t i = 0; i < vertices.size(); ++i)
  {
    this->Sorted[next[cellOf(vertices[i].Place)]++] = i;
  }
}

SharedSearch::Hits SharedSearch::Find(const GateMeasure& measure, const LatticePoint& a,
  const LatticePoint& b, const LatticePoint& c, Ranking ranking) const
{
  const Vec3 w = c - b;
  const double longest = std::max({ Dot(measure.U, measure.U), Dot(measure.V, measure.V), Dot(w, w) });
  double limit = 144.0 * longest; // of 9 times the squared distance
  const double sx = static_cast<double>(a.X) + b.X + c.X;
  const double sy = static_cast<double>(a.Y) + b.Y + c.Y;
  const double sz = static_cast<double>(a.Z) + b.Z + c.Z;

  Hits hits;
  const auto less = [](const Hit& l, const Hit& r)
  { return l.Rank < r.Rank || (l.Rank == r.Rank && l.Index < r.Index); };
  const auto look = [&](int x, int y, int z)
  {
    const auto cell = static_cast<std::size_t>((z * this->Cells + y) * this->Cells + x);
    for (auto i = this->CellStart[cell]; i < this->CellStart[cell + 1]; ++i)
    {
      const auto index = this->Sorted[i];
      if (this->Gone[index])
      {
        continue;
      }
      const auto& p = this->Vertices[index].Place;
      const double dx = 3.0 * p.X - sx, dy = 3.0 * p.Y - sy, dz = 3.0 * p.Z - sz;
      const Hit hit{ dx * dx + dy * dy + dz * dz, index };
      if (hit.Rank > limit || !(Dot(p - a, measure.Normal) > 0))
      {
        continue;
      }
      if (hits.Count == Most && !less(hit, hits.List[Most - 1]))
      {
        continue;
      }
      unsigned at = hits.Count < Most ? hits.Count++ : Most - 1;
      for (; at > 0 && less(hit, hits.List[at - 1]); --at)
      {
        hits.List[at] = hits.List[at - 1];
      }
      hits.List[at] = hit;
    }
  };

  const int cx = static_cast<int>(this->CellOf(sx / 3));
  const int cy = static_cast<int>(this->CellOf(sy / 3));
  const int cz = static_cast<int>(this->CellOf(sz / 3));
  const int last = this->Cells - 1;
  for (int ring = 0; ring <= this->Cells; ++ring)
  {
    // What lies in this ring is at least ring - 1 cells away.
    const double reach = 3.0 * std::max(0, ring - 1) * static_cast<double>(1u << this->Shift);
    if (reach * reach > limit ||
      (hits.Count == Most && reach * reach > hits.List[Most - 1].Rank))
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
          if (x >= 0 && x <= last)
          {
            look(x, y, z);
          }
        }
      }
    }
  }
  if (ranking == Ranking::Sphere)
  {
    for (unsigned i = 0; i < hits.Count; ++i)
    {
      hits.List[i].Rank = measure.GetSphere(this->Vertices[hits.List[i].Index].Place);
    }
    std::sort(hits.List.begin(), hits.List.begin() + hits.Count, less);
  }
  return hits;
}
}
