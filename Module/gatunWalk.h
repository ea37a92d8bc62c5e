// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunWalk_h
#define gatunWalk_h

// The breadth-first walk over a chunk's tetrahedra, the same code for encoder and decoder.
//
// C.-K. Yang, T. Mitra, T.-c. Chiueh, "On-the-fly rendering of losslessly compressed irregular
// volume data", IEEE Visualization 2000: a tetrahedron is grown on each open face (gate) and its
// fourth vertex is named by its neighbourhood. New here: the neighbourhood is ranked by geometry,
// in the spirit of A. Bischoff, J. Rossignac, "TetStreamer", 2005.

#include "gatunEntropy.h"
#include "gatunGate.h"
#include "gatunSharedSearch.h"
#include "gatunTopology.h"
#include "gatunWalkModels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** What names the vertices of a chunk: its sizes, and what its directory entry says. */
struct WalkInput
{
  std::uint32_t Tets = 0;
  std::uint32_t OwnVertices = 0;
  std::span<const SharedVertex> Shared;
  bool Plain = false; // no gates: every tetrahedron is coded by the ids of its vertices
  std::uint32_t Stop = 0xffffffff; // an encoder that only tries may stop after so many tetrahedra
};

/**
 * Side tells an encoder what is true and takes from a decoder what it learnt:
 *
 *   std::uint32_t FindTet(face)         encoder: begin the unvisited tetrahedron over a gate; its
 *                                       number, or NoTet
 *   void NextSeed()                     encoder: begin any unvisited tetrahedron
 *   Vertex GetTarget(i)                 encoder: vertex i of the tetrahedron begun (3 is the one
 *                                       opposite to the gate), or NoVertex if not met yet
 *   bool IsTargetShared(i), std::uint32_t GetTargetShared(i)
 *                                       encoder: for a vertex not met yet
 *   void MeetShared(i, index)           vertex i was met: shared vertex number index
 *   LatticePoint MeetOwn(i, record)     vertex i was met: the next own one; returns its place
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
    , DistantLeft(std::min(8 + input.Tets / 512, 256u))
  {
    const auto vertices = std::size_t{ input.OwnVertices } + input.Shared.size();
    this->Places.reserve(vertices);
    this->Users.reserve(vertices);
    this->Stamps.assign(vertices, 0);
    out.Sources.reserve(vertices);
    out.Tets.reserve(input.Tets);
    out.Parents.reserve(input.Tets);
    out.Records.reserve(input.OwnVertices);
    out.EdgeLog.reserve(std::size_t{ input.Tets } + input.Tets / 2);
  }

  void Run()
  {
    const auto end = std::min(this->Input.Tets, this->Input.Stop);
    while (this->Out.Tets.size() < end)
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
    if (end == this->Input.Tets &&
      (this->Out.Records.size() != this->Input.OwnVertices ||
        this->Out.Sources.size() != this->Stamps.size()))
    {
      ThrowCorrupt("a chunk's walk does not meet all its vertices");
    }
  }

private:
  static constexpr unsigned MaxFan = 32;     // faces visited around a corner in one direction
  static constexpr unsigned MaxRing = 15;    // ring vertices that can be named
  static constexpr unsigned MaxDistant = 15; // front vertices that can be named

  // How far shared vertices are looked for, in longest edges: grids are often much stretched.
  static constexpr double SearchReach = Rule == Ranking::Angle ? 4.0 : 2.0;

  //------------------------------------------------------------------------------------------------
  // Vertices

  Vertex MeetShared(unsigned corner, std::uint32_t index)
  {
    if (index >= this->Input.Shared.size() || this->Search.IsGone(index))
    {
      ThrowCorrupt("a walk names a shared vertex that is not there or was met before");
    }
    this->Search.Remove(index);
    const auto id = static_cast<Vertex>(this->Places.size());
    this->Places.push_back(this->Input.Shared[index].Place);
    this->Users.push_back(this->Input.Shared[index].Users);
    this->Out.Sources.push_back(Topology::SharedFlag | index);
    this->Truth.MeetShared(corner, index);
    return id;
  }

  Vertex MeetOwn(unsigned corner, const GateRecord& record)
  {
    if (this->Out.Records.size() >= this->Input.OwnVertices)
    {
      ThrowCorrupt("a walk meets more vertices than its chunk has");
    }
    const auto id = static_cast<Vertex>(this->Places.size());
    this->Out.Sources.push_back(static_cast<std::uint32_t>(this->Out.Records.size()));
    this->Out.Records.push_back(record);
    this->Places.push_back(this->Truth.MeetOwn(corner, record));
    this->Users.push_back(0);
    return id;
  }

  /** A number below count as it is. */
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

  //------------------------------------------------------------------------------------------------
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
    const auto tet = this->Finish(v, Topology::NoTet);
    const bool degenerate =
      v[0] == v[1] || v[0] == v[2] || v[0] == v[3] || v[1] == v[2] || v[1] == v[3] || v[2] == v[3];
    if (degenerate || this->Input.Plain)
    {
      // One that names a vertex twice has fewer than four faces and stays out of the front.
      return;
    }
    const auto edge = [&](unsigned i, unsigned j) { return this->FindOrAddEdge(v[i], v[j]); };
    const std::array<std::uint32_t, 3> base{ edge(0, 1), edge(1, 2), edge(2, 0) };
    const std::array<std::uint32_t, 3> side{ edge(0, 3), edge(1, 3), edge(2, 3) };
    this->CountTet(base, side);
    this->Open.AddFace({ v[0], v[2], v[1] }, v[3], { base[2], base[1], base[0] }, tet);
    this->AddSides({ v[0], v[1], v[2] }, v[3], base, side, tet, NoTwins);
  }

  Vertex CodeSeedVertex(unsigned corner)
  {
    const Vertex target = Coder::Encoding ? this->Truth.GetTarget(corner) : NoVertex;
    if (!this->Symbols.Bit(this->Models.SeedNew, target == NoVertex))
    {
      return this->CodeIndex(target, this->Places.size());
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

  //------------------------------------------------------------------------------------------------
  // A tetrahedron on a gate

  void GrowOnGate(std::uint32_t id)
  {
    const auto face = this->Open.GetFace(id);
    this->Open.Prefetch(id + 4);
    this->Open.CloseFace(id);
    bool border = false;
    Vertex target = NoVertex;
    if constexpr (Coder::Encoding)
    {
      border = this->Truth.FindTet(face) == Topology::NoTet;
      target = border ? NoVertex : this->Truth.GetTarget(3);
    }

    // The best candidate first: it is right most of the time.
    Gate<Rule> gate(this->Open, this->Places, face);
    if (gate.HasCandidate() &&
      this->Symbols.Bit(this->Models.Hit(gate), !border && target == gate.GetBest()))
    {
      this->Attach(gate, gate.GetBest());
      return;
    }
    gate.LookAround(this->Open, this->Places, this->Users);
    if (this->Symbols.Bit(this->Models.Border(gate), border))
    {
      this->CloseAtBorder(face);
      return;
    }
    if (this->Symbols.Bit(this->Models.New(gate), target == NoVertex))
    {
      this->AttachNew(face, this->MeetNew(gate));
      return;
    }
    this->Attach(gate, this->CodeKnown(gate, target));
  }

  //------------------------------------------------------------------------------------------------
  // The fourth vertex, when it is not the best candidate

  Vertex MeetNew(const Gate<Rule>& gate)
  {
    const auto& c = gate.Face.Corners;
    const auto isShared = [&](Vertex v) { return this->Users[v] != 0; };
    const unsigned grade =
      (isShared(c[0]) + isShared(c[1]) + isShared(c[2])) * 2u + isShared(gate.Face.Apex);
    if (this->Symbols.Bit(
          this->Models.Shared[grade], Coder::Encoding && this->Truth.IsTargetShared(3)))
    {
      return this->MeetShared(3, this->CodeShared(gate));
    }
    return this->MeetOwn(3, gate.GetRecord(this->Open));
  }

  std::uint32_t CodeShared(const Gate<Rule>& gate)
  {
    const auto& c = gate.Face.Corners;
    const auto target = Coder::Encoding ? this->Truth.GetTargetShared(3) : 0;
    auto hits = this->Search.Find(
      gate.Plane, this->Places[c[0]], this->Places[c[1]], this->Places[c[2]], SearchReach);
    if constexpr (Rule == Ranking::Sphere)
    {
      for (unsigned i = 0; i < hits.Count; ++i)
      {
        hits.List[i].Rank = gate.GetSphere(this->Input.Shared[hits.List[i].Id].Place);
      }
      std::sort(hits.List.begin(), hits.List.begin() + hits.Count);
    }
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
    this->StampKnown(gate);
    const auto others = gate.GetOthers();
    for (unsigned i = 0; i < others.Count; ++i)
    {
      if (this->Symbols.Bit(this->Models.Next[i], others.List[i] == target))
      {
        return others.List[i];
      }
    }
    this->FillRing(gate);
    Vertex vertex = this->CodeRank(MaxRing, target, this->Models.RingListed, this->Models.RingRank);
    if (vertex == NoVertex && this->DistantLeft > 0)
    {
      --this->DistantLeft;
      this->FillDistant(gate);
      vertex =
        this->CodeRank(MaxDistant, target, this->Models.DistantListed, this->Models.DistantRank);
    }
    if (vertex == NoVertex)
    {
      vertex = this->CodeIndex(target, this->Places.size());
    }
    const auto& c = gate.Face.Corners;
    if (vertex == c[0] || vertex == c[1] || vertex == c[2])
    {
      ThrowCorrupt("a walk makes a tetrahedron with the same vertex twice");
    }
    return vertex;
  }

  //------------------------------------------------------------------------------------------------
  // Lists of vertices farther away

  /** Far corners of the open faces around the gate's corners, but for its candidates. */
  void FillRing(const Gate<Rule>& gate)
  {
    this->Ring.clear();
    const auto& face = gate.Face;
    for (unsigned i = 0; i < 3; ++i)
    {
      const auto add = [&](Vertex v) { this->AddToRing(gate, v); };
      const auto other = face.Edges[(i + 2) % 3];
      const auto end =
        TurnAround(this->Open, face.Corners[i], face.Edges[i], Front::None, MaxFan, add);
      if (end != other)
      {
        TurnAround(this->Open, face.Corners[i], other, Front::None, MaxFan, add);
      }
    }
  }

  /** All vertices of the front but those of the gate, its candidates and the ring before. */
  void FillDistant(const Gate<Rule>& gate)
  {
    this->Ring.clear();
    const auto bound = this->Open.GetEdgeBound();
    for (std::uint32_t e = 0; e < bound; ++e)
    {
      const auto& edge = this->Open.GetEdge(e);
      if (edge.Open > 0)
      {
        this->AddToRing(gate, edge.Ends[0]);
        this->AddToRing(gate, edge.Ends[1]);
      }
    }
  }

  void StampKnown(const Gate<Rule>& gate)
  {
    ++this->Stamp;
    for (unsigned i = 0; i < 3; ++i)
    {
      this->Stamps[gate.Face.Corners[i]] = this->Stamp;
      if (gate.Sides[i].Id != NoVertex)
      {
        this->Stamps[gate.Sides[i].Id] = this->Stamp;
      }
    }
  }

  GATUN_INLINE void AddToRing(const Gate<Rule>& gate, Vertex v)
  {
    if (this->Stamps[v] != this->Stamp)
    {
      this->Stamps[v] = this->Stamp;
      this->Ring.push_back({ gate.GetSphere(this->Places[v]), v });
    }
  }

  /** Codes a vertex by its rank in the list; NoVertex if it is not among the first most. */
  Vertex CodeRank(unsigned most, Vertex target, BitModel& listed, std::array<BitModel, 6>& models)
  {
    const auto count = static_cast<unsigned>(std::min<std::size_t>(this->Ring.size(), most));
    bool isListed = false;
    if constexpr (Coder::Encoding)
    {
      for (unsigned i = 0; i < count && !isListed; ++i)
      {
        isListed = this->TakeNextOfRing(i) == target;
      }
    }
    if (!this->Symbols.Bit(listed, isListed))
    {
      return NoVertex;
    }
    for (unsigned i = 0; i < count; ++i)
    {
      const Vertex next = this->TakeNextOfRing(i);
      if (this->Symbols.Bit(models[std::min(i, 5u)], next == target))
      {
        return next;
      }
    }
    ThrowCorrupt("a walk names no vertex of a list");
  }

  /** Moves the best vertex of the ring from place begin on there: most often only one is needed. */
  Vertex TakeNextOfRing(std::size_t begin)
  {
    auto& first = this->Ring[begin];
    for (auto i = begin + 1; i < this->Ring.size(); ++i)
    {
      if (this->Ring[i] < first)
      {
        std::swap(this->Ring[i], first);
      }
    }
    return first.Id;
  }

  //------------------------------------------------------------------------------------------------
  // The front

  static constexpr std::array<std::uint32_t, 3> NoTwins{ Front::None, Front::None, Front::None };

  std::uint32_t AddEdge(Vertex a, Vertex b)
  {
    this->Out.EdgeLog.push_back({ a, b });
    return this->Open.AddEdge(a, b);
  }

  std::uint32_t FindOrAddEdge(Vertex a, Vertex b)
  {
    const auto found = this->Open.FindEdge(a, b);
    return found != Front::None ? found : this->AddEdge(a, b);
  }

  void CountTet(const std::array<std::uint32_t, 3>& base, const std::array<std::uint32_t, 3>& side)
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      auto& b = this->Open.GetEdge(base[i]);
      b.Tets += b.Tets < 255;
      auto& s = this->Open.GetEdge(side[i]);
      s.Tets += s.Tets < 255;
    }
  }

  void CloseAtBorder(const Front::Face& face)
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      this->Open.GetEdge(face.Edges[i]).BorderFar = face.Corners[(i + 2) % 3];
      this->Open.DropIfBare(face.Edges[i]);
    }
  }

  std::uint32_t Finish(const std::array<Vertex, 4>& corners, std::uint32_t parent)
  {
    this->Out.Tets.push_back(corners);
    this->Out.Parents.push_back(parent);
    return static_cast<std::uint32_t>(this->Out.Tets.size() - 1);
  }

  void AttachNew(const Front::Face& face, Vertex fourth)
  {
    const auto& c = face.Corners;
    const auto tet = this->Finish({ c[0], c[1], c[2], fourth }, face.Open - 1);
    const std::array<std::uint32_t, 3> side{ this->AddEdge(c[0], fourth),
      this->AddEdge(c[1], fourth), this->AddEdge(c[2], fourth) };
    this->CountTet(face.Edges, side);
    this->AddSides(c, fourth, face.Edges, side, tet, NoTwins);
  }

  /** A tetrahedron with a known fourth vertex closes the open faces that it shares. */
  void Attach(const Gate<Rule>& gate, Vertex fourth)
  {
    const auto& c = gate.Face.Corners;
    const auto& base = gate.Face.Edges;
    const auto tet = this->Finish({ c[0], c[1], c[2], fourth }, gate.Face.Open - 1);
    std::array<std::uint32_t, 3> twin = NoTwins;
    std::array<std::uint32_t, 3> side = NoTwins; // an edge is known where a closed face has it
    for (unsigned i = 0; i < 3; ++i)
    {
      twin[i] = gate.GetTwin(this->Open, i, fourth);
      if (twin[i] != Front::None)
      {
        const auto& face = this->Open.GetFace(twin[i]);
        const unsigned k = FindPlace(face.Edges, base[i]);
        const auto next = face.Edges[k < 2 ? k + 1 : 0];
        const auto last = face.Edges[k > 0 ? k - 1 : 2];
        const bool same = face.Corners[k] == c[i]; // faces side by side run against each other
        side[i] = same ? last : next;
        side[i < 2 ? i + 1 : 0] = same ? next : last;
      }
    }
    for (unsigned i = 0; i < 3; ++i)
    {
      if (side[i] == Front::None)
      {
        side[i] = this->FindOrAddEdge(c[i], fourth);
      }
    }
    this->CountTet(base, side);
    for (unsigned i = 0; i < 3; ++i)
    {
      if (twin[i] != Front::None)
      {
        this->Open.CloseFace(twin[i]);
      }
    }
    this->AddSides(c, fourth, base, side, tet, twin);
    for (unsigned i = 0; i < 3; ++i)
    {
      this->Open.DropIfBare(base[i]);
      this->Open.DropIfBare(side[i]);
    }
  }

  /** Opens the three faces of a new tetrahedron around its fourth vertex, but for glued ones. */
  void AddSides(const std::array<Vertex, 3>& c, Vertex fourth,
    const std::array<std::uint32_t, 3>& base, const std::array<std::uint32_t, 3>& side,
    std::uint32_t tet, const std::array<std::uint32_t, 3>& twin)
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      const unsigned j = (i + 1) % 3;
      if (twin[i] == Front::None)
      {
        this->Open.AddFace(
          { c[i], c[j], fourth }, c[(i + 2) % 3], { base[i], side[j], side[i] }, tet);
      }
    }
  }

  Coder& Symbols;
  Side& Truth;
  const WalkInput Input;
  Topology& Out;
  Front Open;
  SharedSearch Search;
  std::uint32_t DistantLeft; // lists of the whole front that may still be made
  WalkModels<Rule> Models;

  std::vector<LatticePoint> Places;
  std::vector<std::uint64_t> Users; // as SharedVertex::Users; 0 for own vertices
  std::vector<std::uint32_t> Stamps;
  std::uint32_t Stamp = 0;
  std::vector<RankedVertex> Ring;
};
}

#endif
