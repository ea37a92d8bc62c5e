// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Streams of merges.

#include "gatunError.h"
#include "gatunMergeCodec.h"
#include "gatunTestTrees.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace gatun::test
{
namespace
{
Bytes Encode(const MergeTree& tree, MergeKind kind = MergeKind::Tetrahedra)
{
  return EncodeMerges(tree, tree.GetNumberOfPoints(), tree.GetMerges().size(), kind);
}

MergeTree Decode(const Bytes& stream, const MergeTree& like, MergeKind kind = MergeKind::Tetrahedra)
{
  return DecodeMerges(
    stream, like.GetNumberOfPoints(), static_cast<std::uint32_t>(like.GetMerges().size()), kind);
}

TEST(MergeCodec, StreamOfMergesGivesThemBack)
{
  for (const std::uint32_t points : { 0u, 1u, 2u, 3u, 4u, 5u, 7u, 8u, 9u, 1000u, 65537u })
  {
    const auto tree = MakeWildTree(points, points);
    const auto stream = Encode(tree);
    ExpectSame(tree, Decode(stream, tree));
  }
}

/** The same merges, some of which belong together. */
MergeTree Bind(const MergeTree& tree, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<bool> isBound;
  for (std::size_t i = 0; i < tree.GetMerges().size(); ++i)
  {
    isBound.push_back(random() % 5 == 0 && i + 1 < tree.GetMerges().size());
  }
  return { tree.GetNumberOfPoints(), tree.GetMerges(), std::move(isBound) };
}

TEST(MergeCodec, StreamOfASurfaceGivesBondsBack)
{
  for (const std::uint32_t points : { 0u, 1u, 2u, 3u, 1000u, 65537u })
  {
    const auto free = MakeWildTree(points, points);
    const auto bound = Bind(free, points);
    for (const auto* tree : { &free, &bound })
    {
      const auto back = Decode(Encode(*tree, MergeKind::Surface), *tree, MergeKind::Surface);
      ExpectSame(*tree, back);
      for (std::size_t n = 0; n <= tree->GetMerges().size(); n += 1 + points / 50)
      {
        ASSERT_EQ(tree->CountWholeMerges(n), back.CountWholeMerges(n));
      }
    }
    // Without bonds they take next to nothing.
    EXPECT_LE(Encode(free, MergeKind::Surface).size(), Encode(free).size() + 16);
  }
}

TEST(MergeCodec, DamagedStreamsOfMergesAreRefusedOrGiveATree)
{
  const auto tree = MakeWildTree(500, 5);
  const auto good = Encode(tree);
  const auto refused = CountRefused(good, 3000,
    [&](const Bytes& bad)
    { EXPECT_EQ(Decode(bad, tree).GetMerges().size(), 499u); }); // checked by its constructor
  EXPECT_GT(refused, 2000u);
  EXPECT_THROW(DecodeMerges(good, 498, 499, MergeKind::Tetrahedra), Error);
}
}
}
