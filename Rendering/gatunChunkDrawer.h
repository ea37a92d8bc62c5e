// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkDrawer_h
#define gatunChunkDrawer_h

#include "gatunChunkBuffers.h"
#include "gatunDetailSettings.h"
#include "gatunSurfacePreparer.h"
#include "gatunSurfaceTimes.h"
#include "gatunSurfaceView.h"

#include <cstdint>
#include <exception>
#include <span>
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkActor;
class vtkOpenGLPolyDataMapper;
class vtkRenderer;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** An image of a surface. */
struct SurfaceImage
{
  vtkOpenGLPolyDataMapper* Whole; ///< the mapper of the whole surface: its settings and progress
  vtkRenderer* Renderer;
  vtkActor* Actor;
  DetailSettings Detail;
  SurfaceView Camera;
  bool IsOpaque;
  bool IsSelection;
  std::uint64_t MemoryLimit; ///< for buffers, in bytes
  std::size_t Piece;         ///< of the chunks of each surface
  std::size_t Pieces;

  SurfaceImage(vtkOpenGLPolyDataMapper* whole, vtkRenderer* renderer, vtkActor* actor,
    const DetailSettings& detail, std::uint64_t memoryLimit);
};

/** The chunks of a surface that can be seen, in the order in which they are drawn. */
struct VisibleChunks
{
  std::vector<std::uint32_t> Chunks;
  std::uint64_t Cells = 0;  ///< of these
  std::uint64_t Culled = 0; ///< other chunks in the view, all of whose triangles are culled
};

/** Draws the chunks of surfaces, and decodes and transfers those that are missing: at once, or
 * before they are needed. Methods throw gatun::Error. */
class ChunkDrawer
{
public:
  ChunkBuffers Buffers;
  SurfaceTimes Times;

  /** Statistics of the last image, and of all images. */
  struct Counts
  {
    std::uint64_t Drawn = 0;
    std::uint64_t Culled = 0;
    std::uint64_t Merges = 0;  ///< of the surface
    std::uint64_t Decoded = 0; ///< of all images
  };

  /** Draws chunks of another file or with other arrays from now on. Box: of the whole surface;
   * scalars: the array that gives colors. */
  void SetContents(const Bounds& box, const std::string& scalars);

  /** Forgets failures and counts of the last image. */
  void Reset();

  void BeginFrame(const SurfaceImage& image);

  VisibleChunks FindVisible(const SurfaceImage& image, const ChunkedSurface& surface) const;

  /** Draws a surface. Chunks that cannot be decoded are left out, and are a failure. */
  void Draw(const SurfaceImage& image, ChunkedSurface& surface, const VisibleChunks& view);

  /** Draws a surface, and learns how long that takes. Level: for the times. */
  void DrawTimed(const SurfaceImage& image, ChunkedSurface& surface, const VisibleChunks& view,
    std::size_t level);

  /** Whether a surface can be drawn at once. */
  bool IsReady(
    const SurfaceImage& image, const ChunkedSurface& surface, const VisibleChunks& view) const;

  /** Takes chunks that the background thread has decoded, and has it decode the other ones. */
  void Prepare(
    const SurfaceImage& image, ChunkedSurface& surface, const std::vector<std::uint32_t>& chunks);

  /** Decodes the visible chunks that are missing now, as far as there is memory. An error is
   * reported by the image that needs the chunk. */
  void Complete(const SurfaceImage& image, ChunkedSurface& surface, const VisibleChunks& view);

  /** Makes buffers of visible chunks that are decoded, as far as there is time. */
  void Transfer(
    const SurfaceImage& image, ChunkedSurface& surface, const VisibleChunks& view, double seconds);

  /** Forgets what the background thread has decoded. */
  void ForgetPrepared() { this->Preparer.Clear(); }

  /** Waits for the background thread. */
  void Wait() { this->Preparer.Wait(); }

  /** The first failure of the last image; null if there was none. */
  const std::exception_ptr& GetFailure() const { return this->Failure; }
  void NoteFailure(const std::exception_ptr& failure);

  const Counts& GetCounts() const { return this->Numbers; }

private:
  std::vector<std::uint32_t> FindMissing(const SurfaceImage& image, const ChunkedSurface& surface,
    std::span<const std::uint32_t> chunks) const;
  std::vector<SurfacePart> DecodeAll(
    const ChunkedSurface& surface, std::span<const std::uint32_t> chunks, bool withIds);
  void Adopt(const SurfaceImage& image, ChunkedSurface& surface, std::uint32_t chunk,
    const SurfacePart& part);
  void DrawChunk(const SurfaceImage& image, ChunkedSurface& surface, std::uint32_t chunk,
    const SurfacePart* part);

  Bounds Box;
  std::string Scalars;
  Counts Numbers;
  std::exception_ptr Failure;
  int Waiting = 0; // images since a chunk was transferred
  SurfacePreparer Preparer;
};
}

#endif
