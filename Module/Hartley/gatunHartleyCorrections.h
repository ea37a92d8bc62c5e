// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyCorrections_h
#define gatunHartleyCorrections_h

// What makes a volume of integers lossless: voxels that are not what rounding gives. All other
// voxels are so far from where rounding would change that it does not matter in which order a
// machine adds.

#include "gatunBytes.h"
#include "gatunEntropy.h"
#include "gatunHartleyInput.h"
#include "gatunHartleyLayout.h"
#include "gatunHartleyQuantiser.h"

#include <array>
#include <cstdint>
#include <span>

namespace gatun
{
/** The largest range of voxels for which double precision leaves no doubt. */
constexpr double LargestLosslessRange = 1ull << 40;

Bytes EncodeHartleyCorrections(const VolumeInput& input, const HartleyLayout& layout,
  std::size_t chunk, const HartleyQuantiser& quantiser, const Range& range,
  std::span<const std::int64_t> integers);

/** How likely voxels are wrong. */
struct HartleyCorrectionModels
{
  std::array<BitModel, 4> Wrong; ///< by which of the last two were
  BitModel Far;
  BitModel Farther;
  unsigned Recent = 0;
};

/** Reads the corrections of a chunk, which come block by block. */
class HartleyCorrector
{
public:
  /** Range: of the voxels. */
  HartleyCorrector(
    std::span<const std::uint8_t> stream, const HartleyLayout& layout, const Range& range);

  /** Makes the values of a block, less the base, what the voxels are. Blocks must come in their
   * order; without values they are passed over. */
  void Correct(const HartleyLayout::Triple& place, std::span<double> values);

private:
  EntropyDecoder Coder;
  HartleyCorrectionModels Models;
  const HartleyLayout& Layout;
  double Length;
};
}

#endif
