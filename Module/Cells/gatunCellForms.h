// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellForms_h
#define gatunCellForms_h

#include "gatunCellGraph.h"
#include "gatunCellShapes.h"
#include "gatunFormBuilder.h"
#include "gatunFormMaker.h"

#include "gatunExport.h" // For export macro

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace gatun
{
/** A closed surface seen from a gate; see FormMaker. Its sides are the corners of its faces, with
 * the edges that begin there, face by face. The gate is the first face. */
struct CellForm
{
  static constexpr std::uint8_t None = 255;
  static constexpr unsigned Families = 5;
  static constexpr unsigned MostCorners = 255; // of a face

  template <typename T>
  using OfCorners = std::vector<T>;
  template <typename T>
  using OfSides = std::vector<T>;
  using Faces = std::vector<std::uint8_t>;

  /** Parses FormMaker's code. Throws Error(Corrupt) if it is none. */
  GATUN_EXPORT explicit CellForm(std::span<const std::uint8_t> code);

  /** Throws Error(Corrupt) if the surface is not closed. */
  GATUN_EXPORT explicit CellForm(const FormBuilder& builder);

  unsigned GetNumberOfFaces() const { return static_cast<unsigned>(this->FirstSides.size() - 1); }
  unsigned GetFirstSide(unsigned face) const { return this->FirstSides[face]; }
  unsigned GetDegree(unsigned face) const
  {
    return this->FirstSides[face + 1] - this->FirstSides[face];
  }

  std::span<const CellGraph::Local> GetNeighbors(unsigned corner) const
  {
    return this->Graph.GetNeighbors(corner);
  }

  /** The faces except the gate as SurfaceView has them, and the gate in the same direction. */
  GATUN_EXPORT std::vector<std::uint8_t> GetSurface() const;

  unsigned Shape = 0;  // of the table
  unsigned Family = 0; // tetrahedra, pyramids, wedges, hexahedra, others
  unsigned Corners = 0;
  std::vector<std::uint16_t> FirstSides; // of each face, and the end

  /** For each face, bit c mod 64 is set for each of its corners c. */
  std::vector<std::uint64_t> FaceMasks;

  /** The two sides at each edge, the smaller one first, ascending. */
  std::vector<std::array<std::uint16_t, 2>> Edges;

  // Of each side:
  std::vector<std::uint8_t> Corner; // where it begins
  std::vector<std::uint8_t> Face;
  std::vector<std::uint16_t> Twin; // the side of the other face at the edge
  std::vector<std::uint8_t> Below; // the only neighbor of the corner beyond the face, or None

  CellGraph Graph;
};

/** The forms of some shapes, and the ways in which cells of VTK's types have them. */
class FormTable
{
public:
  static constexpr std::uint16_t None = 0xffff;
  static constexpr std::size_t MaxForms = 4096;
  static constexpr std::size_t MaxSides = std::size_t{ 1 } << 18; // of all forms

  /** One of the ways to see a cell from one of its faces. */
  struct Frame
  {
    std::uint16_t Form = None;           // None if the frame does not exist
    std::vector<std::uint8_t> Order;     // the cell's corner for each one of the form
    std::vector<FormMaker::Place> Faces; // the cell's face for each one of the form
  };

  /** Frames of cells with eight faces of eight corners and less. */
  static constexpr unsigned Frames = 128;
  static constexpr unsigned MakeFrame(unsigned gate, unsigned start, bool mirrored)
  {
    return (gate * 8 + start) * 2 + mirrored;
  }

  /** Adds all forms of a surface, unless there would be too many or they are there. */
  GATUN_EXPORT bool AddShape(SurfaceView faces, unsigned corners);

  /** To be called behind the last AddShape. */
  GATUN_EXPORT void MakeFrames();

  std::size_t GetSize() const { return this->Forms.size(); }
  const CellForm& Get(std::size_t form) const { return this->Forms[form]; }

  /** The form with a code, or None. */
  GATUN_EXPORT std::uint16_t Find(const FormCode& code) const;

  /** The form of hexahedra, or None. */
  GATUN_EXPORT std::uint16_t FindHexahedron() const;

  /** The frames of a type's shape, by MakeFrame. Empty if the shape is not in the table. */
  GATUN_EXPORT std::span<const Frame> GetFrames(const CellShape* shape) const;

private:
  std::vector<CellForm> Forms;
  std::size_t Sides = 0;
  unsigned Shapes = 0;
  std::map<FormCode, std::uint16_t, FormOrder> Codes;
  std::map<const CellShape*, std::vector<Frame>> FramesOf;
};
}

#endif
