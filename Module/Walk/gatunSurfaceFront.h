// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceFront_h
#define gatunSurfaceFront_h

// The open edges between the polygons that a walk over a surface has visited and the others.

#include "gatunFront.h"
#include "gatunMeasure.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace gatun
{
/**
 * Open edges in the order of their creation. An edge runs as its next polygon has it, against the
 * polygon behind it. The edges before and after it along the front are its links.
 */
class SurfaceFront
{
public:
  static constexpr std::uint32_t None = 0xffffffff;   // no link, no edge
  static constexpr std::uint32_t Border = 0xfffffffe; // a link to an edge that ended at the border

  struct Edge
  {
    Vertex Begin, End;
    Vertex PastBegin, PastEnd; // the next corners of the polygon behind
    Vertex FarBegin, FarEnd;   // and beyond them, in its neighbors
    std::uint32_t Before = None;
    std::uint32_t After = None;
    std::uint32_t Next = None; // another edge that begins at the same vertex
    std::uint32_t Cell;        // behind
    std::uint32_t Frame;       // the place and direction of the edge in the cell; see SurfaceWalk
    std::uint32_t Degree;      // of the cell
    std::uint8_t Type;         // of the cell
    bool Open = true;
    Vec3 Along;  // of length 1, or 0
    Vec3 Normal; // of the polygon behind
  };

  explicit SurfaceFront(std::size_t vertices)
    : Edges(Mask + 1)
    , Heads(vertices, None)
    , OpenAt(vertices, 0)
    , Cells(vertices, 0)
  {
  }

  /** The oldest open edge, or None. Forgets older ones. */
  std::uint32_t NextGate()
  {
    while (this->Head < this->EdgeEnd && !this->Get(this->Head).Open)
    {
      ++this->Head;
    }
    return this->Head < this->EdgeEnd ? this->Head : None;
  }

  std::uint32_t Add(const Edge& edge)
  {
    if (this->EdgeEnd - this->Head > this->Mask)
    {
      this->Grow();
    }
    const auto id = this->EdgeEnd++;
    auto& added = this->Get(id);
    added = edge;
    added.Next = this->Heads[edge.Begin];
    this->Heads[edge.Begin] = id;
    ++this->OpenAt[edge.Begin];
    ++this->OpenAt[edge.End];
    return id;
  }

  Edge& Get(std::uint32_t id) { return this->Edges[id & this->Mask]; }
  const Edge& Get(std::uint32_t id) const { return this->Edges[id & this->Mask]; }

  bool IsOpen(std::uint32_t id) const
  {
    return id < Border && id >= this->Head && this->Get(id).Open;
  }

  /** The edge after another one along the front, or Border, or None. */
  std::uint32_t GetAfter(std::uint32_t id) const { return this->Check(this->Get(id).After); }
  std::uint32_t GetBefore(std::uint32_t id) const { return this->Check(this->Get(id).Before); }

  /** Makes two edges neighbors along the front. One of them may be Border or None. */
  void Link(std::uint32_t before, std::uint32_t after)
  {
    if (before < Border)
    {
      this->Get(before).After = after;
    }
    if (after < Border)
    {
      this->Get(after).Before = before;
    }
  }

  void Close(std::uint32_t id)
  {
    auto& edge = this->Get(id);
    edge.Open = false;
    --this->OpenAt[edge.Begin];
    --this->OpenAt[edge.End];
  }

  void CloseAtBorder(std::uint32_t id)
  {
    const auto before = this->GetBefore(id);
    const auto after = this->GetAfter(id);
    this->Close(id);
    this->Link(before, Border);
    this->Link(Border, after);
  }

  /** The latest open edge that begins at a vertex and is older than `limit` and accepted, or None.
   */
  template <typename Accept>
  std::uint32_t Find(Vertex begin, std::uint32_t limit, Accept&& accept)
  {
    constexpr unsigned most = 64;
    auto* next = &this->Heads[begin];
    for (unsigned count = 0; *next != None && count < most;)
    {
      const auto id = *next;
      if (id < this->Head)
      {
        *next = None; // further ones are still older
        break;
      }
      const auto& edge = this->Get(id);
      if (!edge.Open)
      {
        *next = edge.Next; // never looked at again
        continue;
      }
      if (id < limit && accept(edge))
      {
        return id;
      }
      next = &this->Get(id).Next;
      ++count;
    }
    return None;
  }

  /** Whether a vertex is on the front. */
  bool IsOnFront(Vertex v) const { return this->OpenAt[v] > 0; }

  /** Counts one more polygon around a vertex. */
  void AddCell(Vertex v) { this->Cells[v] += this->Cells[v] < MostCells; }
  unsigned GetCells(Vertex v) const { return this->Cells[v]; }
  std::uint32_t GetEnd() const { return this->EdgeEnd; }

private:
  static constexpr unsigned MostCells = 7; // larger numbers are clamped

  std::uint32_t Check(std::uint32_t link) const
  {
    return link >= Border || this->IsOpen(link) ? link : None;
  }

  void Grow()
  {
    std::vector<Edge> larger(2 * this->Edges.size());
    for (auto id = this->Head; id < this->EdgeEnd; ++id)
    {
      larger[id & (larger.size() - 1)] = this->Get(id);
    }
    this->Edges = std::move(larger);
    this->Mask = static_cast<std::uint32_t>(this->Edges.size() - 1);
  }

  std::uint32_t Mask = 1023;
  std::vector<Edge> Edges; // a ring buffer, so that memory grows with the front and not the mesh
  std::vector<std::uint32_t> Heads;  // for each vertex, the latest edge that begins there
  std::vector<std::uint32_t> OpenAt; // the number of open edges at each vertex
  std::vector<std::uint8_t> Cells;   // around each vertex
  std::uint32_t Head = 0;
  std::uint32_t EdgeEnd = 0;
};

/**
 * Grades the angle between two edges of a front at their common vertex, on the side that no polygon
 * has: 0 folded shut, 8 straight, up to 14 behind.
 */
inline unsigned GradeCorner(const Vec3& before, const Vec3& after, const Vec3& normal)
{
  const float cosine = Dot(before, after);
  const bool left = Dot(Cross(before, after), normal) > 0;
  const float turn = left ? (1.0F + cosine) * 4.0F + 0.5F : 8.5F + (1.0F - cosine) * 3.0F;
  return turn > 0 ? (turn < 14.0F ? static_cast<unsigned>(turn) : 14) : 0;
}
}

#endif
