// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnVolumeOptions_h
#define gtnVolumeOptions_h

// Options of the compression of volumes.

#include "gtnCommandLine.h"

#include "gatunHartleyVolume.h"

#include <string>

namespace gtn
{
struct CompressionOptions
{
  int BlockSize = 8; ///< 0: whole
  gatun::HartleyRateControl RateControl;

  /** Sets the properties of a vtkGatunHartleyWriter or a vtkGatunHartleyEncoder. */
  template <typename Algorithm>
  void Apply(Algorithm* algorithm) const
  {
    using Mode = gatun::HartleyRateMode;
    algorithm->SetBlockSize(this->BlockSize);
    algorithm->SetRateControl(static_cast<int>(this->RateControl.Mode));
    switch (this->RateControl.Mode)
    {
      case Mode::Quality:
        algorithm->SetQuality(this->RateControl.Value);
        break;
      case Mode::RMSError:
        algorithm->SetRMSError(this->RateControl.Value);
        break;
      case Mode::PSNR:
        algorithm->SetPSNR(this->RateControl.Value);
        break;
      case Mode::BitsPerVoxel:
        algorithm->SetBitsPerVoxel(this->RateControl.Value);
        break;
    }
    algorithm->SetFrequencyWeight(this->RateControl.FrequencyWeight);
  }
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
