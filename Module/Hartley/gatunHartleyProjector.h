// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyProjector_h
#define gatunHartleyProjector_h

#include "gatunExport.h"
#include "gatunHartleyImage.h"
#include "gatunHartleyShading.h"
#include "gatunHartleySource.h"
#include "gatunHartleyView.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace gatun
{
/** Interpolation of spectra, for HartleyMethod::Slice. */
enum class HartleyKernel : std::uint8_t
{
  KaiserBessel = 0, ///< with corrected voxels; exact to about 1e-5
  Trilinear = 1     ///< as in Yang's dissertation, for comparison
};

struct HartleyOptions
{
  HartleyMethod Method = HartleyMethod::Automatic;
  HartleyKernel Kernel = HartleyKernel::KaiserBessel;

  /** Slice: size of a zero-padded block relative to the block, 1 to 8. */
  double Padding = 2;

  /** Upper bound of the memory that is kept from one image to the next, in bytes. It holds the
   * coefficients of chunks or, with the methods Slice and Voxels, the spectra or voxels of blocks.
   * Coefficients that the
   * source holds in memory anyway count but take no additional memory. The spectrum of the whole
   * volume, which X-rays use with the method Automatic, has a budget of the same size of its own.
   */
  std::uint64_t CacheBytes = std::uint64_t{ 512 } << 20;
};

/**
 * Draws a volume from its Hartley coefficients, block by block. A block is the sum
 * of the trilinear basis functions of its voxels. Neighboring blocks overlap by one voxel and add
 * up to the trilinearly interpolated volume. Sums along rays are line integrals of that volume, in
 * samples (HartleyView::Step).
 *
 * The mean density along the ray determines the color of a block and, in the model
 * TransferFunction, its opacity. In the model Exponential, the opacity of a block is exact at the
 * points of HartleyLattice, and interpolated between them.
 *
 * C. Yang: On-the-fly processing of compressed volume data, 2001, section 3.3, equations 6 to 10.
 *
 * An object keeps intermediate results for the next image. It draws one image at a time.
 */
class GATUN_EXPORT HartleyProjector
{
public:
  explicit HartleyProjector(
    std::shared_ptr<const HartleySource> source, const HartleyOptions& options = {});
  ~HartleyProjector();
  HartleyProjector(const HartleyProjector&) = delete;
  HartleyProjector& operator=(const HartleyProjector&) = delete;

  /** Parallel. Throws Error(InvalidInput) for views that have no pixels or whose vectors are not
   * finite or linearly dependent, Error(Aborted), and the errors of the source. */
  HartleyImage Draw(const HartleyView& view, const HartleyShading& shading,
    const std::function<bool(double)>& progress = {});

  /** The image of one block. */
  struct BlockImage
  {
    unsigned Width = 0;
    unsigned Height = 0;
    HartleyView View; ///< of its pixels, in index coordinates of the volume
    std::vector<float> Sums;
  };

  /** For studies: the image of each block of a chunk in the direction of a view, whose pixels are
   * not used. The base value is subtracted from the voxels. */
  std::vector<BlockImage> DrawBlocks(const HartleyView& view, std::size_t chunk);

private:
  struct Internals;
  class Drawing;
  std::unique_ptr<Internals> Data;
};
}

#endif
