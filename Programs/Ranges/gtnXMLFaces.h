// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnXMLFaces_h
#define gtnXMLFaces_h

// The faces of the polyhedra of a .vtu file.

#include "gtnXMLArray.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gtn
{
/** The faces of the polyhedra of a piece, which are read in the order of the cells. */
class XMLFaces
{
public:
  /** Throws for the faces of a cell of the piece, which are wrong. */
  using Fail = std::function<void(std::uint64_t cell)>;

  virtual ~XMLFaces() = default;

  /** The number of values that all cells take. */
  virtual std::uint64_t GetSize() const = 0;

  /** Reads the faces of some cells. values: for each polyhedron the number of faces, and for each
   * of these the number of points and the points, all unchecked. ends: of the values of each cell.
   */
  virtual void Read(std::uint64_t begin, std::size_t count, std::vector<std::int64_t>& values,
    std::vector<std::size_t>& ends) = 0;

  /** Up to version 2.2: the values, and where those of each cell end, or -1. */
  static std::unique_ptr<XMLFaces> FromStream(
    std::unique_ptr<XMLArray> faces, std::unique_ptr<XMLArray> ends, Fail fail);

  /** From version 2.3 on.. */
  struct Lists
  {
    std::unique_ptr<XMLArray> Points;    ///< face_connectivity
    std::unique_ptr<XMLArray> PointEnds; ///< face_offsets
    std::unique_ptr<XMLArray> Faces;     ///< polyhedron_to_faces
    std::unique_ptr<XMLArray> FaceEnds;  ///< polyhedron_offsets
  };
  static std::unique_ptr<XMLFaces> FromLists(Lists lists, Fail fail);
};
}

#endif
