// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunLevelDrawer_h
#define gatunLevelDrawer_h

#include "gatunChunkDrawer.h"
#include "gatunPublishedFile.h"
#include "gatunSurfaceLevel.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace gatun
{
/** The surface of a file that is drawn at rest. */
struct DrawnSurface
{
  PublishedFile Source; ///< without a file if none is drawn
  SurfaceContents What;
  std::shared_ptr<const SurfaceLevel> Mesh;
};

/** Levels of detail of an image in motion, both -1 at rest. */
struct LevelChoice
{
  int Wanted = -1;
  int Shown = -1; ///< until that is ready
};

/** Draws the whole surface, or in motion one of its levels of detail: the base meshes of the file,
 * and halves beyond. */
class LevelDrawer
{
public:
  /** What an image in motion can draw. */
  struct Plan
  {
    std::vector<VisibleChunks> Views; ///< of all levels
    std::size_t Wanted = 0;
    std::size_t Shown = 0; ///< the finest level that is ready
    double Seconds = 0;    ///< the expected time of that
  };

  explicit LevelDrawer(ChunkDrawer& chunks)
    : Chunks(chunks)
  {
  }

  bool IsEmpty() const { return this->Levels.empty(); }
  ChunkedSurface& GetWhole() { return *this->Levels.front(); }

  void Clear();

  /** Draws the surface after another number of merges. Chunks that do not change stay. */
  void SetSurface(const DrawnSurface& surface);

  /** Draws the whole surface. Returns whether it was drawn completely, and images in motion are
   * simplified; then learns how long it takes. */
  bool DrawWhole(const SurfaceImage& image);

  /** Makes ready what the first image in motion is likely to need. Returns whether it is likely to
   * be a coarser level than the whole surface. */
  bool PrepareMotion(const SurfaceImage& image);

  Plan MakePlan(const SurfaceImage& image, double budget);

  /** Draws the level of a plan. Advances: whether what is wanted is made ready first. */
  void DrawInMotion(const SurfaceImage& image, const Plan& plan, bool advances);

  /** The level that would be chosen for the next image, of several processes. */
  LevelChoice Propose(const SurfaceImage& image, double budget);

  /** Draws the level that all processes draw, and makes ready the one that they want. */
  void DrawShared(const SurfaceImage& image, const LevelChoice& choice);

  /** The last image was no level. */
  void NoteOther() { this->Present = this->Levels.size(); }

  /** The budget of the last image in motion. */
  double GetMotionBudget() const { return this->MotionBudget; }

private:
  void FindLevels();
  std::vector<std::uint32_t> ListLikely(
    const ChunkedSurface& level, const VisibleChunks& view) const;
  std::vector<VisibleChunks> FindAllVisible(const SurfaceImage& image) const;
  std::size_t FindReady(
    const SurfaceImage& image, const std::vector<VisibleChunks>& views, std::size_t from) const;
  void Advance(const SurfaceImage& image, std::size_t wanted, const VisibleChunks& view,
    std::size_t shown, std::uint64_t cells);
  void DrawLevel(const SurfaceImage& image, std::size_t level, const VisibleChunks& view);

  ChunkDrawer& Chunks;
  DrawnSurface Surface;
  std::vector<ChunkedSurface*> Levels; // the surface, then those in motion from fine to coarse
  bool HasLevels = false;              // whether the levels in motion are known
  std::size_t Present = 0;             // level of the last image
  double MotionBudget = 0.1;
};
}

#endif
