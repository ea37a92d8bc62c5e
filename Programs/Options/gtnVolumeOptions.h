// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnVolumeOptions_h
#define gtnVolumeOptions_h

// How volumes are compressed.

#include "gatunHartleyVolume.h"

#include <CLI/CLI.hpp>

#include <string>

namespace gtn
{
struct CompressionOptions
{
  int BlockSize = 8; ///< 0: whole
  gatun::HartleyQuality Quality;

  /** Applies them to a vtkHartleyVolumeWriter or a vtkHartleyProjection. */
  template <typename Algorithm>
  void Apply(Algorithm* algorithm) const
  {
    using Goal = gatun::HartleyQuality::Goal;
    algorithm->SetBlockSize(this->BlockSize);
    algorithm->SetGoal(static_cast<int>(this->Quality.Kind));
    switch (this->Quality.Kind)
    {
      case Goal::Quality:
        algorithm->SetQuality(this->Quality.Value);
        break;
      case Goal::Error:
        algorithm->SetMaximumError(this->Quality.Value);
        break;
      case Goal::PSNR:
        algorithm->SetPSNR(this->Quality.Value);
        break;
      case Goal::Rate:
        algorithm->SetRate(this->Quality.Value);
        break;
    }
    algorithm->SetFrequencyWeight(this->Quality.FrequencyWeight);
  }
};

/** --block, --quality, --error, --psnr, --rate and --weight. */
void AddCompression(CLI::App* command, CompressionOptions& options, const char* group);

/** "quality 60". */
std::string Describe(const gatun::HartleyQuality& quality);

/** As in JSON: "quality", "error", "psnr", "rate". */
const char* NameOf(gatun::HartleyQuality::Goal goal);

/** "blocks of 8 x 8 x 8 voxels", or that the whole volume is one. */
std::string DescribeBlocks(const gatun::HartleyLayout& layout);

/** Peak signal to noise ratio, in dB; infinite without an error. */
double PeakSignalToNoise(const gatun::Range& range, double rootMeanSquareError);
}

#endif
