// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunStepPrefetcher_h
#define gatunStepPrefetcher_h

#include "gatunBackgroundWorker.h"
#include "gatunPieceRequest.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace gatun
{
class ChunkCache;

/**
 * Decodes the arrays of the time step that is likely to be asked for next into the cache of a file,
 * in the background. Errors are left to those who read the step. Not thread safe.
 */
class StepPrefetcher
{
public:
  StepPrefetcher() { this->Worker.SetResting(false); }

  /** To be called when a request for a mesh has been filled. The next step is the one in the
   * direction from the step before, and later ones at first. Nothing is done if the budget of the
   * cache is too small for the mesh and several steps. */
  void Start(const std::shared_ptr<ChunkCache>& cache, const PieceRequest& filled);

  /** Ends the work; waits for the chunk at hand at most. */
  void Stop() { this->Worker.StopAndWait(); }

private:
  std::optional<std::size_t> FindNext(const ChunkCache& cache, const PieceRequest& filled);

  std::optional<std::size_t> LastStep;
  BackgroundWorker Worker;
};
}

#endif
