// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSharedSearch_h
#define gatunSharedSearch_h

#include "gatunGate.h"
#include "gatunMeasure.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Finds shared vertices in front of a gate and close to it that have not been met. */
class SharedSearch
{
public:
  static constexpr unsigned Most = 8;
  static constexpr std::uint32_t Patience =
    512; // the maximum number of groups of four vertices to examine

  struct Hits
  {
    std::array<RankedVertex, Most> List; // Id is the index of a shared vertex
    unsigned Count = 0;

    /** Vertices with a lower rank are among the best. */
    float GetBound() const { return this->Count < Most ? NeverRank : this->List[Most - 1].Rank; }

    void Add(const RankedVertex& hit)
    {
      unsigned at = this->Count < Most ? this->Count++ : Most - 1;
      for (; at > 0 && hit.Rank < this->List[at - 1].Rank; --at)
      {
        this->List[at] = this->List[at - 1];
      }
      this->List[at] = hit;
    }
  };

  explicit SharedSearch(std::span<const LatticePoint> vertices);

  /**
   * Finds the best vertices in front of a gate whose distance to its centroid is at most reach
   * times its longest side. getRanks(places, squared distances) ranks them; the best one is first.
   * The search visits the rows of cells of a grid from the middle outwards and stops after Patience
   * groups of vertices.
   */
  template <typename GetRanks>
  Hits Find(const GatePlane& plane, float reach, GetRanks&& getRanks) const
  {
    Hits hits;
    this->EachGroup(plane, reach, getRanks,
      [&](Float4 ranks, std::uint32_t first, std::uint32_t end)
      {
        if (Least(ranks) < hits.GetBound())
        {
          for (unsigned lane = 0; lane < 4 && first + lane < end; ++lane)
          {
            if (ranks[lane] < hits.GetBound())
            {
              hits.Add({ ranks[lane], this->Entries[first + lane].Users });
            }
          }
        }
      });
    return hits;
  }

  /** The first one of the hits that Find returns, or NoVertex, in less time. */
  template <typename GetRanks>
  std::uint32_t FindBest(const GatePlane& plane, float reach, GetRanks&& getRanks) const
  {
    LeastOfGroups best;
    this->EachGroup(plane, reach, getRanks,
      [&](Float4 ranks, std::uint32_t first, std::uint32_t end)
      { best.Compare(ranks, static_cast<std::int32_t>(first), static_cast<std::int32_t>(end)); });
    const auto position = best.GetPosition();
    return position < 0 ? NoVertex : this->Entries[static_cast<std::size_t>(position)].Users;
  }

  void Remove(std::uint32_t index);
  bool IsGone(std::uint32_t index) const { return this->PlaceOf[index] == Gone; }

private:
  static constexpr std::uint32_t Gone = 0xffffffffu;

  /** The cells that a search visits. */
  struct Area
  {
    Area(const SharedSearch& search, const GatePlane& plane, float reach);

    Float4 GetDistances(const Vec3x4& places) const
    {
      const auto d = places - Splat(this->Center);
      return Dot(d, d);
    }

    unsigned CountOf(unsigned axis) const { return this->High[axis] - this->Low[axis] + 1; }

    /** The i-th cell along an axis, from the middle outwards, alternating between the sides. */
    unsigned Outwards(unsigned axis, unsigned i) const
    {
      const auto low = this->Low[axis];
      const auto high = this->High[axis];
      const auto middle = (low + high) / 2;
      return i % 2 == 0 ? middle - i / 2 : middle + (i + 1) / 2;
    }

    Vec3 Center;
    float Limit; // of the squared distance
    std::array<unsigned, 3> Low, High;
  };

  /** Calls use(ranks, first, end) for the groups of vertices within reach, in the order of Find.
   * Lanes of entries from end on do not belong to the search. */
  template <typename GetRanks, typename Use>
  GATUN_INLINE void EachGroup(
    const GatePlane& plane, float reach, GetRanks&& getRanks, Use&& use) const
  {
    const Area area(*this, plane, reach);
    std::uint32_t patience = Patience;
    for (unsigned i = 0; i < area.CountOf(2); ++i)
    {
      const auto z = area.Outwards(2, i);
      for (unsigned j = 0; j < area.CountOf(1); ++j)
      {
        const auto row = ((z << this->Bits) + area.Outwards(1, j)) << this->Bits;
        const auto begin = this->CellStart[row + area.Low[0]];
        const auto end = this->CellStart[row + area.High[0] + 1];
        for (auto first = begin; first < end; first += 4)
        {
          const auto* e = &this->Entries[first];
          const auto places = Gather(e[0], e[1], e[2], e[3]);
          const auto distances = area.GetDistances(places);
          use(SelectGreater(
                distances, Splat(area.Limit), Splat(NeverRank), getRanks(places, distances)),
            first, end);
          if (--patience == 0)
          {
            return;
          }
        }
      }
    }
  }

  unsigned CellOf(float coordinate) const
  {
    const auto count = 1 << this->Bits;
    const auto cell = static_cast<int>(coordinate * this->CellsPerUnit);
    return static_cast<unsigned>(std::clamp(cell, 0, count - 1));
  }

  std::size_t CellOf(const LatticePoint& p) const
  {
    return (((this->CellOf(p.Z) << this->Bits) + this->CellOf(p.Y)) << this->Bits) +
      this->CellOf(p.X);
  }

  std::vector<std::uint32_t> PlaceOf; // the position of each vertex in Entries

  /** Sorted by cell, then by index, which is in Users. Met vertices are far away. Three more at the
   * end. */
  std::vector<LatticePoint> Entries;
  std::vector<std::uint32_t> CellStart;
  unsigned Bits = 0; // the number of cells along each axis is a power of two
  float CellsPerUnit = 1;
};
}

#endif
