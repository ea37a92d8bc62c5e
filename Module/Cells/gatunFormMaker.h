// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFormMaker_h
#define gatunFormMaker_h

#include "gatunExport.h" // For export macro

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
/**
 * The surface of a cell: for each face the number of its corners, then the corners, in local
 * numbers and counterclockwise if seen from outside.
 */
using SurfaceView = std::span<const std::uint8_t>;

/** Limits of surfaces that have forms. */
constexpr unsigned MaxSurfaceFaces = 255;
constexpr unsigned MaxSurfaceCorners = 255;

/** The numbers of the corners of a surface; see FormMaker. */
using FormCode = std::vector<std::uint8_t>;

/** The order of forms: shorter codes first. */
struct FormOrder
{
  bool operator()(const FormCode& a, const FormCode& b) const
  {
    return a.size() != b.size() ? a.size() < b.size()
                                : std::memcmp(a.data(), b.data(), a.size()) < 0;
  }
};

/** Whether a surface is closed and oriented, of one piece, and has no more than its corners: every
 * edge is there once in each direction. Faces must have three corners or more. */
GATUN_EXPORT bool IsClosedSurface(SurfaceView faces, unsigned corners);

/**
 * Sees a closed surface from one of its faces, the gate. The corners of the gate are numbered
 * first, clockwise if seen from outside, then others in breadth-first order over the edges: the
 * face behind each edge of a queue appends its edges, and the queue begins with the edges of the
 * gate. The numbers of the corners, face by face, are the form of the surface. A surface has equal
 * forms if it is symmetric.
 */
class FormMaker
{
public:
  /** Where a face of the form is in the surface. */
  struct Place
  {
    std::uint8_t Face;
    std::uint8_t Start; // the corner of the face that comes first in the form
  };

  /** start: the corner of the gate that is first. mirrored: whether the faces are clockwise. */
  GATUN_EXPORT void Make(
    SurfaceView faces, unsigned corners, unsigned gate, unsigned start, bool mirrored);

  /** The number of corners of the gate, then for each further face the number of its corners and
   * the corners themselves without the first two, the ends of the edge over which it was met. */
  const FormCode& GetCode() const { return this->Code; }

  /** The surface's corner for each one of the form. */
  const std::vector<std::uint8_t>& GetOrder() const { return this->Order; }

  /** The faces of the form, the gate first. */
  const std::vector<Place>& GetFaces() const { return this->Places; }

private:
  FormCode Code;
  std::vector<std::uint8_t> Order;
  std::vector<Place> Places;

  // For each pair of corners, the face with that edge and its place there, as in Place.
  std::vector<Place> FaceOf;
  std::vector<std::uint16_t> FaceStarts;
  std::vector<std::uint8_t> Numbers; // of the surface's corners
  std::vector<char> Met;             // faces
  std::vector<std::array<std::uint8_t, 2>> Queue;
};
}

#endif
