// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceMesh_h
#define gatunSurfaceMesh_h

#include "gatunSurfaceView.h"
#include "gatunTypes.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
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

/** A surface of a file, or a simpler one, in chunks that are drawn apart. Const methods are thread
 * safe. */
class SurfaceMesh
{
public:
  using Progress = std::function<bool(double)>;

  SurfaceMesh() = default;
  virtual ~SurfaceMesh() = default;
  SurfaceMesh(const SurfaceMesh&) = delete;
  SurfaceMesh& operator=(const SurfaceMesh&) = delete;

  /** The number of merges that lead to it. */
  virtual std::size_t GetMerges() const = 0;

  virtual std::size_t GetNumberOfChunks() const = 0;

  /** The bounds of a chunk. */
  virtual const Bounds& GetBox(std::size_t chunk) const = 0;

  /** Cells of a chunk, exact or estimated. */
  virtual std::uint64_t GetNumberOfCells(std::size_t chunk) const = 0;

  /** Decodes a chunk; an error is part of the result. WithIds: whether the mesh gets the numbers of
   * points and cells within the surface, if it is not simplified. If progress returns false, the
   * error is Aborted. */
  virtual SurfacePart Decode(std::uint32_t chunk, bool withIds, const Progress& progress) const = 0;
};
}

#endif
