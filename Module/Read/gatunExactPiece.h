// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunExactPiece_h
#define gatunExactPiece_h

#include "gatunExport.h"
#include "gatunPieceDecoder.h"
#include "gatunRegion.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace gatun
{
class PieceCells;

/**
 * The cells of a piece that meet a region, with their points: those whose bounding box meets the
 * box, and of whose values (for point arrays, the interval that those of its points span) one is in
 * the range. The section of a region does not count.
 *
 * Decodes the whole chunks of the piece. Not thread safe.
 */
class GATUN_EXPORT ExactPiece
{
public:
  using Progress = PieceDecoder::Progress;

  /** Decodes the mesh and chooses its cells. */
  ExactPiece(std::shared_ptr<ChunkCache> cache, const PieceRequest& request, const Region& region,
    const Progress& progress = {});
  ~ExactPiece();
  ExactPiece(const ExactPiece&) = delete;
  ExactPiece& operator=(const ExactPiece&) = delete;

  std::uint64_t GetNumberOfPoints() const { return this->Points.size(); }
  std::uint64_t GetNumberOfCells() const { return this->Cells.size(); }
  bool IsTetrahedral() const { return this->Decoder.IsTetrahedral(); }
  std::uint64_t GetConnectivitySize() const;
  std::uint64_t GetFacesSize() const;

  /** As PieceDecoder::Fill; parents and numbers in the file are left out. */
  void Fill(const PieceTarget& target, const Progress& progress = {});

private:
  void ChooseInBox(const PieceCells& all, const Bounds& box, std::vector<char>& isChosen);
  void ChooseByValue(
    const PieceCells& all, const Region::Values& interval, std::vector<char>& isChosen);

  PieceDecoder Decoder;
  const PieceRequest Request;
  std::vector<std::uint64_t> Points; // their positions in the piece
  std::vector<std::uint64_t> Cells;
  std::unique_ptr<PieceCells> Memory;
};
}

#endif
