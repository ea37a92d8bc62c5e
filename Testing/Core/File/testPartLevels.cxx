// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Base meshes of a mesh that is written in parts are what is left of it, with all values.

#include "gatunDependencyCheck.h"
#include "gatunError.h"
#include "gatunHostile.h"
#include "gatunMeshDependencies.h"
#include "gatunMeshParts.h"
#include "gatunParallel.h"
#include "gatunTestFile.h"
#include "gatunVerifyFile.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gatun::test
{
namespace
{
constexpr int StepsOfLevels = 2;

PartWriterOptions MakeLevelSettings(std::uint64_t tetsOfGroup)
{
  PartWriterOptions options;
  options.File.ChunkSize = 4000;
  options.File.Levels = 8;
  options.Weights = { 1, 0.5, 0, 0, 0 };
  options.TetsOfGroup = tetsOfGroup;
  return options;
}

/** Six tetrahedra in each of n^3 cubes, and points that none of them has. */
PartMesh MakeLevelParts(std::int64_t n = 28)
{
  auto cubes = MakeCubes(n, 0.2);
  cubes.Coordinates.insert(cubes.Coordinates.end(), { 50, 0, 0, 51, 0, 0 });
  return MakePartMesh(cubes);
}

std::string WriteLevels(const std::string& name, const PartMesh& mesh, std::size_t parts,
  const PartWriterOptions& options, int steps = StepsOfLevels, double height = 28)
{
  const auto path = TempPath(name);
  WriteParts(path, Divide(mesh, parts, DealSlabs(mesh, parts, height)), options, steps);
  return path;
}

/** Compares base meshes with the whole mesh after merges, as many as lead to them and then more. */
void ExpectWhatIsLeft(const std::string& path, std::size_t steps = StepsOfLevels)
{
  const auto file = std::make_shared<const FileReader>(path);
  EXPECT_TRUE(VerifyFile(*std::make_shared<FileReader>(path)));
  for (std::size_t i = 0; i < file->GetLevels().size(); ++i)
  {
    const auto level = file->OpenLevel(i);
    const auto merges = file->GetLevels()[i];
    EXPECT_EQ(level->GetNumberOfPoints(), file->GetNumberOfPoints() - merges);
    for (const std::size_t more : { std::size_t{ 0 }, level->GetNumberOfMerges() / 3 })
    {
      const auto step = more == 0 ? steps - 1 : 0;
      const PartContent base(level, step, more);
      const PartContent whole(file, step, merges + more);
      EXPECT_EQ(ListCells(base.Mesh, base.Values), ListCells(whole.Mesh, whole.Values))
        << i << " " << more;
    }
  }
}

/** How many base meshes there are, the first with about an eighth of the points, and each further
 * one with half. */
std::size_t CountHalves(const std::string& path)
{
  const FileReader file(path);
  auto before = static_cast<double>(file.GetNumberOfPoints()) / 4;
  for (const auto merges : file.GetLevels())
  {
    const auto left = static_cast<double>(file.GetNumberOfPoints() - merges);
    EXPECT_LT(left, 0.75 * before);
    EXPECT_GT(left, 0.3 * before);
    before = left;
  }
  return file.GetLevels().size();
}
}

TEST(PartLevels, AreWhatIsLeft)
{
  // In one group; in groups until 60,000 tetrahedra are left, so that the second one is in one
  // group; and in more groups.
  for (const std::uint64_t group : { 1000000, 60000, 12000 })
  {
    const std::int64_t edge = group == 1000000 ? 36 : 28; // so that there are two
    const auto path = WriteLevels("partLevels.gtn", MakeLevelParts(edge), 3,
      MakeLevelSettings(group), StepsOfLevels, static_cast<double>(edge));
    EXPECT_GE(CountHalves(path), group == 1000000 ? 2u : 1u) << group;
    ExpectWhatIsLeft(path);
  }
}

TEST(PartLevels, HaveTheRoundedValuesOfTheMesh)
{
  auto options = MakeLevelSettings(20000);
  options.File.Errors = { { "point", { ErrorKind::Absolute, 0.05 } },
    { "level", { ErrorKind::Relative, 0.01 } } };
  options.File.Levels = 2;
  const PartMesh mesh = MakeLevelParts();
  const auto path = WriteLevels("partLevelsRounded.gtn", mesh, 2, options);
  EXPECT_GE(CountHalves(path), 1u);
  ExpectWhatIsLeft(path);
  // And they are rounded.
  const PartContent whole(path, 1);
  EXPECT_NE(ListCells(whole.Mesh, whole.Values), ListCells(mesh, PartValues(mesh, 1)));
}

TEST(PartLevels, OfCellsOfAllKindsAndOfNoSteps)
{
  const PartMesh mixed = MakePartMesh(Mixture(18));
  auto options = MakeLevelSettings(15000);
  options.File.Levels = 3;
  const auto path = WriteLevels("partLevelsMixed.gtn", mixed, 3, options, 1, 18);
  EXPECT_GE(FileReader(path).GetLevels().size(), 1u);
  ExpectWhatIsLeft(path, 1);
  const auto bare = WriteLevels("partLevelsBare.gtn", MakeLevelParts(), 2, options, 0);
  EXPECT_GE(CountHalves(bare), 1u);
  EXPECT_TRUE(VerifyFile(*std::make_shared<FileReader>(bare)));
}

TEST(PartLevels, HaveTheDependenciesOfAReplayAsTheWholeMeshHas)
{
  for (const std::uint64_t group : { 1000000, 12000 })
  {
    auto options = MakeLevelSettings(group);
    options.File.Dependencies = true;
    const auto path = WriteLevels("partLevelsDependent.gtn", MakeLevelParts(), 3, options, 1);
    const auto whole = std::make_shared<const FileReader>(path);
    EXPECT_TRUE(VerifyFile(*std::make_shared<FileReader>(path)));
    std::vector<std::shared_ptr<const FileReader>> files{ whole };
    for (std::size_t i = 0; i < whole->GetLevels().size(); ++i)
    {
      files.push_back(whole->OpenLevel(i));
    }
    EXPECT_GE(files.size(), 2u);
    for (const auto& file : files)
    {
      ASSERT_TRUE(file->HasDependencies());
      const auto tree = file->GetMergeTree();
      const auto found = FindDependencies(file, tree);
      ASSERT_TRUE(found);
      EXPECT_TRUE(AreEquivalent(file->ReadDependencies(tree), *found)) << group;
    }
  }
}

TEST(PartLevels, DoNotDependOnThreads)
{
  std::string first;
  for (const int threads : { 1, 2, 5 })
  {
    std::string bytes;
    auto options = MakeLevelSettings(12000);
    options.File.Dependencies = true;
    WithNumberOfThreads(threads,
      [&] {
        bytes = ReadBytes(WriteLevels("partLevelsThreads.gtn", MakeLevelParts(), 4, options, 1));
      });
    first = first.empty() ? bytes : first;
    EXPECT_TRUE(bytes == first) << threads;
  }
}

TEST(PartLevels, NeedAHierarchyAndStopWithoutATrace)
{
  const auto path = GetPath("partLevelsErrors.gtn");
  auto options = MakeLevelSettings(12000);
  options.Weights.reset();
  EXPECT_THROW(PartWriter(path, PartMesh::Describe(), options), Error);
  const PartMesh mesh = MakeLevelParts();
  const PartValues values(mesh, 0);
  for (const double last : { 0.3, 0.7, 1.0 })
  {
    double before = 0;
    const auto goesOn = [&](double done)
    {
      const bool stays = done > 0.5 && done == before; // as while a base mesh is written
      before = done;
      return done < last && !(last == 1 && stays);
    };
    PartWriter writer(path, PartMesh::Describe(), MakeLevelSettings(12000));
    writer.Survey(mesh.GetInput());
    writer.SurveyStep(values.Get());
    writer.Write(mesh.GetInput());
    writer.WriteStep(values.Get());
    EXPECT_THROW(writer.Finish(goesOn), Error);
  }
  EXPECT_TRUE(ListFolder(path).empty());
}
}
