// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunDependencySection_h
#define gatunDependencySection_h

#include "gatunMergeDependencies.h"
#include "gatunMergeTree.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <atomic>
#include <functional>
#include <future>
#include <optional>

namespace gatun
{
/**
 * Finds the dependencies between the merges of a file and writes them as its section DEPS.
 *
 * Unless the writer is to use just one thread, they are found in a thread of their own from the
 * construction on, while the caller writes other parts. About 140 bytes a tetrahedron until then.
 */
class DependencySection
{
public:
  /** The state, whose options have a tree, and the mesh of the part must not change before the
   * section is written. */
  DependencySection(WriterState& state, const WriterPart& part);

  /** If the section has not been written, waits shortly for the end of the search. */
  ~DependencySection();

  DependencySection(const DependencySection&) = delete;
  DependencySection& operator=(const DependencySection&) = delete;

  /** Writes the section, unless FindDependencies has no result or there are too many for a stream.
   * tree: in the numbers of the file. Error(Aborted) is thrown if progress returns false. */
  void Write(const MergeTree& tree, const std::function<bool(double)>& progress);

private:
  std::optional<MergeDependencies> Find(const std::function<bool(double)>& progress) const;
  std::optional<MergeDependencies> Wait(const std::function<bool(double)>& progress);

  WriterState& State;
  const WriterPart& Part;
  std::atomic<bool> IsAborted{ false };
  std::future<std::optional<MergeDependencies>> Found; // its destructor waits
};
}

#endif
