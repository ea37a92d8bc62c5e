// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartAgreement_h
#define gatunPartAgreement_h

// Agreement of the processes that write a file together, before they write their parts.

#include "gatunBoundaryMerge.h"
#include "gatunPartExchange.h"
#include "gatunPartSurvey.h"
#include "gatunSpillSorter.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
/** The parts of one process, and its share of the file. */
struct ProcessShare
{
  std::size_t FirstPart = 0;
  std::size_t Parts = 0;
  std::size_t FirstChunk = 0;
  std::size_t Chunks = 0;
  std::size_t FirstBlock = 0;
  std::size_t Blocks = 0;
};

/**
 * Collects the survey of the parts of this process, and agrees with the other processes on that of
 * all parts. Parts are in the order of the processes. After the survey, the methods are collective
 * and are to be called in their order.
 *
 * Memory: the given one for points on boundaries, three times; the groups of shared points; the
 * points that no cell uses, with their values.
 */
class PartAgreement
{
public:
  /** state: that of this process. folder, memory: as for BoundaryMerge. */
  PartAgreement(
    PartExchange& exchange, WriterState& state, const std::string& folder, std::size_t memory);

  /** Adds a use of a point. Parts and chunks have the numbers that they have in this process. */
  void Add(const BoundaryRecord& use) { this->Uses.Add(use); }

  /** Adds the unused points of the next part, and their values at its next step. */
  void AddUnused(const WriterPart& part);
  void AddUnusedValues(std::span<const void* const> values);

  /** Adds the parts, counts and chunks of the other processes. hasIds: whether the parts with
   * points have global ids. */
  void AgreeOnParts(std::vector<SurveyedPart>& parts, const std::optional<bool>& hasIds);

  /** Finds the points that parts have in common. boundaries then has the points of this process,
   * and the state has all groups of shared points. */
  void JoinPoints(BoundaryMerge& boundaries, std::size_t parts);

  /** Adds the values of the parts of the other processes. */
  void AgreeOnDomains(PartDomains& domains);

  /** Finds the blocks that each process writes. places: of all parts. */
  void SetPlaces(const std::vector<PartPlace>& places);

  /** Sends the original numbers of joined points from the first part that has them to the others.
   * numbers: of each group of boundaries. */
  void SendNumbers(BoundaryMerge& boundaries, std::vector<std::vector<std::uint64_t>>& numbers);

  /** Notes the original numbers of the unused points of a part of this process. numbers: of all its
   * points. Empty: consecutive from the first one. Not collective. */
  void KeepUnusedNumbers(
    std::size_t part, std::uint64_t first, const std::vector<std::uint64_t>& numbers);

  /** Sends the unused points that no other part has to the process that writes them. joins: of each
   * part of this process. */
  void SendUnused(const std::vector<PartJoins>& joins);

  const std::vector<ProcessShare>& GetShares() const { return this->Shares; }
  const ProcessShare& GetOwn() const
  {
    return this->Shares[static_cast<std::size_t>(this->Exchange.GetProcess())];
  }

  /** The process that writes the last part. */
  std::size_t GetLast() const;

private:
  /** The unused points of a part. */
  struct PartUnused
  {
    std::vector<std::uint32_t> Points;
    Bytes Coordinates;
    std::vector<std::uint64_t> Numbers;
    std::vector<std::vector<Bytes>> Values; // of each step and array
  };

  void PutSurvey(ByteWriter& out, const std::vector<SurveyedPart>& parts,
    const std::optional<bool>& hasIds) const;
  void PlaceChunks();
  JoinCounts AgreeOnGroups(const JoinCounts& own, const SharedGroups& changes, std::size_t parts);
  void ReturnJoins(BoundaryMerge& merge, BoundaryMerge& boundaries);
  std::size_t FindOwner(std::uint32_t chunk) const;
  std::size_t GetRoundBytes() const;

  PartExchange& Exchange;
  WriterState& State;
  const std::string Folder;
  const std::size_t Memory;
  SpillSorter<BoundaryRecord> Uses;
  std::vector<PartUnused> Unused;
  std::vector<ProcessShare> Shares;
};
}

#endif
