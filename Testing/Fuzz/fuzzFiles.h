// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef fuzzFiles_h
#define fuzzFiles_h

#include <cstdint>
#include <span>
#include <string>

namespace gatun::fuzz
{
/** A file in memory that has a name. */
class MemoryFile
{
public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /** Makes these bytes the file's content. */
  void Set(std::span<const std::uint8_t> bytes);

  const std::string& GetPath() const { return this->Path; }

private:
  int Handle;
  std::string Path;
};

/** One thread for all of gatun, so that a run can be repeated. Call it before anything else. */
void UseOneThread();

/**
 * Decodes a file in all ways: with its order, by pieces with ghosts, steps, field data, after
 * merges, base meshes; and verifies it. Aborts if an error does not say which file is wrong, or if
 * a file that is accepted decodes to ids that are out of range. Returns whether the file was
 * accepted.
 */
bool DecodeFile(const std::string& path);
}

#endif
