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
#include "gatunSharedSearch.h"
#include "gatunTopology.h"

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
  Ranking Rule = Ranking::Sphere;
  bool Plain = false; // no gates: every tetrahedron is coded by the ids of its vertices
};

/**
 * Side tells an encoder what is true and takes from a decoder what it learnt:
 *
 *   std::uint32_t FindTet(corners)      encoder: begin the unvisited tetrahedron over a gate; its
 *                                       number, or NoTet
 *   std::uint32_t NextSeed()            encoder: begin any unvisited tetrahedron
 *   Vertex GetTarget(i)                 encoder: vertex i of the tetrahedron begun (3 is the one
 *                                       opposite to the gate), or NoVertex if not met yet
 *   bool IsTargetShared(i), std::uint32_t GetTargetShared(i)
 *                                       encoder: for a vertex not met yet
 *   void MeetShared(i, index)           vertex i was met: shared vertex number index
 *   LatticePoint MeetOwn(i, record)     vertex i was met: the next own one; returns its place
 */
template <typename Coder, typename Side>
class Walk
{
public:
  Walk(Coder& coder, Side& side, const WalkInput& input, Topology& out)
    : Symbols(coder)
    , Truth(side)
    , Input(input)
    , Out(out)
    , Search(input.Shared)
    , Angle(input.Rule == Ranking::Angle)
    , HitModels(this->Angle ? 64 * 8 * 4 * 10 : 33 * 4 * 8 * 3 * 2)
    , BorderModels(10 * 2 * 33 * 4 * 8)
    , NewModels(this->Angle ? 64 * 4 * 8 * 4 * 8 : 17 * 33 * 2 * 2)
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
    while (this->Out.Tets.size() < this->Input.Tets)
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
    if (this->Out.Records.size() != this->Input.OwnVertices ||
      this->Out.Sources.size() != std::size_t{ this->Input.OwnVertices } + this->Input.Shared.size())
    {
      ThrowCorrupt("a chunk's walk does not meet all its vertices");
    }
  }

private:
  struct Candidate
  {
    double Rank;
    Vertex Id;
    unsigned Edges; // how many of the gate's edges propose it
    unsigned Edge;  // the one with the best rank
  };

  static constexpr unsigned MaxCandidates = 3 * Front::MaxFacesOnEdge;
  static constexpr unsigned MaxFan = 64;     // faces visited around a corner
  static constexpr unsigned MaxRing = 15;    // ring vertices that can be named
  static constexpr unsigned MaxDistant = 15; // front vertices that can be named

  /** All that the decisions at one gate look at. */
  struct Gate
  {
    Front::Face Face;
    GateMeasure Measure;
    std::array<Candidate, MaxCandidates> Candidates;
    unsigned Count = 0;
    std::array<Vertex, 3> Far{ NoVertex, NoVertex, NoVertex };
    unsigned BorderGrade = 0; // pairs (edges at the border, of those coplanar with it), 0 to 9
    unsigned BorderEdges = 0;
    unsigned AllShared = 0; // 1: another chunk uses all three corners
    unsigned EdgeGrade = 0;
  };

  static std::uint8_t Small(std::uint32_t value, std::uint32_t most)
  {
    return static_cast<std::uint8_t>(std::min(value, most));
  }

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
    std::array<Vertex, 4> v{};
    if (Coder::Encoding)
    {
      this->Truth.NextSeed();
    }
    for (unsigned i = 0; i < 4; ++i)
    {
      const Vertex target = Coder::Encoding ? this->Truth.GetTarget(i) : NoVertex;
      if (this->Symbols.Bit(this->SeedNew, target == NoVertex))
      {
        if (this->Symbols.Bit(this->SeedShared, Coder::Encoding && this->Truth.IsTargetShared(i)))
        {
          v[i] = this->MeetShared(i,
            this->CodeIndex(
              Coder::Encoding ? this->Truth.GetTargetShared(i) : 0, this->Input.Shared.size()));
        }
        else
        {
          v[i] = this->MeetOwn(i, GateRecord{});
        }
      }
      else
      {
        v[i] = this->CodeIndex(target, this->Places.size());
      }
    }
    if (v[0] == v[1] || v[0] == v[2] || v[0] == v[3] || v[1] == v[2] || v[1] == v[3] ||
      v[2] == v[3])
    {
      // Such a tetrahedron has fewer than four faces and cannot take part in the front.
      this->Finish(v, Topology::NoTet);
      return;
    }
    const auto tet = this->Finish(v, Topology::NoTet);
    if (this->Input.Plain)
    {
      return;
    }
    const auto edge = [&](unsigned i, unsigned j) { return this->FindOrAddEdge(v[i], v[j]); };
    const std::array<std::uint32_t, 3> base{ edge(0, 1), edge(1, 2), edge(2, 0) };
    const std::array<std::uint32_t, 3> side{ edge(0, 3), edge(1, 3), edge(2, 3) };
    for (unsigned i = 0; i < 3; ++i)
    {
      this->CountTet(base[i]);
      this->CountTet(side[i]);
    }
    this->Open.AddFace({ v[0], v[2], v[1] }, v[3], { base[2], base[1], base[0] }, tet);
    this->AddSides({ v[0], v[1], v[2] }, v[3], base, side, tet);
  }

  //------------------------------------------------------------------------------------------------
  // A tetrahedron on a gate

  void GrowOnGate(std::uint32_t id)
  {
    Gate gate = this->Describe(id);
    const auto parent = gate.Face.Open - 1;
    bool border = false;
    Vertex target = NoVertex;
    if (Coder::Encoding)
    {
      const auto& c = gate.Face.Corners;
      border = this->Truth.FindTet(c) == Topology::NoTet;
      target = border ? NoVertex : this->Truth.GetTarget(3);
    }
    this->Open.CloseFace(id);

    // The best candidate first: it is right most of the time.
    Vertex fourth = NoVertex;
    if (gate.Count > 0)
    {
      const Vertex best = gate.Candidates[0].Id;
      if (this->Symbols.Bit(this->HitModel(gate), !border && target == best))
      {
        fourth = best;
      }
    }
    if (fourth == NoVertex)
    {
      if (this->Symbols.Bit(this->BorderModel(gate), border))
      {
        this->CloseAtBorder(gate);
        return;
      }
      const auto ring = this->CollectRing(gate);
      if (this->Symbols.Bit(this->NewModel(gate, ring), target == NoVertex))
      {
        fourth = this->MeetNew(gate);
        this->Attach(gate, fourth, true, parent);
        return;
      }
      fourth = this->CodeKnown(gate, ring, target);
    }
    this->Attach(gate, fourth, false, parent);
  }

  Gate Describe(std::uint32_t id)
  {
    const auto face = this->Open.GetFace(id);
    const auto& c = face.Corners;
    Gate gate{ face,
      GateMeasure(this->Places[c[0]], this->Places[c[1]], this->Places[c[2]]), {} };
    unsigned coplanar = 0;
    unsigned grade = 0;
    for (unsigned i = 0; i < 3; ++i)
    {
      const auto& edge = this->Open.GetEdge(face.Edges[i]);
      const Vertex s = c[i];
      const Vertex e = c[(i + 1) % 3];
      const Vertex opposite = c[(i + 2) % 3];
      for (unsigned k = 0; k < edge.Listed; ++k)
      {
        if (edge.Faces[k] == id)
        {
          continue;
        }
        const Vertex far = this->Open.GetFar(edge.Faces[k], edge.Ends);
        if (far == opposite)
        {
          continue; // a face with the gate's own corners
        }
        gate.Far[i] = gate.Far[i] == NoVertex ? far : gate.Far[i];
        const double rank = this->Angle
          ? gate.Measure.GetAngle(this->Places[far], this->Places[s], this->Places[e])
          : gate.Measure.GetSphere(this->Places[far]);
        this->Propose(gate, far, i, rank);
      }
      if (edge.BorderFar != NoVertex)
      {
        gate.Far[i] = gate.Far[i] == NoVertex ? edge.BorderFar : gate.Far[i];
        ++gate.BorderEdges;
        coplanar += gate.Measure.IsCoplanar(this->Places[edge.BorderFar], this->Places[s]);
      }
      grade = 3 * grade + Small(edge.Tets - 1, 2);
    }
    gate.BorderGrade = gate.BorderEdges * (gate.BorderEdges + 1) / 2 + coplanar;
    gate.AllShared = (this->Users[c[0]] & this->Users[c[1]] & this->Users[c[2]]) != 0;
    gate.EdgeGrade = grade;
    std::sort(gate.Candidates.begin(), gate.Candidates.begin() + gate.Count,
      [](const Candidate& l, const Candidate& r)
      { return l.Rank < r.Rank || (l.Rank == r.Rank && l.Id < r.Id); });
    return gate;
  }

  static void Propose(Gate& gate, Vertex id, unsigned edge, double rank)
  {
    for (unsigned j = 0; j < gate.Count; ++j)
    {
      auto& known = gate.Candidates[j];
      if (known.Id == id)
      {
        ++known.Edges;
        if (rank < known.Rank)
        {
          known.Rank = rank;
          known.Edge = edge;
        }
        return;
      }
    }
    gate.Candidates[gate.Count++] = { rank, id, 1, edge };
  }

  //------------------------------------------------------------------------------------------------
  // Contexts of the decisions

  static unsigned Steps(double value, std::span<const double> thresholds)
  {
    unsigned step = 0;
    while (step < thresholds.size() && value >= thresholds[step])
    {
      ++step;
    }
    return step;
  }

  /** 0 to 13; 14: no candidate, 15: behind the gate. */
  unsigned CoarseGrade(const Gate& gate, unsigned candidate) const
  {
    static constexpr std::array<double, 13> thresholds{ -1.5, -0.8, -0.5, -0.3, -0.15, -0.02, 0.02,
      0.15, 0.3, 0.5, 0.8, 1.5, 3 };
    if (candidate >= gate.Count)
    {
      return 14;
    }
    const double rank = gate.Candidates[candidate].Rank;
    if (rank == GateMeasure::Never)
    {
      return 15;
    }
    return Steps(gate.Measure.GetRelativeAngle(rank), thresholds);
  }

  /** 0 to 27; 31: behind the gate. */
  static unsigned FineGrade(const Gate& gate, double rank)
  {
    static constexpr std::array<double, 27> thresholds{ -2, -1.4, -1, -0.8, -0.65, -0.5, -0.4, -0.3,
      -0.2, -0.12, -0.05, 0.01, 0.06, 0.12, 0.18, 0.25, 0.32, 0.4, 0.5, 0.6, 0.75, 0.9, 1.1, 1.4, 2,
      3, 5 };
    return rank == GateMeasure::Never
      ? 31
      : Steps(gate.Measure.GetRelativeSphere(rank), thresholds);
  }

  unsigned BestFineGrade(const Gate& gate) const
  {
    return gate.Count > 0 ? FineGrade(gate, gate.Candidates[0].Rank) : 32;
  }

  static unsigned BestEdges(const Gate& gate)
  {
    return gate.Count > 0 ? Small(gate.Candidates[0].Edges, 3) : 0;
  }

  unsigned BestEdgeTets(const Gate& gate)
  {
    return gate.Count > 0
      ? Small(this->Open.GetEdge(gate.Face.Edges[gate.Candidates[0].Edge]).Tets, 7)
      : 0;
  }

  /** How far the second candidate is behind the first. */
  unsigned AngleGap(const Gate& gate, unsigned first, unsigned second) const
  {
    if (gate.Count < 2)
    {
      return 3;
    }
    if (second == 15)
    {
      return 2;
    }
    return second >= first + 3 ? 2 : second > first ? 1 : 0;
  }

  BitModel& HitModel(const Gate& gate)
  {
    if (this->Angle)
    {
      this->First = this->CoarseGrade(gate, 0);
      this->Gap = this->AngleGap(gate, this->First, this->CoarseGrade(gate, 1));
      this->EdgeTets = this->BestEdgeTets(gate);
      return this->HitModels[(((this->First * 4 + BestEdges(gate)) * 8 + this->EdgeTets) * 4 +
                               this->Gap) *
          10 +
        gate.BorderGrade];
    }
    this->First = this->BestFineGrade(gate);
    unsigned gap = 6;
    if (gate.Count > 1)
    {
      const unsigned second = FineGrade(gate, gate.Candidates[1].Rank);
      gap = second == 31 ? 5 : Small(second - std::min(second, this->First), 8) / 2u;
    }
    return this->HitModels[(((this->First * 4 + BestEdges(gate)) * 8 + gap) * 3 +
                             Small(gate.BorderEdges, 2)) *
        2 +
      gate.AllShared];
  }

  BitModel& BorderModel(const Gate& gate)
  {
    if (gate.Count == 0)
    {
      this->First = this->Angle ? 14 : 32;
      this->Gap = 3;
      this->EdgeTets = 0;
    }
    return this->BorderModels[(((gate.BorderGrade * 2 + gate.AllShared) * 33 + this->First) * 4 +
                                BestEdges(gate)) *
        8 +
      (this->Angle ? this->EdgeTets : 0)];
  }

  BitModel& NewModel(const Gate& gate, std::span<const Candidate> ring)
  {
    if (this->Angle)
    {
      unsigned sum = 0;
      for (unsigned grade = gate.EdgeGrade; grade > 0; grade /= 3)
      {
        sum += grade % 3;
      }
      return this->NewModels[((((this->First * 4 + BestEdges(gate)) * 4 + Small(gate.Count, 3)) * 8 +
                                this->EdgeTets) *
                                 4 +
                               this->Gap) *
          8 +
        sum];
    }
    const unsigned best = ring.empty() ? 32 : FineGrade(gate, ring[0].Rank);
    const bool nearer =
      !ring.empty() && (gate.Count == 0 || ring[0].Rank < gate.Candidates[0].Rank);
    return this->NewModels[((this->First / 2 * 33 + best) * 2 + nearer) * 2 + (gate.Count > 0)];
  }

  //------------------------------------------------------------------------------------------------
  // The fourth vertex, when it is not the best candidate

  Vertex MeetNew(const Gate& gate)
  {
    const auto& c = gate.Face.Corners;
    const auto isShared = [&](Vertex v) { return this->Users[v] != 0; };
    const unsigned grade = (isShared(c[0]) + isShared(c[1]) + isShared(c[2])) * 2u +
      isShared(gate.Face.Apex);
    if (this->Symbols.Bit(
          this->SharedModels[grade], Coder::Encoding && this->Truth.IsTargetShared(3)))
    {
      return this->MeetShared(3, this->CodeShared(gate));
    }
    GateRecord record;
    record.Known = { c[0], c[1], c[2], gate.Face.Apex, gate.Far[0], gate.Far[1], gate.Far[2] };
    record.EdgeGrade = static_cast<std::uint8_t>(gate.EdgeGrade);
    record.CandidateGrade = Small(gate.Count, 3);
    return this->MeetOwn(3, record);
  }

  std::uint32_t CodeShared(const Gate& gate)
  {
    const auto& c = gate.Face.Corners;
    const auto target = Coder::Encoding ? this->Truth.GetTargetShared(3) : 0;
    const auto hits = this->Search.Find(gate.Measure, this->Places[c[0]], this->Places[c[1]],
      this->Places[c[2]], this->Input.Rule);
    for (unsigned i = 0; i < hits.Count; ++i)
    {
      if (this->Symbols.Bit(this->SharedRank[i], hits.List[i].Index == target))
      {
        return hits.List[i].Index;
      }
    }
    return this->CodeIndex(target, this->Input.Shared.size());
  }

  /**
   * Vertices of the open faces that can be reached from the gate by turning around one of its
   * corners, without the gate's corners and candidates, sorted by sphere. Not used, and therefore
   * left empty, for the ranking by angle until a vertex of it is coded.
   */
  std::span<const Candidate> CollectRing(const Gate& gate)
  {
    this->Ring.clear();
    if (!this->Angle)
    {
      this->FillRing(gate);
    }
    return this->Ring;
  }

  void FillRing(const Gate& gate)
  {
    this->StampKnown(gate);
    for (const Vertex corner : gate.Face.Corners)
    {
      std::array<std::uint32_t, MaxFan> fan;
      unsigned count = 0;
      const auto visit = [&](const std::array<std::uint32_t, 3>& edges)
      {
        for (const auto e : edges)
        {
          const auto& edge = this->Open.GetEdge(e);
          if (edge.Ends[0] != corner && edge.Ends[1] != corner)
          {
            continue;
          }
          for (unsigned k = 0; k < edge.Listed; ++k)
          {
            const auto face = edge.Faces[k];
            if (count < MaxFan && std::find(fan.begin(), fan.begin() + count, face) ==
                fan.begin() + count)
            {
              fan[count++] = face;
            }
          }
        }
      };
      visit(gate.Face.Edges);
      for (unsigned next = 0; next < count; ++next)
      {
        const auto face = this->Open.GetFace(fan[next]);
        for (const Vertex v : face.Corners)
        {
          this->AddToRing(gate, v);
        }
        visit(face.Edges);
      }
    }
    this->SortRing();
  }

  /** All vertices of the front but those of the gate, its candidates and the ring before. */
  void FillDistant(const Gate& gate)
  {
    this->Ring.clear();
    for (std::uint32_t e = 0; e < this->Open.GetEdgeBound(); ++e)
    {
      const auto& edge = this->Open.GetEdge(e);
      if (edge.Ends[1] != NoVertex && edge.Open > 0)
      {
        this->AddToRing(gate, edge.Ends[0]);
        this->AddToRing(gate, edge.Ends[1]);
      }
    }
    this->SortRing();
  }

  void StampKnown(const Gate& gate)
  {
    ++this->Stamp;
    for (const Vertex v : gate.Face.Corners)
    {
      this->Stamps[v] = this->Stamp;
    }
    for (unsigned i = 0; i < gate.Count; ++i)
    {
      this->Stamps[gate.Candidates[i].Id] = this->Stamp;
    }
  }

  void AddToRing(const Gate& gate, Vertex v)
  {
    if (this->Stamps[v] != this->Stamp)
    {
      this->Stamps[v] = this->Stamp;
      this->Ring.push_back({ gate.Measure.GetSphere(this->Places[v]), v, 0, 0 });
    }
  }

  void SortRing()
  {
    std::sort(this->Ring.begin(), this->Ring.end(),
      [](const Candidate& l, const Candidate& r)
      { return l.Rank < r.Rank || (l.Rank == r.Rank && l.Id < r.Id); });
  }

  /** Codes a vertex by its place in a list; NoVertex if it is not among the first most. */
  Vertex CodeRank(std::span<const Candidate> list, unsigned most, Vertex target,
    BitModel& listed, std::array<BitModel, 6>& models)
  {
    const auto count = std::min<std::size_t>(list.size(), most);
    const auto found = std::find_if(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count),
      [&](const Candidate& c) { return c.Id == target; });
    const auto place = static_cast<std::size_t>(found - list.begin());
    if (!this->Symbols.Bit(listed, place < count))
    {
      return NoVertex;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->Symbols.Bit(models[std::min<std::size_t>(i, 5)], i == place))
      {
        return list[i].Id;
      }
    }
    ThrowCorrupt("a walk names no vertex of a list");
  }

  Vertex CodeKnown(const Gate& gate, std::span<const Candidate> ring, Vertex target)
  {
    for (unsigned i = 1; i < gate.Count; ++i)
    {
      const auto& candidate = gate.Candidates[i];
      if (this->Symbols.Bit(this->NextModels[std::min(i, 3u) * 4 + Small(candidate.Edges, 3)],
            candidate.Id == target))
      {
        return candidate.Id;
      }
    }
    if (this->Angle)
    {
      this->FillRing(gate);
      ring = this->Ring;
    }
    Vertex vertex = this->CodeRank(ring, MaxRing, target, this->RingListed, this->RingRank);
    if (vertex == NoVertex)
    {
      this->FillDistant(gate);
      vertex =
        this->CodeRank(this->Ring, MaxDistant, target, this->DistantListed, this->DistantRank);
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
  // The front

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

  void CountTet(std::uint32_t id)
  {
    auto& edge = this->Open.GetEdge(id);
    edge.Tets += edge.Tets < 255;
  }

  void CloseAtBorder(const Gate& gate)
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      this->Open.GetEdge(gate.Face.Edges[i]).BorderFar = gate.Face.Corners[(i + 2) % 3];
      this->Open.DropIfBare(gate.Face.Edges[i]);
    }
  }

  std::uint32_t Finish(const std::array<Vertex, 4>& corners, std::uint32_t parent)
  {
    this->Out.Tets.push_back(corners);
    this->Out.Parents.push_back(parent);
    return static_cast<std::uint32_t>(this->Out.Tets.size() - 1);
  }

  void Attach(const Gate& gate, Vertex fourth, bool isNew, std::uint32_t parent)
  {
    const auto& c = gate.Face.Corners;
    const auto& base = gate.Face.Edges;
    const auto tet = this->Finish({ c[0], c[1], c[2], fourth }, parent);
    std::array<std::uint32_t, 3> twin{ Front::None, Front::None, Front::None };
    std::array<std::uint32_t, 3> side{};
    for (unsigned i = 0; i < 3; ++i)
    {
      if (isNew)
      {
        side[i] = this->AddEdge(c[i], fourth);
        continue;
      }
      const auto& edge = this->Open.GetEdge(base[i]);
      for (unsigned k = 0; k < edge.Listed; ++k)
      {
        if (this->Open.GetFar(edge.Faces[k], edge.Ends) == fourth)
        {
          twin[i] = edge.Faces[k];
          break;
        }
      }
      side[i] = this->FindOrAddEdge(c[i], fourth);
    }
    for (unsigned i = 0; i < 3; ++i)
    {
      this->CountTet(base[i]);
      this->CountTet(side[i]);
    }
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
    std::uint32_t tet,
    const std::array<std::uint32_t, 3>& twin = { Front::None, Front::None, Front::None })
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
  const bool Angle;

  std::vector<LatticePoint> Places;
  std::vector<std::uint64_t> Users; // as SharedVertex::Users; 0 for own vertices
  std::vector<std::uint32_t> Stamps;
  std::uint32_t Stamp = 0;
  std::vector<Candidate> Ring;

  // Grades of the current gate, made by HitModel and used by the models after it.
  unsigned First = 0;
  unsigned Gap = 0;
  unsigned EdgeTets = 0;

  std::vector<BitModel> HitModels;
  std::vector<BitModel> BorderModels;
  std::vector<BitModel> NewModels;
  std::array<BitModel, 8> SharedModels;
  std::array<BitModel, SharedSearch::Most> SharedRank;
  std::array<BitModel, 16> NextModels;
  std::array<BitModel, 6> RingRank;
  std::array<BitModel, 6> DistantRank;
  BitModel RingListed;
  BitModel DistantListed;
  BitModel SeedNew;
  BitModel SeedShared;
};
}

#endif
