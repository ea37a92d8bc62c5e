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
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
/**
 * Finds shared vertices in front of a gate and close to it that have not been met.
 *
 * The search visits the rows of cells of a grid from the middle outwards and stops after Patience
 * groups of four vertices. Met vertices count for the patience, but they leave their row after a
 * while, so that little time is spent on them.
 */
class SharedSearch
{
public:
  static constexpr unsigned Most = 8; // vertices that a walk can name by their rank
  static constexpr std::uint32_t Patience = 512;

  explicit SharedSearch(std::span<const LatticePoint> vertices);

  /**
   * Ranks the vertices in front of a gate whose distance to its centroid is at most reach times its
   * longest side. getRanks(places, squared distances) ranks them.
   */
  template <typename GetRanks>
  void Begin(const GatePlane& plane, float reach, GetRanks&& getRanks)
  {
    const auto w = ToVector(plane.C) - ToVector(plane.B);
    const float longest = std::max({ Dot(plane.U, plane.U), Dot(plane.V, plane.V), Dot(w, w) });
    const Vec3 sum{ ToVector(plane.A).Lanes + ToVector(plane.B).Lanes + ToVector(plane.C).Lanes };
    this->Begin({ sum.Lanes * Splat(1.0F / 3.0F) }, reach * reach * longest,
      std::forward<GetRanks>(getRanks));
  }

  /** Ranks the vertices around a place. limit: of the squared distance. */
  template <typename GetRanks>
  void Begin(const Vec3& center, float limit, GetRanks&& getRanks)
  {
    const Area area(*this, center, limit);
    std::uint32_t patience = Patience;
    this->RankCount = 0;
    this->RowCount = 0;
    for (unsigned i = 0; i < area.CountOf(2) && patience > 0; ++i)
    {
      const auto z = area.Outwards(2, i);
      for (unsigned j = 0; j < area.CountOf(1) && patience > 0; ++j)
      {
        const auto row = ((z << this->Bits) + area.Outwards(1, j)) * this->GetStride();
        const auto low = row + area.Low[0];
        const auto high = row + area.High[0] + 1;
        const auto groups = (this->CellStart[high] - this->CellStart[low] + 3) / 4;
        auto end = this->LiveStart[high];
        if (groups > patience)
        {
          end = this->FindEnd(this->LiveStart[low], end, this->CellStart[low] + 4 * patience);
        }
        patience -= std::min(groups, patience);
        this->RankRow(this->LiveStart[low], end, area, getRanks);
      }
    }
    std::fill_n(&this->Ranks[this->RankCount], 3, NeverRank);
  }

  /** The next best vertex, among equal ones the one visited first, or NoVertex. */
  std::uint32_t TakeNext();

  /** Removes a vertex that has been met. */
  void Remove(std::uint32_t index);
  std::size_t GetSize() const { return this->Vertices.size(); }
  bool IsGone(std::uint32_t index) const { return this->Gone[index] != 0; }

private:
  /** The cells that a search visits. */
  struct Area
  {
    Area(const SharedSearch& search, const Vec3& center, float limit);

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

  /** Entries of a row whose ranks begin at a position of Ranks. */
  struct RankedRow
  {
    std::uint32_t FirstRank;
    std::uint32_t FirstEntry;
  };

  /** Appends the ranks of entries, and NeverRank for those out of reach. */
  template <typename GetRanks>
  GATUN_INLINE void RankRow(
    std::uint32_t first, std::uint32_t end, const Area& area, GetRanks&& getRanks)
  {
    this->Rows[this->RowCount] = { this->RankCount, first };
    this->RowCount += first < end;
    auto* ranks = &this->Ranks[this->RankCount];
    this->RankCount += end - first;
    // The next row overwrites lanes beyond the end.
    for (; first < end; first += 4, ranks += 4)
    {
      const auto* e = &this->Entries[first];
      const auto places = Gather(e[0], e[1], e[2], e[3]);
      const auto distances = area.GetDistances(places);
      const auto group =
        SelectGreater(distances, Splat(area.Limit), Splat(NeverRank), getRanks(places, distances));
      std::memcpy(ranks, &group, sizeof(group));
    }
  }

  /** The first entry of a row that was at a position or behind it at first. */
  std::uint32_t FindEnd(std::uint32_t first, std::uint32_t end, std::uint32_t position) const;

  /** Removes the met vertices from a row. */
  void Compact(std::size_t row);

  std::size_t GetStride() const { return (std::size_t{ 1 } << this->Bits) + 1; }

  unsigned CellOf(float coordinate) const
  {
    const auto count = 1 << this->Bits;
    const auto cell = static_cast<int>(coordinate * this->CellsPerUnit);
    return static_cast<unsigned>(std::clamp(cell, 0, count - 1));
  }

  /** The position of a place's cell in CellStart and LiveStart. */
  std::size_t CellOf(const LatticePoint& p) const
  {
    return ((this->CellOf(p.Z) << this->Bits) + this->CellOf(p.Y)) * this->GetStride() +
      this->CellOf(p.X);
  }

  std::span<const LatticePoint> Vertices;
  std::vector<std::uint8_t> Gone;        // for each vertex
  std::vector<std::uint32_t> FirstPlace; // its position in Entries at first
  std::vector<std::uint32_t> PlaceOf;    // and now

  /** Sorted by cell, then by index, which is in Users. Met vertices are far away. Three more at the
   * end. */
  std::vector<LatticePoint> Entries;

  // The first entries of the cells of each row and the end of its last cell: at first, and now.
  std::vector<std::uint32_t> CellStart;
  std::vector<std::uint32_t> LiveStart;
  std::vector<std::uint32_t> GoneInRow; // entries of met vertices
  unsigned Bits = 0;                    // the number of cells along each axis is a power of two
  float CellsPerUnit = 1;

  std::array<float, std::size_t{ 4 } * Patience + 4> Ranks; // of the vertices found by Begin
  std::array<RankedRow, Patience + 1> Rows;                 // ascending
  std::uint32_t RankCount = 0;
  std::uint32_t RowCount = 0;
};
}

#endif
