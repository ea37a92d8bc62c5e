// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Small files that claim large contents. Each must be refused, or opened, with little memory. The
// time limit of the test catches those that take unreasonably long.

#include "../gatunSanitizer.h"
#include "gatunHostile.h"
#include "gatunTreeTable.h"

#include <cstdlib>
#include <iostream>
#include <new>
#include <numeric>

#include <sys/resource.h>
#include <unistd.h>

namespace
{
using namespace gatun;
using namespace gatun::test;

std::size_t GetAddressSpace()
{
  std::ifstream in("/proc/self/statm");
  std::size_t pages = 0;
  in >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/** Opens a file and reads its tables with little memory and 20 s of time. The exit code is 0 unless
 * memory ran out. */
void OpenWithLimit(const std::string& path)
{
  const auto limit =
    GetAddressSpace() + (std::size_t{ 64 } << 20) + 256 * std::filesystem::file_size(path);
  const ::rlimit memory{ limit, limit };
  ::setrlimit(RLIMIT_AS, &memory);
  const ::rlimit seconds{ 20, 20 };
  ::setrlimit(RLIMIT_CPU, &seconds);
  try
  {
    FileReader reader(path);
    reader.GetStatistics(); // reads all tables
    if (!reader.GetChunks().empty())
    {
      reader.GetNeighbors(reader.GetChunks().size() - 1);
    }
    std::cerr << "opened" << std::endl;
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

class HostileMemory : public ::testing::Test
{
protected:
  void SetUp() override
  {
#ifdef GATUN_HAS_SANITIZER
    GTEST_SKIP() << "sanitizers need address space of their own";
#endif
  }

  void Open(const FileImage& image, const std::string& what)
  {
    ::testing::FLAGS_gtest_death_test_style = "fast";
    const auto path = PutFile("bomb.gtn", image.Build());
    EXPECT_LT(std::filesystem::file_size(path), 300000u);
    EXPECT_EXIT(OpenWithLimit(path), ::testing::ExitedWithCode(0), what);
  }

  /** Chunks of one tetrahedron each, all with streams of one byte. */
  static FileImage MakeChunks(std::size_t count)
  {
    FileImage image;
    ChunkEntry chunk;
    chunk.Info.Tets = 1;
    chunk.Info.OwnPoints = 3;
    chunk.Connectivity = { 1u << 20, 1, 0 };
    image.Mesh.Chunks.assign(count, chunk);
    image.Meta.Tets = count;
    image.Meta.Points = 3 * count;
    image.Streams.emplace_back(2 * count, std::uint8_t{ 0 });
    return image;
  }
};

TEST_F(HostileMemory, ManyChunksInASmallTable)
{
  auto image = this->MakeChunks(15000);
  this->Open(image, "opened");
  image.Streams.clear(); // now the file is shorter than its chunks' streams
  this->Open(image, "longer than the file");
}

TEST_F(HostileMemory, AllChunksNextToEachOther)
{
  // Blocks of each page that all chunks from that page on share.
  constexpr std::size_t count = 9000;
  for (const std::size_t pages : { 1, 6 })
  {
    auto image = this->MakeChunks(count);
    for (std::uint32_t first = 0; first < pages * ChunksPerPage; first += ChunksPerPage)
    {
      BlockEntry block;
      block.Groups.resize(1);
      block.Groups[0].Points = 1;
      block.Groups[0].Chunks.resize(count - first);
      std::iota(block.Groups[0].Chunks.begin(), block.Groups[0].Chunks.end(), first);
      block.Geometry = { 1u << 20, 1, 0 };
      image.Mesh.Blocks.insert(image.Mesh.Blocks.end(), 100, block);
    }
    for (auto& chunk : image.Mesh.Chunks)
    {
      chunk.Info.Tets = 200;
    }
    image.Meta.Tets = 200 * count;
    image.Meta.Points += 100 * pages;
    this->Open(image, pages == 1 ? "opened" : "a chunk shares points with too many others");
  }
}

TEST_F(HostileMemory, ManyGroups)
{
  auto image = this->MakeChunks(2);
  BlockEntry block;
  block.Groups.assign(200000, { { 0, 1 }, 1 });
  block.Geometry = { 1u << 20, 1000, 0 };
  image.Mesh.Blocks.push_back(block);
  for (auto& chunk : image.Mesh.Chunks)
  {
    chunk.Info.Tets = 60000;
    chunk.Connectivity.Length = 300;
  }
  image.Streams[0].resize(2000);
  image.Meta.Tets = 120000;
  image.Meta.Points += 200000;
  this->Open(image, "opened");
}

TEST_F(HostileMemory, ManyArrays)
{
  auto image = this->MakeChunks(2);
  image.Meta.Arrays.assign(70000, {});
  this->Open(image, "opened");
  // With a step whose table has next to nothing for them.
  image.Steps.resize(1);
  image.ChangeTable = [](FourCC name, std::size_t, Bytes& table)
  { table = name == SectionStep ? Bytes(2000, 0) : table; };
  this->Open(image, "ends too early");
}

TEST_F(HostileMemory, OneStepNamedManyTimes)
{
  auto image = this->MakeChunks(1);
  image.Meta.HasTime = true;
  image.Meta.Arrays.resize(1);
  image.Meta.Arrays[0].Components = 65536;
  image.Meta.Arrays[0].Where = Association::Cell;
  StepTable step;
  step.Arrays.resize(1);
  auto& array = step.Arrays[0];
  array.Palettes.resize(65536);
  array.Ranges.resize(65537);
  array.ChunkRanges.assign(1, ArrayRanges(65537));
  array.Chunks.assign(1, { 1u << 20, 9, 0 });
  image.Steps.assign(300, step);
  this->Open(image, "do not ascend");
}

TEST_F(HostileMemory, ManyStepsWithLargeTables)
{
  // Each table alone may be so large, but not all of them together.
  auto image = this->MakeChunks(1);
  image.Meta.HasTime = true;
  image.Meta.Arrays.resize(6);
  StepTable step;
  step.Arrays.resize(6);
  for (std::size_t a = 0; a < 6; ++a)
  {
    image.Meta.Arrays[a].Components = 65536;
    image.Meta.Arrays[a].Where = Association::Cell;
    auto& array = step.Arrays[a];
    array.Palettes.resize(65536);
    array.Ranges.resize(65537);
    array.ChunkRanges.assign(1, ArrayRanges(65537));
    array.Chunks.assign(1, { 1u << 20, 9, 0 });
  }
  image.Steps.push_back(step);
  this->Open(image, "opened");
  for (int i = 1; i < 40; ++i)
  {
    step.Time = i;
    image.Steps.push_back(step);
  }
  this->Open(image, "the tables of the time steps are too large for such a file");
}

TEST_F(HostileMemory, ManyStepsWithLargeRangesAfterMerges)
{
  auto image = this->MakeChunks(1);
  image.Meta.HasTime = true;
  image.Meta.Arrays.resize(1);
  image.Meta.Arrays[0].Components = 65536;
  TreeTable tree;
  tree.Merges = 1;
  tree.Parts = { { static_cast<std::uint32_t>(image.Meta.Points), { 1u << 20, 9, 0 }, {}, {} } };
  tree.MergeCounts = { 1 };
  tree.Boxes.assign(1, std::vector<Bounds>(1));
  TreeStepTable ranges;
  ranges.Ranges.assign(1, { { ArrayRanges(65537) } });
  StepTable step;
  step.Arrays.resize(1);
  auto& array = step.Arrays[0];
  array.Palettes.resize(65536);
  array.Ranges.resize(65537);
  array.ChunkRanges.assign(1, ArrayRanges(65537));
  array.Chunks.assign(1, { 1u << 20, 9, 0 });
  array.Blocks.resize(1);
  image.MoreSections.push_back({ SectionTree, tree.Write(), SectionVersion, 0 });
  for (int i = 0; i < 9; ++i)
  {
    step.Time = i;
    image.Steps.push_back(step);
    image.MoreSections.push_back({ SectionTreeStep, ranges.Write(), SectionVersion, 0 });
  }
  this->Open(image, "the ranges after merges at byte .* too large for such a file");
}

TEST(HostileTime, AChunkThatClaimsAsMuchAsItCanIsRefused)
{
  auto image = MakeImage();
  auto& chunk = image.Mesh.Chunks[0];
  const std::uint64_t tets = 1u << 18;
  image.Meta.Tets += tets - chunk.Info.Tets;
  image.Meta.Points += 4 * tets - 1000 - chunk.Info.OwnPoints;
  chunk.Info.Tets = tets;
  chunk.Info.OwnPoints = 4 * tets - 1000;
  std::mt19937 random(1);
  for (int attempt = 0; attempt < 8; ++attempt)
  {
    Bytes stream(tets / 256 + 1 + 8192);
    std::generate(stream.begin(), stream.end(),
      [&] { return static_cast<std::uint8_t>(attempt < 4 ? 0 : random()); });
    stream[0] = static_cast<std::uint8_t>(attempt % 4);
    stream[1] = 0x80;
    stream[2] = 0x40;
    image.Set(chunk.Connectivity, stream);
    const auto path = PutFile("claims.gtn", image.Build());
    EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path, "the mesh of chunk 0", [&] { ReadAll(path); });
  }
}
}
