// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes the golden files of volumes: makeGoldenVolumes FOLDER. What they hold is found out by
// Testing/Python/make_golden_volumes.py.

#include "gatunError.h"
#include "gatunHartleyFile.h"
#include "gatunHartleySample.h"

#include <iostream>

namespace
{
using namespace gatun;
using namespace gatun::test;
using Mode = HartleyRateMode;

struct Golden
{
  const char* Name;
  SampleVolume Volume;
  std::uint32_t BlockSize;
  HartleyRateControl RateControl;
};
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: makeGoldenVolumes FOLDER\n";
    return 1;
  }
  auto placed = MakePhantom({ 21, 18, 13 }, ScalarType::Int16);
  placed.Input.Name = "density";
  placed.Input.VTKType = 4;
  placed.Input.Origin = { 1, -2, 3.5 };
  placed.Input.Spacing = { 0.5, 0.25, 2 };
  placed.Input.Direction = { 0, 1, 0, -1, 0, 0, 0, 0, 1 };
  placed.Input.FirstIndex = { -4, 0, 7 };
  std::vector<Golden> all;
  all.push_back({ "one_voxel.ghv", MakePhantom({ 1, 1, 1 }, ScalarType::UInt8), 8, {} });
  all.push_back({ "small.ghv",
    MakeVolume({ 4, 2, 2 }, ScalarType::UInt8,
      [](auto x, auto y, auto z) { return 10 * x + 3 * y + 7 * z * z; }),
    2, { Mode::RMSError, 1, 0 } });
  all.push_back({ "quality.ghv", std::move(placed), 8, { Mode::Quality, 50, 1.5 } });
  all.push_back(
    { "blocks_of_2.ghv", MakePhantom({ 19, 23, 9 }, ScalarType::UInt8), 2, { Mode::PSNR, 40, 0 } });
  all.push_back({ "blocks_of_5.ghv", MakePhantom({ 70, 12, 11 }, ScalarType::UInt16), 5,
    { Mode::BitsPerVoxel, 3, 0 } });
  all.push_back({ "blocks_of_32.ghv", MakePhantom({ 40, 33, 32 }, ScalarType::Float32), 32,
    { Mode::PSNR, 30, 0 } });
  all.push_back(
    { "thin.ghv", MakePhantom({ 100, 1, 37 }, ScalarType::Int8), 64, { Mode::RMSError, 1, 0 } });
  all.push_back(
    { "whole.ghv", MakePhantom({ 31, 22, 17 }, ScalarType::UInt8), 0, { Mode::RMSError, 2, 0 } });
  all.push_back(
    { "segments.ghv", MakePhantom({ 72, 64, 60 }, ScalarType::UInt8), 0, { Mode::PSNR, 25, 0 } });
  all.push_back({ "lossless.ghv", MakePhantom({ 20, 17, 11 }, ScalarType::Int16), 8,
    { Mode::RMSError, 0, 0 } });
  all.push_back({ "lossless_spikes.ghv",
    MakeVolume({ 32, 32, 32 }, ScalarType::Int32,
      [](auto x, auto y, auto z)
      {
        return x == 5 && y == 9 ? 1000 * z
          : x == 7 && y == z    ? 2147483647.0
                                : 3.9 * (GetNoise(x, y, z) > 0.99);
      }),
    32, { Mode::RMSError, 0, 0 } });
  all.push_back({ "lossless_floats.ghv", MakePhantom({ 9, 10, 11 }, ScalarType::Float64), 4,
    { Mode::RMSError, 0, 0 } });
  all.push_back({ "constant.ghv",
    MakeVolume({ 20, 20, 20 }, ScalarType::UInt64, [](auto, auto, auto) { return 7; }), 8, {} });
  for (const auto& golden : all)
  {
    try
    {
      HartleyWriterOptions options;
      options.BlockSize = golden.BlockSize;
      options.RateControl = golden.RateControl;
      WriteHartleyFile(std::string(argv[1]) + "/" + golden.Name, golden.Volume.Input, options);
    }
    catch (const Error& error)
    {
      std::cerr << golden.Name << ": " << error.what() << "\n";
      return 1;
    }
  }
  return 0;
}
