// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBoundaryMerge_h
#define gatunBoundaryMerge_h

#include "gatunSharedGroups.h"
#include "gatunSpillSorter.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gatun
{
/** The use of a point of a part by a chunk. The point may be one of other parts, too. */
struct BoundaryRecord
{
  static constexpr std::uint32_t NoChunk = 0xffffffffu;

  std::array<std::uint64_t, 3> Key{}; // equal points have equal keys
  std::uint64_t Values = 0;           // a hash of coordinates and values
  std::uint64_t Morton = 0;           // within the part
  std::uint32_t Part = 0;
  std::uint32_t Point = 0;
  std::uint32_t Chunk = NoChunk; // of the file; NoChunk if no cell uses the point
  std::uint32_t Reserved = 0;

  bool operator<(const BoundaryRecord& other) const
  {
    return this->Key != other.Key    ? this->Key < other.Key
      : this->Values != other.Values ? this->Values < other.Values
      : this->Part != other.Part     ? this->Part < other.Part
      : this->Point != other.Point   ? this->Point < other.Point
                                     : this->Chunk < other.Chunk;
  }
};

/** The points that a part has in common with other parts. */
struct PartJoins
{
  /** The points of each group, in the order of the file. Groups are numbers of BoundaryMerge. */
  std::map<std::uint32_t, std::vector<std::uint32_t>> Groups;

  std::vector<std::uint32_t> Dropped; ///< unused points that another part has
};

/** A point of a part that other parts have, too. */
struct JoinRecord
{
  static constexpr std::uint32_t Dropped = 0xffffffffu;

  std::uint32_t Part = 0;
  std::uint32_t Group = 0;  // a number of BoundaryMerge, or Dropped
  std::uint64_t Morton = 0; // that of the point in the first part of the group
  std::uint32_t First = 0;  // its number there
  std::uint32_t Point = 0;

  bool operator<(const JoinRecord& other) const
  {
    return this->Part != other.Part  ? this->Part < other.Part
      : this->Group != other.Group   ? this->Group < other.Group
      : this->Morton != other.Morton ? this->Morton < other.Morton
      : this->First != other.First   ? this->First < other.First
                                     : this->Point < other.Point;
  }
};

/** Numbers of points that parts have in common. */
struct JoinCounts
{
  /** How many points of each part belong to an earlier one. */
  std::vector<std::uint64_t> Repeated;

  std::uint64_t Dropped = 0; ///< unused ones of these, in all parts

  /** How many points were left apart, though another part has a point with the same key: because of
   * different values, or because there are several in one part. */
  std::uint64_t Different = 0;
  std::uint64_t Ambiguous = 0;
};

/**
 * Finds equal points of parts, by keys and values. Points of one part are never joined, and points
 * that have several equal ones in a part are left apart, so that cracks stay.
 *
 * Memory: about twice the given one, and the groups of shared points.
 */
class BoundaryMerge
{
public:
  /** folder: of temporary files. memory: in bytes, before files are used. */
  BoundaryMerge(const std::string& folder, std::size_t memory)
    : Boundaries(folder, memory)
    , Joins(folder, memory)
  {
  }

  /** Adds a use of a point. */
  void Add(const BoundaryRecord& use) { this->Boundaries.Add(use); }

  /** Joins points when all uses have been added, and changes the groups of the file accordingly.
   * parts: the number of parts. */
  void Join(std::size_t parts, SharedGroups& groups);

  /** The points of the next part that are joined with others. To be called once for each part, in
   * the order of the parts. */
  PartJoins Take(std::uint32_t part);

  /** The chunks of a group of points of several parts. */
  const ChunkGroup& GetGroup(std::uint32_t group) const { return *this->Groups[group]; }

  const JoinCounts& GetCounts() const { return this->Counts; }
  std::size_t GetNumberOfGroups() const { return this->Groups.size(); }

  /** The number of a group, which becomes known if it is not. */
  std::uint32_t FindGroup(const ChunkGroup& chunks);

  /** The next joined point in place of Take, for the process that has its part, or null. */
  const JoinRecord* GetJoin() const { return this->Joins.Get(); }
  void NextJoin() { this->Joins.Next(); }

  /** Adds joined points that other processes have found, in place of Join. To be called for all of
   * them, then with their numbers. */
  void AddJoin(const JoinRecord& join) { this->Joins.Add(join); }
  void SetJoined(JoinCounts counts)
  {
    this->Counts = std::move(counts);
    this->Joins.Sort();
  }

  std::uint64_t GetSpilledBytes() const
  {
    return this->Boundaries.GetSpilledBytes() + this->Joins.GetSpilledBytes();
  }

private:
  /** A point of a part. */
  struct Member
  {
    std::uint32_t Part = 0;
    std::uint32_t Point = 0;
    std::uint64_t Morton = 0;
    ChunkGroup Chunks; // of that part
  };

  void JoinEqual(const std::vector<Member>& members, SharedGroups& groups);
  void Drop(const Member& member);

  SpillSorter<BoundaryRecord> Boundaries;
  SpillSorter<JoinRecord> Joins;
  std::map<ChunkGroup, std::uint32_t> GroupNumbers;
  std::vector<const ChunkGroup*> Groups;
  JoinCounts Counts;
};
}

#endif
