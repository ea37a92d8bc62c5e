// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Volumes in files that are damaged, or that lie.

#include "../gatunSanitizer.h"
#include "gatunHartleyFileImage.h"
#include "gatunHartleySample.h"
#include "gatunHostile.h"

#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <random>

#include <sys/resource.h>
#include <unistd.h>

namespace
{
using namespace gatun;
using namespace gatun::test;
using Mode = HartleyRateMode;

std::string WriteSampleVolume(const HartleyLayout::Triple& size, std::uint32_t blockSize,
  double error, ScalarType type = ScalarType::UInt8)
{
  const auto path = GetPath("volume.ghv");
  const auto volume = MakePhantom(size, type);
  HartleyWriterOptions options;
  options.BlockSize = blockSize;
  options.RateControl = { Mode::RMSError, error, 0 };
  WriteHartleyFile(path, volume.Input, options);
  return path;
}

/** All that a file gives: its terms and its voxels. */
struct Content
{
  std::vector<HartleyTerm> Terms;
  std::vector<unsigned char> Voxels;

  bool operator==(const Content&) const = default;
};

Content ReadContent(const std::string& path)
{
  const HartleyFile file(path);
  Content content;
  for (std::size_t chunk = 0; chunk < file.GetLayout().GetNumberOfChunks(); ++chunk)
  {
    const auto terms = file.GetChunk(chunk);
    content.Terms.insert(content.Terms.end(), terms->Terms.begin(), terms->Terms.end());
  }
  content.Voxels = ReadVoxels(file);
  file.Verify();
  return content;
}

Bytes ReadBytes(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(in), {} };
}

/** Changes a good file and expects that reading all of it fails like this. */
void ExpectRefused(const std::string& what, const std::function<void(HartleyFileImage&)>& change,
  ErrorCode code = ErrorCode::Corrupt, std::uint32_t blockSize = 4)
{
  HartleyFileImage image(WriteSampleVolume({ 9, 70, 5 }, blockSize, 0));
  change(image);
  const auto path = PutFile("changed.ghv", image.Build());
  EXPECT_GATUN_ERROR(code, path, what, [&] { ReadContent(path); });
}
}

//------------------------------------------------------------------------------
TEST(HostileHartley, TheUnchangedFileIsRead)
{
  for (const std::uint32_t blockSize : { 4u, 0u })
  {
    const auto path = WriteSampleVolume({ 9, 70, 5 }, blockSize, 0);
    const auto content = ReadContent(path);
    const HartleyFileImage image(path);
    EXPECT_EQ(image.Build(), ReadBytes(path));
    EXPECT_EQ(ReadContent(PutFile("same.ghv", image.Build())), content);
  }
}

TEST(HostileHartley, EveryTruncationIsFound)
{
  for (const double error : { 0.0, 4.0 })
  {
    const auto bytes = ReadBytes(WriteSampleVolume({ 9, 7, 5 }, 4, error));
    for (std::size_t length = 0; length < bytes.size(); ++length)
    {
      const auto path = PutFile(
        "short.ghv", Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)));
      EXPECT_THROW(ReadContent(path), Error) << length;
    }
  }
}

TEST(HostileHartley, EveryFlippedBitIsFound)
{
  for (const double error : { 0.0, 4.0 })
  {
    auto bytes = ReadBytes(WriteSampleVolume({ 5, 4, 3 }, 4, error));
    const auto path = PutFile("flipped.ghv", bytes);
    ReadContent(path);
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit)
    {
      bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
      PutFile("flipped.ghv", bytes);
      // Verify checks even those bytes that nothing is read from.
      EXPECT_THROW(ReadContent(path), Error) << bit;
      bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
    }
  }
}

TEST(HostileHartley, StreamsOfNoiseDoNoHarm)
{
  std::mt19937 random(3);
  for (const std::uint32_t blockSize : { 2u, 4u, 64u, 0u })
  {
    HartleyFileImage image(WriteSampleVolume({ 80, 70, 50 }, blockSize, 0));
    const auto good = image.Streams;
    int refused = 0;
    constexpr int attempts = 60;
    for (int i = 0; i < attempts; ++i)
    {
      image.Streams = good;
      for (auto& stream : image.Streams)
      {
        for (int change = 0; change < 1 + i % 4; ++change)
        {
          stream[random() % stream.size()] = static_cast<std::uint8_t>(random());
        }
      }
      const auto path = PutFile("noise.ghv", image.Build());
      try
      {
        ReadContent(path);
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.Code, ErrorCode::Corrupt) << error.what();
        EXPECT_EQ(std::string(error.what()).find(path + ": "), 0u) << error.what();
        ++refused;
      }
    }
    // The number of terms gives most of them away.
    EXPECT_GT(refused, attempts / 2) << blockSize;
  }
}

//------------------------------------------------------------------------------
TEST(HostileHartley, OtherFilesAreNotVolumes)
{
  const auto path = PutFile("empty.ghv", {});
  EXPECT_FALSE(HartleyFile::CanRead(path));
  EXPECT_GATUN_ERROR(ErrorCode::NotGatun, path, "the file is empty", [&] { HartleyFile f(path); });
  const auto mesh = GetPath("mesh.gtn");
  WriteSample(mesh, MakeCubes(2, 0.2), {}, 1);
  EXPECT_FALSE(HartleyFile::CanRead(mesh));
  EXPECT_GATUN_ERROR(
    ErrorCode::NotGatun, mesh, "this is not a .ghv file", [&] { HartleyFile f(mesh); });
  const auto volume = WriteSampleVolume({ 9, 7, 5 }, 4, 0);
  EXPECT_GATUN_ERROR(
    ErrorCode::NotGatun, volume, "this is not a .gtn file", [&] { FileReader f(volume); });
  const auto missing = GetPath("missing.ghv");
  EXPECT_FALSE(HartleyFile::CanRead(missing));
  EXPECT_GATUN_ERROR(
    ErrorCode::CannotOpen, missing, "cannot open", [&] { HartleyFile f(missing); });
}

TEST(HostileHartley, AnotherVersionIsNamed)
{
  ExpectRefused(
    "version 2 of the .ghv format; this program reads version 1 only",
    [](HartleyFileImage& f) { f.Version = 2; }, ErrorCode::UnsupportedVersion);
}

TEST(HostileHartley, MetaDataMustBePossible)
{
  const auto nan = std::nan("");
  ExpectRefused("the meta data at byte", [](HartleyFileImage& f) { f.MetaBytes = Bytes(3, 0); });
  ExpectRefused("the meta data at byte",
    [](HartleyFileImage& f)
    {
      f.MetaBytes = f.Meta.Write();
      f.MetaBytes->push_back(0);
    });
  ExpectRefused("is empty", [](HartleyFileImage& f) { f.Meta.Volume.Size[1] = 0; });
  ExpectRefused("too large",
    [](HartleyFileImage& f) {
      f.Meta.Volume.Size = { 1u << 31, 1u << 31, 1u << 31 };
    });
  ExpectRefused("blocks of 1 voxels", [](HartleyFileImage& f) { f.Meta.BlockSize = 1; });
  ExpectRefused("blocks of 65 voxels", [](HartleyFileImage& f) { f.Meta.BlockSize = 65; });
  ExpectRefused("there is no type 0",
    [](HartleyFileImage& f) { f.Meta.Volume.Type = static_cast<ScalarType>(0); });
  ExpectRefused("there is no type 11",
    [](HartleyFileImage& f) { f.Meta.Volume.Type = static_cast<ScalarType>(11); });
  ExpectRefused("the origin", [=](HartleyFileImage& f) { f.Meta.Volume.Origin[2] = nan; });
  ExpectRefused("the spacing", [=](HartleyFileImage& f) { f.Meta.Volume.Spacing[0] = HUGE_VAL; });
  ExpectRefused("the direction", [=](HartleyFileImage& f) { f.Meta.Volume.Direction[8] = nan; });
  ExpectRefused("the smallest voxel", [=](HartleyFileImage& f) { f.Meta.Values.Min = nan; });
  for (const Range range :
    { Range{ -1, 200 }, Range{ 0, 256 }, Range{ 0.5, 200 }, Range{ 0, 199.5 }, Range{ 100, 50 } })
  {
    ExpectRefused("the range of the voxels", [=](HartleyFileImage& f) { f.Meta.Values = range; });
  }
  for (const double step : { 0.0, -1.0, nan, HUGE_VAL, 1e300, 1e-320 })
  {
    ExpectRefused(
      "the step of the quantizer", [=](HartleyFileImage& f) { f.Meta.Steps.Step = step; });
  }
  for (const double weight : { -0.1, 4.1, nan })
  {
    ExpectRefused(
      "the weight of frequencies", [=](HartleyFileImage& f) { f.Meta.Steps.Weight = weight; });
  }
  ExpectRefused(
    "a shift of the quantizer", [](HartleyFileImage& f) { f.Meta.Steps.Shifts[2] = 0.6; });
  ExpectRefused("there is no rate control mode",
    [](HartleyFileImage& f) { f.Meta.RateControl.Mode = static_cast<Mode>(4); });
  ExpectRefused("the quality", [=](HartleyFileImage& f) { f.Meta.RateControl.Value = nan; });
  ExpectRefused("the error", [=](HartleyFileImage& f) { f.Meta.RMSError = -1; });
  ExpectRefused("the largest error", [=](HartleyFileImage& f) { f.Meta.MaximumError = nan; });
}

TEST(HostileHartley, TablesMustFitTheVolume)
{
  ExpectRefused(
    "fewer chunks than the volume needs", [](HartleyFileImage& f) { f.TableBytes = Bytes(); });
  ExpectRefused("fewer chunks than the volume needs",
    [](HartleyFileImage& f) {
      f.Meta.Volume.Size = { 1u << 20, 1u << 10, 1u << 10 };
    });
  ExpectRefused("there are bytes after its end",
    [](HartleyFileImage& f)
    {
      f.TableBytes = f.Table.Write(f.Meta);
      f.TableBytes->push_back(0);
    });
  ExpectRefused("more coefficients than its blocks",
    [](HartleyFileImage& f) { f.Table.Chunks[1].Terms = 1u << 20; });
  ExpectRefused(
    "its number of coefficients is wrong", [](HartleyFileImage& f) { ++f.Table.Chunks[1].Terms; });
  ExpectRefused("chunk 0 at byte", [](HartleyFileImage& f) { f.Streams[0].clear(); });
  ExpectRefused(
    "the corrections of chunk 0 at byte", [](HartleyFileImage& f) { f.Streams[1].clear(); });
  for (const bool far : { false, true })
  {
    ExpectRefused(far ? "a stream is too far away" : "extends beyond the end of the file",
      [=](HartleyFileImage& f)
      {
        f.Table.Chunks.back().Corrections.Length = far ? std::uint64_t{ 1 } << 63 : 100000;
        f.TableBytes = f.Table.Write(f.Meta);
      });
  }
}

TEST(HostileHartley, SegmentsAreNotShorterThanTheyCanBe)
{
  HartleyFileImage image(WriteSampleVolume({ 80, 70, 50 }, 0, 50));
  ASSERT_EQ(image.Streams.size(), 2u);
  image.Streams[1].resize(10);
  const auto path = PutFile("short.ghv", image.Build());
  EXPECT_GATUN_ERROR(
    ErrorCode::Corrupt, path, "chunk 0 is too short", [&] { HartleyFile f(path); });
}

//------------------------------------------------------------------------------
namespace
{
/** Opens a file with little memory, in a process of its own: exit code 0 unless memory ran out. */
void OpenWithLimit(const std::string& path)
{
  std::ifstream in("/proc/self/statm");
  std::size_t pages = 0;
  in >> pages;
  const auto limit = pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) +
    (std::size_t{ 64 } << 20) + 256 * std::filesystem::file_size(path);
  const ::rlimit memory{ limit, limit };
  ::setrlimit(RLIMIT_AS, &memory);
  try
  {
    const HartleyFile file(path);
    std::cerr << "opened" << std::endl;
    if (file.GetLayout().GetNumberOfChunks() > 1)
    {
      file.GetChunk(0);
      std::cerr << "decoded" << std::endl;
    }
  }
  catch (const Error& error)
  {
    std::cerr << error.what() << std::endl;
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << "out of memory" << std::endl;
    std::_Exit(1);
  }
  std::_Exit(0);
}
}

TEST(HostileHartley, SmallFilesDoNotTakeMuchMemory)
{
#ifdef GATUN_HAS_SANITIZER
  GTEST_SKIP() << "a sanitizer has memory of its own";
#endif
  ::testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const auto open = [](const HartleyFileImage& image, const char* what)
  {
    const auto path = PutFile("large.ghv", image.Build());
    EXPECT_EXIT(OpenWithLimit(path), ::testing::ExitedWithCode(0), what);
  };
  {
    HartleyFileImage image(WriteSampleVolume({ 9, 7, 5 }, 8, 4));
    image.Meta.Volume.Size = { 1u << 14, 1u << 13, 1u << 13 };
    open(image, "fewer chunks than the volume needs");
  }
  {
    // 2^32 voxels in 2^14 chunks that all look the same.
    HartleyFileImage image(WriteSampleVolume({ 64, 64, 64 }, 8, 4));
    image.Meta.Volume.Size = { 1u << 11, 1u << 11, 1u << 10 };
    image.Table.Chunks.resize(1u << 14, image.Table.Chunks[0]);
    image.Streams.resize(1u << 14, Bytes(image.Streams[0]));
    open(image, "decoded");
  }
  {
    // One block of 2^30 voxels.
    HartleyFileImage image(WriteSampleVolume({ 9, 7, 5 }, 0, 4));
    image.Meta.Volume.Size = { 1u << 10, 1u << 10, 1u << 10 };
    open(image, "fewer chunks than the volume needs");
    image.Table.Chunks[0].Streams.resize(1u << 12);
    open(image, "is too short");
    image.Streams.assign(1u << 12, Bytes(256));
    open(image, "opened");
  }
}
