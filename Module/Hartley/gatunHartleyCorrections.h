// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyCorrections_h
#define gatunHartleyCorrections_h

// Lossless volumes of integers: corrections of the voxels whose rounded value is wrong or
// uncertain. The values of all other voxels are far enough from a rounding boundary that the order
// of additions does not matter.

#include "gatunBytes.h"
#include "gatunEntropy.h"
#include "gatunHartleyInput.h"
#include "gatunHartleyLayout.h"
#include "gatunHartleyQuantizer.h"

#include <array>
#include <cstdint>
#include <span>

namespace gatun
{
/** The largest range of voxels for which double precision suffices. */
constexpr double LargestLosslessRange = 1ull << 40;

Bytes EncodeHartleyCorrections(const VolumeInput& input, const HartleyLayout& layout,
  std::size_t chunk, const HartleyQuantizer& quantizer, const Range& range,
  std::span<const std::int64_t> integers);

/** Probabilities of corrections. */
struct HartleyCorrectionModels
{
  std::array<BitModel, 4> Wrong; ///< by the state of the last two voxels
  BitModel Far;
  BitModel Farther;
  unsigned Recent = 0;
};

/** Decodes the corrections of a chunk, block by block. */
class HartleyCorrector
{
public:
  /** Range: that of the voxels. Safe on hostile input. */
  HartleyCorrector(
    std::span<const std::uint8_t> stream, const HartleyLayout& layout, const Range& range);

  /** Replaces the values of a block, minus the base, by those of the voxels. Blocks must be given
   * in order; blocks without values are skipped. */
  void Correct(const HartleyLayout::Triple& place, std::span<double> values);

private:
  EntropyDecoder Coder;
  HartleyCorrectionModels Models;
  const HartleyLayout& Layout;
  double Length;
};
}

#endif
