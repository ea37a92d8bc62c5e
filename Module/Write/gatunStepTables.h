// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunStepTables_h
#define gatunStepTables_h

#include "gatunBytes.h"
#include "gatunOutputFile.h"
#include "gatunStepPages.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** The tables of the time steps of a file that is being written. They are kept and written
 * together, so that one read brings those of all steps. */
class StepTables
{
public:
  /** Adds the table of a step whose values are all in the file. */
  void Add(const StepTable& step, const MetaTable& meta, const MeshIndex& mesh);

  /** Adds the ranges after merges of a step. stepsAfter: how many steps have been added since. */
  void AddMerged(Bytes ranges, std::size_t stepsAfter = 0);

  /** Whether they take so much memory that they have to be written before the last step. */
  bool AreLarge() const { return this->Size >= LargeBytes; }

  /** Writes the tables that have been added. */
  void Write(OutputFile& file, const MetaTable& meta);

private:
  struct Entry
  {
    StepIndex Index;
    std::vector<Bytes> Pages;
    Bytes Merged; // ranges after merges, if there are any
  };

  static constexpr std::uint64_t LargeBytes = 16u << 20;

  std::vector<Entry> Entries;
  std::uint64_t Size = 0; // in memory
};
}

#endif
