// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnVolumeOptions.h"

#include "gtnParse.h"
#include "gtnText.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <limits>

namespace gtn
{
namespace
{

using Goal = gatun::HartleyQuality::Goal;

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
void AddCompression(CLI::App* command, CompressionOptions& options, const char* group)
{
  command
    ->add_option_function<std::string>(
      "--block", [&options](const std::string& text) { options.BlockSize = ParseBlock(text); },
      "Voxels of a block along each axis, 2 to 64, or whole: one block. Smaller ones are drawn "
      "with "
      "better opacities, larger ones take fewer bits")
    ->option_text("N|whole [8]")
    ->group(group);
  const auto add =
    [&](const char* name, Goal goal, double low, double high, const char* text, const char* value)
  {
    return command
      ->add_option_function<double>(
        name,
        [&options, goal](double number)
        {
          options.Quality.Kind = goal;
          options.Quality.Value = number;
        },
        text)
      ->check(Between(low, high))
      ->option_text(value)
      ->group(group);
  };
  const double most = std::numeric_limits<double>::max();
  const std::array goals{
    add("--quality", Goal::Quality, 1, 100,
      "How well to keep the values, 1 to 100: ten more make errors half as large", "Q [60]"),
    add("--error", Goal::Error, 0, most,
      "Root mean square error at most, in the unit of the values; 0: none, but for rounding", "E"),
    add("--psnr", Goal::PSNR, 1, 300,
      "Peak signal to noise ratio at least, in dB: 20 log10(range / root mean square error)", "DB"),
    add("--rate", Goal::Rate, 0.001, 64, "Bits a voxel of the whole file, within 1 %", "BITS")
  };
  for (std::size_t i = 0; i < goals.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      goals[i]->excludes(goals[j]);
    }
  }
  command
    ->add_option("--weight", options.Quality.FrequencyWeight,
      "How much coarser the highest frequencies are kept than the lowest, 0 (not at all) to 4")
    ->check(Between(0, 4))
    ->option_text("W [0]")
    ->group(group);
}

//------------------------------------------------------------------------------
const char* NameOf(Goal goal)
{
  constexpr std::array<const char*, 4> names{ "quality", "error", "psnr", "rate" };
  return names.at(static_cast<std::size_t>(goal));
}

//------------------------------------------------------------------------------
std::string Describe(const gatun::HartleyQuality& quality)
{
  const std::string weight = quality.FrequencyWeight > 0
    ? fmt::format(", frequency weight {:.4g}", quality.FrequencyWeight)
    : "";
  switch (quality.Kind)
  {
    case Goal::Error:
      return fmt::format("root mean square error {:.4g} at most{}", quality.Value, weight);
    case Goal::PSNR:
      return fmt::format("{:.4g} dB at least{}", quality.Value, weight);
    case Goal::Rate:
      return fmt::format("{:.4g} bits a voxel{}", quality.Value, weight);
    case Goal::Quality:
      break;
  }
  return fmt::format("quality {:.4g}{}", quality.Value, weight);
}

//------------------------------------------------------------------------------
std::string DescribeBlocks(const gatun::HartleyLayout& layout)
{
  const auto& block = layout.Block;
  const std::string size = fmt::format("{} x {} x {}", block[0], block[1], block[2]);
  return layout.IsWhole()
    ? fmt::format("one block of {} voxels", size)
    : fmt::format("{} blocks of {} voxels", Grouped(layout.GetNumberOfBlocks()), size);
}

//------------------------------------------------------------------------------
double PeakSignalToNoise(const gatun::Range& range, double rootMeanSquareError)
{
  return rootMeanSquareError > 0 ? 20 * std::log10((range.Max - range.Min) / rootMeanSquareError)
                                 : std::numeric_limits<double>::infinity();
}
}
