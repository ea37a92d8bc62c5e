// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFront_h
#define gatunFront_h

// The open surface between the tetrahedra that a walk has visited and those it has not.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Index of a vertex in the order in which the walk first met it. */
using Vertex = std::uint32_t;

/**
 * Open faces in the order of their creation and the edges they lie on. A face is a triangle seen
 * from outside the visited part, with Apex the fourth corner of the tetrahedron behind it.
 *
 * Faces wait in a ring, so that memory follows the size of the front and not of the mesh.
 * An edge lives as long as an open face lies on it. Both fill half a cache line.
 */
class Front
{
public:
  static constexpr unsigned MaxFacesOnEdge = 4;
  static constexpr std::uint32_t None = 0xffffffff;

  struct alignas(32) Face
  {
    std::array<Vertex, 3> Corners;
    Vertex Apex;
    std::array<std::uint32_t, 3> Edges; // Edges[i] joins Corners[i] and Corners[(i + 1) % 3]
    std::uint32_t Open;                 // 0: closed, else 1 + the tetrahedron behind it
  };

  struct alignas(32) Edge
  {
    std::array<Vertex, 2> Ends;                      // ascending
    std::array<std::uint32_t, MaxFacesOnEdge> Faces; // open ones, oldest first, then None
    Vertex BorderFar;        // far corner of the last border face here, or None
    std::uint32_t Tets : 8;  // visited tetrahedra with this edge, at most 255
    std::uint32_t Open : 24; // open faces on this edge, listed or not
  };

  Front();

  /** The oldest open face, or None. */
  std::uint32_t NextGate()
  {
    while (this->Head != this->Tail)
    {
      if (this->GetFace(this->Head).Open)
      {
        return this->Head;
      }
      ++this->Head;
    }
    return None;
  }

  Face& GetFace(std::uint32_t id) { return this->Faces[id & this->FaceMask]; }
  Edge& GetEdge(std::uint32_t id) { return this->Edges[id]; }

  /** The first open face on an edge that is not this one, or None. */
  static std::uint32_t GetOther(const Edge& edge, std::uint32_t face)
  {
    return edge.Faces[edge.Faces[0] == face];
  }

  /** The corner of a face opposite to an edge of it. */
  static Vertex GetFar(const Face& face, const Edge& edge)
  {
    const auto& c = face.Corners;
    // The corners' exclusive or with the ends leaves the third one, whatever the order.
    return c[0] ^ c[1] ^ c[2] ^ edge.Ends[0] ^ edge.Ends[1];
  }

  std::uint32_t FindEdge(Vertex a, Vertex b) const
  {
    const auto ends = Sorted(a, b);
    const auto tag = Hash(ends);
    for (auto at = tag & this->SlotMask;; at = (at + 1) & this->SlotMask)
    {
      const auto& slot = this->Slots[at];
      if (slot.Edge == None || (slot.Tag == tag && this->Edges[slot.Edge].Ends == ends))
      {
        return slot.Edge;
      }
    }
  }

  std::uint32_t AddEdge(Vertex a, Vertex b)
  {
    if (2 * (this->LiveEdges + 1) > this->Slots.size())
    {
      this->GrowSlots();
    }
    if (this->FreeEdges.empty())
    {
      this->FreeEdges.push_back(static_cast<std::uint32_t>(this->Edges.size()));
      this->Edges.emplace_back();
    }
    const auto id = this->FreeEdges.back();
    this->FreeEdges.pop_back();
    const auto ends = Sorted(a, b);
    this->Edges[id] = { ends, { None, None, None, None }, None, 0, 0 };
    this->Insert(Hash(ends), id);
    ++this->LiveEdges;
    return id;
  }

  void AddFace(const std::array<Vertex, 3>& corners, Vertex apex,
    const std::array<std::uint32_t, 3>& edges, std::uint32_t tet)
  {
    if (this->Tail - this->Head == this->Faces.size())
    {
      this->GrowFaces();
    }
    const auto id = this->Tail++;
    this->GetFace(id) = { corners, apex, edges, tet + 1 };
    for (const auto e : edges)
    {
      auto& edge = this->Edges[e];
      ++edge.Open;
      auto& f = edge.Faces;
      const unsigned listed =
        unsigned{ f[0] != None } + unsigned{ f[1] != None } + unsigned{ f[2] != None };
      f[listed] = listed < 3 || f[3] == None ? id : f[3];
    }
  }

  /** Closes a face. Edges without open faces stay until DropIfBare is called for them. */
  void CloseFace(std::uint32_t id)
  {
    auto& face = this->GetFace(id);
    face.Open = 0;
    for (const auto e : face.Edges)
    {
      auto& edge = this->Edges[e];
      --edge.Open;
      auto& f = edge.Faces;
      if (f[2] == None)
      {
        f[0] = f[0] == id ? f[1] : f[0];
        f[1] = f[1] == id || f[1] == f[0] ? None : f[1];
        continue;
      }
      bool found = false;
      for (unsigned i = 0; i < MaxFacesOnEdge; ++i)
      {
        found = found || f[i] == id;
        f[i] = !found ? f[i] : i + 1 < MaxFacesOnEdge ? f[i + 1] : None;
      }
    }
  }

  void DropIfBare(std::uint32_t id)
  {
    if (this->Edges[id].Open == 0 && this->Edges[id].Ends[1] != None)
    {
      this->DropEdge(id);
    }
  }

  /** Number of the edges, some of them dead (their ends are None), for searches over all. */
  std::size_t GetEdgeBound() const { return this->Edges.size(); }

  /** Brings a gate that comes soon near the processor. */
  void Prefetch(std::uint32_t gate)
  {
#if defined(__GNUC__)
    for (const auto e : this->GetFace(gate).Edges)
    {
      __builtin_prefetch(&this->Edges[e]);
    }
#endif
  }

private:
  struct Slot
  {
    std::uint32_t Tag = 0;
    std::uint32_t Edge = None;
  };

  static std::array<Vertex, 2> Sorted(Vertex a, Vertex b)
  {
    return a < b ? std::array<Vertex, 2>{ a, b } : std::array<Vertex, 2>{ b, a };
  }

  static std::uint32_t Hash(const std::array<Vertex, 2>& ends)
  {
    const std::uint64_t key = (static_cast<std::uint64_t>(ends[0]) << 32) | ends[1];
    return static_cast<std::uint32_t>((key * 0x9e3779b97f4a7c15u) >> 32);
  }

  void Insert(std::uint32_t tag, std::uint32_t id)
  {
    auto at = tag & this->SlotMask;
    while (this->Slots[at].Edge != None)
    {
      at = (at + 1) & this->SlotMask;
    }
    this->Slots[at] = { tag, id };
  }

  void DropEdge(std::uint32_t id);
  void GrowFaces();
  void GrowSlots();

  std::vector<Face> Faces;
  std::vector<Edge> Edges;
  std::vector<std::uint32_t> FreeEdges;
  std::vector<Slot> Slots;
  std::uint32_t FaceMask;
  std::uint32_t SlotMask;
  std::uint32_t Head = 0;
  std::uint32_t Tail = 0;
  std::uint32_t LiveEdges = 0;
};
}

#endif
