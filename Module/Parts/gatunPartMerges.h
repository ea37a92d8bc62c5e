// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunPartMerges_h
#define gatunPartMerges_h

#include "gatunBrickBuilder.h"
#include "gatunBrickDivision.h"
#include "gatunBrickFile.h"
#include "gatunBrickGroup.h"
#include "gatunMergeDependencies.h"
#include "gatunMergeTree.h"
#include "gatunSpillSorter.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gatun
{
struct PartMergeSettings
{
  MergeSettings Merges; ///< PartAtOnce is not for parts

  /** The most tetrahedra of a group of bricks, of which each thread has one in memory at 100 to 160
   * bytes a tetrahedron. It determines the merges, unlike the number of threads. */
  std::uint64_t TetsOfGroup = 0;

  /** Where temporary files are made, without names. */
  std::string Folder = ".";

  bool KeepsCells = false; ///< whether the parts have MergePart::Cells, which MergedPart then has
};

/** Some tetrahedra of a mesh after merges. */
struct MergedPart
{
  std::vector<std::uint32_t> Points;  ///< their numbers in the mesh, ascending
  std::vector<std::uint8_t> IsShared; ///< whether other parts have a point, too
  std::vector<MergeTree::Tet> Tets;   ///< as places among the points
  std::vector<std::uint32_t> Cells;   ///< of each tetrahedron; empty unless they are kept
};

/**
 * Merges the points of a mesh that never is in memory as a whole.
 *
 * The mesh is cut into bricks, which are on disk. Groups of bricks are merged by themselves, each
 * in memory, up to one limit of the cost for all of them; points that a group shares with others
 * stay. Then the bricks are divided into other groups, and merged up to the same limit: that is a
 * level. The limit rises from level to level, until all that is left fits into one group. So, no
 * wall between groups is ever finer than what is around it by more than a level.
 *
 * The order of the merges is by level, and within it by the largest cost of a merge and of those
 * that it needs. Errors are within some percent of those of BuildMergeTree at equal numbers of
 * tetrahedra. The merges do not depend on the number of threads.
 *
 * Memory: the groups; 1 byte a point, and what sums there are of points of several parts; and for
 * the tree, 12 bytes a merge. Disk: 38 bytes a tetrahedron and 6 for each field, and 70 bytes a
 * merge.
 *
 * Methods throw Error (InvalidInput, CannotWrite, Aborted).
 */
class PartMerges
{
public:
  /** points: the number of points of the mesh. fields: that of its fields. */
  PartMerges(std::uint32_t points, std::size_t fields, const PartMergeSettings& settings);

  /** The merges depend on the parts and on their order. */
  void Add(const MergePart& part);

  /** Called by Build at the end of each level, when the first merges of the tree, so many, have
   * been made. */
  using Listener = std::function<void(std::uint32_t merges)>;
  void SetListener(Listener listener) { this->OnLevel = std::move(listener); }

  /** To be called once behind the last part. progress: see BuildMergeTree. */
  MergeTree Build(const std::function<bool(double)>& progress = {});

  /** The dependencies between the merges, which take 28 bytes each. To be called once behind Build.
   * tree: its result. */
  MergeDependencies FindDependencies(const MergeTree& tree);

  /** The parts of the mesh at the end of the last level. Any group of bricks that fits into memory
   * may be one. Before the first level there is a single part. */
  std::size_t GetNumberOfParts() const { return this->Groups.size(); }
  MergedPart ReadPart(std::size_t part) const { return this->Read(this->Groups[part], {}); }

  /** The tetrahedra of all of them. */
  std::uint64_t CountTets() const;

  /** All of the mesh after further merges. To be called behind Build. ancestors: of each point. */
  MergedPart ReadRest(std::span<const std::uint32_t> ancestors) const;

  /** Whether a point has been merged by the end of the last level. */
  bool IsMerged(std::uint32_t point) const { return this->IsGone[point]; }
  std::uint32_t GetMergesOfLevels() const { return this->MergesOfLevels; }

private:
  struct Record
  {
    double Change;
    std::uint32_t Point, Into;
    std::uint32_t Group, Number; // the group of the pass, the merge of the group
    std::uint16_t Level, Pass;
    MergeQueue::Key Key;

    bool operator<(const Record& other) const;
  };

  /** That a merge depends on an earlier one. Both have their numbers in the tree. */
  struct Dependency
  {
    std::uint32_t Merge, Earlier;

    bool operator<(const Dependency& other) const
    {
      return this->Merge != other.Merge ? this->Merge < other.Merge : this->Earlier < other.Earlier;
    }
  };

  std::vector<std::uint64_t> ListTets() const;
  MergeBrick ReadBrick(std::size_t number) const;
  std::uint16_t ReduceToOneGroup();
  MergedPart Read(
    const BrickDivision::Group& group, std::span<const std::uint32_t> ancestors) const;
  void EndLevel();
  void FindTouched();
  void RunPass(std::uint16_t level, std::uint16_t pass, unsigned limit);
  MergedGroup RunGroup(const BrickDivision::Group& group, unsigned limit);
  void Note(
    const MergedGroup& merged, std::uint16_t level, std::uint16_t pass, std::uint32_t group);
  void CountBricks(std::span<const std::pair<std::uint32_t, int>> changes);
  unsigned FindLimit() const;
  bool Report(double done);
  MergeTree MakeTree();

  const std::uint32_t Points;
  const PartMergeSettings Settings;
  BrickGroupSettings OfGroups;
  BrickBuilder Builder;
  BrickFile Bricks;
  std::vector<Bounds> Boxes; // of the bricks
  bool HasSums = true;       // whether the samples of the bricks are those of the builder
  std::vector<std::uint8_t> BricksOfPoint;
  std::optional<BrickDivision> Division;
  std::vector<BrickDivision::Group> Groups; // of the last pass
  std::vector<bool> IsGone;                 // of each point
  std::uint32_t MergesOfLevels = 0;
  Listener OnLevel;
  std::vector<std::uint64_t> Histogram; // of the keys of the last pass
  SpillSorter<Record> Records;
  std::size_t Merges = 0;
  std::vector<BaredFace> Bared;            // by the last pass
  std::unique_ptr<AtomicFile> Touched;     // by the pass: TouchedFace
  std::vector<Dependency> Either;          // by points: depends on the earlier one if it is later
  AtomicFile Earlier;                      // for each group, its merges and what they depend on
  std::vector<std::size_t> EarlierOfGroup; // the bytes in the file
  const std::function<bool(double)>* Progress = nullptr;
  double Done = 0;
};
}

#endif
