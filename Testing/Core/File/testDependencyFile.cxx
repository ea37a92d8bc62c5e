// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files with the dependencies of their merges: they are those of the mesh, and damage is found.

#include "gatunDependencyCheck.h"
#include "gatunDependencyCodec.h"
#include "gatunHostileTrees.h"
#include "gatunMeshDependencies.h"
#include "gatunParallel.h"
#include "gatunSharedFile.h"
#include "gatunSurfaceTrees.h"
#include "gatunTestTrees.h"
#include "gatunTreeFile.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace
{
using namespace gatun;
using namespace gatun::test;

WriterOptions MakeOptions(const MergeTree& tree, bool dependencies = true, unsigned levels = 0)
{
  WriterOptions options;
  options.ChunkSize = 4000;
  options.Tree = &tree;
  if (levels > 0)
  {
    const auto merges = static_cast<std::uint32_t>(tree.GetMerges().size());
    options.LevelMerges = { merges / 2, 3 * (merges / 4) };
  }
  options.Dependencies = dependencies;
  return options;
}

/** Expects that a file has dependencies, and that they are those of its mesh. */
void ExpectDependencies(const std::shared_ptr<const FileReader>& file)
{
  ASSERT_TRUE(file->HasDependencies());
  const auto tree = file->GetMergeTree();
  const auto read = file->ReadDependencies(tree);
  const auto found = FindDependencies(file, tree);
  ASSERT_TRUE(found);
  EXPECT_TRUE(AreEquivalent(read, *found));
  std::size_t any = 0;
  for (std::size_t i = 0; i < read.GetNumberOfMerges(); ++i)
  {
    any += read.Get(i).size();
  }
  EXPECT_GT(any, read.GetNumberOfMerges());
  EXPECT_TRUE(VerifyFile(*file));
}

/** A mesh with base meshes and a boundary. */
std::string WriteLarge(bool dependencies)
{
  static const auto mesh = MakeMesh(22); // 63,888 tetrahedra
  static const auto tree = BuildTree(mesh);
  const std::string path = TempPath(dependencies ? "dependencies.gtn" : "independent.gtn");
  auto options = MakeOptions(tree, dependencies, 8);
  options.Boundary = true;
  Write(path, mesh, options, 2);
  return path;
}

TEST(DependencyFile, MeshBaseMeshesAndBoundaryHaveThoseOfAReplay)
{
  const auto file = std::make_shared<const FileReader>(WriteLarge(true));
  ExpectDependencies(file);
  EXPECT_GT(file->GetStatistics().DependencyBytes, 0u);
  ASSERT_GE(file->GetLevels().size(), 2u);
  for (std::size_t level = 0; level < file->GetLevels().size(); ++level)
  {
    ExpectDependencies(file->OpenLevel(level));
  }
  ExpectDependencies(file->OpenBoundary());
}

TEST(DependencyFile, SurfacesHaveThoseOfTheirTriangles)
{
  const auto path = TempPath("surface.gtn");
  const auto sample = MakeSurfaceSample(20, 12, 2);
  WriteTreeSample(path, sample, MakeOptions(sample.Tree));
  ExpectDependencies(std::make_shared<const FileReader>(path));
}

TEST(DependencyFile, NothingElseIsInTheFile)
{
  const FileReader with(WriteLarge(true)), without(WriteLarge(false));
  EXPECT_FALSE(without.HasDependencies());
  EXPECT_EQ(without.GetStatistics().DependencyBytes, 0u);
  EXPECT_THROW(without.ReadDependencies(without.GetMergeTree()), Error);
  EXPECT_NEAR(static_cast<double>(with.GetStatistics().TreeBytes),
    static_cast<double>(without.GetStatistics().TreeBytes), 100); // where the streams are
  EXPECT_LT(with.GetStatistics().DependencyBytes, 3 * with.GetNumberOfMerges());
  // Without base meshes, the section, its place in the directory and that of the stream are added.
  const auto mesh = MakeMesh(8);
  const auto tree = BuildTree(mesh);
  std::vector<std::uint64_t> sizes;
  std::uint64_t bytes = 0;
  for (const bool dependencies : { false, true })
  {
    const auto path = TempPath("plain.gtn");
    Write(path, mesh, MakeOptions(tree, dependencies));
    sizes.push_back(ReadFile(path).size());
    bytes = FileReader(path).GetStatistics().DependencyBytes;
  }
  const auto added = bytes + 2 * SectionHeaderSize + sizeof(std::uint64_t);
  EXPECT_GE(sizes[1] - sizes[0], added);
  EXPECT_LE(sizes[1] - sizes[0], added + 32);
}

TEST(DependencyFile, TreesWithoutMergesHaveNoSection)
{
  const auto mesh = MakeSoup(40, 200);
  const MergeTree tree(40, {});
  const auto path = TempPath("stiff.gtn");
  Write(path, mesh, MakeOptions(tree));
  EXPECT_FALSE(FileReader(path).HasDependencies());
  auto file = std::make_shared<const FileReader>(path);
  const auto found = SharedFile(file).GetDependencies(*file);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->GetNumberOfMerges(), 0u);
}

TEST(DependencyFile, MergesThatTurnTetrahedraOverHaveDependenciesToo)
{
  const auto mesh = MakeCubes(6, 0.2);
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    const auto tree = MakeWildTree(static_cast<std::uint32_t>(mesh.GetPoints()), seed);
    const auto path = TempPath("wild.gtn");
    Write(path, mesh, MakeOptions(tree));
    ExpectDependencies(std::make_shared<const FileReader>(path));
  }
}

TEST(DependencyFile, TheNumberOfThreadsDoesNotMatter)
{
  const auto mesh = MakeMesh(12);
  const auto tree = BuildTree(mesh);
  std::vector<Bytes> files;
  for (const int threads : { 1, 4 })
  {
    WithNumberOfThreads(threads,
      [&]
      {
        const auto path = TempPath("threads.gtn");
        Write(path, mesh, MakeOptions(tree));
        files.push_back(ReadFile(path));
      });
  }
  EXPECT_EQ(files[0], files[1]);
}

TEST(DependencyFile, WritingCanBeAbortedAtAnyTime)
{
  const auto mesh = MakeMesh(12);
  const auto tree = BuildTree(mesh);
  for (const int threads : { 1, 4 })
  {
    WithNumberOfThreads(threads,
      [&]
      {
        const auto path = TempPath("aborted.gtn");
        bool isAborted = true;
        for (int calls = 0; isAborted; ++calls)
        {
          ASSERT_LT(calls, 1000);
          int left = calls;
          try
          {
            FileWriter writer(path, mesh.GetInput(), Values::Describe(), MakeOptions(tree),
              [&](double) { return left-- > 0; });
            isAborted = false;
          }
          catch (const Error& error)
          {
            EXPECT_EQ(error.Code, ErrorCode::Aborted);
          }
          EXPECT_FALSE(std::filesystem::exists(path));
        }
      });
  }
}

TEST(DependencyFile, SharedFilesReadThemOnceOrFindThem)
{
  const std::string paths[] = { WriteLarge(true), WriteLarge(false) };
  for (std::size_t merges : { std::size_t{ 100 }, std::size_t{ 9000 } })
  {
    std::vector<std::shared_ptr<const MergeDependencies>> both;
    for (const auto& path : paths)
    {
      SharedFile file(std::make_shared<const FileReader>(path));
      const auto place = file.Find(merges);
      ASSERT_TRUE(place.Tree);
      EXPECT_EQ(file.GetTree(*place.File), place.Tree);
      const auto before = file.GetBytesRead();
      std::vector<std::shared_ptr<const MergeDependencies>> found(4);
      std::vector<std::thread> threads;
      for (auto& one : found)
      {
        threads.emplace_back([&] { one = file.GetDependencies(*place.File); });
      }
      for (auto& thread : threads)
      {
        thread.join();
      }
      ASSERT_TRUE(found[0]);
      EXPECT_EQ(std::count(found.begin(), found.end(), found[0]), 4);
      const auto bytes = file.GetBytesRead() - before;
      EXPECT_EQ(file.GetDependencies(*place.File), found[0]);
      EXPECT_EQ(file.GetBytesRead() - before, bytes);
      if (place.File->HasDependencies())
      {
        EXPECT_GT(bytes, 0u);
        const auto statistics = file.GetFile()->GetStatistics();
        EXPECT_LE(bytes, statistics.DependencyBytes + statistics.TreeBytes);
      }
      else
      {
        EXPECT_GT(bytes, place.File->GetStatistics().ConnectivityBytes);
      }
      EXPECT_EQ(found[0]->GetNumberOfMerges(), place.Tree->GetMerges().size());
      both.push_back(found[0]);
    }
    EXPECT_TRUE(AreEquivalent(*both[0], *both[1]));
  }
  SharedFile file(std::make_shared<const FileReader>(paths[1]));
  EXPECT_THROW(file.GetDependencies(FileReader(paths[1])), Error);
  // An abort does not stay.
  const auto& whole = *file.GetFile();
  EXPECT_THROW(file.GetDependencies(whole, [](double) { return false; }), Error);
  EXPECT_TRUE(file.GetDependencies(whole, [](double) { return true; }));
}

/** The good image without base meshes, and with a stream of dependencies, if it has bytes. */
std::string PutImage(const Bytes& stream)
{
  auto image = GetGoodImage();
  image.RemoveLevels();
  image.Parts.front().Dependencies = stream;
  return PutFile("changed.gtn", image.Build());
}

/** The dependencies of that image's mesh. */
Bytes GetGoodStream()
{
  const auto file = std::make_shared<const FileReader>(PutImage({}));
  const auto tree = file->GetMergeTree();
  return EncodeDependencies(tree, FindDependencies(file, tree).value());
}

TEST(DependencyFile, DamagedStreamsAreNamed)
{
  const auto good = GetGoodStream();
  const auto path = PutImage(good);
  EXPECT_TRUE(VerifyFile(FileReader(path)));
  std::mt19937 random(5);
  std::size_t refused = 0;
  for (int i = 0; i < 200; ++i)
  {
    auto bad = good;
    if (i % 2 == 0)
    {
      bad.resize(1 + random() % (bad.size() - 1));
    }
    else
    {
      bad[random() % bad.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
    }
    PutImage(bad);
    const FileReader file(path); // which does not read them
    const auto tree = file.GetMergeTree();
    try
    {
      EXPECT_EQ(file.ReadDependencies(tree).GetNumberOfMerges(), tree.GetMerges().size());
      // Others than those of the mesh, if any are different at all.
      VerifyFile(file);
    }
    catch (const Error& error)
    {
      ++refused;
      EXPECT_EQ(error.Code, ErrorCode::Corrupt);
      EXPECT_NE(std::string(error.what()).find("the dependencies of merges"), std::string::npos)
        << error.what();
      EXPECT_EQ(std::string(error.what()).find(path), 0u) << error.what();
    }
  }
  EXPECT_GT(refused, 180u);
}

TEST(DependencyFile, VerifyFindsThoseOfAnotherMesh)
{
  const auto good = std::make_shared<const FileReader>(PutImage({}));
  const auto tree = good->GetMergeTree();
  MergeDependencies none, chain;
  for (std::uint32_t i = 0; i < tree.GetMerges().size(); ++i)
  {
    none.Add({});
    chain.Add(i > 0 ? std::vector<std::uint32_t>{ i - 1 } : std::vector<std::uint32_t>{});
  }
  for (const auto& other : { none, chain })
  {
    const auto path = PutImage(EncodeDependencies(tree, other));
    EXPECT_NO_THROW(FileReader(path).ReadDependencies(tree));
    EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path,
      "the dependencies of merges are not those of the mesh",
      [&] { VerifyFile(FileReader(path)); });
  }
}

TEST(DependencyFile, ATreeOfAnotherFileIsRefused)
{
  const FileReader file(PutImage(GetGoodStream()));
  EXPECT_THROW(file.ReadDependencies(MergeTree(7, {})), Error);
}

TEST(DependencyFile, MergesOfAllPointsIntoOneHaveNone)
{
  const auto mesh = MakeCubes(30, 0.2);
  std::vector<Merge> merges;
  for (std::uint32_t i = 1; i < mesh.GetPoints(); ++i)
  {
    merges.push_back({ i, 0, 0 });
  }
  const MergeTree tree(static_cast<std::uint32_t>(mesh.GetPoints()), std::move(merges));
  const auto path = TempPath("star.gtn");
  Write(path, mesh, MakeOptions(tree));
  const auto file = std::make_shared<const FileReader>(path);
  EXPECT_FALSE(file->HasDependencies());
  EXPECT_TRUE(VerifyFile(*file));
  EXPECT_FALSE(SharedFile(file).GetDependencies(*file));
}

/** Each merge of a chain into one point depends on the first one: all are skipped for it. */
TEST(DependencyFile, WorkIsInProportionToTheMerges)
{
  constexpr std::uint32_t points = 200'000;
  std::vector<Merge> merges;
  for (std::uint32_t i = 1; i < points; ++i)
  {
    merges.push_back({ i, 0, 0 });
  }
  const MergeTree tree(points, std::move(merges));
  MergeDependencies onFirst, onLast;
  const std::vector<std::uint32_t> first{ 0 };
  for (std::uint32_t i = 0; i + 1 < points; ++i)
  {
    const std::vector<std::uint32_t> last{ i - 1 };
    onFirst.Add(i > 0 ? std::span<const std::uint32_t>(first) : std::span<const std::uint32_t>());
    onLast.Add(i > 0 ? std::span<const std::uint32_t>(last) : std::span<const std::uint32_t>());
  }
  EXPECT_TRUE(EncodeDependencies(tree, onFirst).empty());
  const auto stream = EncodeDependencies(tree, onLast);
  EXPECT_FALSE(stream.empty());
  EXPECT_TRUE(AreEquivalent(DecodeDependencies(stream, tree), onLast));
}
}
