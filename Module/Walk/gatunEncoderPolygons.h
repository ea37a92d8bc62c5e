// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunEncoderPolygons_h
#define gatunEncoderPolygons_h

#include "gatunCellForms.h"
#include "gatunCellList.h"
#include "gatunShapeTable.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The cells of an encoder's input that a walk can take, by their faces. */
class EncoderPolygons
{
public:
  static constexpr std::uint32_t None = 0xffffffff;

  EncoderPolygons(const CellList& cells, const FormTable& forms);

  /** Begins the unvisited cell on a gate. Returns false if there is none. */
  bool FindCell(std::span<const std::uint32_t> gate);

  /** Begins any unvisited cell, seen from its first face. Returns false if there is none. */
  bool FindSeed();

  /** The code of the form of the polyhedron that was begun. */
  const FormCode& GetCode() const { return this->Maker.GetCode(); }

  /** Whether all cells that can be begun are hexahedra (and not polyhedra that look like them). */
  bool IsOfHexahedra() const;

  /** All cells that are never begun. */
  std::vector<std::uint32_t> GetOthers() const;

  // The cell that was begun:
  std::uint32_t Cell = 0;
  std::uint16_t Form = 0;             // FormTable::None if it is not listed
  std::uint8_t Frame = 0;             // see PolygonWalk
  std::vector<std::uint32_t> Corners; // the vertex at each of the form's corners

private:
  struct Surface
  {
    std::uint32_t Cell;
    std::uint8_t Type;
    const CellShape* Shape;   // null for polyhedra
    std::uint32_t FirstFace;  // in Faces
    std::uint32_t FirstLocal; // of polyhedra: in Locals
    std::uint32_t LocalSize;
    std::uint32_t FirstPoint; // in Points
    std::uint32_t PointNumber;
    bool Visited;
  };

  struct Face
  {
    std::uint64_t Hash; // of the vertices, in any order
    std::uint32_t Surface;
    std::uint32_t Next; // with the same place in the table, or None
  };

  void AddSurface(const CellList& cells, std::uint32_t cell, const CellShape* shape);
  SurfaceView GetFaces(const Surface& surface) const;
  bool Begin(std::uint32_t surface, unsigned face, std::span<const std::uint32_t> gate);
  void BeginAt(std::uint32_t surface, unsigned face, unsigned start, bool mirrored);

  const FormTable& Forms;
  std::vector<Surface> Surfaces;
  std::vector<Face> Faces;
  std::vector<std::uint32_t> Heads; // of lists of faces with the same place
  std::vector<std::uint8_t> Locals;
  std::vector<std::uint32_t> Points;
  std::vector<std::uint32_t> Others, Key;
  PolyhedronSurface Polyhedron;
  FormMaker Maker;
  std::size_t Next = 0; // the first surface that may be unvisited
};
}

#endif
