// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellSubset_h
#define gatunCellSubset_h

#include "gatunBytes.h"
#include "gatunCellMask.h"
#include "gatunMeshAccess.h"
#include "gatunMeshInput.h"
#include "gatunTypes.h"
#include "gatunWriterPart.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The remaining cells of a mesh that is being written, and the points that a time step has. */
class CellSubset
{
public:
  /** Throws Error(InvalidInput) unless numbers ascend and exist, and the points are those of the
   * cells. */
  CellSubset(const MeshAccess& mesh, const RemainingCells& remaining);

  /** Whether each point or cell of the mesh remains. */
  const std::vector<bool>& Get(Association where) const
  {
    return where == Association::Point ? this->Points : this->Cells;
  }

  /** The values of an array for all points or cells of the mesh: deleted ones have the values of
   * the previous step. */
  Bytes Spread(
    const void* values, Association where, std::size_t tupleSize, const Bytes& before) const;

  /** The mask in the order of the file. */
  CellMask MakeMask(const WriterPart& part) const;

private:
  std::vector<bool> Points;
  std::vector<bool> Cells;
  bool DropsPoints;
};
}

#endif
