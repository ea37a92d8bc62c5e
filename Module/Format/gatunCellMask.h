// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellMask_h
#define gatunCellMask_h

// The LIVE section: the cells of a mesh that some time steps have. See
// Documentation/format.md, 18.4.

#include "gatunBytes.h"
#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The numbers of points and remaining cells of a time step. */
struct RemainingCounts
{
  bool DropsPoints = false;         ///< whether points of no remaining cell are left out
  std::uint64_t Cells = 0;          ///< remaining ones
  std::uint64_t Points = 0;         ///< that time steps have
  std::vector<CellTypeCount> Types; ///< of the remaining cells, as many as the mesh has

  bool operator==(const RemainingCounts&) const = default;
};

/** Which cells of a mesh remain, in the order of the file. */
struct CellMask : RemainingCounts
{
  std::vector<bool> IsAlive; ///< one for each cell of the mesh

  /** The number of remaining cells among some that follow each other. */
  std::uint64_t Count(std::uint64_t first, std::uint64_t cells) const;

  /** The memory that it takes. */
  std::uint64_t GetBytes() const { return sizeof(*this) + this->IsAlive.capacity() / 8; }

  bool operator==(const CellMask&) const = default;

  /** Stores the difference to the mask before, or to a mask of remaining cells if that is shorter
   * or before is null. hasTypes: whether the mesh has other cells than tetrahedra. */
  Bytes Write(const CellMask* before, bool hasTypes) const;

  /** Whether a stored mask needs the one before. */
  static bool NeedsBefore(std::span<const std::uint8_t> bytes);

  /** The sizes to which a mask must fit. */
  struct Mesh
  {
    std::uint64_t Cells = 0;
    std::uint64_t Points = 0;
    std::span<const CellTypeCount> Types; // empty if all cells are tetrahedra
  };

  /** Replaces the mask, which is the one before if that is needed. Throws Error(Corrupt). */
  void Read(std::span<const std::uint8_t> bytes, const Mesh& mesh);
};
}

#endif
