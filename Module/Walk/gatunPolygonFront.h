// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPolygonFront_h
#define gatunPolygonFront_h

// The open surface between the cells that a walk has visited and the others, made of polygons.

#include "gatunFront.h"
#include "gatunMeasure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace gatun
{
/** The link over a side of an open face: a side of another one, or the border, with or without the
 * far corner of the face that ended there. Counts the visited cells around the edge, too. */
class SideLink
{
public:
  static constexpr unsigned MostCells = 7; // larger numbers are clamped

  SideLink() = default;

  static SideLink ToSide(std::uint32_t side, unsigned cells)
  {
    return SideLink(side, std::min(cells, MostCells));
  }

  /** far may be NoVertex. */
  static SideLink ToBorder(Vertex far, unsigned cells)
  {
    return SideLink((far & Mask) | BorderBit, std::min(cells, MostCells));
  }

  bool IsBorder() const { return (this->Bits & BorderBit) != 0; }
  unsigned GetCells() const { return this->Bits >> CellShift & 7; }
  std::uint32_t GetSide() const { return this->Bits & Mask; }
  Vertex GetFar() const { return (this->Bits & Mask) == Mask ? NoVertex : this->Bits & Mask; }

private:
  static constexpr std::uint32_t BorderBit = 0x80000000u;
  static constexpr unsigned CellShift = 28;
  static constexpr std::uint32_t Mask = (1u << CellShift) - 1;

  SideLink(std::uint32_t bits, unsigned cells)
    : Bits(bits | cells << CellShift)
  {
  }

  std::uint32_t Bits = BorderBit | Mask;
};

/**
 * Open faces in the order of their creation, each a polygon seen from outside of the visited part.
 * Side i of a face runs from its corner i to the next one. Sides that are linked run in opposite
 * directions.
 */
class PolygonFront
{
public:
  static constexpr std::uint32_t None = 0xffffffff;

  struct Face
  {
    std::uint32_t First; // side
    std::uint16_t Degree;
    std::uint16_t Form;    // of the cell behind
    std::uint32_t Cell;    // behind
    std::uint16_t Frame;   // where the cell's type has the face; see PolygonWalk
    std::uint8_t Type;     // of the cell
    std::uint8_t FormFace; // of the form
    bool Open;
    bool HasNormal;
    Vec3 Normal; // of length 1 if there is one
  };

  struct Side
  {
    Vertex Corner;
    SideLink Over;
    Vertex Below; // the only neighbor of the corner beyond the face in the cell behind, or none
    std::uint32_t Face;
    std::uint32_t Next;  // another side that begins at the corner, or None
    std::uint8_t Index;  // in the face
    std::uint8_t Degree; // of the face
    bool Open;
  };

  explicit PolygonFront(std::size_t vertices)
    : Faces(FaceMask + 1)
    , Sides(SideMask + 1)
    , Heads(vertices, None)
  {
  }

  /** The oldest open face, or None. Forgets older ones. */
  std::uint32_t NextGate()
  {
    while (this->Head < this->FaceEnd && !this->GetFace(this->Head).Open)
    {
      ++this->Head;
    }
    const bool has = this->Head < this->FaceEnd;
    this->FirstSide = has ? this->GetFace(this->Head).First : this->SideEnd;
    return has ? this->Head : None;
  }

  /** Opens a face with a number of corners, and for each the vertex below it. Its links are the
   * border. Returns its first side. */
  GATUN_INLINE std::uint32_t AddFace(
    Face face, unsigned degree, const Vertex* corners, const Vertex* below)
  {
    if (this->FaceEnd - this->Head > this->FaceMask)
    {
      this->FaceMask = Grow(this->Faces, this->Head, this->FaceEnd);
    }
    // The sides of a face have consecutive places.
    while (this->GetSideBegin(degree) + degree - this->FirstSide > this->SideMask + 1)
    {
      this->SideMask = Grow(this->Sides, this->FirstSide, this->SideEnd);
    }
    const auto id = this->FaceEnd++;
    const auto first = this->GetSideBegin(degree);
    this->SideEnd = first + degree;
    face.First = first;
    face.Degree = static_cast<std::uint16_t>(degree);
    this->GetFace(id) = face;
    auto* const sides = &this->GetSide(first);
    auto* const heads = this->Heads.data();
    for (unsigned i = 0; i < degree; ++i)
    {
      auto& head = heads[corners[i]];
      sides[i] = { corners[i], SideLink(), below[i], id, head, static_cast<std::uint8_t>(i),
        static_cast<std::uint8_t>(degree), true };
      head = first + i;
    }
    return first;
  }

  Face& GetFace(std::uint32_t id) { return this->Faces[id & this->FaceMask]; }
  const Face& GetFace(std::uint32_t id) const { return this->Faces[id & this->FaceMask]; }
  Side& GetSide(std::uint32_t id) { return this->Sides[id & this->SideMask]; }
  const Side& GetSide(std::uint32_t id) const { return this->Sides[id & this->SideMask]; }

  Face& GetFaceOfSide(std::uint32_t side) { return this->GetFace(this->GetSide(side).Face); }
  const Face& GetFaceOfSide(std::uint32_t side) const
  {
    return this->GetFace(this->GetSide(side).Face);
  }

  std::uint32_t GetNext(std::uint32_t id) const
  {
    const auto& side = this->GetSide(id);
    return side.Index + 1 < side.Degree ? id + 1 : id - side.Index;
  }

  std::uint32_t GetLast(std::uint32_t id) const
  {
    const auto& side = this->GetSide(id);
    return side.Index > 0 ? id - 1 : id + side.Degree - 1u;
  }

  /** The side over a side, or None if there is no open face. */
  GATUN_INLINE std::uint32_t GetOpen(std::uint32_t side) const
  {
    const auto link = this->GetSide(side).Over;
    return !link.IsBorder() && this->IsOpen(link.GetSide()) ? link.GetSide() : None;
  }

  void Close(std::uint32_t id)
  {
    auto& face = this->GetFace(id);
    face.Open = false;
    for (unsigned i = 0; i < face.Degree; ++i)
    {
      this->GetSide(face.First + i).Open = false;
    }
  }

  /** Makes two sides each other's links. */
  void Join(std::uint32_t a, std::uint32_t b, unsigned cells)
  {
    this->GetSide(a).Over = SideLink::ToSide(b, cells);
    this->GetSide(b).Over = SideLink::ToSide(a, cells);
  }

  /** Closes a face at the border of the mesh. */
  void CloseAtBorder(std::uint32_t id)
  {
    const auto& face = this->GetFace(id);
    this->Close(id);
    for (unsigned i = 0; i < face.Degree; ++i)
    {
      const auto over = this->GetOpen(face.First + i);
      if (over != None)
      {
        const auto far = this->GetSide(face.First + (i + 2u) % face.Degree).Corner;
        auto& link = this->GetSide(over).Over;
        link = SideLink::ToBorder(far, link.GetCells());
      }
    }
  }

  /** Calls use(side) for the sides of open faces that begin at a corner, the latest first. */
  template <typename Use>
  void ForEachAround(Vertex corner, Use&& use)
  {
    constexpr unsigned most = 64;
    auto* next = &this->Heads[corner];
    for (unsigned count = 0; *next != None && count < most;)
    {
      const auto side = *next;
      if (side < this->FirstSide)
      {
        *next = None; // further ones are still older
        break;
      }
      if (!this->GetSide(side).Open)
      {
        *next = this->GetSide(side).Next; // never looked at again
        continue;
      }
      use(side);
      next = &this->GetSide(side).Next;
      ++count;
    }
  }

private:
  bool IsOpen(std::uint32_t side) const
  {
    return side >= this->FirstSide && this->GetSide(side).Open;
  }

  /** The next side after which the sides of a face fit before the end of the buffer. */
  std::uint32_t GetSideBegin(unsigned degree) const
  {
    const auto size = this->SideMask + 1;
    const auto place = this->SideEnd & this->SideMask;
    return place + degree <= size ? this->SideEnd : this->SideEnd + size - place;
  }

  /** Doubles a ring buffer. Returns its new mask. */
  template <typename T>
  static std::uint32_t Grow(std::vector<T>& ring, std::uint32_t begin, std::uint32_t end)
  {
    std::vector<T> larger(2 * ring.size());
    for (auto id = begin; id < end; ++id)
    {
      larger[id & (larger.size() - 1)] = ring[id & (ring.size() - 1)];
    }
    ring = std::move(larger);
    return static_cast<std::uint32_t>(ring.size() - 1);
  }

  std::uint32_t FaceMask = 1023; // the sizes of the buffers minus 1
  std::uint32_t SideMask = 4095;

  // Ring buffers, so that memory grows with the front and not with the mesh.
  std::vector<Face> Faces;
  std::vector<Side> Sides;
  std::vector<std::uint32_t> Heads; // for each vertex, the latest side that begins there
  std::uint32_t Head = 0;
  std::uint32_t FaceEnd = 0;
  std::uint32_t FirstSide = 0; // of the face at Head
  std::uint32_t SideEnd = 0;
};

/** Closed faces. First is the place of a face's corners. */
struct ClosedFaces
{
  void Add(const PolygonFront& front, const PolygonFront::Face& face)
  {
    this->Faces.push_back(face);
    this->Faces.back().First = static_cast<std::uint32_t>(this->Corners.size());
    for (unsigned i = 0; i < face.Degree; ++i)
    {
      this->Corners.push_back(front.GetSide(face.First + i).Corner);
    }
  }

  std::vector<PolygonFront::Face> Faces;
  std::vector<Vertex> Corners;
};

/** The turns from a face to others: 0 folded shut to 8 flat, behind up to 16. cosines: of the
 * normals. heights: of the other faces in front of the face. */
GATUN_INLINE Float4 GetTurns(Float4 cosines, Float4 heights)
{
  const auto one = Splat(1.0F);
  const auto four = Splat(4.0F);
  return SelectGreater(
    heights, Splat(0.0F), (one + cosines) * four, Splat(8.0F) + (one - cosines) * four);
}

GATUN_INLINE std::uint8_t GradeTurn(float turn)
{
  return turn > 0 ? (turn < 15.0F ? static_cast<std::uint8_t>(turn) : 15) : 0;
}

/**
 * Grades the angle in front of face a at the edge that it has in common with face b: 0 folded shut
 * to 7 flat, 8 to 15 behind, 16 if it is unknown.
 *
 * begin: a corner of the edge. next: the corner of b after the edge.
 */
GATUN_INLINE unsigned GradeAngle(const PolygonFront::Face& a, const PolygonFront::Face& b,
  const LatticePoint& begin, const LatticePoint& next)
{
  const float cosine = Dot(a.Normal, b.Normal);
  const float height = Dot(ToVector(next) - ToVector(begin), a.Normal);
  const auto turn = GetTurns(Splat(cosine), Splat(height))[0];
  return a.HasNormal && b.HasNormal ? GradeTurn(turn) : 16;
}
}

#endif
