// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Base meshes of files with a merge tree, and trees that files cannot have.

#include "gatunError.h"
#include "gatunPieceDecoder.h"
#include "gatunTestTrees.h"
#include "gatunTreeFile.h"
#include "gatunVerifyFile.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace gatun::test
{
namespace
{
TEST(TreeFile, BaseMeshesAreWhatIsLeft)
{
  const auto mesh = MakeMesh(22); // 63,888 tetrahedra
  const auto tree = BuildTree(mesh);
  const auto path = TempPath("levels.gtn");
  WriterOptions options;
  options.ChunkSize = 5000;
  options.Tree = &tree;
  options.Levels = 8;
  Write(path, mesh, options, 2);
  const auto file = std::make_shared<const FileReader>(path);
  ASSERT_GE(file->GetLevels().size(), 1u);
  EXPECT_TRUE(VerifyFile(*file));
  for (std::size_t i = 0; i < file->GetLevels().size(); ++i)
  {
    const auto level = file->OpenLevel(i);
    const auto merges = file->GetLevels()[i];
    // An eighth of the points and so on, and no more than a group of merges more.
    const auto most = (mesh.GetPoints() + 7) >> (i + 3);
    EXPECT_GE(level->GetNumberOfPoints(), most);
    EXPECT_LE(level->GetNumberOfPoints(), most + most / 8);
    const auto rest = std::make_shared<const MergeTree>(level->GetMergeTree());
    EXPECT_EQ(rest->GetMerges().size(), tree.GetMerges().size() - merges);
    for (const std::size_t more : { std::size_t{ 0 }, rest->GetMerges().size() / 3 })
    {
      auto request = AskForAll(*level);
      request.Step = 1;
      request.Merges = more;
      request.Tree = rest;
      PieceDecoder decoder(level);
      const Piece piece(decoder, request);
      const Left left(mesh, Values(mesh, 0.25), tree, merges + more);
      EXPECT_EQ(piece.Mesh.GetPoints(), left.Mesh.GetPoints());
      EXPECT_EQ(GetCells(piece.Mesh, piece), GetCells(left.Mesh, left)) << i << " " << more;
    }
  }
}

TEST(TreeFile, MoreMergesThanThereAreAreRefused)
{
  const auto mesh = MakeMesh(4);
  const auto tree = BuildTree(mesh);
  const auto path = TempPath("few.gtn");
  WriterOptions options;
  options.Tree = &tree;
  Write(path, mesh, options);
  const FileReader file(path);
  const auto all = file.GetNumberOfMerges();
  EXPECT_NO_THROW(file.GetChunkBounds(0, all));
  EXPECT_NO_THROW(file.GetChunkRanges(0, 0, 0, all));
  EXPECT_THROW(file.GetChunkBounds(0, all + 1), Error);
  EXPECT_THROW(file.GetChunkRanges(0, 0, 0, all + 1), Error);
  EXPECT_NO_THROW(file.GetChunkRanges(2, 0, 0, all + 1)); // values of cells stay as they are
  EXPECT_THROW(file.OpenLevel(0), Error);
}

TEST(TreeFile, MeshesThatCannotBeSimplifiedHaveATreeWithoutMerges)
{
  const auto mesh = MakeSoup(40, 200);
  const MergeTree tree(40, {});
  const auto path = TempPath("stiff.gtn");
  WriterOptions options;
  options.Tree = &tree;
  options.Levels = 3;
  Write(path, mesh, options);
  const FileReader file(path);
  EXPECT_TRUE(file.HasMergeTree());
  EXPECT_EQ(file.GetNumberOfMerges(), 0u);
  EXPECT_TRUE(file.GetLevels().empty());
  EXPECT_EQ(file.GetMergeTree().GetNumberOfPoints(), 40u);
  EXPECT_TRUE(VerifyFile(file));
}

TEST(TreeFile, FilesWithoutATreeSayThatThereIsNone)
{
  const auto mesh = MakeMesh(3);
  const auto path = TempPath("notree.gtn");
  Write(path, mesh, {});
  const auto file = std::make_shared<const FileReader>(path);
  EXPECT_FALSE(file->HasMergeTree());
  EXPECT_EQ(file->GetNumberOfMerges(), 0u);
  EXPECT_TRUE(file->GetLevels().empty());
  auto request = AskForAll(*file);
  request.Merges = 1;
  PieceDecoder decoder(file);
  EXPECT_THROW(decoder.SetRequest(request), Error);
  request.Tree = std::make_shared<const MergeTree>(file->GetMergeTree());
  EXPECT_THROW(decoder.SetRequest(request), Error);
}

TEST(TreeFile, TreesOfOtherMeshesAreRefused)
{
  const auto mesh = MakeMesh(3);
  const auto tree = MakeWildTree(static_cast<std::uint32_t>(mesh.GetPoints() + 1), 1);
  WriterOptions options;
  options.Tree = &tree;
  EXPECT_THROW(Write(TempPath("other.gtn"), mesh, options), Error);
  options.Tree = nullptr;
  options.Levels = 1;
  EXPECT_THROW(Write(TempPath("other.gtn"), mesh, options), Error);
}
}
}
