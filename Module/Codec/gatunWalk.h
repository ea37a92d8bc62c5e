// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunWalk_h
#define gatunWalk_h

// The breadth-first walk over a chunk's tetrahedra. Encoder and decoder use the same code.
//
// C.-K. Yang, T. Mitra, T.-c. Chiueh, "On-the-fly rendering of losslessly compressed irregular
// volume data", IEEE Visualization 2000: a tetrahedron is grown on each open face (gate), and its
// fourth vertex is coded by its neighborhood. In addition, the neighborhood is ranked by geometry,
// in the spirit of U. Bischoff, J. Rossignac, "TetStreamer: compressed back-to-front transmission
// of Delaunay tetrahedra meshes", Data Compression Conference 2005.

#include "gatunEntropy.h"
#include "gatunGate.h"
#include "gatunSharedSearch.h"
#include "gatunTopology.h"
#include "gatunVertexRing.h"
#include "gatunWalkModels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The sizes and shared vertices of a chunk, from its directory entry. */
struct WalkInput
{
  std::uint32_t Tets = 0;
  std::uint32_t OwnVertices = 0;
  std::span<const LatticePoint> Shared;
  bool Plain = false; // no gates: every tetrahedron is coded by the ids of its vertices
  std::uint32_t Stop = 0xffffffff; // the number of tetrahedra to code, for trial encodings
};

/**
 * Side provides the mesh to an encoder and receives it from a decoder:
 *
 *   std::uint32_t FindTet(face)         encoder: begins the unvisited tetrahedron over a gate.
 *                                       Returns its number, or NoTet
 *   void NextSeed()                     encoder: begins any unvisited tetrahedron
 *   Vertex GetTarget(i)                 encoder: vertex i of that tetrahedron (3 is opposite to
 *                                       the gate), or NoVertex if it has not been met
 *   bool IsTargetShared(i), std::uint32_t GetTargetShared(i)
 *                                       encoder: for a vertex that has not been met
 *   void MeetShared(i, index)           vertex i has been met: shared vertex number index
 *   LatticePoint MeetOwn(i, record)     vertex i has been met: the next own one. Returns its place
 */
template <Ranking Rule, typename Coder, typename Side>
class Walk
{
public:
  Walk(Coder& coder, Side& side, const WalkInput& input, Topology& out)
    : Symbols(coder)
    , Truth(side)
    , Input(input)
    , Out(out)
    , Search(input.Shared)
    , Ring(std::size_t{ input.OwnVertices } + input.Shared.size())
  {
    // Sized once, because growing vectors would cost more than the walk itself.
    const auto vertices = std::size_t{ input.OwnVertices } + input.Shared.size();
    const auto tets = std::min(input.Tets, input.Stop);
    this->Places.resize(vertices);
    out.Sources.resize(vertices);
    out.Records.resize(input.OwnVertices);
    out.Tets.resize(tets);
    out.Parents.resize(tets);
    out.EdgeLog.resize(tets + tets / 4 + MostNewEdges);
  }

  void Run()
  {
    const auto end = static_cast<std::uint32_t>(this->Out.Tets.size());
    while (this->Tets < end) // NOLINT(bugprone-infinite-loop): both branches add tetrahedra
    {
      const auto gate = this->Input.Plain ? Front::None : this->Open.NextGate();
      if (gate == Front::None)
      {
        this->GrowSeed();
      }
      else
      {
        this->GrowOnGate(gate);
      }
    }
    this->Out.EdgeLog.resize(this->Edges);
    if (end < this->Input.Tets)
    {
      this->Out.Sources.resize(this->Vertices);
      this->Out.Records.resize(this->Owns);
    }
    else if (this->Owns != this->Input.OwnVertices || this->Vertices != this->Places.size())
    {
      ThrowCorrupt("a chunk's walk does not meet all its vertices");
    }
  }

private:
  static constexpr unsigned MaxRing = 15; // ring vertices that can be named

  // The order of the sides of the gate. Other orders cost some bits in grids.
  static constexpr std::array<unsigned, 3> OrderOfFaces{ 2, 0, 1 };

  // The search radius for shared vertices in longest edges. Grids are often stretched.
  static constexpr float SearchReach = Rule == Ranking::Angle ? 3.0F : 1.25F;

  //----------------------------------------------------------------------------
  // Vertices

  Vertex MeetShared(unsigned corner, std::uint32_t index)
  {
    if (index >= this->Input.Shared.size() || this->Search.IsGone(index))
    {
      ThrowCorrupt("a walk names a shared vertex that is not there or was met before");
    }
    this->Search.Remove(index);
    const auto id = this->Vertices++;
    this->Places[id] = this->Input.Shared[index];
    this->Out.Sources[id] = Topology::SharedFlag | index;
    this->Truth.MeetShared(corner, index);
    return id;
  }

  Vertex MeetOwn(unsigned corner, const GateRecord& record)
  {
    if (this->Owns >= this->Input.OwnVertices)
    {
      ThrowCorrupt("a walk meets more vertices than its chunk has");
    }
    const auto id = this->Vertices++;
    this->Out.Sources[id] = this->Owns;
    this->Out.Records[this->Owns++] = record;
    this->Places[id] = this->Truth.MeetOwn(corner, record);
    return id;
  }

  /** Codes a number below count without modeling. */
  std::uint32_t CodeIndex(std::uint32_t value, std::size_t count)
  {
    const auto bits = static_cast<unsigned>(std::bit_width(count > 0 ? count - 1 : 0));
    const auto coded = static_cast<std::uint32_t>(this->Symbols.Raw(value, bits));
    if (coded >= count)
    {
      ThrowCorrupt("a walk names a vertex that is not there");
    }
    return coded;
  }

  //----------------------------------------------------------------------------
  // A tetrahedron without a gate

  void GrowSeed()
  {
    if constexpr (Coder::Encoding)
    {
      this->Truth.NextSeed();
    }
    std::array<Vertex, 4> v{};
    for (unsigned i = 0; i < 4; ++i)
    {
      v[i] = this->CodeSeedVertex(i);
    }
    const bool degenerate =
      v[0] == v[1] || v[0] == v[2] || v[0] == v[3] || v[1] == v[2] || v[1] == v[3] || v[2] == v[3];
    if (degenerate || this->Input.Plain)
    {
      // A tetrahedron with a vertex twice has fewer than four faces and stays out of the front.
      this->Finish(v, Topology::NoTet);
      return;
    }
    const auto tet = this->Finish(v, Topology::NoTet);
    this->MakeRoom();
    const auto base = this->Open.AddFace({ v[0], v[2], v[1] }, v[3], tet);
    Sides sides;
    for (const unsigned i : OrderOfFaces)
    {
      const unsigned side = i > 0 ? 3 - i : 0;
      this->Raise({ v[0], v[1], v[2] }, i, v[3], tet, Link::ToSide(base, side), sides);
    }
    for (unsigned k = 0; k < 3; ++k)
    {
      this->LogEdge(v[k], v[NextSide(k)]);
    }
    for (unsigned k = 0; k < 3; ++k)
    {
      this->LogEdge(v[k], v[3]);
      this->Open.Connect(sides.Left[k], sides.Right[k], 1);
    }
  }

  Vertex CodeSeedVertex(unsigned corner)
  {
    const Vertex target = Coder::Encoding ? this->Truth.GetTarget(corner) : NoVertex;
    if (!this->Symbols.Bit(this->Models.SeedNew, target == NoVertex))
    {
      return this->CodeIndex(target, this->Vertices);
    }
    if (!this->Symbols.Bit(
          this->Models.SeedShared, Coder::Encoding && this->Truth.IsTargetShared(corner)))
    {
      return this->MeetOwn(corner, GateRecord{});
    }
    return this->MeetShared(corner,
      this->CodeIndex(
        Coder::Encoding ? this->Truth.GetTargetShared(corner) : 0, this->Input.Shared.size()));
  }

  //----------------------------------------------------------------------------
  // A tetrahedron on a gate

  void GrowOnGate(std::uint32_t id)
  {
    this->Open.Prefetch(id + 4);
    auto& face = this->Open.GetFace(id);
    bool border = false;
    Vertex target = NoVertex;
    if constexpr (Coder::Encoding)
    {
      border = this->Truth.FindTet(face) == Topology::NoTet;
      target = border ? NoVertex : this->Truth.GetTarget(3);
    }

    // Most faces whose corners another chunk uses are the interface with that chunk.
    const bool isInterface = this->GetUsers(face) != 0;
    if (isInterface &&
      this->Symbols.Bit(this->Models.Interface[this->GradeInterface(face)], border))
    {
      face.Open = 0;
      this->Open.CloseAtBorder(face);
      return;
    }

    // The best candidate is usually right, so it comes first.
    const Gate<Rule> gate(this->Open, this->Places, face);
    face.Open = 0;
    if (gate.HasCandidate() &&
      this->Symbols.Bit(this->Models.Hit(gate), !border && target == gate.GetBest()))
    {
      this->Attach(gate, gate.GetBest());
      return;
    }
    if (!isInterface && this->Symbols.Bit(this->Models.Border(gate, this->Places), border))
    {
      this->Open.CloseAtBorder(gate.Face);
      return;
    }
    if (this->Symbols.Bit(this->Models.New(gate, this->Open, this->Places), target == NoVertex))
    {
      this->template AttachGlued<0, true>(gate, this->MeetNew(gate));
      return;
    }
    this->Attach(gate, this->CodeKnown(gate, target));
  }

  /** The other chunks that use all corners of a face. */
  std::uint32_t GetUsers(const Front::Face& face) const
  {
    const auto& c = face.Corners;
    return this->Places[c[0]].Users & this->Places[c[1]].Users & this->Places[c[2]].Users;
  }

  unsigned GradeInterface(const Front::Face& face) const
  {
    const auto& over = face.Over;
    const unsigned borders = unsigned{ over[0].IsBorder() } + unsigned{ over[1].IsBorder() } +
      unsigned{ over[2].IsBorder() };
    const unsigned apex = (this->GetUsers(face) & this->Places[face.Apex].Users) != 0;
    return (borders * 27 + GradeTets(face)) * 2 + apex;
  }

  //----------------------------------------------------------------------------
  // The fourth vertex, if it is not the best candidate

  Vertex MeetNew(const Gate<Rule>& gate)
  {
    const auto isShared = [&](Vertex v) { return unsigned{ this->Places[v].Users != 0 }; };
    const auto& c = gate.Face.Corners;
    const unsigned grade =
      (isShared(c[0]) + isShared(c[1]) + isShared(c[2])) * 2 + isShared(gate.Face.Apex);
    if (this->Symbols.Bit(
          this->Models.Shared[grade], Coder::Encoding && this->Truth.IsTargetShared(3)))
    {
      return this->MeetShared(3, this->CodeShared(gate));
    }
    return this->MeetOwn(3, gate.GetRecord());
  }

  std::uint32_t CodeShared(const Gate<Rule>& gate)
  {
    const auto target = Coder::Encoding ? this->Truth.GetTargetShared(3) : 0;
    const auto hits = this->Search.Find(gate.Plane, SearchReach,
      [&](const Vec3x4& places, Float4 distances)
      {
        return Rule == Ranking::Sphere ? gate.GetSpheres(places)
                                       : gate.Plane.SelectInFront(places, distances);
      });
    for (unsigned i = 0; i < hits.Count; ++i)
    {
      const auto index = hits.List[i].Id;
      if (this->Symbols.Bit(this->Models.SharedRank[i], index == target))
      {
        return index;
      }
    }
    return this->CodeIndex(target, this->Input.Shared.size());
  }

  Vertex CodeKnown(const Gate<Rule>& gate, Vertex target)
  {
    const auto others = gate.GetOthers();
    for (unsigned i = 0; i < others.Count; ++i)
    {
      if (this->Symbols.Bit(this->Models.Next[i], others.List[i] == target))
      {
        return others.List[i];
      }
    }
    this->FillRing(gate);
    Vertex vertex = this->CodeRing(target);
    if (vertex == NoVertex)
    {
      vertex = this->CodeIndex(target, this->Vertices);
    }
    const auto& c = gate.Face.Corners;
    if (vertex == c[0] || vertex == c[1] || vertex == c[2])
    {
      ThrowCorrupt("a walk makes a tetrahedron with the same vertex twice");
    }
    return vertex;
  }

  /** Collects the far corners of the open faces around the gate's corners, except its candidates.
   */
  void FillRing(const Gate<Rule>& gate)
  {
    this->Ring.Begin(gate);
    for (unsigned i = 0; i < 3; ++i)
    {
      this->TurnBothWays(gate, i,
        [this](Vertex v, Link, Turn)
        {
          this->Ring.Add(v);
          return true;
        });
    }
    this->Ring.Rank(gate, this->Places);
  }

  /** Visits the faces around a corner of the gate until use returns false. */
  template <typename Use>
  void TurnBothWays(const Gate<Rule>& gate, unsigned corner, Use&& use)
  {
    const auto& over = gate.Face.Over;
    const auto end =
      TurnAround<Turn::Forward>(this->Open, over[NextSide(corner)], VertexRing::MaxFan, use);
    if (end.IsBorder())
    {
      TurnAround<Turn::Back>(this->Open, over[LastSide(corner)], VertexRing::MaxFan, use);
    }
  }

  /** Codes a vertex by its rank in the ring. Returns NoVertex if it is not among the first ones. */
  Vertex CodeRing(Vertex target)
  {
    const auto count = std::min(this->Ring.GetSize(), MaxRing);
    bool isListed = false;
    if constexpr (Coder::Encoding)
    {
      for (unsigned i = 0; i < count && !isListed; ++i)
      {
        isListed = this->Ring.TakeNext(i) == target;
      }
    }
    if (!this->Symbols.Bit(this->Models.RingListed, isListed))
    {
      return NoVertex;
    }
    for (unsigned i = 0; i < count; ++i)
    {
      const Vertex next = this->Ring.TakeNext(i);
      if (this->Symbols.Bit(this->Models.RingRank[std::min(i, 5u)], next == target))
      {
        return next;
      }
    }
    ThrowCorrupt("a walk names no vertex of a list");
  }

  //----------------------------------------------------------------------------
  // A new tetrahedron in the front

  /**
   * The neighbors on both sides of the edges from the gate's corners to the fourth vertex: a new
   * face, or the neighbor over that edge of an open face that the tetrahedron closes.
   */
  struct Sides
  {
    std::array<Link, 3> Left;
    std::array<Link, 3> Right;
  };

  static constexpr std::size_t MostNewEdges = 6; // of one tetrahedron

  std::uint32_t Finish(const std::array<Vertex, 4>& corners, std::uint32_t parent)
  {
    const auto tet = this->Tets++;
    this->Out.Tets[tet] = corners;
    this->Out.Parents[tet] = parent;
    return tet;
  }

  /** Makes room for the faces and edges of a tetrahedron. */
  void MakeRoom()
  {
    this->Open.MakeRoom();
    auto& log = this->Out.EdgeLog;
    if (this->Edges + MostNewEdges > log.size())
    {
      log.resize(2 * log.size());
    }
  }

  GATUN_INLINE void LogEdge(Vertex a, Vertex b) { this->Out.EdgeLog[this->Edges++] = { a, b }; }

  /** Opens the face over side i of a triangle and links it there. */
  GATUN_INLINE void Raise(const std::array<Vertex, 3>& c, unsigned i, Vertex fourth,
    std::uint32_t tet, Link base, Sides& sides)
  {
    const auto next = NextSide(i);
    const auto last = LastSide(i);
    const auto face = this->Open.AddFace({ c[next], c[last], fourth }, c[i], tet);
    this->Open.Connect(Link::ToSide(face, 2), base, base.GetTets() + 1);
    sides.Left[last] = Link::ToSide(face, 0);
    sides.Right[next] = Link::ToSide(face, 1);
  }

  /** Adds a tetrahedron with a known fourth vertex, which closes the open faces that it shares. */
  void Attach(const Gate<Rule>& gate, Vertex fourth)
  {
    const unsigned glued = unsigned{ gate.Ids[0] == fourth } |
      unsigned{ gate.Ids[1] == fourth } << 1 | unsigned{ gate.Ids[2] == fourth } << 2;
    switch (glued)
    {
      case 0:
        return this->template AttachGlued<0>(gate, fourth);
      case 1:
        return this->template AttachGlued<1>(gate, fourth);
      case 2:
        return this->template AttachGlued<2>(gate, fourth);
      case 3:
        return this->template AttachGlued<3>(gate, fourth);
      case 4:
        return this->template AttachGlued<4>(gate, fourth);
      case 5:
        return this->template AttachGlued<5>(gate, fourth);
      case 6:
        return this->template AttachGlued<6>(gate, fourth);
      default:
        return this->template AttachGlued<7>(gate, fourth);
    }
  }

  /**
   * Adds the tetrahedron on a gate. Bit i of Glued is set if it shares the open face over side i of
   * the gate. IsNew: whether its fourth vertex is new.
   */
  template <unsigned Glued, bool IsNew = false>
  void AttachGlued(const Gate<Rule>& gate, Vertex fourth)
  {
    constexpr std::array<bool, 3> glued{ (Glued & 1) != 0, (Glued & 2) != 0, (Glued & 4) != 0 };
    const auto& c = gate.Face.Corners;
    const auto& over = gate.Face.Over;
    std::array<Touch, 3> touches;
    for (unsigned k = 0; k < 3 && !IsNew; ++k)
    {
      if (!glued[NextSide(k)] && !glued[LastSide(k)])
      {
        touches[k] = this->FindTouch(gate, k, fourth);
      }
    }
    const auto tet = this->Finish({ c[0], c[1], c[2], fourth }, gate.Face.Open - 1);
    this->MakeRoom();
    Sides sides;
    for (const unsigned i : OrderOfFaces)
    {
      if (glued[i])
      {
        auto& face = this->Open.GetFace(over[i]);
        face.Open = 0;
        sides.Left[LastSide(i)] = face.Over[LastSide(over[i].GetSide())];
        sides.Right[NextSide(i)] = face.Over[NextSide(over[i].GetSide())];
      }
      else
      {
        this->Raise(c, i, fourth, tet, over[i], sides);
      }
    }
    for (unsigned k = 0; k < 3; ++k)
    {
      if (glued[NextSide(k)] || glued[LastSide(k)])
      {
        this->JoinAround(sides.Left[k], sides.Right[k]);
      }
      else if (touches[k].Found)
      {
        this->JoinTouching(touches[k], sides.Left[k], sides.Right[k]);
      }
      else
      {
        this->LogEdge(c[k], fourth);
        this->Open.Connect(sides.Left[k], sides.Right[k], 1);
      }
    }
  }

  /** Links the neighbors on both sides of a tetrahedron at an edge that is already in the front. */
  GATUN_INLINE void JoinAround(Link left, Link right)
  {
    const bool closed =
      !left.IsBorder() && this->Open.GetFace(left).Open == 0; // all around the edge
    if (!closed)
    {
      this->Open.Connect(left, right, left.GetTets() + right.GetTets() + 1);
    }
  }

  //----------------------------------------------------------------------------
  // A front that touches itself

  /** A side of the front at an edge of the new tetrahedron. */
  struct Touch
  {
    Link Edge;
    bool Found = false;
    bool FromFourth = false; // the side runs from the fourth vertex to the corner
  };

  /** Searches the edges around a corner for the one to a vertex. */
  Touch FindTouch(const Gate<Rule>& gate, unsigned corner, Vertex fourth)
  {
    Touch touch;
    this->TurnBothWays(gate, corner,
      [&](Vertex v, Link side, Turn sense)
      {
        if (v != fourth)
        {
          return true;
        }
        touch = { side, true, sense == Turn::Forward };
        return false;
      });
    return touch;
  }

  /** Links those of the four faces at an edge that have no visited tetrahedra between them. */
  void JoinTouching(const Touch& touch, Link left, Link right)
  {
    const auto before = this->Open.GetFace(touch.Edge).Over[touch.Edge.GetSide()];
    const auto tets = before.GetTets() + 1;
    this->Open.Connect(touch.FromFourth ? left : right, touch.Edge, tets);
    this->Open.Connect(touch.FromFourth ? right : left, before, tets);
  }

  Coder& Symbols;
  Side& Truth;
  const WalkInput Input;
  Topology& Out;
  Front Open;
  SharedSearch Search;
  VertexRing Ring;
  WalkModels<Rule> Models;

  std::uint32_t Tets = 0; // made so far
  Vertex Vertices = 0;    // met so far
  std::uint32_t Owns = 0; // own ones among them
  std::size_t Edges = 0;  // logged so far
  std::vector<LatticePoint> Places;
};
}

#endif
