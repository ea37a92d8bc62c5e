// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunError.h"
#include "gatunHartleyFile.h"
#include "gatunHartleySample.h"
#include "gatunHostile.h"
#include "gatunParallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace gatun::test
{
namespace
{
using Triple = HartleyLayout::Triple;
using Mode = HartleyRateMode;

constexpr std::array AllTypes{ ScalarType::Int8, ScalarType::UInt8, ScalarType::Int16,
  ScalarType::UInt16, ScalarType::Int32, ScalarType::UInt32, ScalarType::Int64, ScalarType::UInt64,
  ScalarType::Float32, ScalarType::Float64 };

HartleyWriterOptions MakeOptions(std::uint32_t blockSize, Mode mode, double value)
{
  HartleyWriterOptions options;
  options.BlockSize = blockSize;
  options.RateControl.Mode = mode;
  options.RateControl.Value = value;
  return options;
}

std::string Describe(const SampleVolume& volume, std::uint32_t blockSize)
{
  const auto& size = volume.Input.Size;
  return "type " + std::to_string(static_cast<int>(volume.Input.Type)) + ", " +
    std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]) +
    ", blocks of " + std::to_string(blockSize);
}

void ExpectLossless(const SampleVolume& volume, std::uint32_t blockSize)
{
  const auto path = GetPath("lossless.ghv");
  const auto written =
    WriteHartleyFile(path, volume.Input, MakeOptions(blockSize, Mode::RMSError, 0));
  const HartleyFile file(path);
  EXPECT_TRUE(file.IsLossless());
  const auto voxels = ReadVoxels(file);
  if (!IsFloating(volume.Input.Type))
  {
    EXPECT_EQ(voxels, volume.Data) << Describe(volume, blockSize);
    EXPECT_EQ(written.MaximumError, 0);
  }
  else
  {
    const double range = file.GetRange().Max - file.GetRange().Min;
    const double precision = volume.Input.Type == ScalarType::Float32
      ? 1.2e-7 * std::max(range, std::abs(file.GetRange().Max))
      : 2.3e-16 * std::max(64 * range, std::abs(file.GetRange().Max));
    const auto difference = Compare(volume, voxels);
    EXPECT_LE(difference.Largest, 4 * precision) << Describe(volume, blockSize);
    EXPECT_EQ(written.MaximumError, difference.Largest);
  }
  file.Verify();
}

Bytes ReadBytes(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(in), {} };
}
}

//------------------------------------------------------------------------------
TEST(HartleyFile, LosslessForAllTypes)
{
  for (const auto type : AllTypes)
  {
    ExpectLossless(MakePhantom({ 21, 18, 13 }, type), 8);
    ExpectLossless(MakePhantom({ 21, 18, 13 }, type), 0);
  }
}

TEST(HartleyFile, LosslessForAllBlockSizes)
{
  for (const std::uint32_t blockSize : { 2, 3, 4, 7, 8, 16, 32, 64, 0 })
  {
    ExpectLossless(MakePhantom({ 37, 41, 35 }, ScalarType::UInt8), blockSize);
    ExpectLossless(MakePhantom({ 70, 9, 66 }, ScalarType::Int16), blockSize);
    ExpectLossless(MakePhantom({ 19, 1, 23 }, ScalarType::UInt16), blockSize);
    ExpectLossless(MakePhantom({ 1, 1, 1 }, ScalarType::Float32), blockSize);
    ExpectLossless(MakePhantom({ 1, 67, 1 }, ScalarType::Int8), blockSize);
  }
}

TEST(HartleyFile, LosslessWhereCoefficientsSeeNothing)
{
  // A single voxel spreads over all coefficients of a large block, none of which reaches a step.
  for (const std::uint32_t blockSize : { 8u, 64u, 0u })
  {
    ExpectLossless(
      MakeVolume({ 64, 64, 64 }, ScalarType::UInt8,
        [](auto x, auto y, auto z) { return x == 20 && y == 30 && z == 40 ? 200 : 0; }),
      blockSize);
    ExpectLossless(
      MakeVolume({ 64, 64, 64 }, ScalarType::Int32,
        [](auto x, auto y, auto z) { return (x + y + z) % 2 ? 2147483647.0 : -2147483648.0; }),
      blockSize);
    ExpectLossless(MakeVolume({ 64, 64, 64 }, ScalarType::UInt16,
                     [](auto x, auto y, auto z) { return std::floor(65536 * GetNoise(x, y, z)); }),
      blockSize);
  }
}

TEST(HartleyFile, LargeBlocksHaveSegments)
{
  const auto volume = MakePhantom({ 90, 80, 75 }, ScalarType::UInt8);
  ExpectLossless(volume, 0);
  const auto path = GetPath("whole.ghv");
  WriteHartleyFile(path, volume.Input, MakeOptions(0, Mode::PSNR, 45));
  const HartleyFile file(path);
  EXPECT_EQ(file.GetLayout().GetNumberOfChunks(), 1u);
  EXPECT_EQ(file.GetLayout().GetVoxelsPerBlock(), 90u * 80u * 75u);
  const auto difference = Compare(volume, ReadVoxels(file));
  EXPECT_LE(difference.RootMeanSquare, 255 * std::pow(10.0, -45.0 / 20));
}

TEST(HartleyFile, TellsWhatItWasMadeOf)
{
  auto volume = MakePhantom({ 21, 18, 13 }, ScalarType::Int16);
  volume.Input.Name = "density";
  volume.Input.VTKType = 4;
  volume.Input.Origin = { 1, -2, 3.5 };
  volume.Input.Spacing = { 0.5, 0, 2 };
  volume.Input.Direction = { 0, 1, 0, -1, 0, 0, 0, 0, 1 };
  volume.Input.FirstIndex = { -4, 0, 7 };
  auto options = MakeOptions(4, Mode::Quality, 35);
  options.RateControl.FrequencyWeight = 1.5;
  const auto path = GetPath("described.ghv");
  const auto written = WriteHartleyFile(path, volume.Input, options);
  EXPECT_TRUE(HartleyFile::CanRead(path));
  EXPECT_FALSE(FileReader::CanRead(path));
  const HartleyFile file(path);
  EXPECT_EQ(file.GetPath(), path);
  EXPECT_EQ(file.GetVolume().Size, volume.Input.Size);
  EXPECT_EQ(file.GetVolume().Type, volume.Input.Type);
  EXPECT_EQ(file.GetVolume().Name, "density");
  EXPECT_EQ(file.GetVolume().VTKType, 4);
  EXPECT_EQ(file.GetVolume().Origin, volume.Input.Origin);
  EXPECT_EQ(file.GetVolume().Spacing, volume.Input.Spacing);
  EXPECT_EQ(file.GetVolume().Direction, volume.Input.Direction);
  EXPECT_EQ(file.GetVolume().FirstIndex, volume.Input.FirstIndex);
  EXPECT_EQ(file.GetVolume().Values, nullptr);
  EXPECT_EQ(file.GetRateControl().Mode, Mode::Quality);
  EXPECT_EQ(file.GetRateControl().Value, 35);
  EXPECT_EQ(file.GetRateControl().FrequencyWeight, 1.5);
  EXPECT_FALSE(file.IsLossless());
  EXPECT_EQ(file.GetFormatVersion(), 1u);
  EXPECT_EQ(file.GetFileBytes(), written.FileBytes);
  EXPECT_EQ(file.GetFileBytes(), std::filesystem::file_size(path));
  EXPECT_EQ(file.GetLayout(), HartleyLayout::Make(volume.Input.Size, 4));
  EXPECT_EQ(file.GetRMSError(), written.RMSError);
  EXPECT_EQ(file.GetMaximumError(), written.MaximumError);
  const auto difference = Compare(volume, ReadVoxels(file));
  EXPECT_NEAR(difference.RootMeanSquare, written.RMSError, 1e-12);
  EXPECT_EQ(difference.Largest, written.MaximumError);
}

TEST(HartleyFile, HasTheCoefficientsOfTheVolumeInMemory)
{
  for (const std::uint32_t blockSize : { 2u, 5u, 8u, 33u, 0u })
  {
    for (const auto& options : { MakeOptions(blockSize, Mode::Quality, 40),
           MakeOptions(blockSize, Mode::PSNR, 35), MakeOptions(blockSize, Mode::BitsPerVoxel, 1.5),
           MakeOptions(blockSize, Mode::RMSError, 0) })
    {
      const auto volume = MakePhantom({ 70, 36, 51 }, ScalarType::Int16);
      const auto path = GetPath("same.ghv");
      WriteHartleyFile(path, volume.Input, options);
      const HartleyFile file(path);
      const auto memory = HartleyVolume::Make(volume.Input, blockSize, options.RateControl);
      ASSERT_EQ(file.GetLayout(), memory->GetLayout());
      EXPECT_EQ(file.GetBase(), memory->GetBase());
      EXPECT_EQ(file.GetRange().Min, memory->GetRange().Min);
      EXPECT_EQ(file.GetRange().Max, memory->GetRange().Max);
      std::uint64_t terms = 0;
      for (std::size_t chunk = 0; chunk < file.GetLayout().GetNumberOfChunks(); ++chunk)
      {
        const auto ofFile = file.GetChunk(chunk);
        const auto ofMemory = memory->GetChunk(chunk);
        EXPECT_EQ(ofFile->Starts, ofMemory->Starts);
        EXPECT_EQ(ofFile->Terms, ofMemory->Terms);
        terms += ofFile->Terms.size();
      }
      EXPECT_EQ(terms, file.GetNumberOfTerms());
      EXPECT_GT(terms, 0u);
    }
  }
}

TEST(HartleyFile, GivesPartsOfTheVolume)
{
  const auto volume = MakePhantom({ 70, 66, 71 }, ScalarType::UInt16);
  for (const std::uint32_t blockSize : { 7u, 64u, 0u })
  {
    for (const double error : { 0.0, 500.0 })
    {
      const auto path = GetPath("parts.ghv");
      WriteHartleyFile(path, volume.Input, MakeOptions(blockSize, Mode::RMSError, error));
      const HartleyFile file(path);
      const auto all = ReadVoxels(file);
      const auto before = file.GetBytesRead();
      for (const auto& [first, end] : { std::pair{ Triple{ 3, 4, 5 }, Triple{ 4, 5, 6 } },
             { { 60, 0, 64 }, { 70, 66, 65 } }, { { 6, 7, 8 }, { 64, 66, 71 } } })
      {
        const Triple size{ end[0] - first[0], end[1] - first[1], end[2] - first[2] };
        std::vector<std::uint16_t> part(std::size_t{ size[0] } * size[1] * size[2]);
        file.GetVoxels(first, end, part.data());
        std::size_t i = 0;
        for (auto z = first[2]; z < end[2]; ++z)
        {
          for (auto y = first[1]; y < end[1]; ++y)
          {
            for (auto x = first[0]; x < end[0]; ++x, ++i)
            {
              std::uint16_t expected = 0;
              std::memcpy(&expected, all.data() + 2 * (x + 70ull * (y + 66ull * z)), 2);
              ASSERT_EQ(part[i], expected) << x << " " << y << " " << z;
            }
          }
        }
      }
      EXPECT_GT(file.GetBytesRead(), before);
      EXPECT_THROW(file.GetVoxels({ 0, 0, 0 }, { 71, 1, 1 }, nullptr), Error);
      EXPECT_THROW(file.GetVoxels({ 5, 0, 0 }, { 5, 1, 1 }, nullptr), Error);
    }
  }
}

TEST(HartleyFile, ReadsOnlyTheChunksThatAreAskedFor)
{
  const auto volume = MakePhantom({ 200, 130, 3 }, ScalarType::UInt8);
  const auto path = GetPath("seek.ghv");
  WriteHartleyFile(path, volume.Input, MakeOptions(8, Mode::Quality, 60));
  const HartleyFile file(path);
  const auto before = file.GetBytesRead();
  unsigned char voxel = 0;
  file.GetVoxels({ 100, 70, 1 }, { 101, 71, 2 }, &voxel);
  const auto chunk = file.GetLayout().GetChunkOfBlock({ 100 / 8, 70 / 8, 0 });
  EXPECT_EQ(file.GetBytesRead() - before, file.GetChunkBytes(chunk));
  EXPECT_LT(file.GetChunkBytes(chunk), file.GetFileBytes() / 4);
}

//------------------------------------------------------------------------------
namespace
{
/** Checks the promises of errors and rates. */
void ExpectPromises(const SampleVolume& volume, std::uint32_t blockSize,
  const std::vector<double>& errors, const std::vector<double>& rates)
{
  const auto path = GetPath("promises.ghv");
  const auto voxels = static_cast<double>(volume.GetCount());
  for (const double error : errors)
  {
    WriteHartleyFile(path, volume.Input, MakeOptions(blockSize, Mode::RMSError, error));
    const auto found = Compare(volume, ReadVoxels(HartleyFile(path))).RootMeanSquare;
    EXPECT_LE(found, error * (1 + 1e-12)) << Describe(volume, blockSize);
    EXPECT_GE(found, 0.9 * error) << Describe(volume, blockSize);

    const HartleyFile file(path);
    const double range = file.GetRange().Max - file.GetRange().Min;
    const double psnr = 20 * std::log10(range / error);
    WriteHartleyFile(path, volume.Input, MakeOptions(blockSize, Mode::PSNR, psnr));
    const auto again = Compare(volume, ReadVoxels(HartleyFile(path))).RootMeanSquare;
    EXPECT_NEAR(again, found, 1e-9 * found) << Describe(volume, blockSize);
  }
  for (const double rate : rates)
  {
    const auto written =
      WriteHartleyFile(path, volume.Input, MakeOptions(blockSize, Mode::BitsPerVoxel, rate));
    EXPECT_NEAR(8 * static_cast<double>(written.FileBytes) / voxels, rate, 0.02 * rate)
      << Describe(volume, blockSize);
  }
}

SampleVolume LoadRaw(const Triple& size, ScalarType type, const std::string& bytes)
{
  SampleVolume volume;
  volume.Input.Size = size;
  volume.Input.Type = type;
  volume.Data.assign(bytes.begin(), bytes.end());
  volume.Input.Values = volume.Data.data();
  EXPECT_EQ(volume.Data.size(), volume.GetCount() * SizeOf(type));
  return volume;
}
}

TEST(HartleyFile, KeepsItsPromises)
{
  const auto volume = MakePhantom({ 65, 50, 47 }, ScalarType::Int16);
  for (const std::uint32_t blockSize : { 2u, 8u, 16u, 64u, 0u })
  {
    ExpectPromises(volume, blockSize, { 5, 40 }, { 0.5, 3 });
  }
  ExpectPromises(MakePhantom({ 65, 50, 47 }, ScalarType::UInt8), 8, { 0.2, 0.45, 1, 20 }, { 1 });
  ExpectPromises(MakePhantom({ 65, 50, 47 }, ScalarType::Float32), 8, { 1e-4, 0.1 }, { 0.25, 8 });
  ExpectPromises(MakePhantom({ 65, 50, 47 }, ScalarType::Float64), 8, { 1e-7 }, { 2 });
}

TEST(HartleyFile, KeepsItsPromisesForRealVolumes)
{
  const char* const folder = std::getenv("GATUN_DATA_DIR");
  const auto path = std::filesystem::path(folder ? folder : "") / "ironProt.vtk";
  if (!folder || !std::filesystem::exists(path))
  {
    GTEST_SKIP() << "GATUN_DATA_DIR has no ironProt.vtk";
  }
  const auto bytes = ReadBytes(path.string());
  constexpr std::size_t voxels = 68 * 68 * 68;
  // The voxels are what the file ends with, but for an end of line.
  const std::size_t end = bytes.size() - (bytes.size() > voxels && bytes.back() == '\n');
  const auto volume = LoadRaw({ 68, 68, 68 }, ScalarType::UInt8,
    std::string(bytes.begin() + static_cast<std::ptrdiff_t>(end - voxels),
      bytes.begin() + static_cast<std::ptrdiff_t>(end)));
  for (const std::uint32_t blockSize : { 2u, 8u, 16u, 0u })
  {
    ExpectLossless(volume, blockSize);
    ExpectPromises(volume, blockSize, { 0.5, 4 }, { 1 });
  }
}

TEST(HartleyFile, HigherQualityIsBetterAndLarger)
{
  const auto volume = MakePhantom({ 64, 64, 40 }, ScalarType::UInt16);
  const auto path = GetPath("quality.ghv");
  double lastError = 1e300;
  std::uint64_t lastBytes = 0;
  for (const double quality : { 1, 10, 25, 40, 55, 70, 85, 100 })
  {
    const auto written =
      WriteHartleyFile(path, volume.Input, MakeOptions(8, Mode::Quality, quality));
    EXPECT_LT(written.RMSError, lastError) << quality;
    EXPECT_GT(written.FileBytes, lastBytes) << quality;
    lastError = written.RMSError;
    lastBytes = written.FileBytes;
  }
  // The step is 1024th of the range then.
  EXPECT_LT(lastError, 65535 / 1024.0 / std::sqrt(12.0));
}

TEST(HartleyFile, ConstantVolumesTakeNothing)
{
  for (const auto type : AllTypes)
  {
    const auto volume = MakeVolume({ 70, 50, 40 }, type, [](auto, auto, auto) { return 42.0; });
    for (const auto& options :
      { MakeOptions(8, Mode::Quality, 60), MakeOptions(8, Mode::RMSError, 0),
        MakeOptions(0, Mode::PSNR, 50), MakeOptions(16, Mode::BitsPerVoxel, 1) })
    {
      const auto path = GetPath("constant.ghv");
      const auto written = WriteHartleyFile(path, volume.Input, options);
      EXPECT_LT(written.FileBytes, 2000u);
      EXPECT_EQ(ReadVoxels(HartleyFile(path)), volume.Data);
    }
  }
}

TEST(HartleyFile, BytesDoNotDependOnThreads)
{
  const auto volume = MakePhantom({ 130, 90, 70 }, ScalarType::Int16);
  for (const std::uint32_t blockSize : { 8u, 0u })
  {
    std::vector<Bytes> files;
    for (const bool parallel : { true, false })
    {
      const auto path = GetPath("threads.ghv");
      const auto write = [&]
      { WriteHartleyFile(path, volume.Input, MakeOptions(blockSize, Mode::PSNR, 50)); };
      if (parallel)
      {
        write();
      }
      else
      {
        // Within a body, everything is done by its thread.
        ParallelFor(1, [&](std::size_t) { write(); });
      }
      files.push_back(ReadBytes(path));
    }
    EXPECT_TRUE(files[0] == files[1]);
  }
}

TEST(HartleyFile, CanBeStopped)
{
  const auto volume = MakePhantom({ 130, 90, 70 }, ScalarType::Int16);
  const auto path = GetPath("stopped.ghv");
  for (const std::uint32_t blockSize : { 8u, 0u })
  {
    for (const double when : { 0.0, 0.1, 0.65 })
    {
      try
      {
        WriteHartleyFile(path, volume.Input, MakeOptions(blockSize, Mode::Quality, 50),
          [&](double done) { return done < when; });
        ADD_FAILURE() << "not stopped";
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.Code, ErrorCode::Aborted);
      }
      EXPECT_TRUE(ListFolder(path).empty());
    }
  }
  WriteHartleyFile(path, volume.Input, MakeOptions(8, Mode::Quality, 50));
  const HartleyFile file(path);
  std::vector<std::int16_t> voxels(volume.GetCount());
  EXPECT_THROW(
    file.GetVoxels({ 0, 0, 0 }, volume.Input.Size, voxels.data(), [](double) { return false; }),
    Error);
  EXPECT_THROW(file.Verify([](double done) { return done < 0.1; }), Error);
}

TEST(HartleyFile, ProgressGoesForward)
{
  const auto volume = MakePhantom({ 130, 90, 70 }, ScalarType::Int16);
  for (const auto& options : { MakeOptions(8, Mode::Quality, 50), MakeOptions(0, Mode::PSNR, 45),
         MakeOptions(16, Mode::BitsPerVoxel, 1) })
  {
    double last = 0;
    const auto path = GetPath("progress.ghv");
    WriteHartleyFile(path, volume.Input, options,
      [&](double done)
      {
        EXPECT_GE(done, last);
        EXPECT_LE(done, 1);
        last = done;
        return true;
      });
    EXPECT_GT(last, 0.5);
  }
}

//------------------------------------------------------------------------------
namespace
{
void ExpectRefused(
  const VolumeInput& volume, const HartleyWriterOptions& options, const std::string& what)
{
  const auto path = GetPath("refused.ghv");
  const auto check = [&](auto&& run)
  {
    try
    {
      run();
      ADD_FAILURE() << "no error, but expected: " << what;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidInput);
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  check([&] { WriteHartleyFile(path, volume, options); });
  EXPECT_TRUE(ListFolder(path).empty());
  check([&] { HartleyVolume::Make(volume, options.BlockSize, options.RateControl); });
}
}

TEST(HartleyFile, RefusesVoxelsItCannotKeep)
{
  const auto options = MakeOptions(8, Mode::Quality, 50);
  for (const double bad : { std::nan(""), HUGE_VAL, -HUGE_VAL })
  {
    for (const auto type : { ScalarType::Float32, ScalarType::Float64 })
    {
      const auto volume = MakeVolume({ 20, 10, 30 }, type,
        [&](auto x, auto y, auto z)
        { return z * 200 + y * 20 + x >= 2346 && x % 2 == 0 ? bad : 1.0; });
      ExpectRefused(volume.Input, options, "the voxel (6, 7, 11) is not a finite number");
    }
  }
  const auto large = MakeVolume({ 4, 4, 4 }, ScalarType::UInt64,
    [](auto x, auto y, auto z) { return x + y + z == 9 ? 18446744073709549568.0 : 5.0; });
  ExpectRefused(large.Input, options, "the voxel (3, 3, 3) is beyond 2^53");
  const auto negative = MakeVolume({ 4, 4, 4 }, ScalarType::Int64,
    [](auto x, auto y, auto z) { return x + y + z == 0 ? -9223372036854775808.0 : 5.0; });
  ExpectRefused(negative.Input, options, "the voxel (0, 0, 0) is beyond 2^53");
  const auto wide = MakeVolume({ 4, 4, 4 }, ScalarType::Float64,
    [](auto x, auto, auto) { return x == 1 ? 1.7e308 : -1.7e308; });
  ExpectRefused(wide.Input, options, "beyond single precision");
  const auto narrow = MakeVolume(
    { 4, 4, 4 }, ScalarType::Float64, [](auto x, auto, auto) { return x == 1 ? 1e-300 : 0; });
  ExpectRefused(narrow.Input, options, "beyond single precision");
  const auto range = MakeVolume(
    { 4, 4, 4 }, ScalarType::Int64, [](auto x, auto, auto) { return x == 1 ? 9e15 : 0; });
  ExpectRefused(range.Input, MakeOptions(8, Mode::RMSError, 0), "exceeds 2^40");
}

TEST(HartleyFile, RefusesSettingsThatMakeNoSense)
{
  const auto volume = MakePhantom({ 9, 8, 7 }, ScalarType::UInt8);
  ExpectRefused(volume.Input, MakeOptions(1, Mode::Quality, 50), "blocks of 1 voxels");
  ExpectRefused(volume.Input, MakeOptions(100000, Mode::Quality, 50), "blocks of 100000 voxels");
  ExpectRefused(volume.Input, MakeOptions(8, Mode::Quality, 0), "the quality is 0");
  ExpectRefused(volume.Input, MakeOptions(8, Mode::Quality, 101), "the quality is 101");
  ExpectRefused(volume.Input, MakeOptions(8, Mode::RMSError, -1), "the RMS error is -1");
  ExpectRefused(volume.Input, MakeOptions(8, Mode::RMSError, std::nan("")), "the RMS error is nan");
  const auto noise = MakeVolume({ 9, 8, 7 }, ScalarType::Float64, GetNoise);
  ExpectRefused(noise.Input, MakeOptions(8, Mode::RMSError, 1e-250), "is too small");
  ExpectRefused(volume.Input, MakeOptions(8, Mode::PSNR, 0), "the peak signal-to-noise ratio");
  ExpectRefused(
    volume.Input, MakeOptions(8, Mode::BitsPerVoxel, 0), "the number of bits per voxel");
  auto options = MakeOptions(8, Mode::Quality, 50);
  options.RateControl.FrequencyWeight = 5;
  ExpectRefused(volume.Input, options, "the frequency weight");
  auto empty = volume.Input;
  empty.Size[1] = 0;
  ExpectRefused(empty, MakeOptions(8, Mode::Quality, 50), "is empty");
  auto nothing = volume.Input;
  nothing.Values = nullptr;
  ExpectRefused(nothing, MakeOptions(8, Mode::Quality, 50), "has no values");
}
}
