// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceCut_h
#define gatunSurfaceCut_h

#include "gatunMergeCut.h"
#include "gatunSurfaceBase.h"
#include "gatunSurfaceMesh.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gatun
{
/** A surface that is finer in some places than in others. Its chunks are the blocks of its base
 * mesh. Immutable and thread safe. */
class SurfaceCut final : public SurfaceMesh
{
public:
  /** Before: a cut of the same base mesh with which blocks are shared that do not differ, or null.
   */
  SurfaceCut(std::shared_ptr<const SurfaceBase> base, MergeCut cut, const SurfaceCut* before);

  const SurfaceBase& GetBase() const { return *this->Base; }
  const MergeCut& GetCut() const { return this->Cut; }

  /** Whether a chunk is not that of another cut. */
  bool Differs(std::size_t chunk, const SurfaceCut& other) const
  {
    return this->Base != other.Base || this->Blocks[chunk] != other.Blocks[chunk];
  }

  std::size_t GetMerges() const override
  {
    return this->Base->GetMerges() + this->Cut.GetNumberOfMerges();
  }
  std::size_t GetNumberOfChunks() const override { return this->Blocks.size(); }
  const Bounds& GetBox(std::size_t chunk) const override { return this->Blocks[chunk]->Box; }
  std::uint64_t GetNumberOfCells(std::size_t chunk) const override
  {
    return this->Blocks[chunk]->Cells.size();
  }
  SurfacePart Decode(std::uint32_t chunk, bool withIds, const Progress& progress) const override;

private:
  std::shared_ptr<const SurfaceBase> Base;
  MergeCut Cut;
  std::vector<std::shared_ptr<const SurfaceBlock>> Blocks;
};
}

#endif
