// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeTree_h
#define gatunMergeTree_h

#include "vtkGatunCoreModule.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** A point is merged into another one, and is gone from then on. */
struct Merge
{
  std::uint32_t Point;
  std::uint32_t Into;
  float Error; ///< what it costs; in a tree the largest cost of all up to this one
};

/**
 * How a tetrahedral mesh becomes simpler: merges, one after the other. After so many of them, each
 * point is where its ancestor is, and tetrahedra of which two corners have the same ancestor are
 * gone.
 *
 * Based on: Yang, Chiueh: An Integrated Pipeline of Decompression, Simplification and Rendering for
 * Irregular Volume Data, technical report, SUNY at Stony Brook, 2001; Yang: On-the-fly Processing
 * of Compressed Volume Data, 2001, section 5.
 */
class VTKGATUNCORE_EXPORT MergeTree
{
public:
  using Tet = std::array<std::uint32_t, 4>;

  MergeTree() = default;

  /** Throws InvalidInput unless each merge is of two points that there still are. Errors are
   * rounded up to eight significant bits, which is what files keep of them. */
  MergeTree(std::uint32_t points, std::vector<Merge> merges);

  std::uint32_t GetNumberOfPoints() const { return this->Points; }
  const std::vector<Merge>& GetMerges() const { return this->Merges; }

  /** How many merges leave so many points, or as few as there can be. */
  std::size_t CountMergesForPoints(std::uint64_t pointsLeft) const;

  /** The largest error of the first so many merges. */
  double GetLargestError(std::size_t merges) const
  {
    return merges == 0 ? 0 : this->Merges[merges - 1].Error;
  }

  /** How many merges there are before the first that costs more. NaN counts as 0. */
  std::size_t CountMergesForError(double error) const;

  /** Of each point, where it is after the first so many merges: itself, or another one. */
  std::vector<std::uint32_t> FindAncestors(std::size_t merges) const;

private:
  std::uint32_t Points = 0;
  std::vector<Merge> Merges;
};

/** Replaces corners by their ancestors; false if the tetrahedron is gone. */
inline bool Simplify(MergeTree::Tet& tet, std::span<const std::uint32_t> ancestors)
{
  for (auto& corner : tet)
  {
    corner = ancestors[corner];
  }
  return tet[0] != tet[1] && tet[0] != tet[2] && tet[0] != tet[3] && tet[1] != tet[2] &&
    tet[1] != tet[3] && tet[2] != tet[3];
}
}

#endif
