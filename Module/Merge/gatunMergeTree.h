// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeTree_h
#define gatunMergeTree_h

#include "gatunExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** An edge collapse: a point is merged into another one and removed. */
struct Merge
{
  std::uint32_t Point;
  std::uint32_t Into;
  float Error; ///< cost; in a tree, the largest cost of all merges up to this one
};

/**
 * A sequence of merges that simplifies a mesh of tetrahedra or a surface. After a number of merges,
 * each point is replaced by its ancestor, and cells with two corners of the same ancestor are
 * removed.
 *
 * Based on: Chuan-kai Yang, Tzi-cker Chiueh: An integrated pipeline of decompression,
 * simplification and rendering for irregular volume data. Technical report, ECSL, Computer Science
 * Department, SUNY at Stony Brook, March 2001.
 */
class GATUN_EXPORT MergeTree
{
public:
  using Tet = std::array<std::uint32_t, 4>;
  using Triangle = std::array<std::uint32_t, 3>;

  MergeTree() = default;

  /** Throws InvalidInput unless both points of each merge still exist. Errors are rounded up to
   * eight significant bits, the precision of files.
   *
   * isBound: for each merge, whether the next one belongs to it, such as that of the other point of
   * a seam. Empty: none. Its size must be that of merges, and the last element must be false.
   *
   * rounds: the number of the first merge of each round, ascending from 0. The merges of a round
   * may be done in any order, but those that belong together follow each other. All get the
   * largest error of the round. Empty: nothing is known about that. */
  MergeTree(std::uint32_t points, std::vector<Merge> merges, std::vector<bool> isBound = {},
    std::vector<std::uint32_t> rounds = {});

  std::uint32_t GetNumberOfPoints() const { return this->Points; }
  const std::vector<Merge>& GetMerges() const { return this->Merges; }

  /** For each merge, whether the next one belongs to it. Empty: none. */
  const std::vector<bool>& GetBonds() const { return this->IsBound; }

  /** The first merge of each round. Empty: unknown. */
  const std::vector<std::uint32_t>& GetRounds() const { return this->Rounds; }

  /** Returns the smallest number of merges, not below a given one, that separates no merges of a
   * round, or, if rounds are unknown, none that belong together. */
  std::size_t CountMergesOfRounds(std::size_t merges) const;

  /** Returns the largest number of merges, not above a given one, that separates no merges that
   * belong together. Otherwise seams of a surface would open. */
  std::size_t CountWholeMerges(std::size_t merges) const;

  /** Returns the number of merges of whole rounds that leave a given number of points, or somewhat
   * fewer, or all merges. */
  std::size_t CountMergesForPoints(std::uint64_t pointsLeft) const;

  /** Returns the largest error of a given number of first merges. */
  double GetLargestError(std::size_t merges) const
  {
    return merges == 0 ? 0 : this->Merges[merges - 1].Error;
  }

  /** Returns the number of merges before the first one with a larger error. NaN counts as 0. */
  std::size_t CountMergesForError(double error) const;

  /** Returns the ancestor of each point after a given number of merges. */
  std::vector<std::uint32_t> FindAncestors(std::size_t merges) const;

private:
  void CheckRounds() const;

  std::uint32_t Points = 0;
  std::vector<Merge> Merges;
  std::vector<bool> IsBound;
  std::vector<std::uint32_t> Rounds;
};

/** Sorts the merges of each round by the numbers of their points. Those that belong together stay
 * together, and are sorted by the first one. numbers: of each point. ends: numbers of merges,
 * ascending; none that is before one of them gets behind it. */
GATUN_EXPORT MergeTree SortRounds(const MergeTree& tree, std::span<const std::uint32_t> numbers,
  std::span<const std::uint32_t> ends = {});

/** Replaces corners by their ancestors. Returns false if the tetrahedron vanishes. */
inline bool Simplify(MergeTree::Tet& tet, std::span<const std::uint32_t> ancestors)
{
  for (auto& corner : tet)
  {
    corner = ancestors[corner];
  }
  return tet[0] != tet[1] && tet[0] != tet[2] && tet[0] != tet[3] && tet[1] != tet[2] &&
    tet[1] != tet[3] && tet[2] != tet[3];
}

/** The same for a triangle. It does not vanish by corners that were one point before. */
inline bool Simplify(MergeTree::Triangle& triangle, std::span<const std::uint32_t> ancestors)
{
  const MergeTree::Triangle before = triangle;
  for (auto& corner : triangle)
  {
    corner = ancestors[corner];
  }
  const auto isOne = [&](unsigned i, unsigned j)
  { return triangle[i] == triangle[j] && before[i] != before[j]; };
  return !isOne(0, 1) && !isOne(1, 2) && !isOne(2, 0);
}
}

#endif
