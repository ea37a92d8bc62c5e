// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes the golden files with merge trees: makeGoldenTrees FOLDER. Those that also have the
// dependencies of merges: makeGoldenTrees FOLDER dependencies.
// Testing/Python/make_golden_trees.py determines their contents.

#include "gatunTreeSample.h"

#include <cmath>
#include <iostream>
#include <limits>

namespace
{
using namespace gatun;
using namespace gatun::test;

constexpr float Infinity = std::numeric_limits<float>::infinity();

/** Two tetrahedra that have a face in common, and merges until nothing is left: the example of
 * Documentation/format.md. */
TreeSample MakeTwoTets()
{
  TreeSample sample(
    { { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1 }, { 0, 1, 2, 3, 1, 4, 2, 3 } });
  sample.CoordinateType = ScalarType::Float32;
  sample.AddArray<float>("T", Association::Point, ScalarType::Float32, 1, 1,
    [](std::size_t i, std::size_t, std::size_t) { return 20 + i * i; });
  sample.Tree = MergeTree(5, { { 4, 1, 0.5f }, { 0, 3, 2 } });
  return sample;
}

/** Merges that no builder makes: any points, errors from 0 to infinity, all points but one. */
TreeSample MakeWild()
{
  TreeSample sample(MakeSoup(40, 90));
  sample.AddArray<std::int8_t>("t", Association::Point, ScalarType::Int8, 1, 1,
    [](std::size_t i, std::size_t, std::size_t) { return static_cast<int>(i) - 20; });
  std::vector<bool> isUsed(sample.GetPoints(), false);
  for (const auto id : sample.Ids)
  {
    isUsed[static_cast<std::size_t>(id)] = true;
  }
  std::mt19937 random(4);
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < isUsed.size(); ++i)
  {
    if (isUsed[i])
    {
      left.push_back(i);
    }
  }
  const float errors[] = { 0, 0, std::numeric_limits<float>::denorm_min(), 1e-20f, 1.0f / 3, 1, 7,
    1e30f, std::numeric_limits<float>::max(), Infinity };
  std::vector<Merge> merges;
  const auto all = left.size();
  while (left.size() > 1)
  {
    std::swap(left[random() % left.size()], left.back());
    const auto point = left.back();
    left.pop_back();
    merges.push_back(
      { point, left[random() % left.size()], errors[merges.size() * std::size(errors) / all] });
  }
  sample.Tree = MergeTree(static_cast<std::uint32_t>(isUsed.size()), std::move(merges));
  return sample;
}

/** Values and coordinates that are no numbers or not finite: they stay out of some ranges. */
TreeSample MakeOdd()
{
  auto mesh = MakeCubes(3, 0.1);
  const double nan = std::nan("");
  mesh.Coordinates[3 * 5] = nan;
  mesh.Coordinates[3 * 9 + 1] = -Infinity;
  TreeSample sample(mesh);
  std::vector<double> field(sample.GetPoints());
  for (std::size_t i = 0; i < field.size(); ++i)
  {
    field[i] = static_cast<double>(i % 5);
  }
  sample.BuildTree(field);
  sample.AddArray<double>("odd", Association::Point, ScalarType::Float64, 2, 1,
    [&](std::size_t i, std::size_t c, std::size_t) {
      return i % 11 == 3 ? nan : i % 13 == 7 && c == 1 ? Infinity : 0.1 * double(i * i);
    });
  return sample;
}

/** Each point of one half goes to the other end of the mesh. */
TreeSample MakeFar()
{
  auto sample = MakeTreeSample(5, 1);
  std::vector<Merge> merges;
  const auto points = static_cast<std::uint32_t>(sample.GetPoints());
  for (std::uint32_t i = 1; i + 1 < points / 2; ++i)
  {
    merges.push_back({ i, points - 1 - i, 0.125f * static_cast<float>(i / 9) });
  }
  sample.Tree = MergeTree(points, std::move(merges));
  return sample;
}

void Write(const std::string& folder, const std::string& name, const TreeSample& sample,
  const WriterOptions& options, std::vector<double> levels = {})
{
  std::vector<std::uint32_t> merges;
  for (const auto part : levels)
  {
    merges.push_back(
      static_cast<std::uint32_t>(part * static_cast<double>(sample.Tree.GetMerges().size())));
  }
  WriteTreeSample(folder + "/" + name + ".gtn", sample, options, merges);
}

WriterOptions MakeOptions(std::uint32_t chunkTets = 0, std::uint8_t keep = KeepNone)
{
  WriterOptions options;
  options.ChunkTets = chunkTets;
  options.Keep = keep;
  options.KeyStepInterval = 2;
  return options;
}

/** All of these have them, base meshes too. */
void WriteDependencies(const std::string& folder)
{
  const auto write = [&](const std::string& name, const TreeSample& sample, std::uint32_t chunkTets,
                       const std::vector<double>& levels = {})
  {
    auto options = MakeOptions(chunkTets);
    options.Dependencies = true;
    Write(folder, name, sample, options, levels);
  };
  write("two_tets", MakeTwoTets(), 0);
  write("many_chunks", MakeTreeSample(5, 1), 64, { 0.3, 0.6 });
  write("wild", MakeWild(), 64);
  write("far", MakeFar(), 64);
}
}

int main(int argc, char* argv[])
{
  const bool hasDependencies = argc == 3 && argv[2] == std::string("dependencies");
  if (argc != 2 && !hasDependencies)
  {
    std::cerr << "usage: makeGoldenTrees FOLDER [dependencies]\n";
    return 2;
  }
  const std::string folder = argv[1];
  std::filesystem::create_directories(folder);
  if (hasDependencies)
  {
    WriteDependencies(folder);
    return 0;
  }
  Write(folder, "two_tets", MakeTwoTets(), MakeOptions());
  Write(folder, "two_tets_and_one", MakeTwoTets(), MakeOptions(), { 0.5 });
  Write(folder, "one_chunk", MakeTreeSample(4, 1), MakeOptions(0, KeepAll));
  Write(folder, "many_chunks", MakeTreeSample(5, 1), MakeOptions(64, KeepPoints), { 0.3, 0.6, 1 });
  Write(folder, "rungs", MakeTreeSample(8, 1), MakeOptions(500)); // so many points have two
  Write(folder, "steps", MakeTreeSample(4, 3), MakeOptions(100), { 0.5 });
  Write(folder, "wild", MakeWild(), MakeOptions(64, KeepCells));
  Write(folder, "odd", MakeOdd(), MakeOptions(64));
  Write(folder, "far", MakeFar(), MakeOptions(64));
  auto stiff = MakeTreeSample(2, 1);
  stiff.Tree = MergeTree(static_cast<std::uint32_t>(stiff.GetPoints()), {});
  Write(folder, "no_merges", stiff, MakeOptions());
  auto single = MakeTreeSample(3, 2);
  single.CoordinateType = ScalarType::Float32;
  single.Field.resize(1);
  single.Field[0].Name = "once";
  single.Field[0].Type = ScalarType::Float64;
  single.Field[0].VTKType = 11;
  single.Field[0].Values.assign(8, 3);
  Write(folder, "field_data", single, MakeOptions(80), { 0.4 });
  return 0;
}
