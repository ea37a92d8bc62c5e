// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFront_h
#define gatunFront_h

// The open surface between the tetrahedra that a walk has visited and the others.

#include "gatunInline.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Index of a vertex in the order in which the walk first met it. */
using Vertex = std::uint32_t;

constexpr Vertex NoVertex = 0xffffffff;

/** a or b without a branch, for unpredictable conditions. */
GATUN_INLINE std::uint32_t Choose(bool condition, std::uint32_t a, std::uint32_t b)
{
  const std::uint32_t mask = 0u - std::uint32_t{ condition };
  return b ^ ((a ^ b) & mask);
}

/** The side of a triangle after one, opposite to the next corner. */
constexpr unsigned NextSide(unsigned side)
{
  return (0x09u >> (2 * side)) & 3u;
}

/** The side of a triangle before one. */
constexpr unsigned LastSide(unsigned side)
{
  return (0x12u >> (2 * side)) & 3u;
}

/**
 * The neighbor over a side of an open face: a side of another open face, or the border with the far
 * corner of the last face there. Also counts the visited tetrahedra around the edge.
 */
class Link
{
public:
  static constexpr unsigned MostTets = 7; // larger numbers are clamped

  Link() = default;

  static Link ToSide(std::uint32_t face, unsigned side) { return Link(face << 2 | side); }
  static Link ToBorder(Vertex far) { return Link(BorderBit | far << 2); }

  Link WithTets(unsigned tets) const
  {
    return Link((this->Bits & ~(7u << TetsShift)) | std::min(tets, MostTets) << TetsShift);
  }

  bool IsBorder() const { return (this->Bits & BorderBit) != 0; }
  unsigned GetTets() const { return this->Bits >> TetsShift & 7; }
  std::uint32_t GetFace() const { return (this->Bits & Mask) >> 2; }
  std::uint32_t GetFaceAndMore() const { return this->Bits >> 2; } // with other bits above it
  unsigned GetSide() const { return this->Bits & 3; }
  Vertex GetBorderFar() const { return (this->Bits & Mask) >> 2; }

private:
  static constexpr std::uint32_t BorderBit = 0x80000000u;
  static constexpr unsigned TetsShift = 28;
  static constexpr std::uint32_t Mask = (1u << TetsShift) - 1;

  explicit Link(std::uint32_t bits)
    : Bits(bits)
  {
  }

  std::uint32_t Bits = 0;
};

/**
 * Open faces in the order of their creation. A face is a triangle seen from outside the visited
 * part. Apex is the fourth corner of the tetrahedron behind it. Each side has exactly one other
 * open face, or the border, as its neighbor. Where the front touches itself in an edge, its faces
 * are linked in pairs.
 *
 * Faces are in a ring buffer, so that memory grows with the front and not with the mesh.
 */
class Front
{
public:
  static constexpr std::uint32_t None = 0xffffffff;

  struct alignas(32) Face
  {
    std::array<Vertex, 3> Corners;
    Vertex Apex;
    std::array<Link, 3> Over; // the side opposite to the corner of the same number
    std::uint32_t Open;       // 0: closed, else 1 + the tetrahedron behind it
  };

  Front()
    : Faces(1025)
    , Mask(1023)
  {
  }

  /** The oldest open face, or None. */
  std::uint32_t NextGate()
  {
    // Four at a time, because closed faces are unpredictable. Faces beyond the last one are closed.
    while (this->Head < this->Tail)
    {
      const unsigned open = this->IsOpen(this->Head) | this->IsOpen(this->Head + 1) << 1 |
        this->IsOpen(this->Head + 2) << 2 | this->IsOpen(this->Head + 3) << 3;
      if (open != 0)
      {
        this->Head += static_cast<std::uint32_t>(std::countr_zero(open));
        return this->Head;
      }
      this->Head = std::min(this->Head + 4, this->Tail);
    }
    return None;
  }

  Face& GetFace(std::uint32_t id) { return this->Faces[id & this->Mask]; }
  const Face& GetFace(std::uint32_t id) const { return this->Faces[id & this->Mask]; }

  /** The face of a link, or an arbitrary one for the border. The mask removes the other bits. */
  Face& GetFace(Link link) { return this->Faces[link.GetFaceAndMore() & this->Mask]; }
  const Face& GetFace(Link link) const { return this->Faces[link.GetFaceAndMore() & this->Mask]; }

  /** Makes room for four faces, so that adding them does not move the others. */
  void MakeRoom()
  {
    if (this->Tail - this->Head + 4 > this->Mask + 1)
    {
      this->Grow();
    }
  }

  /** Adds a face without links. */
  std::uint32_t AddFace(const std::array<Vertex, 3>& corners, Vertex apex, std::uint32_t tet)
  {
    const auto id = this->Tail++;
    this->SetFace(id, corners, apex, tet);
    return id;
  }

  /** Adds two faces for SetFace. Returns the first one; the other one follows. */
  std::uint32_t AddTwoFaces()
  {
    const auto id = this->Tail;
    this->Tail += 2;
    return id;
  }

  /** Sets a new face, without links. */
  GATUN_INLINE void SetFace(
    std::uint32_t id, const std::array<Vertex, 3>& corners, Vertex apex, std::uint32_t tet)
  {
    this->GetFace(id) = { corners, apex, {}, tet + 1 };
  }

  /** Links two sides over an edge with a given number of tetrahedra. One may be the border. */
  GATUN_INLINE void Connect(Link a, Link b, unsigned tets)
  {
    a = a.WithTets(tets);
    b = b.WithTets(tets);
    this->GetLink(a) = b;
    this->GetLink(b) = a;
  }

  /** Turns the links of the neighbors of a closed face to the border. */
  void CloseAtBorder(const Face& face)
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      this->GetLink(face.Over[i]) =
        Link::ToBorder(face.Corners[i]).WithTets(face.Over[i].GetTets());
    }
  }

  /** Prefetches the neighborhood of an upcoming gate. */
  void Prefetch(std::uint32_t gate) const
  {
#if defined(__GNUC__)
    for (const auto link : this->GetFace(gate).Over)
    {
      __builtin_prefetch(&this->GetFace(link));
    }
#else
    static_cast<void>(gate);
#endif
  }

private:
  unsigned IsOpen(std::uint32_t id) const
  {
    return this->GetFace(id).Open != 0;
  }
  void Grow();

  /** The link of a side, or an unused place for the border, which is unpredictable. */
  GATUN_INLINE Link& GetLink(Link side)
  {
    const auto at = Choose(side.IsBorder(), this->Mask + 1, side.GetFaceAndMore() & this->Mask);
    return this->Faces[at].Over[side.GetSide()];
  }

  std::vector<Face> Faces; // the ring buffer, and one for the links of the border
  std::uint32_t Mask;
  std::uint32_t Head = 0;
  std::uint32_t Tail = 0;
};
}

#endif
