// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes the golden files of surfaces with merge trees: makeGoldenSurfaceTrees FOLDER. Those that
// also have the dependencies of merges: makeGoldenSurfaceTrees FOLDER dependencies.
// Testing/Python/make_golden_trees.py determines their contents.

#include "gatunSurfaceTrees.h"

#include <iostream>
#include <numeric>
#include <random>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** Two triangles on each side of a seam, whose points are merged together: the example of
 * Documentation/format.md. */
TreeSample MakeSeam()
{
  TreeSample sample;
  sample.Coordinates = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0, 2, 1, 0 };
  sample.Singles.assign(sample.Coordinates.begin(), sample.Coordinates.end());
  sample.CoordinateType = ScalarType::Float32;
  sample.Ids = { 0, 1, 2, 0, 2, 3, 4, 6, 5, 5, 6, 7 };
  sample.Types = { 5, 5, 5, 5 };
  sample.Offsets = { 0, 3, 6, 9, 12 };
  sample.AddArray<float>("T", Association::Point, ScalarType::Float32, 1, 1,
    [](std::size_t i, std::size_t, std::size_t) { return 20 + i * i; });
  sample.Tree =
    MergeTree(8, { { 1, 2, 0.5f }, { 4, 5, 0.5f }, { 3, 2, 2 } }, { true, false, false });
  return sample;
}

/** Merges that no builder makes: any points, those of all cells and of none, and any bonds. */
TreeSample MakeWild()
{
  auto sample = MakeSurfaceSample(9, 6, 1);
  std::mt19937 random(4);
  const auto points = static_cast<std::uint32_t>(sample.GetPoints());
  std::vector<std::uint32_t> left(points - 1); // nothing is merged into the last, of no cell
  std::iota(left.begin(), left.end(), 0u);
  std::vector<Merge> merges{ { points - 1, 0, 0 } };
  std::vector<bool> bonds{ true };
  while (left.size() > 1)
  {
    std::swap(left[random() % left.size()], left.back());
    const auto point = left.back();
    left.pop_back();
    merges.push_back(
      { point, left[random() % left.size()], 0.25f * static_cast<float>(merges.size() / 7) });
    bonds.push_back(random() % 3 == 0);
  }
  bonds.back() = false;
  sample.Tree = MergeTree(points, std::move(merges), std::move(bonds));
  return sample;
}

void Write(const std::string& folder, const std::string& name, const TreeSample& sample,
  std::uint32_t chunkTets, std::uint8_t keep, const std::vector<double>& levels = {},
  bool hasDependencies = false)
{
  WriterOptions options;
  options.ChunkTets = chunkTets;
  options.Keep = keep;
  options.Dependencies = hasDependencies;
  options.KeyStepInterval = 2;
  std::vector<std::uint32_t> merges;
  for (const auto part : levels)
  {
    const auto all = static_cast<double>(sample.Tree.GetMerges().size());
    merges.push_back(static_cast<std::uint32_t>(
      sample.Tree.CountWholeMerges(static_cast<std::size_t>(part * all))));
  }
  WriteTreeSample(folder + "/" + name + ".gtn", sample, options, merges);
}
}

int main(int argc, char* argv[])
{
  const bool hasDependencies = argc == 3 && argv[2] == std::string("dependencies");
  if (argc != 2 && !hasDependencies)
  {
    std::cerr << "usage: makeGoldenSurfaceTrees FOLDER [dependencies]\n";
    return 2;
  }
  const std::string folder = argv[1];
  std::filesystem::create_directories(folder);
  if (hasDependencies)
  {
    Write(folder, "surface_seam", MakeSeam(), 0, KeepNone, {}, true);
    Write(folder, "surface_chunks", MakeSurfaceSample(16, 8, 1), 64, KeepNone, { 0.3, 0.6 }, true);
    Write(folder, "surface_wild", MakeWild(), 64, KeepNone, {}, true);
    return 0;
  }
  Write(folder, "seam", MakeSeam(), 0, KeepNone);
  Write(folder, "seam_and_one", MakeSeam(), 0, KeepNone, { 0.7 });
  Write(folder, "one_chunk", MakeSurfaceSample(10, 6, 1), 0, KeepAll);
  Write(folder, "many_chunks", MakeSurfaceSample(16, 8, 1), 64, KeepPoints, { 0.3, 0.6, 1 });
  Write(folder, "steps", MakeSurfaceSample(12, 8, 3), 64, KeepNone, { 0.5 });
  Write(folder, "wild", MakeWild(), 64, KeepCells);
  auto stiff = MakeSurfaceSample(8, 6, 1);
  stiff.Tree = MergeTree(static_cast<std::uint32_t>(stiff.GetPoints()), {});
  Write(folder, "no_merges", stiff, 0, KeepNone);
  return 0;
}
