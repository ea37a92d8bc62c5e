// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunStepPrefetcher_h
#define gatunStepPrefetcher_h

#include "gatunPieceRequest.h"

#include <atomic>
#include <memory>
#include <optional>
#include <thread>

namespace gatun
{
class ChunkCache;

/**
 * Decodes the arrays of the time step that is likely to be asked for next into the cache of a file,
 * in a thread of its own. Errors are left to those who read the step. Not thread safe.
 */
class StepPrefetcher
{
public:
  StepPrefetcher() = default;
  ~StepPrefetcher() { this->Stop(); }
  StepPrefetcher(const StepPrefetcher&) = delete;
  StepPrefetcher& operator=(const StepPrefetcher&) = delete;

  /** To be called when a request for a mesh has been filled. The next step is the one in the
   * direction from the step before, and later ones at first. Nothing is done if the budget of the
   * cache is too small for the mesh and several steps. */
  void Start(const std::shared_ptr<ChunkCache>& cache, const PieceRequest& filled);

  /** Ends the thread; waits for the chunk at hand at most. */
  void Stop();

private:
  std::optional<std::size_t> FindNext(const ChunkCache& cache, const PieceRequest& filled);

  std::thread Thread;
  std::atomic<bool> IsStopped{ false };
  std::optional<std::size_t> LastStep;
};
}

#endif
