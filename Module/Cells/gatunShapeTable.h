// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunShapeTable_h
#define gatunShapeTable_h

#include "gatunBytes.h"
#include "gatunCellForms.h"
#include "gatunCellList.h"

#include "gatunExport.h" // For export macro

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace gatun
{
/**
 * The closed surfaces that occur as cells of a file.
 *
 * Tables of parts of a mesh can be made by several threads and merged. The result depends neither
 * on the parts nor on the order of merging. Rare shapes are left out, and so are the rarest ones if
 * there are too many.
 */
class ShapeTable
{
public:
  /** Adds the shapes of cells. */
  GATUN_EXPORT void Add(const CellList& cells);

  /** Adds the shapes of another table, none of which was read. */
  GATUN_EXPORT void Merge(const ShapeTable& other);

  /** All uses, for another process, and their addition to another table. */
  GATUN_EXPORT void PutUses(ByteWriter& out) const;
  GATUN_EXPORT void AddUses(ByteReader& in);

  /** The table as it is stored. */
  GATUN_EXPORT Bytes Write() const;

  /** Reads the result of Write. Safe on hostile input: throws Error(Corrupt). */
  GATUN_EXPORT static ShapeTable Read(std::span<const std::uint8_t> bytes);

  /** The forms of all shapes. They are made at each call unless the table was read. */
  GATUN_EXPORT std::shared_ptr<const FormTable> GetForms() const;

private:
  /** Whether a shape saves more than it takes here. Others are coded with each cell. */
  static bool IsWorthwhile(const FormCode& code, std::uint64_t uses)
  {
    return uses >= 3 && 4 * uses >= code.size();
  }

  void Add(SurfaceView faces, unsigned corners, std::uint64_t uses);
  std::vector<FormCode> Select() const;

  /** The uses of shapes, by one of their forms, not always the same one. */
  std::map<FormCode, std::uint64_t, FormOrder> Uses;
  std::shared_ptr<const FormTable> Forms; // of a table that was read
};

/**
 * The surface of a polyhedron in local numbers, in the order of the points of its faces.
 */
class PolyhedronSurface
{
public:
  /** Returns false if the polyhedron is not closed, has a point that no face has or not all points
   * of its faces, or is larger than surfaces with forms are. */
  GATUN_EXPORT bool Set(
    std::span<const std::uint32_t> corners, std::span<const std::uint32_t> faces);

  SurfaceView GetFaces() const { return this->Faces; }

  /** The point for each local number. */
  const std::vector<std::uint32_t>& GetPoints() const { return this->Points; }

private:
  std::vector<std::uint8_t> Faces;
  std::vector<std::uint32_t> Points, Sorted;
};
}

#endif
