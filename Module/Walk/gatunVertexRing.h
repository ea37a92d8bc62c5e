// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunVertexRing_h
#define gatunVertexRing_h

#include "gatunGate.h"
#include "gatunInline.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
/** The vertices around a gate that may be the fourth vertex of its tetrahedron, ranked on demand.
 */
class VertexRing
{
public:
  static constexpr unsigned MaxFan = 32; // faces visited around a corner in one direction

  explicit VertexRing(std::size_t vertices)
    : Stamps(vertices)
  {
  }

  /** Clears the ring. The gate's corners and candidates will not be added. */
  template <Ranking Rule>
  GATUN_INLINE void Begin(const Gate<Rule>& gate)
  {
    ++this->Stamp;
    this->Count = 0;
    for (unsigned i = 0; i < 3; ++i)
    {
      this->Stamps[gate.Face.Corners[i]] = this->Stamp;
      if (gate.Ids[i] != NoVertex)
      {
        this->Stamps[gate.Ids[i]] = this->Stamp;
      }
    }
  }

  /** Adds a vertex, unless it is there already. */
  GATUN_INLINE void Add(Vertex v)
  {
    // Without a branch, because the condition is unpredictable.
    this->Ids[this->Count] = v;
    this->Count += this->Stamps[v] != this->Stamp;
    this->Stamps[v] = this->Stamp;
  }

  /** Computes the ranks of the vertices. */
  template <Ranking Rule>
  GATUN_INLINE void Rank(const Gate<Rule>& gate, std::span<const LatticePoint> places)
  {
    for (unsigned i = 0; i < this->Count; i += 4)
    {
      const auto* ids = &this->Ids[i]; // beyond the end, ids of other rings
      const auto ranks =
        gate.GetSpheres(Gather(places[ids[0]], places[ids[1]], places[ids[2]], places[ids[3]]));
      for (unsigned lane = 0; lane < 4; ++lane)
      {
        this->Ranked[i + lane] = { ranks[lane], ids[lane] };
      }
    }
  }

  unsigned GetSize() const { return this->Count; }

  /** Moves the best vertex from position begin on to begin. Usually only one vertex is needed. */
  GATUN_INLINE Vertex TakeNext(unsigned begin)
  {
    unsigned best = begin;
    for (auto i = begin + 1; i < this->Count; ++i)
    {
      best = Choose(this->Ranked[i] < this->Ranked[best], i, best);
    }
    std::swap(this->Ranked[begin], this->Ranked[best]);
    return this->Ranked[begin].Id;
  }

private:
  static constexpr unsigned Most = 3 * 2 * MaxFan;

  std::vector<std::uint32_t> Stamps; // the last ring of each vertex
  std::uint32_t Stamp = 0;
  std::array<Vertex, Most> Ids{};
  std::array<RankedVertex, Most> Ranked;
  unsigned Count = 0;
};

/** Visits the faces around a corner of a gate until use returns false. */
template <Ranking Rule, typename Use>
GATUN_INLINE void TurnBothWays(
  const Front& front, const Gate<Rule>& gate, unsigned corner, Use&& use)
{
  const auto& over = gate.Face.Over;
  const auto end =
    TurnAround<Turn::Forward>(front, over[NextSide(corner)], VertexRing::MaxFan, use);
  if (end.IsBorder())
  {
    TurnAround<Turn::Back>(front, over[LastSide(corner)], VertexRing::MaxFan, use);
  }
}
}

#endif
