// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunPieceDecoder_h
#define gatunPieceDecoder_h

#include "gatunFileReader.h"
#include "gatunPieceRequest.h"
#include "vtkGatunCoreModule.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace gatun
{
class ChunkCache;

/**
 * Decodes pieces of a file into arrays of the caller, chunks in parallel.
 *
 * Order of the cells: chunk by chunk, ghosts last. Order of the points: those shared by chunks,
 * then each chunk's own, then unused ones, ghosts' last. What it decodes it leaves in a cache, so
 * that another time step, other arrays or a piece with the same chunks need not decode all again.
 * Not thread safe; but several may use one cache, each in a thread of its own.
 */
class VTKGATUNCORE_EXPORT PieceDecoder
{
public:
  using Progress = std::function<bool(double)>; ///< as in FileWriter; abort throws Aborted

  /** With a cache of its own, or with one that others may use too. */
  explicit PieceDecoder(std::shared_ptr<const FileReader> file);
  explicit PieceDecoder(std::shared_ptr<ChunkCache> cache);
  ~PieceDecoder();
  PieceDecoder(const PieceDecoder&) = delete;
  PieceDecoder& operator=(const PieceDecoder&) = delete;

  /** Prepares a request; afterwards the sizes are known (with ghosts this decodes the mesh). */
  void SetRequest(const PieceRequest& request, const Progress& progress = {});
  std::uint64_t GetNumberOfPoints() const;
  std::uint64_t GetNumberOfTets() const;

  /** Fills the target for the request last set. May be called again with other pointers. */
  void Fill(const PieceTarget& target, const Progress& progress = {});

  const std::shared_ptr<const FileReader>& GetFile() const;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
