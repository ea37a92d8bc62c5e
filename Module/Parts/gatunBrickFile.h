// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunBrickFile_h
#define gatunBrickFile_h

#include "gatunAtomicFile.h"
#include "gatunMergeBrick.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace gatun
{
/**
 * Bricks in a file without a name, which the system removes when it is closed, also if the process
 * is killed. A brick keeps its place while it fits. Different bricks may be read and replaced at
 * the same time. Methods throw Error(CannotWrite).
 */
class BrickFile
{
public:
  /** fields: their number in each sample of a brick. hasCells: whether bricks have Cells. */
  BrickFile(const std::string& folder, std::size_t fields, bool hasCells)
    : Fields(fields)
    , HasCells(hasCells)
    , File(AtomicFile::MakeScratch(folder))
  {
  }

  void Add(const MergeBrick& brick);
  MergeBrick Read(std::size_t brick) const;

  /** Replaces a brick by what merges have left of it. */
  void Replace(std::size_t brick, const MergeBrick& by);

  std::size_t GetNumber() const { return this->Entries.size(); }
  std::uint64_t GetTets(std::size_t brick) const { return this->Entries[brick].Tets; }

private:
  struct Entry
  {
    std::uint64_t Offset;
    std::size_t Points;
    std::size_t Tets;
    std::size_t Bared;
    std::size_t Room; // in bytes
  };

  const std::size_t Fields;
  const bool HasCells;
  AtomicFile File;
  std::mutex Mutex; // for new places
  std::vector<Entry> Entries;
};
}

#endif
