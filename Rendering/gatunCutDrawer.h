// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCutDrawer_h
#define gatunCutDrawer_h

#include "gatunChunkDrawer.h"
#include "gatunLevelDrawer.h"
#include "gatunSurfaceCutter.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace gatun
{
/** Draws surfaces that are finer where the view needs it: in motion, or within an error in pixels.
 */
class CutDrawer
{
public:
  explicit CutDrawer(ChunkDrawer& chunks)
    : Chunks(chunks)
  {
  }

  void Clear();

  /** The surface has another number of merges. */
  void SetSurface(const DrawnSurface& surface);

  /** Requests a surface for the view of an image, with as many points as there is time for. */
  void Request(const SurfaceImage& image, double budget);

  /** Draws the surface for a view that is there, and makes the next one ready. Returns false if
   * there is none, or if it takes too long and longer than what is drawn otherwise. Otherwise: the
   * seconds of that. IsReady: whether that is as good as it can be. */
  bool DrawInMotion(const SurfaceImage& image, double budget, double otherwise, bool isReady);

  /** Draws the surface with the error in pixels that is allowed. Returns false if all of it has to
   * be drawn, as there is no room for what it would be made of. */
  bool DrawPrecise(const SurfaceImage& image);

  /** Whether a surface for the view waits for its chunks. */
  bool IsAdvancing() const { return this->Next.Mesh != nullptr; }

  /** Waits for the background thread. */
  void Wait() { this->Cutter.Wait(); }

private:
  /** A surface for a view. */
  struct Cut
  {
    std::shared_ptr<const SurfaceLevel> Mesh; // null for none
    ChunkedSurface* Chunks = nullptr;
    std::optional<std::vector<std::uint32_t>> Changes; // since the one before; nothing: all chunks
  };

  bool CanCut(const SurfaceImage& image) const;
  std::optional<SurfaceCutOrder> MakeOrder(const SurfaceImage& image) const;
  std::uint64_t CountPoints(double budget);
  void SetNext(std::shared_ptr<const SurfaceLevel> mesh);
  void Take();
  std::vector<std::uint32_t> ListNeeded() const;
  void Advance(const SurfaceImage& image, double seconds);
  void Adopt();
  void Drop(Cut& cut);

  ChunkDrawer& Chunks;
  DrawnSurface Surface;
  Cut Present;                              // that was drawn last
  Cut Next;                                 // takes its place once its visible chunks are there
  std::uint64_t Points = 0;                 // of the last order
  std::optional<SurfaceDetailView> Ordered; // the view of the last order
  bool HasFailed = false;
  SurfaceCutter Cutter;
};
}

#endif
