// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunShapeTable_h
#define gatunShapeTable_h

#include "gatunBytes.h"
#include "gatunCellList.h"

#include "vtkGatunCoreModule.h" // For export macro

#include <cstdint>
#include <span>

namespace gatun
{
/**
 * The closed surfaces that occur as cells of a file.
 *
 * Tables of parts of a mesh can be made by several threads and merged. The result depends neither
 * on the parts nor on the order of merging.
 */
class ShapeTable
{
public:
  /** Adds the shapes of cells. */
  VTKGATUNCORE_EXPORT void Add(const CellList& cells);

  /** Adds the shapes of another table. */
  VTKGATUNCORE_EXPORT void Merge(const ShapeTable& other);

  /** The table as it is stored. */
  VTKGATUNCORE_EXPORT Bytes Write() const;

  /** Reads the result of Write. Safe on hostile input: throws Error(Corrupt). */
  VTKGATUNCORE_EXPORT static ShapeTable Read(std::span<const std::uint8_t> bytes);
};
}

#endif
