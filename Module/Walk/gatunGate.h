// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGate_h
#define gatunGate_h

// An open face and candidates for the fourth vertex of the tetrahedron behind it.

#include "gatunFront.h"
#include "gatunInline.h"
#include "gatunMeasure.h"
#include "gatunTopology.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

namespace gatun
{
/** A vertex and its rank; lower is better, and the lower number wins among equals. */
struct RankedVertex
{
  float Rank = NeverRank;
  Vertex Id = NoVertex;

  bool operator<(const RankedVertex& other) const
  {
    return (this->Rank < other.Rank) | ((this->Rank == other.Rank) & (this->Id < other.Id));
  }
};

/** The direction in which the faces around a vertex are visited. */
enum class Turn
{
  Forward,
  Back
};

/**
 * Visits a limited number of open faces around a vertex, starting at the face of a link. Calls
 * use(vertex, side, Sense) with the next vertex around and the side of the face that leads on, as a
 * link. Stops when use returns false. Returns the link that was not followed.
 */
template <Turn Sense, typename Use>
GATUN_INLINE Link TurnAround(const Front& front, Link link, unsigned most, Use&& use)
{
  for (unsigned step = 0; step < most && !link.IsBorder(); ++step)
  {
    const auto& face = front.GetFace(link);
    if (!face.Open)
    {
      break; // a full turn, back at the gate
    }
    const auto side = link.GetSide();
    const auto next = Sense == Turn::Forward ? LastSide(side) : NextSide(side);
    if (!use(face.Corners[side], Link::ToSide(link.GetFace(), next), Sense))
    {
      break;
    }
    link = face.Over[next];
  }
  return link;
}

/** Grades the numbers of tetrahedra at a face's sides (1, 2, more), 0 to 26. */
inline unsigned GradeTets(const Front::Face& face)
{
  unsigned grade = 0;
  for (const auto link : face.Over)
  {
    grade = 3 * grade + std::min(link.GetTets() - 1u, 2u);
  }
  return grade;
}

/** An open face whose sides propose the far corners of the open faces over them as candidates. */
template <Ranking Rule>
class Gate
{
public:
  struct Others
  {
    std::array<Vertex, 2> List;
    unsigned Count = 0;
  };

  static constexpr bool UsesAngle = Rule == Ranking::Angle;
  struct NoCircle
  {
    explicit NoCircle(const GatePlane&) {}
  };
  using Circle = std::conditional_t<UsesAngle, NoCircle, GateCircle>;

  /** Collects the proposals. */
  GATUN_INLINE Gate(
    const Front& front, std::span<const LatticePoint> places, const Front::Face& face)
    : Face(face)
    , Plane(places[face.Corners[0]], places[face.Corners[1]], places[face.Corners[2]])
    , Ring(Plane)
  {
    std::array<Vertex, 3> lanes; // a corner of the gate where there is no proposal
    for (unsigned i = 0; i < 3; ++i)
    {
      const auto link = face.Over[i];
      const auto& over = front.GetFace(link);
      const Vertex far = Choose(link.IsBorder(), link.GetBorderFar(), over.Corners[link.GetSide()]);
      const bool proposed = !link.IsBorder() & (far != face.Corners[i]);
      this->Far[i] = far;
      this->Ids[i] = Choose(proposed, far, NoVertex);
      lanes[i] = Choose(proposed, far, face.Corners[i]);
    }
    const auto ranks = this->GetRanks(
      Gather(places[lanes[0]], places[lanes[1]], places[lanes[2]], places[face.Corners[0]]));
    for (unsigned i = 0; i < 3; ++i)
    {
      this->Ranks[i] = this->Ids[i] != NoVertex ? ranks[i] : NeverRank;
    }
    const unsigned second = this->Ranks[1] < this->Ranks[0];
    const unsigned third = this->Ranks[2] < std::min(this->Ranks[0], this->Ranks[1]);
    this->Best = third * 2 + (second & ~third);
  }

  bool HasCandidate() const { return this->GetBest() != NoVertex; }
  Vertex GetBest() const { return this->Ids[this->Best]; }
  float GetBestRank() const { return this->Ranks[this->Best]; }

  float GetSecondRank() const
  {
    float rank = NeverRank;
    for (unsigned i = 0; i < 3; ++i)
    {
      const bool other = this->Ids[i] != this->GetBest();
      rank = other && this->Ranks[i] < rank ? this->Ranks[i] : rank;
    }
    return rank;
  }

  /** The number of sides that propose the best candidate. */
  unsigned CountBest() const
  {
    const Vertex best = this->GetBest();
    return unsigned{ this->Ids[0] == best } + unsigned{ this->Ids[1] == best } +
      unsigned{ this->Ids[2] == best };
  }

  /** The number of tetrahedra at the side of the best candidate. */
  unsigned GetBestTets() const
  {
    return this->HasCandidate() ? this->Face.Over[this->Best].GetTets() : 0;
  }

  /** The number of distinct proposals. */
  unsigned CountCandidates() const
  {
    return this->HasCandidate() ? 1 + this->GetOthers().Count : 0;
  }

  /** The other candidates, sorted by rank. */
  Others GetOthers() const
  {
    Others result;
    const auto first = NextSide(this->Best);
    const auto second = LastSide(this->Best);
    const bool swap = this->IsBefore(second, first);
    for (const auto side : { swap ? second : first, swap ? first : second })
    {
      const Vertex id = this->Ids[side];
      if (id != NoVertex && id != this->GetBest() && (result.Count == 0 || id != result.List[0]))
      {
        result.List[result.Count++] = id;
      }
    }
    return result;
  }

  Float4 GetSpheres(const Vec3x4& places) const
  {
    if constexpr (UsesAngle)
    {
      return GateCircle(this->Plane).GetSpheres(this->Plane, places);
    }
    else
    {
      return this->Ring.GetSpheres(this->Plane, places);
    }
  }

  /** Grades the number of sides at the border and the number of coplanar ones among them, 0 to 9.
   */
  unsigned GetBorderGrade(std::span<const LatticePoint> places) const
  {
    unsigned border = 0;
    unsigned coplanar = 0;
    for (unsigned i = 0; i < 3; ++i)
    {
      const bool here = this->Face.Over[i].IsBorder();
      const auto& far = places[Choose(here, this->Far[i], this->Face.Corners[i])];
      border += here;
      coplanar += here & this->Plane.IsCoplanar(far, places[this->Face.Corners[NextSide(i)]]);
    }
    return border * (border + 1) / 2 + coplanar;
  }

  /** The known vertices that predict a vertex met on this gate. */
  GateRecord GetRecord() const
  {
    const auto& c = this->Face.Corners;
    GateRecord record;
    record.Known = { c[0], c[1], c[2], this->Face.Apex, this->Far[0], this->Far[1], this->Far[2] };
    record.EdgeGrade = static_cast<std::uint8_t>(GradeTets(this->Face));
    record.CandidateGrade = static_cast<std::uint8_t>(this->CountCandidates());
    return record;
  }

  /** The lowest sphere rank among the far corners of the faces next to those over the sides. */
  float GetRingRank(const Front& front, std::span<const LatticePoint> places) const
  {
    std::array<Vertex, 8>
      seen; // a corner of the gate, which is never in front of it, where there is none
    seen.fill(this->Face.Corners[0]);
    for (unsigned i = 0; i < 3; ++i)
    {
      const auto link = this->Face.Over[i];
      if (!link.IsBorder())
      {
        const auto& over = front.GetFace(link).Over;
        seen[2 * i] = this->GetRingVertex(front, over[NextSide(link.GetSide())]);
        seen[2 * i + 1] = this->GetRingVertex(front, over[LastSide(link.GetSide())]);
      }
    }
    const auto place = [&](unsigned i) -> const LatticePoint& { return places[seen[i]]; };
    const auto first = this->GetSpheres(Gather(place(0), place(1), place(2), place(3)));
    const auto last = this->GetSpheres(Gather(place(4), place(5), place(6), place(7)));
    return Least(SelectGreater(first, last, last, first));
  }

  const Front::Face Face;
  const GatePlane Plane;
  const Circle Ring;
  std::array<Vertex, 3> Far; // the far corner of the face or the border over each side
  std::array<Vertex, 3> Ids; // the proposal of each side, or NoVertex
  std::array<float, 3> Ranks;
  unsigned Best = 0;

private:
  /** The far corner over a side of a neighboring face, or a corner of the gate if it is not new. */
  Vertex GetRingVertex(const Front& front, Link link) const
  {
    const Vertex far = front.GetFace(link).Corners[link.GetSide()];
    const auto& c = this->Face.Corners;
    const auto& ids = this->Ids;
    const bool known = link.IsBorder() | (far == ids[0]) | (far == ids[1]) | (far == ids[2]) |
      (far == c[1]) | (far == c[2]);
    return Choose(known, c[0], far);
  }

  bool IsBefore(unsigned l, unsigned r) const { return this->Ranks[l] < this->Ranks[r]; }

  GATUN_INLINE Float4 GetRanks(const Vec3x4& places) const
  {
    if constexpr (UsesAngle)
    {
      return this->Plane.GetAngles(places);
    }
    else
    {
      return this->Ring.GetSpheres(this->Plane, places);
    }
  }
};
}

#endif
