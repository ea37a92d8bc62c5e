// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFormBuilder_h
#define gatunFormBuilder_h

#include "gatunFormMaker.h"

#include "gatunExport.h" // For export macro

#include <array>
#include <bitset>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Makes a form from its code, face by face; see FormMaker. Throws Error(Corrupt) if a code is none
 * of a closed surface. */
class FormBuilder
{
public:
  static constexpr unsigned None = 255;

  /** Throws that a shape is not a closed surface. */
  [[noreturn]] GATUN_EXPORT static void ThrowOpen();

  /** degree: of the gate. */
  GATUN_EXPORT void Begin(unsigned degree);

  /** Finds the next edge without a face. Returns false if the surface is closed. */
  GATUN_EXPORT bool FindEdge();

  /** Begins the face over the edge that was found. */
  GATUN_EXPORT void BeginFace(unsigned size);

  /** Adds a corner to the face, which may be the next new one. */
  GATUN_EXPORT void AddCorner(unsigned corner);

  /** The corners of the edge that was found. */
  unsigned GetFrom() const { return this->Edge[0]; }
  unsigned GetTo() const { return this->Edge[1]; }

  unsigned GetCorners() const { return this->Corners; }
  unsigned GetLast() const { return this->Sides.back(); }

  /** The number of faces that have a corner. */
  unsigned CountFaces(unsigned corner) const { return this->FacesAt[corner]; }

  /** The end of an edge without a face that begins at a corner, or None. */
  unsigned FindNext(unsigned corner) const
  {
    return this->FindOpen([&](unsigned other) { return this->IsOpen(corner, other); });
  }

  /** The beginning of an edge without a face that ends at a corner, or None. */
  unsigned FindBefore(unsigned corner) const
  {
    return this->FindOpen([&](unsigned other) { return this->IsOpen(other, corner); });
  }

  /** The corners of all faces, and where the faces begin, as CellForm has them. */
  const std::vector<std::uint8_t>& GetSides() const { return this->Sides; }
  const std::vector<std::uint16_t>& GetFirstSides() const { return this->FirstSides; }

private:
  /** Whether the face on one side of an edge is there, and the one of this direction is not. */
  bool IsOpen(unsigned from, unsigned to) const
  {
    return this->Edges[to][from] && !this->Edges[from][to];
  }

  template <typename IsOpenTo>
  unsigned FindOpen(IsOpenTo&& isOpen) const
  {
    unsigned other = 0;
    while (other < this->Corners && !isOpen(other))
    {
      ++other;
    }
    return other < this->Corners ? other : None;
  }

  std::array<std::bitset<256>, 256> Edges; // of faces, from a corner to another
  std::array<std::uint8_t, 256> FacesAt{};
  std::vector<std::array<std::uint8_t, 2>> Queue;
  std::size_t Head = 0;
  std::array<std::uint8_t, 2> Edge{};
  std::vector<std::uint8_t> Sides;
  std::vector<std::uint16_t> FirstSides;
  unsigned Corners = 0;
  unsigned Left = 0; // corners of the face
};
}

#endif
