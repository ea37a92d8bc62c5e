// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFront_h
#define gatunFront_h

// The open surface between the tetrahedra that a walk has visited and those it has not.

#include <array>
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
 * An edge lives as long as an open face lies on it.
 */
class Front
{
public:
  static constexpr unsigned MaxFacesOnEdge = 4;
  static constexpr std::uint32_t None = 0xffffffff;

  struct Face
  {
    std::array<Vertex, 3> Corners;
    Vertex Apex;
    std::array<std::uint32_t, 3> Edges; // Edges[i] joins Corners[i] and Corners[(i + 1) % 3]
    std::uint32_t Open;                 // 0: closed, else 1 + the tetrahedron behind it
  };

  struct Edge
  {
    std::array<Vertex, 2> Ends;
    std::array<std::uint32_t, MaxFacesOnEdge> Faces; // open ones, oldest first
    Vertex BorderFar; // far corner of the last border face here, or None
    std::uint32_t Tets : 8;   // visited tetrahedra with this edge, at most 255
    std::uint32_t Listed : 4; // entries in use in Faces
    std::uint32_t Open : 20;  // open faces on this edge, listed or not
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

  /** The corner of the face opposite to an edge of it. */
  Vertex GetFar(std::uint32_t face, const std::array<Vertex, 2>& ends)
  {
    const auto& c = this->GetFace(face).Corners;
    // The corners' exclusive or with the ends leaves the third one, whatever the order.
    return c[0] ^ c[1] ^ c[2] ^ ends[0] ^ ends[1];
  }

  std::uint32_t FindEdge(Vertex a, Vertex b) const
  {
    const auto ends = Sorted(a, b);
    for (auto slot = Hash(ends) & this->SlotMask;; slot = (slot + 1) & this->SlotMask)
    {
      const auto edge = this->Slots[slot];
      if (edge == None || this->Edges[edge].Ends == ends)
      {
        return edge;
      }
    }
  }

  std::uint32_t AddEdge(Vertex a, Vertex b);

  void AddFace(const std::array<Vertex, 3>& corners, Vertex apex,
    const std::array<std::uint32_t, 3>& edges, std::uint32_t tet);

  /** Closes a face. Edges without open faces stay until DropIfBare is called for them. */
  void CloseFace(std::uint32_t id)
  {
    auto& face = this->GetFace(id);
    face.Open = 0;
    for (const auto e : face.Edges)
    {
      auto& edge = this->Edges[e];
      unsigned kept = 0;
      for (unsigned i = 0; i < edge.Listed; ++i)
      {
        edge.Faces[kept] = edge.Faces[i];
        kept += edge.Faces[i] != id;
      }
      edge.Listed = kept & 15;
      --edge.Open;
    }
  }

  void DropIfBare(std::uint32_t id)
  {
    if (this->Edges[id].Open == 0 && this->Edges[id].Ends[1] != None)
    {
      this->DropEdge(id);
    }
  }

  /** Live edges, for searches over the whole front; ids below this, some of them dead. */
  std::size_t GetEdgeBound() const { return this->Edges.size(); }

private:
  static std::array<Vertex, 2> Sorted(Vertex a, Vertex b)
  {
    return a < b ? std::array<Vertex, 2>{ a, b } : std::array<Vertex, 2>{ b, a };
  }

  static std::uint32_t Hash(const std::array<Vertex, 2>& ends)
  {
    const std::uint64_t key = (static_cast<std::uint64_t>(ends[0]) << 32) | ends[1];
    return static_cast<std::uint32_t>((key * 0x9e3779b97f4a7c15u) >> 32);
  }

  void DropEdge(std::uint32_t id);
  void GrowFaces();
  void GrowSlots();

  std::vector<Face> Faces;
  std::vector<Edge> Edges;
  std::vector<std::uint32_t> FreeEdges;
  std::vector<std::uint32_t> Slots;
  std::uint32_t FaceMask;
  std::uint32_t SlotMask;
  std::uint32_t Head = 0;
  std::uint32_t Tail = 0;
  std::uint32_t LiveEdges = 0;
};
}

#endif
