// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyProjector_h
#define gatunHartleyProjector_h

#include "gatunHartleyShading.h"
#include "gatunHartleySource.h"
#include "gatunHartleyView.h"
#include "vtkGatunCoreModule.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gatun
{
/** By which way a block's picture is made of its coefficients. */
enum class HartleyMethod : std::uint8_t
{
  Automatic = 0, ///< Basis for blocks of up to 16 voxels along each axis, Slice for larger ones
  Basis = 1,     ///< the sum of the pictures of its basis functions, which all blocks share
  Slice = 2      ///< a slice through its spectrum, transformed back in two dimensions
};

/** How values between the points of a spectrum are found, for HartleyMethod::Slice. */
enum class HartleyKernel : std::uint8_t
{
  KaiserBessel = 0, ///< with voxels corrected beforehand; exact to about 1e-5
  Trilinear = 1     ///< as in Yang's dissertation, for comparison
};

struct HartleyOptions
{
  HartleyMethod Method = HartleyMethod::Automatic;
  HartleyKernel Kernel = HartleyKernel::KaiserBessel;

  /** Size of a block with the zeros around it, for spectra, in sizes of the block; 1 to 8. */
  double Padding = 2;

  /** How much memory may be kept from one picture to the next, in bytes: for the coefficients of
   * chunks that have been used, or, of slices, for spectra of blocks. What is in memory already, as
   * that of a HartleyVolume, counts as well but takes no more. */
  std::uint64_t CacheBytes = std::uint64_t{ 1 } << 30;
};

/** All arrays row after row, beginning with the row of HartleyView::Origin. */
struct HartleyPicture
{
  unsigned Width = 0;
  unsigned Height = 0;
  std::vector<std::array<float, 4>> Colours; ///< red, green, blue, times opacity; opacity
  std::vector<float> Sums;                   ///< of the densities along the ray; by XRay only
  std::vector<float> Samples;                ///< how many of them lie in the volume; by XRay only

  // What it took.
  std::uint64_t Terms = 0;  ///< coefficients that were added up
  std::uint64_t Blocks = 0; ///< that were drawn
  HartleyMethod Method = HartleyMethod::Basis;
};

/**
 * Draws a volume from its Hartley coefficients, without going back to voxels. Blocks are sums of
 * trilinear hats around their voxels, so that neighbours overlap by a voxel and add up to the
 * trilinear volume, without gaps; sums are line integrals of that, in samples (HartleyView::Step).
 * A block counts as if its mean density were everywhere in it, weighed by the part of the ray that
 * is in it; under HartleyLaw::Exponential its opacity is exact.
 *
 * C. Yang: On-the-fly processing of compressed volume data, 2001, section 3.3, equations 6 to 10.
 *
 * Keeps what can be used for the next picture; one picture at a time.
 */
class VTKGATUNCORE_EXPORT HartleyProjector
{
public:
  explicit HartleyProjector(
    std::shared_ptr<const HartleySource> source, const HartleyOptions& options = {});
  ~HartleyProjector();
  HartleyProjector(const HartleyProjector&) = delete;
  HartleyProjector& operator=(const HartleyProjector&) = delete;

  /** Parallel. Throws Error(InvalidInput) for views without pixels or with vectors that are not
   * finite or span no space, Error(Aborted), and what the source throws. */
  HartleyPicture Draw(const HartleyView& view, const HartleyShading& shading,
    const std::function<bool(double)>& progress = {});

  /** A block's picture by itself, at points of the plane of Sampling. */
  struct BlockPicture
  {
    unsigned Width = 0;
    unsigned Height = 0;
    HartleyView View; ///< of its pixels: index coordinates of the volume
    std::vector<float> Sums;
  };

  /** For studies: the picture of each block of a chunk, under the view's direction; the view's
   * pixels do not matter. Sums are those of the voxels less the base. */
  std::vector<BlockPicture> DrawBlocks(const HartleyView& view, std::size_t chunk);

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}

#endif
