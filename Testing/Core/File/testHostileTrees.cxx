// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files with valid checksums and invalid merge trees, and damaged files.

#include "gatunEntropy.h"
#include "gatunHostileTrees.h"
#include "gatunNumberModel.h"
#include "gatunTableParts.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>

namespace
{
using namespace gatun;
using namespace gatun::test;

TEST(HostileTrees, TheUnchangedFileIsRead)
{
  const auto path = PutFile("same.gtn", GetGoodImage().Build());
  EXPECT_NO_THROW(ReadTree(path));
  EXPECT_TRUE(VerifyFile(FileReader(path)));
  EXPECT_EQ(FileReader(path).GetLevels().size(), 2u);
}

TEST(HostileTrees, ATreeMustBeThatOfTheMesh)
{
  const auto points =
    static_cast<std::uint32_t>(GetGoodImage().Meta.Points - GetGoodImage().Meta.UnusedPoints);
  ExpectRefused("there are more merges than points",
    [=](TreeImage& f)
    {
      f.Tree.Merges = points + 1; // as many as points, but two of them are unused
      f.Tree.MergeCounts.back() = points + 1;
    });
  ExpectRefused("the merges have no stream", [](TreeImage& f) { f.Parts[0].Merges.clear(); });
  ExpectRefused("the merges have no stream",
    [](TreeImage& f)
    {
      f.RemoveLevels();
      f.Tree.Merges = 0;
      f.Tree.MergeCounts.clear();
      f.Tree.Boxes.assign(f.Tree.Boxes.size(), {});
    });
  ExpectRefused("the file has several sections for the table of merges",
    [](TreeImage& f) {
      f.MoreSections.push_back({ SectionTree, f.Tree.Write(), SectionVersion, 0 });
    });
}

TEST(HostileTrees, MeshesOfTooManyPointsHaveNoTree)
{
  MetaTable meta;
  meta.Points = std::uint64_t{ 1 } << 32;
  EXPECT_THROW(TreeTable::Read(TreeTable().Write(), meta, 0), Error);
  --meta.Points;
  EXPECT_NO_THROW(TreeTable::Read(TreeTable().Write(), meta, 0));
}

TEST(HostileTrees, RungsMustAscendToAllMerges)
{
  const std::string ascend = "numbers of merges do not ascend";
  const std::string last = "the last merge count is not that of all merges";
  ExpectRefused(ascend, [](TreeImage& f) { f.Tree.MergeCounts[0] = 0; });
  ExpectRefused(ascend, [](TreeImage& f) { f.Tree.MergeCounts[0] = f.Tree.MergeCounts[1]; });
  ExpectRefused(
    ascend, [](TreeImage& f) { std::swap(f.Tree.MergeCounts[0], f.Tree.MergeCounts[1]); });
  ExpectRefused(ascend, [](TreeImage& f) { ++f.Tree.MergeCounts.back(); });
  ExpectRefused(last, [](TreeImage& f) { --f.Tree.MergeCounts.back(); });
  ExpectRefused(last,
    [](TreeImage& f)
    {
      f.Tree.MergeCounts.clear();
      f.Tree.Boxes.assign(f.Tree.Boxes.size(), {});
    });
  ExpectRefused("there are too many merge counts or levels",
    [](TreeImage& f)
    {
      // Each is right, but they are too many.
      f.Tree.Merges = 100;
      f.Tree.MergeCounts.resize(65);
      std::iota(f.Tree.MergeCounts.begin(), f.Tree.MergeCounts.end(), 36u);
      ByteWriter content;
      content.PutVarint(1);
      content.PutVarint(0);
      content.PutVarint(0);
      content.PutVarint(65);
      content.Data.resize(content.Data.size() + 65, 1);
      f.StoredTree = content.Data;
    });
  ExpectRefused("a count is larger",
    [](TreeImage& f)
    {
      ByteWriter content;
      content.PutVarint(1);
      content.PutVarint(std::uint64_t{ 1 } << 60);
      f.StoredTree = content.Data;
    });
}

TEST(HostileTrees, BoundsMustBeThereForAllRungsAndBeNumbers)
{
  ExpectRefused("a range is not a number",
    [](TreeImage& f) { f.Tree.Boxes.back().back()[2].Max = std::nan(""); });
  ExpectRefused("the bounds of chunks after merges are not all there",
    [](TreeImage& f) { f.Tree.Boxes.resize(1); });
  ExpectRefused(
    "the table of merges", [](TreeImage& f) { f.Tree.Boxes[0].push_back(f.Tree.Boxes[0][0]); });
  const auto content = Decompress(GetGoodImage().Tree.Write(), 1 << 20);
  ExpectRefused("bytes behind the end",
    [&](TreeImage& f)
    {
      f.StoredTree = content;
      f.StoredTree->push_back(0);
    });
  for (std::size_t size = 0; size < content.size(); size += size < 40 ? 1 : 29)
  {
    ExpectRefused("the table of merges",
      [&](TreeImage& f) { f.StoredTree = Bytes(content.data(), content.data() + size); });
  }
}

TEST(HostileTrees, TablesCannotExpandAtWill)
{
  const auto addBomb = [](FourCC name, std::size_t size)
  {
    return [=](TreeImage& f)
    {
      f.TreeName = name == SectionTree ? MakeFourCC("NONE") : SectionTree; // is not looked at
      if (name == SectionTreeStep)
      {
        f.TreeSteps.clear();
      }
      f.MoreSections.push_back({ name, Compress(Bytes(size, 0)), SectionVersion, 0 });
    };
  };
  ExpectRefused("claims to hold", addBomb(SectionTree, (std::size_t{ 1 } << 20) + 1));
  ExpectRefused("claims to hold", addBomb(SectionTreeStep, (std::size_t{ 1 } << 24) + 1));
}

TEST(HostileTrees, TheStreamOfMergesMustLieInTheFile)
{
  const auto setStream = [](StreamRef stream)
  {
    return [=](TreeImage& f)
    {
      f.KeepStream = true;
      f.Tree.Parts[0].Merges = stream;
    };
  };
  ExpectRefused("the stream of merges at byte 1152921504606846976 reaches past the end of the file",
    setStream({ std::uint64_t{ 1 } << 60, 100, 0 }), ErrorCode::Truncated);
  ExpectRefused("reaches past the end of the file", setStream({ 40, ~std::uint64_t{ 0 } - 20, 0 }),
    ErrorCode::Truncated);
  ExpectRefused("the stream of merges at byte 40 (100 bytes) is damaged: its checksum is wrong",
    setStream({ 40, 100, 0 }));
}

/** A run of one merge as it is coded. */
struct CodedMerge
{
  std::uint32_t Place;
  std::int64_t Distance;
  std::uint32_t Growth;
  std::uint32_t More = 0; // merges that the run claims to have
};

/** What EncodeMerges writes of few merges, but of anything. */
Bytes EncodeAnything(std::uint32_t points, const std::vector<CodedMerge>& merges)
{
  EntropyEncoder coder;
  NumberModel runs, growths;
  BitModel rounds;
  std::array<NumberModel, 33> skipped;
  std::array<BitTree<6>, 9> lengths;
  std::array<BitModel, 34> signs, seconds;
  unsigned before = 0;
  for (const auto& merge : merges)
  {
    runs.Code(coder, merge.More);
    coder.Bit(rounds, true);
    growths.Code(coder, merge.Growth);
    skipped[static_cast<std::size_t>(std::bit_width(points / (merge.More + 1)))].Code(
      coder, merge.Place);
    const auto magnitude = static_cast<std::uint64_t>(std::abs(merge.Distance));
    const auto length = static_cast<unsigned>(std::bit_width(magnitude));
    lengths[before / 4].Code(coder, length);
    if (length > 33)
    {
      break;
    }
    before = length;
    if (length > 0)
    {
      coder.Bit(signs[length], merge.Distance < 0);
    }
    if (length > 1)
    {
      coder.Bit(seconds[length], (magnitude >> (length - 2) & 1) != 0);
      coder.Raw(magnitude & ((std::uint64_t{ 1 } << (length - 2)) - 1), length - 2);
    }
  }
  const auto block = coder.Finish();
  ByteWriter out;
  out.PutVarint(block.size());
  out.PutBytes(block);
  return out.Data;
}

TEST(HostileTrees, MergesMustFollowFromEachOther)
{
  const auto points =
    static_cast<std::uint32_t>(GetGoodImage().Meta.Points - GetGoodImage().Meta.UnusedPoints);
  constexpr auto far = std::int64_t{ 1 } << 33;
  const std::string tooFar = "a distance of points is longer than 33 bits";
  const std::string follow = "the merges of points do not follow from each other";
  const std::string missing = "a point is merged into one that does not exist";
  const std::string errors = "the errors of merges do not ascend";
  const std::vector<std::pair<std::string, std::vector<CodedMerge>>> cases{
    { follow, { { 3, 0, 0 }, { 0, 1, 0 } } },                           // into itself
    { follow, { { 3, 1, 0 }, { 0, 3, 0 } } },                           // into one that is gone
    { missing, { { 3, -4, 0 }, { 0, 1, 0 } } },                         // before the first
    { missing, { { 3, std::int64_t{ points } - 3, 0 }, { 0, 1, 0 } } }, // the first unused one
    { missing, { { 3, far - 1, 0 }, { 0, 1, 0 } } },
    { missing, { { 3, 1 - far, 0 }, { 0, 1, 0 } } },
    { tooFar, { { 3, far, 0 }, { 0, 1, 0 } } },
    { tooFar, { { 3, std::numeric_limits<std::int64_t>::max(), 0 }, { 0, 1, 0 } } },
    { "there are too many merges of one error", { { 3, 1, 0, 2 }, { 0, 1, 0 } } },
    { errors, { { 3, 1, 0x7f81 }, { 0, 1, 0 } } }, // a NaN
    { errors, { { 3, 1, 0x7f80 }, { 0, 1, 1 } } },
    { errors, { { 3, 1, 5 }, { 0, 1, 0xffffffff } } },
  };
  const auto set = [&](const std::vector<CodedMerge>& merges)
  {
    return [&](TreeImage& f)
    {
      f.RemoveLevels();
      f.Parts[0].Merges = EncodeAnything(points, merges);
      f.Tree.Merges = 2;
      f.Tree.MergeCounts = { 1, 2 };
      for (auto& boxes : f.Tree.Boxes)
      {
        boxes.resize(2);
      }
      for (auto& step : f.TreeSteps)
      {
        for (auto& chunks : step.Ranges)
        {
          for (auto& ranges : chunks)
          {
            ranges.resize(2);
          }
        }
      }
    };
  };
  for (const auto& [what, merges] : cases)
  {
    ExpectRefused(what, set(merges));
    ExpectRefused("the stream of merges at byte", set(merges));
  }
  // The same with nothing wrong: the largest error, and the last place twice.
  auto good = GetGoodImage();
  set({ { points - 1, -1, 0x7f80 }, { points - 2, -2, 0 } })(good);
  const auto path = PutFile("good.gtn", good.Build());
  EXPECT_NO_THROW(ReadTree(path));
  const auto tree = FileReader(path).GetMergeTree();
  ASSERT_EQ(tree.GetMerges().size(), 2u);
  EXPECT_EQ(tree.GetMerges()[0].Point, points - 1);
  EXPECT_EQ(tree.GetMerges()[1].Point, points - 2);
  EXPECT_EQ(tree.GetMerges()[1].Into, points - 4);
  EXPECT_EQ(tree.GetMerges()[1].Error, std::numeric_limits<float>::infinity());
}

TEST(HostileTrees, TheStreamOfMergesMustBeLongEnough)
{
  const auto& merges = GetGoodImage().Parts[0].Merges;
  for (std::size_t size = 1; size < merges.size(); ++size)
  {
    ExpectRefused("", [&](TreeImage& f) { f.Parts[0].Merges.resize(size); });
  }
}

TEST(HostileTrees, AStreamOfMergesCannotClaimMoreThanItHolds)
{
  const std::uint32_t points = 1u << 20;
  for (const std::uint32_t merges : { 11u * 256u, points - 1 })
  {
    try
    {
      DecodeMerges(Bytes(10, 0), points, merges, MergeKind::Tetrahedra);
      ADD_FAILURE() << "no error";
    }
    catch (const Error& error)
    {
      EXPECT_STREQ(error.what(), "there are more merges than their stream can hold");
    }
  }
}

TEST(HostileTrees, EachTimeStepHasItsRanges)
{
  const std::string behind = "bytes behind the end";
  ExpectRefused("the ranges after merges of some time steps are missing",
    [](TreeImage& f) { f.TreeSteps.pop_back(); });
  ExpectRefused("there are ranges after merges of more time steps than there are",
    [](TreeImage& f) { f.TreeSteps.push_back(f.TreeSteps.back()); });
  ExpectRefused("a range is not a number",
    [](TreeImage& f) { f.TreeSteps[1].Ranges[0].back().back()[2].Min = std::nan(""); });
  ExpectRefused("the ranges of chunks after merges are not all there",
    [](TreeImage& f) { f.TreeSteps[1].Ranges[0].pop_back(); });
  ExpectRefused(
    behind, [](TreeImage& f) { f.TreeSteps[0].Ranges[0].push_back(f.TreeSteps[0].Ranges[0][0]); });
  // Arrays of cells have none.
  ExpectRefused(behind, [](TreeImage& f) { f.TreeSteps[0].Ranges[1] = f.TreeSteps[0].Ranges[0]; });
  ExpectRefused("the ranges after merges at byte",
    [](TreeImage& f)
    {
      f.TreeSteps.clear();
      f.StoredSteps = { {}, {} };
    });
}

TEST(HostileTrees, WithoutATreeTheRestIsIgnored)
{
  for (const bool isOther : { false, true })
  {
    auto image = GetGoodImage();
    image.TreeName = isOther ? MakeFourCC("NONE") : SectionTree;
    image.StoredTree = Bytes(7, 0xff);
    image.Levels.assign(3, Bytes(9, 1));
    image.TreeSteps.clear();
    image.StoredSteps.assign(5, Bytes(3, 0xff));
    const auto path = PutFile("changed.gtn", image.Build());
    if (isOther)
    {
      EXPECT_NO_THROW(ReadTree(path));
      EXPECT_TRUE(VerifyFile(FileReader(path)));
      EXPECT_FALSE(FileReader(path).HasMergeTree());
    }
    else
    {
      EXPECT_GATUN_ERROR(
        ErrorCode::Corrupt, path, "the table of merges", [&] { FileReader file(path); });
    }
  }
}

/** Merges of any points into any others: tetrahedra get turned over, flat, and long. */
TEST(HostileTrees, TreesThatDoNotFitTheMeshAreReadAllTheSame)
{
  auto image = GetGoodImage();
  const auto points = static_cast<std::uint32_t>(image.Meta.Points);
  const auto used = points - static_cast<std::uint32_t>(image.Meta.UnusedPoints);
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> left(used);
    std::iota(left.begin(), left.end(), 0u);
    std::shuffle(left.begin(), left.end(), random);
    std::vector<Merge> merges;
    while (left.size() > 1 + seed % 3)
    {
      const auto point = left.back();
      left.pop_back();
      merges.push_back({ point, left[random() % left.size()], 0 });
    }
    image.SetMerges(MergeTree(points, std::move(merges)));
    const auto path = PutFile("wild.gtn", image.Build());
    EXPECT_NO_THROW(ReadTree(path));
  }
}

/** Small, but with all that a file can have. */
Bytes MakeSmallFile()
{
  TreeSample sample(
    { { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1 }, { 0, 1, 2, 3, 1, 4, 2, 3 } });
  sample.AddArray<float>("T", Association::Point, ScalarType::Float32, 1, 1,
    [](std::size_t i, std::size_t, std::size_t) { return i * i; });
  sample.Tree = MergeTree(5, { { 4, 1, 0.5f }, { 0, 3, 2 } });
  const auto path = GetPath("small.gtn");
  WriterOptions options;
  options.Dependencies = true;
  WriteTreeSample(path, sample, options, { 1 });
  return ReadFile(path);
}

TEST(HostileTrees, EveryFlippedBitIsFound)
{
  const auto good = MakeSmallFile();
  ASSERT_LT(good.size(), 2600u);
  std::size_t openedOnly = 0;
  for (std::size_t at = 0; at < good.size(); ++at)
  {
    auto bytes = good;
    bytes[at] ^= static_cast<std::uint8_t>(1u << at % 8);
    const auto path = PutFile("flipped.gtn", bytes);
    const auto use = [&](auto&& call)
    {
      try
      {
        call();
        return true;
      }
      catch (const Error& error)
      {
        EXPECT_EQ(std::string(error.what()).find(path), 0u) << error.what();
        return false;
      }
    };
    openedOnly += use([&] { ReadTree(path); });
    EXPECT_FALSE(use([&] { VerifyFile(FileReader(path)); })) << at;
  }
  EXPECT_GT(openedOnly, 10u);             // headers of sections
  EXPECT_LT(openedOnly, good.size() / 2); // all else
}

TEST(HostileTrees, EveryTruncatedFileIsRefused)
{
  const auto good = MakeSmallFile();
  for (std::size_t size = 0; size < good.size(); ++size)
  {
    const auto path = PutFile("short.gtn", Bytes(good.data(), good.data() + size));
    EXPECT_THROW(FileReader{ path }, Error) << size;
  }
  // Base meshes that are too short, in files whose checksums are right.
  auto image = GetGoodImage();
  const auto level = image.Levels[1];
  for (std::size_t size = 0; size < level.size(); size += size < 200 ? 1 : 97)
  {
    image.Levels[1] = Bytes(level.data(), level.data() + size);
    const auto path = PutFile("short.gtn", image.Build());
    EXPECT_THROW(FileReader(path).OpenLevel(1), Error) << size;
    EXPECT_THROW(VerifyFile(FileReader(path)), Error) << size;
  }
}
}
