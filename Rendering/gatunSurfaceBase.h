// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceBase_h
#define gatunSurfaceBase_h

#include "gatunPublishedFile.h"
#include "gatunSurfaceDetail.h"
#include "gatunSurfaceMesh.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The cells that a cut leaves of a block. */
struct SurfaceBlock
{
  std::vector<std::uint32_t> Cells;   ///< by their numbers in the base mesh
  std::vector<std::uint32_t> Corners; ///< of all of them, one after the other
  Bounds Box;
};

/**
 * A base mesh of a file, or all of the surface, in memory, of which cuts are made. Its cells are
 * divided into blocks, which are the chunks of the cuts. Const methods are thread safe. Methods
 * throw Error.
 */
class SurfaceBase
{
public:
  /** Merges: those that lead to the base mesh; 0 for all of the surface. If progress returns false,
   * Error(Aborted) is thrown. */
  SurfaceBase(PublishedFile source, std::size_t merges, SurfaceContents what,
    const SurfaceMesh::Progress& progress);
  ~SurfaceBase();
  SurfaceBase(const SurfaceBase&) = delete;
  SurfaceBase& operator=(const SurfaceBase&) = delete;

  /** The memory of a base mesh with so many points, approximately. */
  static std::uint64_t EstimateBytes(std::uint64_t points);

  const PublishedFile& GetSource() const { return this->Source; }
  const SurfaceContents& GetContents() const { return this->What; }
  std::size_t GetMerges() const { return this->Merges; }
  const SurfaceDetail& GetDetail() const { return *this->Detail; }
  std::size_t GetNumberOfBlocks() const { return this->Starts.size() - 1; }

  /** Whether a point of a block is among marked ones. */
  bool Touches(std::size_t block, const std::vector<bool>& isMarked) const;

  /** What is left of a block if its points are replaced. */
  SurfaceBlock Simplify(std::size_t block, std::span<const std::uint32_t> ancestors) const;

  /** The mesh of a block, with the arrays that are drawn. */
  vtkSmartPointer<vtkPolyData> MakeMesh(const SurfaceBlock& block) const;

private:
  void Read(const SurfaceMesh::Progress& progress);
  void Divide(std::span<const SurfaceDetail::Point> places);
  std::span<const std::uint32_t> GetCorners(std::size_t cell) const;

  PublishedFile Source;
  std::size_t Merges;
  SurfaceContents What;
  vtkSmartPointer<vtkUnstructuredGrid> Grid; // points and arrays
  std::vector<std::uint8_t> Types;           // of cells
  std::vector<std::uint32_t> Corners;        // of cells, one after the other
  std::vector<std::uint32_t> Begins;         // in these
  std::vector<std::uint32_t> Order;          // cells, block after block
  std::vector<std::size_t> Starts;           // of blocks in these, and the end
  std::unique_ptr<const SurfaceDetail> Detail;
};
}

#endif
