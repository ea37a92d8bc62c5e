// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfacePreparer_h
#define gatunSurfacePreparer_h

#include "gatunBackgroundWorker.h"
#include "gatunSurfaceLevel.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace gatun
{
/**
 * Decodes chunks of a level in the background, one after the other. After each chunk the thread
 * rests as long as it has worked, so that images are not much slower meanwhile. All methods must be
 * called from one thread.
 */
class SurfacePreparer
{
public:
  /** Requests chunks; replaces what was requested before. Chunks of the same level that were
   * decoded and not taken stay. */
  void Prepare(const std::shared_ptr<const SurfaceLevel>& level, std::vector<std::uint32_t> chunks);

  /** A decoded chunk of the level, once; nothing if it is not ready. */
  std::optional<SurfacePart> Take(const SurfaceLevel* level, std::uint32_t chunk);

  /** Waits until all requested chunks are decoded. */
  void Wait() { this->Worker.Wait(); }

  /** Forgets all requests and chunks. */
  void Clear();

private:
  std::shared_ptr<const SurfaceLevel> Level;
  std::map<std::uint32_t, SurfacePart> Ready; // with the lock of the worker
  BackgroundWorker Worker;
};
}

#endif
