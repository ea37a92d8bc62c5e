// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunGate_h
#define gatunGate_h

// An open face and what can be known of the tetrahedron behind it before it is decoded.

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
/** A vertex and how near it is to being the one wanted; the lower number wins among equals. */
struct RankedVertex
{
  double Rank = NeverRank;
  Vertex Id = NoVertex;

  bool operator<(const RankedVertex& other) const
  {
    return this->Rank < other.Rank || (this->Rank == other.Rank && this->Id < other.Id);
  }
};

/** Where a value is among three. */
inline unsigned FindPlace(const std::array<std::uint32_t, 3>& values, std::uint32_t value)
{
  return values[1] == value ? 1 : values[2] == value ? 2 : 0;
}

/**
 * Visits the open faces around a corner, from one over the edge given to at most so many, and calls
 * use(far corner) for each: the end of the edge over which the next face lies. From is the face to
 * come from; on an edge with several other faces the oldest is taken. Returns the last edge.
 */
template <typename Use>
GATUN_INLINE std::uint32_t TurnAround(
  Front& front, Vertex corner, std::uint32_t edge, std::uint32_t from, unsigned most, Use&& use)
{
  for (unsigned step = 0; step < most; ++step)
  {
    const auto id = Front::GetOther(front.GetEdge(edge), from);
    if (id == Front::None)
    {
      break;
    }
    const auto& face = front.GetFace(id);
    const auto& c = face.Corners;
    const unsigned at = FindPlace(c, corner);
    const unsigned before = at > 0 ? at - 1 : 2;
    const unsigned after = at < 2 ? at + 1 : 0;
    const bool back = face.Edges[at] == edge;
    use(c[back ? before : after]);
    edge = face.Edges[back ? before : at];
    from = id;
  }
  return edge;
}

/** Each edge of the gate proposes the far corner of another open face on it. */
template <Ranking Rule>
class Gate
{
public:
  struct Proposal
  {
    double Rank = NeverRank;
    Vertex Id = NoVertex;
    std::uint32_t Face = Front::None;
  };

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

  /** Makes the proposals. The face is closed already. */
  Gate(Front& front, std::span<const LatticePoint> places, const Front::Face& face)
    : Face(face)
    , Plane(places[face.Corners[0]], places[face.Corners[1]], places[face.Corners[2]])
    , Ring(Plane)
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      this->Propose(front, places, i);
    }
    this->Best = this->IsBefore(1, 0) ? 1 : 0;
    this->Best = this->IsBefore(2, this->Best) ? 2 : this->Best;
    if constexpr (UsesAngle)
    {
      this->BestTets = this->HasCandidate()
        ? std::min<unsigned>(front.GetEdge(face.Edges[this->Best]).Tets, 7)
        : 0;
    }
  }

  bool HasCandidate() const { return this->GetBest() != NoVertex; }
  Vertex GetBest() const { return this->Sides[this->Best].Id; }
  double GetBestRank() const { return this->Sides[this->Best].Rank; }

  double GetSecondRank() const
  {
    double rank = NeverRank;
    for (const auto& side : this->Sides)
    {
      rank = side.Id != this->GetBest() && side.Rank < rank ? side.Rank : rank;
    }
    return rank;
  }

  /** How many edges propose the best candidate. */
  unsigned CountBest() const
  {
    const Vertex best = this->GetBest();
    return static_cast<unsigned>(this->Sides[0].Id == best) + (this->Sides[1].Id == best) +
      (this->Sides[2].Id == best);
  }

  /** How many different vertices are proposed. */
  unsigned CountCandidates() const
  {
    return this->HasCandidate() ? 1 + this->GetOthers().Count : 0;
  }

  /** The candidates after the best one, in the order of their ranks. */
  Others GetOthers() const
  {
    Others result;
    const Vertex best = this->GetBest();
    for (unsigned step = 1; step < 3; ++step)
    {
      const auto side = (this->Best + step) % 3;
      const Vertex id = this->Sides[side].Id;
      if (id != NoVertex && id != best && (result.Count == 0 || id != result.List[0]))
      {
        result.List[result.Count++] = id;
      }
    }
    const auto first = (this->Best + 1) % 3;
    if (result.Count == 2 && this->IsBefore((this->Best + 2) % 3, first))
    {
      std::swap(result.List[0], result.List[1]);
    }
    return result;
  }

  double GetSphere(const LatticePoint& d) const
  {
    if constexpr (UsesAngle)
    {
      return GateCircle(this->Plane).GetSphere(this->Plane, d);
    }
    else
    {
      return this->Ring.GetSphere(this->Plane, d);
    }
  }

  /** Looks at what only matters when the best candidate is wrong: the border and the ring. */
  void LookAround(
    Front& front, std::span<const LatticePoint> places, std::span<const std::uint64_t> users)
  {
    const auto& c = this->Face.Corners;
    this->AllShared = (users[c[0]] & users[c[1]] & users[c[2]]) != 0;
    this->LookAtBorder(front, places);
    if constexpr (UsesAngle)
    {
      this->EdgeGrade = this->GetEdgeGrade(front);
    }
    else
    {
      this->LookAtRing(front, places);
    }
  }

  /** What a vertex that is met on this gate can be predicted from. */
  GateRecord GetRecord(Front& front) const
  {
    const auto& c = this->Face.Corners;
    GateRecord record;
    record.Known = { c[0], c[1], c[2], this->Face.Apex };
    for (unsigned i = 0; i < 3; ++i)
    {
      const auto& edge = front.GetEdge(this->Face.Edges[i]);
      const Vertex far = this->Sides[i].Id;
      record.Known[4 + i] = far != NoVertex ? far : edge.BorderFar;
    }
    record.EdgeGrade = static_cast<std::uint8_t>(this->GetEdgeGrade(front));
    record.CandidateGrade = static_cast<std::uint8_t>(this->CountCandidates());
    return record;
  }

  /** How many tetrahedra the three edges have (1, 2, more), 0 to 26. */
  unsigned GetEdgeGrade(Front& front) const
  {
    unsigned grade = 0;
    for (const auto e : this->Face.Edges)
    {
      grade = 3 * grade + std::min(front.GetEdge(e).Tets - 1u, 2u);
    }
    return grade;
  }

  /** The open face over an edge that a tetrahedron with this fourth vertex closes, or None. */
  std::uint32_t GetTwin(Front& front, unsigned side, Vertex fourth) const
  {
    if (this->Sides[side].Id == fourth)
    {
      return this->Sides[side].Face;
    }
    const auto& edge = front.GetEdge(this->Face.Edges[side]);
    if (edge.Faces[1] != Front::None)
    {
      for (const auto id : edge.Faces)
      {
        if (id != Front::None && Front::GetFar(front.GetFace(id), edge) == fourth)
        {
          return id;
        }
      }
    }
    return Front::None;
  }

  const Front::Face Face;
  const GatePlane Plane;
  const Circle Ring;
  std::array<Proposal, 3> Sides;
  unsigned Best = 0;

  unsigned BestTets = 0; // tetrahedra at the edge of the best candidate, at most 7; by angle only

  // Made by LookAround.
  unsigned BorderGrade = 0; // pairs (edges at the border, of those coplanar with it), 0 to 9
  unsigned AllShared = 0;   // 1: another chunk uses all three corners
  unsigned EdgeGrade = 0;
  double RingRank = NeverRank;

private:
  bool IsBefore(unsigned l, unsigned r) const
  {
    const auto& a = this->Sides[l];
    const auto& b = this->Sides[r];
    // Without branches, as the answer is as good as random.
    return (unsigned{ a.Rank < b.Rank } |
             (unsigned{ a.Rank == b.Rank } & unsigned{ a.Id < b.Id })) != 0;
  }

  double GetRank(std::span<const LatticePoint> places, unsigned side, Vertex far) const
  {
    if constexpr (UsesAngle)
    {
      const auto& c = this->Face.Corners;
      return this->Plane.GetAngle(places[far], places[c[side]], places[c[(side + 1) % 3]]);
    }
    else
    {
      return this->Ring.GetSphere(this->Plane, places[far]);
    }
  }

  GATUN_INLINE void Propose(Front& front, std::span<const LatticePoint> places, unsigned side)
  {
    const auto& edge = front.GetEdge(this->Face.Edges[side]);
    if (edge.Faces[1] != Front::None)
    {
      this->ProposeBest(front, places, side);
    }
    else if (edge.Faces[0] != Front::None)
    {
      this->ProposeFar(front, places, side, edge.Faces[0]);
    }
  }

  /** Where the front touches itself: the best of the far corners on an edge. */
  void ProposeBest(Front& front, std::span<const LatticePoint> places, unsigned side)
  {
    Proposal best;
    for (const auto id : front.GetEdge(this->Face.Edges[side]).Faces)
    {
      if (id == Front::None)
      {
        break;
      }
      this->ProposeFar(front, places, side, id);
      const auto& next = this->Sides[side];
      best = best.Id == NoVertex || next.Rank < best.Rank ? next : best;
    }
    this->Sides[side] = best;
  }

  GATUN_INLINE void ProposeFar(
    Front& front, std::span<const LatticePoint> places, unsigned side, std::uint32_t id)
  {
    const auto& edge = front.GetEdge(this->Face.Edges[side]);
    const Vertex far = Front::GetFar(front.GetFace(id), edge);
    if (far == this->Face.Corners[side > 0 ? side - 1 : 2])
    {
      this->Sides[side] = {}; // a face with the gate's own corners
      return;
    }
    this->Sides[side] = { this->GetRank(places, side, far), far, id };
  }

  void LookAtBorder(Front& front, std::span<const LatticePoint> places)
  {
    unsigned border = 0;
    unsigned coplanar = 0;
    for (unsigned i = 0; i < 3; ++i)
    {
      const Vertex far = front.GetEdge(this->Face.Edges[i]).BorderFar;
      if (far != NoVertex)
      {
        ++border;
        coplanar += this->Plane.IsCoplanar(places[far], places[this->Face.Corners[i]]);
      }
    }
    this->BorderGrade = border * (border + 1) / 2 + coplanar;
  }

  /** The best rank of the far corners of faces next to those that made the proposals. */
  void LookAtRing(Front& front, std::span<const LatticePoint> places)
  {
    const auto look = [&](Vertex v)
    {
      const double rank = this->Ring.GetSphere(this->Plane, places[v]);
      const unsigned proposed = unsigned{ v == this->Sides[0].Id } |
        unsigned{ v == this->Sides[1].Id } | unsigned{ v == this->Sides[2].Id };
      this->RingRank = !proposed && rank < this->RingRank ? rank : this->RingRank;
    };
    for (unsigned i = 0; i < 3; ++i)
    {
      const auto id = this->Sides[i].Face;
      if (id != Front::None)
      {
        const auto& face = front.GetFace(id);
        const unsigned k = FindPlace(face.Edges, this->Face.Edges[i]);
        const unsigned next = k < 2 ? k + 1 : 0;
        const unsigned last = k > 0 ? k - 1 : 2;
        TurnAround(front, face.Corners[next], face.Edges[next], id, 2, look);
        TurnAround(front, face.Corners[k], face.Edges[last], id, 2, look);
      }
    }
  }
};
}

#endif
