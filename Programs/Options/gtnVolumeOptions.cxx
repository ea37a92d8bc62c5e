// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnVolumeOptions.h"

#include "gtnParse.h"

#include "gatunVolumeDescription.h"
#include "vtkGatunHartleyEncoding.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <array>
#include <limits>

namespace gtn
{
namespace
{

using Mode = gatun::HartleyRateMode;

int ParseBlock(const std::string& text)
{
  const int size = text == "whole" ? 0 : Parse<int>(text).value_or(-1);
  const auto least = static_cast<int>(gatun::HartleyLayout::SmallestBlock);
  const auto most = static_cast<int>(gatun::HartleyLayout::LargestBlock);
  if (text != "whole" && (size < least || size > most))
  {
    Refuse("--block", text, fmt::format("a number from {} to {}, or whole", least, most));
  }
  return size;
}

} // anonymous namespace

//------------------------------------------------------------------------------
void CompressionOptions::Apply(vtkGatunHartleyEncoding* encoding) const
{
  using Mode = gatun::HartleyRateMode;
  encoding->SetBlockSize(this->BlockSize);
  encoding->SetRateControl(static_cast<int>(this->RateControl.Mode));
  switch (this->RateControl.Mode)
  {
    case Mode::Quality:
      encoding->SetQuality(this->RateControl.Value);
      break;
    case Mode::RMSError:
      encoding->SetRMSError(this->RateControl.Value);
      break;
    case Mode::PSNR:
      encoding->SetPSNR(this->RateControl.Value);
      break;
    case Mode::BitsPerVoxel:
      encoding->SetBitsPerVoxel(this->RateControl.Value);
      break;
  }
  encoding->SetFrequencyWeight(this->RateControl.FrequencyWeight);
}

//------------------------------------------------------------------------------
void AddCompression(CLI::App* command, CompressionOptions& options, const char* group)
{
  command
    ->add_option_function<std::string>(
      "--block", [&options](const std::string& text) { options.BlockSize = ParseBlock(text); },
      "Voxels of a block along each axis, 2 to 64, or whole: one block. Small blocks give more "
      "accurate opacities, large blocks need fewer bits")
    ->option_text("N|whole [8]")
    ->group(group);
  const auto add =
    [&](const char* name, Mode mode, double low, double high, const char* text, const char* value)
  {
    return command
      ->add_option_function<double>(
        name,
        [&options, mode](double number)
        {
          options.RateControl.Mode = mode;
          options.RateControl.Value = number;
        },
        text)
      ->check(Between(low, high))
      ->option_text(value)
      ->group(group);
  };
  const double most = std::numeric_limits<double>::max();
  const std::array modes{ add("--quality", Mode::Quality, 1, 100,
                            "Quality, 1 to 100: an increase of 10 halves the quantizer's step",
                            "Q [60]"),
    add("--rms-error", Mode::RMSError, 0, most,
      "Upper bound of the root mean square error, in the unit of the values; 0: integers "
      "lossless, floating-point values up to rounding",
      "E"),
    add("--psnr", Mode::PSNR, 1, 200,
      "Lower bound of the peak signal-to-noise ratio, in dB: 20 log10(range / root mean square "
      "error)",
      "DB"),
    add("--bits-per-voxel", Mode::BitsPerVoxel, 0.001, 64,
      "Size of the file in bits per voxel, within 1 %", "BITS") };
  for (std::size_t i = 0; i < modes.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      modes[i]->excludes(modes[j]);
    }
  }
  command
    ->add_option("--weight", options.RateControl.FrequencyWeight,
      "How much coarser the highest frequencies are quantized than the lowest, 0 (not at all) to 4")
    ->check(Between(0, 4))
    ->option_text("W [0]")
    ->group(group);
}

//------------------------------------------------------------------------------
const char* NameOf(Mode mode)
{
  return gatun::NameOfRateMode(mode);
}

//------------------------------------------------------------------------------
std::string Describe(const gatun::HartleyRateControl& control)
{
  return gatun::DescribeRate(control);
}

//------------------------------------------------------------------------------
std::string DescribeBlocks(const gatun::HartleyLayout& layout)
{
  return gatun::DescribeVolumeBlocks(layout);
}

//------------------------------------------------------------------------------
double PeakSignalToNoise(const gatun::Range& range, double rootMeanSquareError)
{
  return gatun::ComputePeakSignalToNoise(range, rootMeanSquareError);
}
}
