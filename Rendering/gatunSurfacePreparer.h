// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfacePreparer_h
#define gatunSurfacePreparer_h

#include "gatunSurfaceMesh.h"

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace gatun
{
/**
 * Decodes chunks of a level in a thread of its own, one after the other. After each chunk the
 * thread rests as long as it has worked, so that images are not much slower meanwhile. All methods
 * must be called from one thread.
 */
class SurfacePreparer
{
public:
  SurfacePreparer() = default;
  ~SurfacePreparer();
  SurfacePreparer(const SurfacePreparer&) = delete;
  SurfacePreparer& operator=(const SurfacePreparer&) = delete;

  /** Requests chunks; replaces what was requested before. Chunks of the same level that were
   * decoded and not taken stay. */
  void Prepare(const std::shared_ptr<const SurfaceMesh>& level, std::vector<std::uint32_t> chunks);

  /** A decoded chunk of the level, once; nothing if it is not ready. */
  std::optional<SurfacePart> Take(const SurfaceMesh* level, std::uint32_t chunk);

  /** Waits until all requested chunks are decoded. */
  void Wait();

  /** Forgets all requests and chunks. */
  void Clear();

private:
  void Run();

  std::mutex Guard; // of all that follows
  std::condition_variable Changed;
  std::shared_ptr<const SurfaceMesh> Level;
  std::vector<std::uint32_t> Wanted; // the next one is the last
  std::map<std::uint32_t, SurfacePart> Ready;
  std::uint64_t Version = 0; // of the level
  bool IsWorking = false;
  bool IsEnding = false;
  std::thread Worker; // while there was a request
};
}

#endif
