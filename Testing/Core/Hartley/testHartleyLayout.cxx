// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunError.h"
#include "gatunHartleyLayout.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gatun
{
namespace
{
using Triple = HartleyLayout::Triple;

void ExpectRefused(const Triple& size, std::uint32_t blockSize, const std::string& what)
{
  try
  {
    HartleyLayout::Make(size, blockSize);
    ADD_FAILURE() << "no error, but expected: " << what;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::InvalidInput);
    EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
  }
}
}

//------------------------------------------------------------------------------
TEST(HartleyLayout, CoversEachVoxelOnce)
{
  for (const Triple& size : { Triple{ 1, 1, 1 }, { 20, 7, 3 }, { 130, 65, 2 }, { 64, 64, 64 } })
  {
    for (const std::uint32_t blockSize : { 0u, 2u, 3u, 8u, 31u, 64u })
    {
      const auto layout = HartleyLayout::Make(size, blockSize);
      std::size_t voxels = 0;
      std::vector<int> seen(layout.GetNumberOfBlocks());
      for (std::size_t chunk = 0; chunk < layout.GetNumberOfChunks(); ++chunk)
      {
        const auto box = layout.GetBlocksOfChunk(chunk);
        for (auto z = box.First[2]; z < box.End[2]; ++z)
        {
          for (auto y = box.First[1]; y < box.End[1]; ++y)
          {
            for (auto x = box.First[0]; x < box.End[0]; ++x)
            {
              const auto number = layout.GetBlockNumber({ x, y, z });
              ++seen[number];
              EXPECT_EQ(layout.GetBlockPlace(number), (Triple{ x, y, z }));
              EXPECT_EQ(layout.GetChunkOfBlock({ x, y, z }), chunk);
              const auto filled = layout.GetFilled({ x, y, z });
              voxels += std::size_t{ filled[0] } * filled[1] * filled[2];
            }
          }
        }
      }
      EXPECT_EQ(seen, std::vector<int>(seen.size(), 1));
      EXPECT_EQ(voxels, std::size_t{ size[0] } * size[1] * size[2]);
    }
  }
}

TEST(HartleyLayout, MakesWholeVolumesFast)
{
  const auto layout = HartleyLayout::Make({ 242, 1, 127 }, 0);
  EXPECT_EQ(layout.Block, (Triple{ 243, 1, 128 }));
  EXPECT_TRUE(layout.IsWhole());
}

TEST(HartleyLayout, FillsChunksOf64Voxels)
{
  EXPECT_EQ(HartleyLayout::Make({ 200, 200, 200 }, 8).Chunk, (Triple{ 8, 8, 8 }));
  EXPECT_EQ(HartleyLayout::Make({ 200, 200, 200 }, 3).Chunk, (Triple{ 21, 21, 21 }));
  EXPECT_EQ(HartleyLayout::Make({ 200, 200, 200 }, 63).Chunk, (Triple{ 1, 1, 1 }));
  // Blocks are no larger than the volume, and chunks have no more blocks than there are.
  EXPECT_EQ(HartleyLayout::Make({ 200, 40, 3 }, 8).Block, (Triple{ 8, 8, 3 }));
  EXPECT_EQ(HartleyLayout::Make({ 200, 40, 3 }, 8).Chunk, (Triple{ 8, 5, 1 }));
}

TEST(HartleyLayout, RefusesWhatMakesNoSense)
{
  ExpectRefused({ 0, 1, 1 }, 8, "the volume of 0 x 1 x 1 voxels is empty");
  ExpectRefused({ 5, 5, 5 }, 1, "blocks of 1 voxels");
  ExpectRefused({ 5, 5, 5 }, 65, "blocks of 65 voxels");
  ExpectRefused({ 1u << 31, 1u << 31, 1u << 31 }, 8, "too large");
  ExpectRefused({ 1u << 20, 1u << 20, 2 }, 8, "too large");
  ExpectRefused({ 4000000000u, 2, 2 }, 0, "too large for one block");
  ExpectRefused({ 65536, 2, 2 }, 0, "65535 along an axis");
  EXPECT_EQ(HartleyLayout::Make({ 64800, 2, 2 }, 0).Block[0], 64800u);
  EXPECT_EQ(HartleyLayout::Make({ 1u << 20, 1u << 20, 1 }, 64).GetNumberOfChunks(), 1u << 28);
}
}
