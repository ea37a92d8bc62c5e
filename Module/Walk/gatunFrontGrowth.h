// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFrontGrowth_h
#define gatunFrontGrowth_h

#include "gatunGate.h"
#include "gatunTopology.h"
#include "gatunVertexRing.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Adds tetrahedra to the front of a walk, and to the topology that the walk makes. */
template <Ranking Rule>
class FrontGrowth
{
public:
  /** The numbers of tetrahedra and vertices that the walk will meet. */
  FrontGrowth(std::size_t tets, std::size_t vertices, Topology& out)
    : Out(out)
    , Edged(vertices)
  {
    // Sized once, because growing vectors would cost more than the walk itself.
    out.Tets.resize(tets);
    out.Parents.resize(tets);
    out.EdgeLog.resize(tets + tets / 4 + MostNewEdges);
  }

  Front& GetFront() { return this->Open; }

  /** The number of tetrahedra so far. */
  std::uint32_t GetTets() const { return this->Tets; }

  /** Ends the list of edges. */
  void Finish() { this->Out.EdgeLog.resize(this->Edges); }

  /** Adds a tetrahedron that stays out of the front. */
  void AddAlone(const std::array<Vertex, 4>& v) { this->Add(v, Topology::NoTet); }

  /** Adds a tetrahedron without a gate. */
  void AddSeed(const std::array<Vertex, 4>& v)
  {
    const auto tet = this->Add(v, Topology::NoTet);
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

  /** Adds a tetrahedron with a known fourth vertex, which closes the open faces that it shares. */
  void Attach(const Gate<Rule>& gate, Vertex fourth)
  {
    const unsigned glued = unsigned{ gate.Ids[0] == fourth } |
      unsigned{ gate.Ids[1] == fourth } << 1 | unsigned{ gate.Ids[2] == fourth } << 2;
    // Which side it is is unpredictable, so the gate is rotated instead of a branch for each.
    constexpr unsigned bitCounts = 0xe994; // of the numbers 0 to 7; not all processors count bits
    switch (bitCounts >> (2 * glued) & 3)
    {
      case 0:
        return this->template AttachFree<false>(gate, fourth);
      case 1:
        return this->AttachToOne(gate, fourth, glued >> 1);
      case 2:
        return this->AttachToTwo(gate, fourth, (7 - glued) >> 1);
      default:
        return this->AttachToThree(gate, fourth);
    }
  }

  /** Adds a tetrahedron with a new fourth vertex. */
  void AttachNew(const Gate<Rule>& gate, Vertex fourth)
  {
    this->template AttachFree<true>(gate, fourth);
  }

private:
  // The order of the sides of the gate. Other orders cost some bits in grids.
  static constexpr std::array<unsigned, 3> OrderOfFaces{ 2, 0, 1 };

  /**
   * The neighbors on both sides of the edges from the gate's corners to the fourth vertex: a new
   * face, or the neighbor over that edge of an open face that the tetrahedron closes.
   */
  struct Sides
  {
    std::array<Link, 3> Left;
    std::array<Link, 3> Right;
  };

  /** The neighbors of a face that a tetrahedron has closed, over the other sides than the gate. */
  struct ClosedFace
  {
    Link OverLast;
    Link OverNext;
  };

  /** A side of the front at an edge of the new tetrahedron. */
  struct Touch
  {
    Link Edge;
    bool Found = false;
    bool FromFourth = false; // the side runs from the fourth vertex to the corner
  };

  static constexpr std::size_t MostNewEdges = 6; // of one tetrahedron

  std::uint32_t Add(const std::array<Vertex, 4>& corners, std::uint32_t parent)
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

  GATUN_INLINE void LogEdge(Vertex a, Vertex b)
  {
    this->Out.EdgeLog[this->Edges++] = { a, b };
    this->Edged[a] |= HashBit(b);
  }

  /** One of 64 bits, by the hash of a vertex. */
  static std::uint64_t HashBit(Vertex v) { return std::uint64_t{ 1 } << (v * 0x9e3779b1u >> 26); }

  /** False only if no edge between two vertices has been logged. */
  bool MayHaveEdge(Vertex a, Vertex b) const
  {
    return ((this->Edged[a] & HashBit(b)) | (this->Edged[b] & HashBit(a))) != 0;
  }

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

  /** Adds a tetrahedron that shares no other open face. IsNew: whether its fourth vertex is new. */
  template <bool IsNew>
  void AttachFree(const Gate<Rule>& gate, Vertex fourth)
  {
    const auto& c = gate.Face.Corners;
    std::array<Touch, 3> touches;
    for (unsigned k = 0; k < 3 && !IsNew; ++k)
    {
      touches[k] = this->FindTouch(gate, k, fourth);
    }
    const auto tet = this->Add({ c[0], c[1], c[2], fourth }, gate.Face.Open - 1);
    this->MakeRoom();
    Sides sides;
    for (const unsigned i : OrderOfFaces)
    {
      this->Raise(c, i, fourth, tet, gate.Face.Over[i], sides);
    }
    for (unsigned k = 0; k < 3; ++k)
    {
      this->JoinNew(touches[k], c[k], fourth, sides.Left[k], sides.Right[k]);
    }
  }

  /** Adds a tetrahedron that shares the open face over a side of the gate. */
  GATUN_INLINE void AttachToOne(const Gate<Rule>& gate, Vertex fourth, unsigned side)
  {
    const auto& c = gate.Face.Corners;
    const auto& over = gate.Face.Over;
    const auto next = NextSide(side);
    const auto last = LastSide(side);
    const auto touch = this->FindTouch(gate, side, fourth);
    const auto tet = this->Add({ c[0], c[1], c[2], fourth }, gate.Face.Open - 1);
    this->MakeRoom();
    auto& glued = this->Open.GetFace(over[side]);
    const auto overLast = glued.Over[LastSide(over[side].GetSide())];
    const auto overNext = glued.Over[NextSide(over[side].GetSide())];
    glued.Open = 0;
    // In OrderOfFaces, the next side comes before the last one except after side 0.
    const auto first = this->Open.AddTwoFaces();
    const auto nextFace = first + (side == 0);
    const auto lastFace = first + (side != 0);
    this->Open.SetFace(nextFace, { c[last], c[side], fourth }, c[next], tet);
    this->Open.SetFace(lastFace, { c[side], c[next], fourth }, c[last], tet);
    this->Open.Connect(Link::ToSide(nextFace, 2), over[next], over[next].GetTets() + 1);
    this->Open.Connect(Link::ToSide(lastFace, 2), over[last], over[last].GetTets() + 1);
    this->Open.Connect(Link::ToSide(lastFace, 0), overNext, overNext.GetTets() + 1);
    this->Open.Connect(overLast, Link::ToSide(nextFace, 1), overLast.GetTets() + 1);
    this->JoinNew(touch, c[side], fourth, Link::ToSide(nextFace, 0), Link::ToSide(lastFace, 1));
  }

  /** Adds a tetrahedron that shares the open faces over all sides of the gate but one. */
  GATUN_INLINE void AttachToTwo(const Gate<Rule>& gate, Vertex fourth, unsigned side)
  {
    const auto& c = gate.Face.Corners;
    const auto& over = gate.Face.Over;
    const auto tet = this->Add({ c[0], c[1], c[2], fourth }, gate.Face.Open - 1);
    this->MakeRoom();
    const auto next = this->Close(over[NextSide(side)]);
    const auto last = this->Close(over[LastSide(side)]);
    const auto face =
      this->Open.AddFace({ c[NextSide(side)], c[LastSide(side)], fourth }, c[side], tet);
    this->Open.Connect(Link::ToSide(face, 2), over[side], over[side].GetTets() + 1);
    this->JoinAround(next.OverLast, last.OverNext);
    this->Open.Connect(last.OverLast, Link::ToSide(face, 1), last.OverLast.GetTets() + 1);
    this->Open.Connect(Link::ToSide(face, 0), next.OverNext, next.OverNext.GetTets() + 1);
  }

  /** Adds a tetrahedron that shares the open faces over all sides of the gate. */
  void AttachToThree(const Gate<Rule>& gate, Vertex fourth)
  {
    const auto& c = gate.Face.Corners;
    this->Add({ c[0], c[1], c[2], fourth }, gate.Face.Open - 1);
    std::array<ClosedFace, 3> closed;
    for (unsigned i = 0; i < 3; ++i)
    {
      closed[i] = this->Close(gate.Face.Over[i]);
    }
    for (unsigned k = 0; k < 3; ++k)
    {
      this->JoinAround(closed[NextSide(k)].OverLast, closed[LastSide(k)].OverNext);
    }
  }

  GATUN_INLINE ClosedFace Close(Link side)
  {
    auto& face = this->Open.GetFace(side);
    face.Open = 0;
    return { face.Over[LastSide(side.GetSide())], face.Over[NextSide(side.GetSide())] };
  }

  /** Links two new faces at the edge from a corner of the gate to the fourth vertex. */
  GATUN_INLINE void JoinNew(const Touch& touch, Vertex corner, Vertex fourth, Link left, Link right)
  {
    if (touch.Found)
    {
      this->JoinTouching(touch, left, right);
      return;
    }
    this->LogEdge(corner, fourth);
    this->Open.Connect(left, right, 1);
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

  /** Searches the edges around a corner for the one to a vertex. */
  Touch FindTouch(const Gate<Rule>& gate, unsigned corner, Vertex fourth)
  {
    Touch touch;
    if (!this->MayHaveEdge(gate.Face.Corners[corner], fourth))
    {
      return touch;
    }
    TurnBothWays(this->Open, gate, corner,
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

  /** Links faces at an edge, of the four, that have no visited tetrahedra between them. */
  void JoinTouching(const Touch& touch, Link left, Link right)
  {
    const auto before = this->Open.GetFace(touch.Edge).Over[touch.Edge.GetSide()];
    const auto tets = before.GetTets() + 1;
    this->Open.Connect(touch.FromFourth ? left : right, touch.Edge, tets);
    this->Open.Connect(touch.FromFourth ? right : left, before, tets);
  }

  Topology& Out;
  Front Open;
  std::uint32_t Tets = 0;           // so far
  std::size_t Edges = 0;            // logged so far
  std::vector<std::uint64_t> Edged; // for each vertex, the hash bits of ends of its edges
};
}

#endif
