// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunBrickGroup_h
#define gatunBrickGroup_h

#include "gatunMergeBrick.h"
#include "gatunMergeInput.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
constexpr std::uint8_t ManyBricks = 255; ///< that many bricks have a point, or more

/** What all groups of bricks of a mesh have in common. */
struct BrickGroupSettings
{
  MergeSettings Merges;
  std::size_t Fields = 0;
  double PerWhole = 0; ///< MergeFields::GetPerWhole of the whole mesh
  double PerTet = 0;
};

/** A merge of points of the mesh, with the largest key of it and of all merges that it needs. */
struct KeyedMerge
{
  std::uint32_t Point;
  std::uint32_t Into;
  double Change;
  MergeQueue::Key Key;
};

/** A group of bricks after their points have been merged. */
struct MergedGroup
{
  std::vector<MergeBrick> Bricks;
  std::vector<KeyedMerge> Merges;
  std::vector<std::pair<std::uint32_t, int>> Changes; ///< of the number of bricks of points
  std::vector<MergeQueue::Key> Keys; ///< of the next merges of the points that are not kept

  /** For each merge, how many merges it depends on, and the points of these. */
  std::vector<std::uint32_t> Earlier;

  std::vector<BaredFace> Bared; ///< for the other groups
  std::vector<TouchedFace> Touched;
};

/**
 * Merges points of a group of bricks as BuildMergeTree does. Points that other bricks have, too,
 * are kept: a merge changes only tetrahedra around its point, and all of these are in the group.
 *
 * bricksOfPoint: how many bricks of the mesh have each of its points, at most ManyBricks.
 * Empty: there are no other bricks. bared: those of all groups since these bricks were in groups
 * before. limit: only what has a key below it is merged; 0 only finds the keys. progress: see
 * BuildMergeTree.
 */
MergedGroup MergeBricks(std::vector<MergeBrick> bricks, const BrickGroupSettings& settings,
  std::span<const std::uint8_t> bricksOfPoint, std::span<const BaredFace> bared,
  std::optional<unsigned> limit, const std::function<bool(double)>& progress = {});
}

#endif
