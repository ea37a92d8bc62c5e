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
#include "gatunFrontGrowth.h"
#include "gatunGate.h"
#include "gatunSharedSearch.h"
#include "gatunTopology.h"
#include "gatunVertexRing.h"
#include "gatunWalkModels.h"

#include <algorithm>
#include <array>
#include <bit>
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
    , Actual(side)
    , Input(input)
    , Out(out)
    , Growth(std::min(input.Tets, input.Stop),
        std::size_t{ input.OwnVertices } + input.Shared.size(), out)
    , Open(Growth.GetFront())
    , Search(input.Shared)
    , Ring(std::size_t{ input.OwnVertices } + input.Shared.size())
  {
    // Sized once, because growing vectors would cost more than the walk itself.
    const auto vertices = std::size_t{ input.OwnVertices } + input.Shared.size();
    this->Places.resize(vertices);
    out.Sources.resize(vertices);
    out.Records.resize(input.OwnVertices);
  }

  void Run()
  {
    const auto end = static_cast<std::uint32_t>(this->Out.Tets.size());
    while (
      this->Growth.GetTets() < end) // NOLINT(bugprone-infinite-loop): both branches add tetrahedra
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
    this->Growth.Finish();
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
    this->Actual.MeetShared(corner, index);
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
    this->Places[id] = this->Actual.MeetOwn(corner, record);
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
      this->Actual.NextSeed();
    }
    std::array<Vertex, 4> v{};
    for (unsigned i = 0; i < 4; ++i)
    {
      v[i] = this->CodeSeedVertex(i);
    }
    // A tetrahedron with a vertex twice has fewer than four faces and stays out of the front.
    const bool degenerate =
      v[0] == v[1] || v[0] == v[2] || v[0] == v[3] || v[1] == v[2] || v[1] == v[3] || v[2] == v[3];
    if (degenerate || this->Input.Plain)
    {
      this->Growth.AddAlone(v);
    }
    else
    {
      this->Growth.AddSeed(v);
    }
  }

  Vertex CodeSeedVertex(unsigned corner)
  {
    const Vertex target = Coder::Encoding ? this->Actual.GetTarget(corner) : NoVertex;
    if (!this->Symbols.Bit(this->Models.SeedNew, target == NoVertex))
    {
      return this->CodeIndex(target, this->Vertices);
    }
    if (!this->Symbols.Bit(
          this->Models.SeedShared, Coder::Encoding && this->Actual.IsTargetShared(corner)))
    {
      return this->MeetOwn(corner, GateRecord{});
    }
    return this->MeetShared(corner,
      this->CodeIndex(
        Coder::Encoding ? this->Actual.GetTargetShared(corner) : 0, this->Input.Shared.size()));
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
      border = this->Actual.FindTet(face) == Topology::NoTet;
      target = border ? NoVertex : this->Actual.GetTarget(3);
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
      this->Growth.Attach(gate, gate.GetBest());
      return;
    }
    if (!isInterface && this->Symbols.Bit(this->Models.Border(gate, this->Places), border))
    {
      this->Open.CloseAtBorder(gate.Face);
      return;
    }
    if (this->Symbols.Bit(this->Models.New(gate, this->Open, this->Places), target == NoVertex))
    {
      this->Growth.AttachNew(gate, this->MeetNew(gate));
      return;
    }
    this->Growth.Attach(gate, this->CodeKnown(gate, target));
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
          this->Models.Shared[grade], Coder::Encoding && this->Actual.IsTargetShared(3)))
    {
      return this->MeetShared(3, this->CodeShared(gate));
    }
    return this->MeetOwn(3, gate.GetRecord());
  }

  // This and the next one stand apart from the step, whose variables they would push out of
  // registers.
  [[gnu::noinline]] std::uint32_t CodeShared(const Gate<Rule>& gate)
  {
    const auto target = Coder::Encoding ? this->Actual.GetTargetShared(3) : 0;
    const auto getRanks = [&](const Vec3x4& places, Float4 distances)
    {
      return Rule == Ranking::Sphere ? gate.GetSpheres(places)
                                     : gate.Plane.SelectInFront(places, distances);
    };
    this->Search.Begin(gate.Plane, SearchReach, getRanks);
    for (auto& model : this->Models.SharedRank)
    {
      const auto index = this->Search.TakeNext();
      if (index == NoVertex)
      {
        break;
      }
      if (this->Symbols.Bit(model, index == target))
      {
        return index;
      }
    }
    return this->CodeIndex(target, this->Input.Shared.size());
  }

  [[gnu::noinline]] Vertex CodeKnown(const Gate<Rule>& gate, Vertex target)
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
      TurnBothWays(this->Open, gate, i,
        [this](Vertex v, Link, Turn)
        {
          this->Ring.Add(v);
          return true;
        });
    }
    this->Ring.Rank(gate, this->Places);
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

  Coder& Symbols;
  Side& Actual;
  const WalkInput Input;
  Topology& Out;
  FrontGrowth<Rule> Growth;
  Front& Open;
  SharedSearch Search;
  VertexRing Ring;
  WalkModels<Rule> Models;

  Vertex Vertices = 0;    // met so far
  std::uint32_t Owns = 0; // own ones among them
  std::vector<LatticePoint> Places;
};
}

#endif
