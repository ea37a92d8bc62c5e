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

  /** Whether nothing with such values in a box could be seen, as far as is known now. */
  bool IsHidden(const Bounds& box, const Range& values) const;

  /**
   * Writes the picture: for each pixel, row by row from below, red, green, blue (with opacity
   * multiplied in) and opacity; and, if depth is not null, how far the first sample is that can be
   * seen, in world units as samples are measured, or infinity. (Mode Maximum and XRay: infinity.)
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
