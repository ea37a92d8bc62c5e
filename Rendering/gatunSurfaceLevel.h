// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceLevel_h
#define gatunSurfaceLevel_h

#include "gatunMergeChanges.h"
#include "gatunPieceReader.h"
#include "gatunPublishedFile.h"
#include "gatunSurfaceView.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkPolyData;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** What is drawn of a file. */
struct SurfaceContents
{
  std::vector<std::uint32_t> Arrays;
  std::string Scalars; ///< name of the array that gives colors
  std::size_t Step = 0;

  bool operator==(const SurfaceContents&) const = default;
};

/** A chunk that was decoded, or the reason why it was not. */
struct SurfacePart
{
  vtkSmartPointer<vtkPolyData> Mesh;
  NormalCone Cone;
  std::exception_ptr Failure;
};

/**
 * A surface in a file after a number of merges: the surface itself, a base mesh, or one of these
 * with more merges. Const methods are thread safe. Methods throw Error.
 */
class SurfaceLevel
{
public:
  using Progress = std::function<bool(double)>;

  SurfaceLevel(PublishedFile source, std::size_t merges, SurfaceContents what);
  ~SurfaceLevel();
  SurfaceLevel(const SurfaceLevel&) = delete;
  SurfaceLevel& operator=(const SurfaceLevel&) = delete;

  std::size_t GetMerges() const { return this->Merges; }
  std::size_t GetNumberOfChunks() const;

  /** The bounds of a chunk. */
  const Bounds& GetBox(std::size_t chunk) const;

  /** Cells of a chunk, without those that merges beyond a base mesh remove. */
  std::uint64_t GetNumberOfCells(std::size_t chunk) const;

  /** Decodes a chunk; an error is part of the result. WithIds: whether the mesh gets the numbers of
   * points and cells within the surface. If progress returns false, the error is Aborted. */
  SurfacePart Decode(std::uint32_t chunk, bool withIds, const Progress& progress) const;

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
  SimplifiedFile::Place Place;                         // of the mesh that is decoded
  double Left = 1;                                     // share of its points that merges leave
  mutable std::shared_ptr<const MergeChanges> Changes; // once they were needed; of one thread
  mutable std::mutex Guard;                            // of the readers that no thread uses now
  mutable std::vector<std::unique_ptr<PieceReader>> Readers;
};
}

#endif
