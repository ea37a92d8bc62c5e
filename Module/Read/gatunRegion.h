// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunRegion_h
#define gatunRegion_h

#include "gatunExport.h"
#include "gatunFileReader.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gatun
{
/** What is of interest in a mesh. An empty region is all of it. */
struct Region
{
  /** Values of an array in a range, its ends included. */
  struct Values
  {
    std::uint32_t Array = 0;
    int Component = -1; ///< -1: the length of the tuples
    Range Within;
  };

  struct Plane
  {
    std::array<double, 3> Origin{};
    std::array<double, 3> Normal{ 0, 0, 1 };

    /** The signed distance of a point, times the length of the normal. */
    double Evaluate(const std::array<double, 3>& point) const
    {
      double sum = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        sum += (point[axis] - this->Origin[axis]) * this->Normal[axis];
      }
      return sum;
    }
  };

  std::optional<Bounds> Box;
  std::optional<Values> Interval;
  std::optional<Plane> Section;
};

/** The chunks of a file that may have a part of the region at a step after some merges, ascending.
 * Decodes nothing. Throws Error (InvalidInput) for an array or component that does not exist. */
GATUN_EXPORT std::vector<std::uint32_t> FindChunks(
  const FileReader& file, const Region& region, std::size_t step, std::size_t merges = 0);

/** The chunks of piece 0 to pieces - 1 of a list of chunks; none for other pieces. */
GATUN_EXPORT std::vector<std::uint32_t> GetPiece(
  const std::vector<std::uint32_t>& chunks, std::size_t piece, std::size_t pieces);

/** The given chunks and those within a number of layers of chunks around them that share points,
 * ascending. universe: as in PieceRequest. */
std::vector<std::uint32_t> Surround(const FileReader& file,
  const std::vector<std::uint32_t>& chunks, const std::vector<std::uint32_t>& universe,
  unsigned levels);
}

#endif
