// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayCaster_h
#define gatunRayCaster_h

#include "gatunRayBlock.h"
#include "gatunRayShading.h"
#include "gatunRaySource.h"
#include "gatunRayTable.h"
#include "gatunRayView.h"
#include "vtkGatunCoreModule.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
struct RaySettings
{
  /** Where less light than this comes through, nothing behind is drawn; 0 to draw all. */
  float Opaque = 1e-3f;

  /** How lights fall on the volume; none: it looks as its colours say. Modes Composite and Area. */
  std::optional<RayShading> Shading = {};

  /** Whether rays may grow from their far ends too; see gatunRelease.h. */
  bool FromBothEnds = false;

  /** Whether tetrahedra between the rays, or between samples, are left out before their planes are
   * set up: the paper's pre-filter. It changes no picture. */
  bool Prefilter = true;

  /** Whether to use only instructions that every processor has. */
  bool Portable = false;

  /** Whether a tile of the picture comes out the same to the last bit whatever the others show, and
   * however many of them are drawn. Threads may have less to do at the same time. */
  bool Repeatable = false;

  bool operator==(const RaySettings&) const = default;
};

/** What has been done so far; times are of all threads together, in seconds. */
struct RayStatistics
{
  double FetchTime = 0;  ///< making or decoding blocks
  double OrderTime = 0;  ///< projecting and ordering tetrahedra
  double SetUpTime = 0;  ///< planes of their faces
  double DrawTime = 0;   ///< samples
  double FinishTime = 0; ///< fragments into pixels
  std::uint64_t Tets = 0;
  std::uint64_t SeenTets = 0;      ///< those that may own a sample
  std::uint64_t Blocks = 0;        ///< drawn
  std::uint64_t SkippedBlocks = 0; ///< outside, transparent or hidden: never fetched
  std::uint64_t MostWaiting = 0;   ///< tetrahedra that waited for others, in one block
  std::uint64_t MostFragments = 0; ///< in all pixels together, before pictures were finished
  std::uint64_t MostBytes = 0;     ///< of picture and blocks at work, without those of the source
};

/**
 * Casts rays through tetrahedra, block by block in any order (front to back is fastest), into one
 * picture. The picture is the same up to rounding for any order, any blocks, any number of threads.
 *
 * What is summed up for a pixel is kept in fragments, each of samples that follow each other; two
 * are merged when one ends where the other begins. Memory: about 75 bytes a pixel that is reached,
 * and 300 bytes a tetrahedron of the blocks that are at work, one for each thread.
 *
 * Methods throw Error(Aborted) when progress says so, after which only Finish makes sense.
 *
 * Based on: Yang, Mitra, Chiueh: On-the-fly rendering of losslessly compressed irregular volume
 * data. IEEE Visualization 2000.
 */
class VTKGATUNCORE_EXPORT RayCaster
{
public:
  using Progress = RaySource::Progress;

  /** Limits: see RayLimits; may be empty. */
  RayCaster(const RayView& view, RayTable table, const RayLimits& limits = {},
    const RaySettings& settings = {});
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /** Draws all blocks of a source that can be seen, front to back. */
  void Draw(RaySource& source, const Progress& progress = {});

  /** Draws some blocks. */
  void Draw(std::span<const std::shared_ptr<const RayBlock>> blocks);

  /** Pictures are drawn in squares of 16 by 16 pixels, row by row from below. */
  std::size_t GetNumberOfTiles() const;

  /**
   * Of each tile, a number that stands for all that decides what it shows: the tetrahedra that
   * reach it and the order in which they are drawn. With the same view, table, limits and settings,
   * and Repeatable, tiles with equal numbers look the same to the last bit. (Different ones come
   * out equal with a probability of 1 in 2^64.) Makes all blocks that are in the picture, and
   * orders them, but draws nothing.
   */
  std::vector<std::uint64_t> GetFingerprints(RaySource& source, const Progress& progress = {});

  /** Before anything is drawn: leaves out all tiles for which this is 0, also when finishing. */
  void Restrict(std::span<const std::uint8_t> tiles);

  /** Whether nothing with such values in a box could be seen, as far as is known now. */
  bool IsHidden(const Bounds& box, const Range& values) const;

  /**
   * Writes the picture, as far as it is not restricted: for each pixel, row by row from below, red,
   * green, blue (with opacity multiplied in) and opacity; and, if depth is not null, how far the
   * first sample is that can be seen, in world units as samples are measured, or infinity. (Mode
   * Maximum and XRay: infinity.)
   */
  void Finish(float* rgba, float* depth = nullptr);

  RayStatistics GetStatistics() const;

  /** The set of instructions in use, as "AVX2". */
  const char* GetInstructions() const;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
