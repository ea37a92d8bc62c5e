// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkBuffers_h
#define gatunChunkBuffers_h

#include "gatunSurfaceLevel.h"
#include "vtkGatunChunkMapper.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkWindow;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** A chunk of a surface, and what is kept to draw it. */
struct SurfaceChunk
{
  vtkSmartPointer<vtkGatunChunkMapper> Mapper; ///< null if nothing is kept
  std::uint64_t Bytes = 0;
  std::uint64_t Frame = 0; ///< in which it was seen last
  NormalCone Cone;
  bool IsTransferred = false; ///< whether there are buffers
};

/** The surface, or one of its levels of detail. */
struct ChunkedSurface
{
  std::shared_ptr<const SurfaceLevel> Mesh;
  std::vector<SurfaceChunk> Chunks;
};

/** The chunks of surfaces, whose buffers are kept within a limit of memory. Buffers belong to a
 * window. */
class ChunkBuffers
{
public:
  /** Adds a surface without buffers. */
  ChunkedSurface* Add(std::shared_ptr<const SurfaceLevel> mesh);

  /** Removes a surface that was added, and frees its chunks. Null: does nothing. */
  void Remove(ChunkedSurface* surface);

  /** Removes a surface that another one replaces, which takes its chunks but for those that change.
   * Before: null for none. Changes: nothing if all chunks may. */
  void Replace(ChunkedSurface* before, ChunkedSurface& after,
    const std::optional<std::vector<std::uint32_t>>& changes);

  /** Begins an image. Frees the chunks of another window. Limit: in bytes. */
  void BeginFrame(vtkWindow* window, std::uint64_t limit);

  /** The number of the present image. */
  std::uint64_t GetFrame() const { return this->Frame; }

  /** Bytes of all chunks. */
  std::uint64_t GetBytes() const { return this->Bytes; }

  /** Takes a mapper for a chunk, in place of what was kept. */
  void Adopt(SurfaceChunk& chunk, vtkGatunChunkMapper* mapper);

  /** Counts the memory of a chunk that was made for this image, and frees what is too much: its
   * mesh beyond a quarter of the limit, and chunks beyond the limit. */
  void Keep(SurfaceChunk& chunk);

  /** Frees chunks that are not in this image, those not seen for the longest time first, and then
   * the last one that was drawn. Last: null for none. */
  void MakeRoom(SurfaceChunk* last);

  /** Frees a chunk. */
  void Drop(SurfaceChunk& chunk);

  /** Frees all chunks. */
  void DropAll();

  /** Frees all chunks and what they have in a window. */
  void Release(vtkWindow* window);

private:
  std::list<ChunkedSurface> Surfaces;
  std::uint64_t Bytes = 0;
  std::uint64_t Limit = 0;
  std::uint64_t Frame = 0;
  vtkWindow* Window = nullptr; // only compared
};
}

#endif
