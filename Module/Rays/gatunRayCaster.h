// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayCaster_h
#define gatunRayCaster_h

#include "gatunExport.h"
#include "gatunRayBlock.h"
#include "gatunRayInstructions.h"
#include "gatunRayShading.h"
#include "gatunRaySource.h"
#include "gatunRayTable.h"
#include "gatunRayView.h"

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
  /** Early ray termination: nothing is drawn behind a transmittance below this; 0 draws all. */
  float Opaque = 1e-3f;

  /** Shading in modes Composite and Sampled, or none. */
  std::optional<RayShading> Shading = {};

  /** Whether rays may also grow from their far ends; see gatunRelease.h. */
  bool FromBothEnds = false;

  /** Whether to skip tetrahedra between the rays, or in mode Sampled between samples, before their
   * planes are set up: the paper's pre-filter. It does not change the image. */
  bool Prefilter = true;

  /** The instruction set, or the next simpler one that this processor has. */
  RayInstructions Instructions = RayInstructions::Best;

  /** Whether a tile of the image is the same to the last bit whatever other tiles show, and whether
   * they are drawn or not. May leave threads idle. */
  bool Repeatable = false;

  bool operator==(const RaySettings&) const = default;
};

/** Statistics of an image. Times are sums over all threads, in seconds. */
struct RayStatistics
{
  double FetchTime = 0;    ///< making or decoding blocks
  double SimplifyTime = 0; ///< of FetchTime: merging points
  double OrderTime = 0;    ///< projecting and ordering tetrahedra
  double SetUpTime = 0;    ///< planes of their faces
  double DrawTime = 0;     ///< integrals along rays
  double FinishTime = 0;   ///< fragments into pixels
  std::uint64_t Tets = 0;
  std::uint64_t SeenTets = 0;      ///< tetrahedra that may be on a ray, or contain a sample
  std::uint64_t Blocks = 0;        ///< drawn
  std::uint64_t SkippedBlocks = 0; ///< never fetched: outside, transparent or hidden
  std::uint64_t MostWaiting = 0; ///< maximum number of tetrahedra of a block that waited for others
  std::uint64_t MostFragments = 0; ///< maximum sum over all pixels, before the image was finished
  std::uint64_t MostBytes = 0; ///< maximum memory of image and blocks in use, without the source
};

/**
 * Casts rays through tetrahedra, block by block in any order (front to back is fastest), into one
 * image. Up to rounding, the image depends neither on the order nor on the blocks nor on the number
 * of threads.
 *
 * The sums of a pixel are in fragments, segments of its ray. Two fragments are merged when one
 * ends where the other begins. Memory: about 75 bytes for each pixel that is reached, and 300 bytes
 * for each tetrahedron of the blocks in use, one block for each thread.
 *
 * Methods throw Error(Aborted) when progress returns false. After that, only Finish may be called.
 *
 * Based on: Yang, Mitra, Chiueh: On-the-fly rendering of losslessly compressed irregular volume
 * data. IEEE Visualization 2000.
 */
class GATUN_EXPORT RayCaster
{
public:
  using Progress = RaySource::Progress;

  /** Limits may be empty. */
  RayCaster(const RayView& view, RayTable table, const RayLimits& limits = {},
    const RaySettings& settings = {});
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /** Draws all visible blocks of a source, front to back. */
  void Draw(RaySource& source, const Progress& progress = {});

  /** Draws the given blocks. */
  void Draw(std::span<const std::shared_ptr<const RayBlock>> blocks);

  /** The image is divided into tiles of 32 by 32 pixels, row by row from below. */
  std::size_t GetNumberOfTiles() const;

  /**
   * Returns a fingerprint of each tile: a hash of the tetrahedra that reach it and of their order.
   * With the same view, table, limits and settings, and Repeatable, tiles with equal fingerprints
   * are the same to the last bit. (The probability that different tiles have equal fingerprints is
   * 1 in 2^64.) Makes and orders all blocks of the image, but draws nothing.
   */
  std::vector<std::uint64_t> GetFingerprints(RaySource& source, const Progress& progress = {});

  /** Leaves out the tiles whose element is 0, also in Finish. Call this before drawing. */
  void Restrict(std::span<const std::uint8_t> tiles);

  /**
   * Writes the image, except for tiles that Restrict left out: for each pixel, row by row from
   * below, red, green, blue (premultiplied by opacity) and opacity. If depth is not null, it gets
   * the distance at which the first visible segment begins, or that of the first visible sample, in
   * world units and measured as sample distances are, or infinity. In modes Maximum and XRay it is
   * always infinity.
   */
  void Finish(float* rgba, float* depth = nullptr);

  /** Returns the fragments of some tiles for RayMerger, in this process or in another one, and
   * frees them: Finish finds nothing in these tiles. WithDepths: whether it will be asked for
   * depths. */
  std::vector<std::uint8_t> TakeFragments(
    std::span<const std::size_t> tiles, bool withDepths = false);

  RayStatistics GetStatistics() const;

  /** The instruction set in use, such as "AVX2". */
  const char* GetInstructions() const;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
