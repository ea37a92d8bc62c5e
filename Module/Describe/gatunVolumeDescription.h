// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunVolumeDescription_h
#define gatunVolumeDescription_h

#include "gatunDescription.h"
#include "gatunHartleyVolume.h"

#include <array>
#include <cstdint>
#include <string>

namespace gatun
{
class HartleyFile;

/** What is in a .ghv file, from its directory alone. IsVerified: says so. Verbose: also each
 * chunk. */
GATUN_EXPORT Description DescribeVolume(const HartleyFile& file, bool isVerified, bool verbose);

/** "16 x 16 x 8". */
GATUN_EXPORT std::string DescribeVoxels(const std::array<std::uint32_t, 3>& size);

/** As in JSON: "quality", "rmsError", "psnr", "bitsPerVoxel". */
GATUN_EXPORT const char* NameOfRateMode(HartleyRateMode mode);

/** "quality 60". */
GATUN_EXPORT std::string DescribeRate(const HartleyRateControl& control);

/** "512 blocks of 8 x 8 x 8 voxels". */
GATUN_EXPORT std::string DescribeVolumeBlocks(const HartleyLayout& layout);

/** Peak signal to noise ratio, in dB; infinite without an error. */
GATUN_EXPORT double ComputePeakSignalToNoise(const Range& range, double rootMeanSquareError);
}

#endif
