// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Neighbors in a block, with and without what decoding knows of them.

#include "gatunChunkCache.h"
#include "gatunFileReader.h"
#include "gatunRayDecoder.h"
#include "gatunSampleFile.h"
#include "gatunTestFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace gatun::test
{
namespace
{
constexpr auto None = RayBlock::NoNeighbor;

std::vector<RayBlock> DecodeAll(const std::string& path)
{
  const auto file = std::make_shared<FileReader>(path);
  const auto parts = std::make_shared<ChunkCache>(file, std::uint64_t{ 1 } << 30);
  std::vector<RayBlock> blocks;
  for (std::size_t chunk = 0; chunk < file->GetChunks().size(); ++chunk)
  {
    blocks.push_back(DecodeRayBlock(parts, {}, chunk));
  }
  return blocks;
}

/** Each neighbor has the block's tetrahedron as its own, and the same face. Returns the number of
 * faces with a neighbor. */
std::size_t CheckNeighbors(const RayBlock& block)
{
  std::size_t found = 0;
  const auto getFace = [&](std::uint32_t face)
  {
    auto corners = block.Tets[face / 4];
    corners[face % 4] = None;
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  for (std::uint32_t face = 0; face < 4 * block.Tets.size(); ++face)
  {
    const auto other = block.Neighbors[face / 4][face % 4];
    if (other != None)
    {
      EXPECT_EQ(block.Neighbors[other / 4][other % 4], face);
      EXPECT_EQ(getFace(face), getFace(other));
      ++found;
    }
  }
  return found;
}
}

//------------------------------------------------------------------------------
TEST(RayBlock, NeighborsAreTheSameWithParents)
{
  const auto path = TempPath("ray-blocks.gtn");
  WriterOptions options;
  options.ChunkSize = 700;
  WriteSample(path, MakeCubes(7, 0.2), options, 1);
  const auto blocks = DecodeAll(path);
  ASSERT_GT(blocks.size(), 2u);
  for (RayBlock block : blocks)
  {
    // All tetrahedra but those that begin a part of the chunk.
    ASSERT_EQ(block.Parents.size(), block.Tets.size());
    EXPECT_LT(std::count(block.Parents.begin(), block.Parents.end(), None), 20);
    RayBlock plain = block;
    plain.Parents.clear();
    plain.Prepare();
    block.Prepare();
    EXPECT_TRUE(block.Parents.empty());
    EXPECT_EQ(block.Tets, plain.Tets);
    EXPECT_EQ(block.Neighbors, plain.Neighbors);
    EXPECT_EQ(block.Turned, plain.Turned);
    EXPECT_GT(CheckNeighbors(block), 2 * block.Tets.size());
  }
}

//------------------------------------------------------------------------------
TEST(RayBlock, WrongParentsAreNoNeighbors)
{
  const auto path = TempPath("ray-blocks-wrong.gtn");
  WriterOptions options;
  options.ChunkSize = 700;
  WriteSample(path, MakeCubes(5, 0.2), options, 1);
  std::mt19937 random(3);
  for (RayBlock block : DecodeAll(path))
  {
    RayBlock plain = block;
    plain.Parents.clear();
    plain.Prepare();
    for (std::size_t i = 0; i < block.Parents.size(); ++i)
    {
      block.Parents[i] =
        random() % 4 == 0 ? random() : random() % static_cast<std::uint32_t>(block.Tets.size());
    }
    block.Prepare();
    EXPECT_EQ(block.Neighbors, plain.Neighbors);
  }
}

//------------------------------------------------------------------------------
TEST(RayBlock, FacesOfManyTetrahedraHaveOneNeighborEach)
{
  // A fan around one face, all of which have the first one as a parent, and two that are the same.
  RayBlock block;
  for (int i = 0; i < 9; ++i)
  {
    block.Points.push_back({ i % 2 * 1.0, i % 3 * 1.0, i * 0.5, 0 });
  }
  for (std::uint32_t i = 3; i < 9; ++i)
  {
    block.Tets.push_back({ 0, 1, 2, i });
  }
  block.Tets.push_back({ 0, 1, 2, 8 });
  block.Parents.assign(block.Tets.size(), 0);
  block.Parents[0] = None;
  block.Prepare();
  EXPECT_GE(CheckNeighbors(block), 6u);
}
}
