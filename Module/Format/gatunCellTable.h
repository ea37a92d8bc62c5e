// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellTable_h
#define gatunCellTable_h

#include "gatunBytes.h"
#include "gatunChunkCodec.h"
#include "gatunShapeTable.h"
#include "gatunTypes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The sizes of the cells of a chunk. */
struct CellSizes
{
  /** Whether the chunk consists of tetrahedra and is encoded as in a file of tetrahedra. */
  bool IsTetrahedral = true;

  std::uint32_t Cells = 0;
  std::uint32_t Corners = 0;    ///< the points of all cells
  std::uint32_t FaceValues = 0; ///< the size of CellList::Faces
  std::uint32_t Polyhedra = 0;

  /** Sets the sizes in the frame of the chunk. */
  void SetIn(ChunkFrame& frame) const
  {
    frame.Tets = this->IsTetrahedral ? this->Cells : 0;
    if (!this->IsTetrahedral)
    {
      frame.Cells = { this->Cells, this->Corners, this->FaceValues };
    }
  }

  /** The number of different points cannot be larger. */
  std::uint64_t GetMostPoints() const { return std::uint64_t{ this->Corners } + this->FaceValues; }
};

/** The CELL section of a file whose cells are not all tetrahedra. */
struct CellTable
{
  std::vector<CellTypeCount> Types; ///< ascending, each at least once
  std::vector<CellSizes> Chunks;    ///< of chunks of tetrahedra, only IsTetrahedral is stored
  Bytes StoredShapes;               ///< as ShapeTable writes them
  ShapeTable Shapes;                ///< what it reads of them

  /** Sets both forms of the shapes. */
  void SetShapes(Bytes stored);

  Bytes Write() const;
  static CellTable Read(std::span<const std::uint8_t> bytes);
};
}

#endif
