// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceLevel_h
#define gatunSurfaceLevel_h

#include "gatunMergeChanges.h"
#include "gatunPieceReader.h"
#include "gatunPublishedFile.h"
#include "gatunSurfaceMesh.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace gatun
{
/**
 * A surface in a file after a number of merges: the surface itself, a base mesh, or one of these
 * with more merges. Const methods are thread safe. Methods throw Error.
 */
class SurfaceLevel final : public SurfaceMesh
{
public:
  SurfaceLevel(PublishedFile source, std::size_t merges, SurfaceContents what);
  ~SurfaceLevel() override;

  std::size_t GetMerges() const override { return this->Merges; }
  std::size_t GetNumberOfChunks() const override;
  const Bounds& GetBox(std::size_t chunk) const override { return this->Boxes[chunk]; }
  std::uint64_t GetNumberOfCells(std::size_t chunk) const override;
  SurfacePart Decode(std::uint32_t chunk, bool withIds, const Progress& progress) const override;

  /** The chunks that differ from those of another level of the same file. Nothing if all may. To be
   * called from one thread for all levels. */
  std::optional<std::vector<std::uint32_t>> FindChanges(const SurfaceLevel& other) const;

private:
  std::unique_ptr<PieceReader> TakeReader() const;
  vtkSmartPointer<vtkPolyData> Read(
    PieceReader& reader, std::uint32_t chunk, bool withIds, const Progress& progress) const;

  PublishedFile Source;
  std::size_t Merges;
  SurfaceContents What;
  SharedFile::Place Place;                             // of the mesh that is decoded
  std::vector<Bounds> Boxes;                           // of the chunks
  double Left = 1;                                     // share of its points that merges leave
  mutable std::shared_ptr<const MergeChanges> Changes; // once they were needed; of one thread
  mutable std::mutex Guard;                            // of the readers that no thread uses now
  mutable std::vector<std::unique_ptr<PieceReader>> Readers;
};
}

#endif
