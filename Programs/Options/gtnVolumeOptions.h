// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnVolumeOptions_h
#define gtnVolumeOptions_h

// Options of the compression of volumes.

#include "gtnCommandLine.h"

#include "gatunHartleyVolume.h"

#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkGatunHartleyEncoding;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gtn
{
struct CompressionOptions
{
  int BlockSize = 8; ///< 0: whole
  gatun::HartleyRateControl RateControl;

  void Apply(vtkGatunHartleyEncoding* encoding) const;
};

/** --block, --quality, --rms-error, --psnr, --bits-per-voxel and --weight. */
void AddCompression(CLI::App* command, CompressionOptions& options, const char* group);

/** "quality 60". */
std::string Describe(const gatun::HartleyRateControl& control);

/** As in JSON: "quality", "rmsError", "psnr", "bitsPerVoxel". */
const char* NameOf(gatun::HartleyRateMode mode);

/** "512 blocks of 8 x 8 x 8 voxels". */
std::string DescribeBlocks(const gatun::HartleyLayout& layout);

/** Peak signal to noise ratio, in dB; infinite without an error. */
double PeakSignalToNoise(const gatun::Range& range, double rootMeanSquareError);
}

#endif
