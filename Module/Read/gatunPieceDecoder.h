// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPieceDecoder_h
#define gatunPieceDecoder_h

#include "gatunExport.h"
#include "gatunFileReader.h"
#include "gatunPieceRequest.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace gatun
{
class ChunkCache;

/**
 * Decodes pieces of a file into arrays of the caller, chunks in parallel.
 *
 * Cells are sorted chunk by chunk, ghosts last. Points are sorted: shared points, own points of
 * each chunk, unused points, points of ghosts. Decoded parts stay in a cache, which speeds up
 * further time steps, arrays and pieces with the same chunks. Not thread safe, but decoders in
 * several threads may use one cache.
 */
class GATUN_EXPORT PieceDecoder
{
public:
  using Progress =
    std::function<bool(double)>; ///< as in FileWriter; an abort throws Error(Aborted)

  /** With a cache of its own, or with a cache that others may use. */
  explicit PieceDecoder(std::shared_ptr<const FileReader> file);
  explicit PieceDecoder(std::shared_ptr<ChunkCache> cache);
  ~PieceDecoder();
  PieceDecoder(const PieceDecoder&) = delete;
  PieceDecoder& operator=(const PieceDecoder&) = delete;

  /** Prepares a request and determines its sizes. With ghosts, this decodes the mesh. */
  void SetRequest(const PieceRequest& request, const Progress& progress = {});

  /** Frees the data of the request, which must be set again. Data for the next request after the
   * same merges are kept. */
  void Forget();

  std::uint64_t GetNumberOfPoints() const;
  std::uint64_t GetNumberOfCells() const;

  /** Whether all cells of the piece are tetrahedra: if they were asked for, or all cells of the
   * file are, or there are merges and the file is no surface. */
  bool IsTetrahedral() const;

  /** The numbers of values of PieceTarget::Connectivity and PieceTarget::Faces. */
  std::uint64_t GetConnectivitySize() const;
  std::uint64_t GetFacesSize() const;

  /** Fills the target for the current request. May be called again with other pointers. */
  void Fill(const PieceTarget& target, const Progress& progress = {});

  const std::shared_ptr<const FileReader>& GetFile() const;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
