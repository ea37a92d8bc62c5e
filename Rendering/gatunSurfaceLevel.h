// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceLevel_h
#define gatunSurfaceLevel_h

#include "gatunMergeCut.h"
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
 * A surface in a file after some merges, in chunks that are drawn apart: the surface itself, a base
 * mesh, or one of these with more merges, the same everywhere or finer where a view needs it. Const
 * methods are thread safe. Methods throw Error.
 */
class SurfaceLevel
{
public:
  using Progress = std::function<bool(double)>;

  /** The surface after the first merges of the file. */
  SurfaceLevel(PublishedFile source, std::size_t merges, SurfaceContents what);

  /** A level of the file after the merges of a cut of its tree. */
  SurfaceLevel(PublishedFile source, std::size_t level, MergeCut cut, SurfaceContents what);

  ~SurfaceLevel();
  SurfaceLevel(const SurfaceLevel&) = delete;
  SurfaceLevel& operator=(const SurfaceLevel&) = delete;

  /** The number of merges that lead to it. */
  std::size_t GetMerges() const { return this->Merges; }
  std::size_t GetNumberOfChunks() const { return this->Boxes.size(); }

  /** The bounds of a chunk. */
  const Bounds& GetBox(std::size_t chunk) const { return this->Boxes[chunk]; }

  /** Cells of a chunk, exact or estimated. */
  std::uint64_t GetNumberOfCells(std::size_t chunk) const { return this->Cells[chunk]; }

  /** Decodes a chunk; an error is part of the result. WithIds: whether the mesh gets the numbers of
   * points and cells within the surface, if it is not simplified. If progress returns false, the
   * error is Aborted. */
  SurfacePart Decode(std::uint32_t chunk, bool withIds, const Progress& progress) const;

  /** The chunks that differ from those of another level. Nothing if all may. */
  std::optional<std::vector<std::uint32_t>> FindChanges(const SurfaceLevel& other) const;

private:
  using LayoutPointer = std::shared_ptr<const CoarseLayout>;

  LayoutPointer GetLayout(const MergeTree& tree) const;
  std::unique_ptr<PieceReader> TakeReader() const;
  vtkSmartPointer<vtkPolyData> Read(
    PieceReader& reader, std::uint32_t chunk, bool withIds, const Progress& progress) const;

  PublishedFile Source;
  std::size_t Merges;
  SurfaceContents What;
  SharedFile::Place Place;                                   // of the mesh that is decoded
  std::vector<Bounds> Boxes;                                 // of the chunks
  std::vector<std::uint64_t> Cells;                          // of the chunks
  mutable std::mutex Guard;                                  // of what follows
  mutable LayoutPointer Layout;                              // once it was needed
  mutable std::vector<std::unique_ptr<PieceReader>> Readers; // that no thread uses now
};
}

#endif
