// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes the golden files with layers: makeGoldenLayers FOLDER.
// Testing/Python/make_golden_layers.py determines their contents.

#include "gatunTreeSample.h"

#include <cmath>
#include <iostream>
#include <limits>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** Layers of an array of a sample at its first step. */
WriterOptions MakeOptions(const TreeSample& sample, std::uint32_t chunkTets, std::uint32_t array,
  int component, std::uint32_t count, LayerSpacing spacing)
{
  WriterOptions options;
  options.ChunkTets = chunkTets;
  options.KeyStepInterval = 2;
  options.Layers.emplace();
  options.Layers->Array = array;
  options.Layers->Component = component;
  options.Layers->Count = count;
  options.Layers->Spacing = spacing;
  options.Layers->Values = sample.Steps[0][array].data();
  return options;
}

void WriteWithoutTree(
  const std::string& path, const TreeSample& sample, const WriterOptions& options)
{
  FileWriter writer(path, sample.GetInput(), sample.Arrays, options);
  WriteValues(writer, sample, sample.Field,
    [](const Bytes& values, const ArrayDescription&) { return values; });
}

/** The example of Documentation/format.md: two tetrahedra that share no point. */
TreeSample MakeTwoTets()
{
  TreeSample sample({ { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, 3, 0, 0, 2, 1, 0, 2, 0, 1 },
    { 0, 1, 2, 3, 4, 5, 6, 7 } });
  sample.CoordinateType = ScalarType::Float32;
  sample.AddArray<float>("T", Association::Point, ScalarType::Float32, 1, 1,
    [](std::size_t i, std::size_t, std::size_t) { return 20 + i * i; });
  return sample;
}

/** Values that are no numbers or not finite, in some places alone. */
TreeSample MakeOdd()
{
  TreeSample sample(MakeCubes(6, 0.1));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  sample.AddArray<double>("odd", Association::Point, ScalarType::Float64, 1, 1,
    [&](std::size_t i, std::size_t, std::size_t)
    {
      return i < 60   ? std::nan("")
        : i % 97 == 0 ? infinity
        : i % 89 == 0 ? -infinity
                      : 0.1 * static_cast<double>(i * i);
    });
  return sample;
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: makeGoldenLayers FOLDER\n";
    return 2;
  }
  const std::string folder = std::string(argv[1]) + "/";
  std::filesystem::create_directories(folder);
  const auto two = MakeTwoTets();
  WriteWithoutTree(
    folder + "two_layers.gtn", two, MakeOptions(two, 0, 0, 0, 2, LayerSpacing::Uniform));
  const auto odd = MakeOdd();
  WriteWithoutTree(
    folder + "odd.gtn", odd, MakeOptions(odd, 128, 0, 0, 5, LayerSpacing::Histogram));
  auto lengths = MakeTreeSample(5, 3);
  auto options = MakeOptions(lengths, 100, 0, -1, 6, LayerSpacing::Normal);
  options.Keep = KeepAll;
  WriteWithoutTree(folder + "lengths.gtn", lengths, options);
  auto same = MakeTreeSample(2, 1);
  same.AddArray<std::uint8_t>("same", Association::Point, ScalarType::UInt8, 1, 1,
    [](std::size_t, std::size_t, std::size_t) { return 7; });
  WriteWithoutTree(
    folder + "one_layer.gtn", same, MakeOptions(same, 0, 2, 0, 9, LayerSpacing::Uniform));
  const auto tree = MakeTreeSample(4, 1);
  const auto merges = static_cast<std::uint32_t>(tree.Tree.GetMerges().size());
  WriteTreeSample(folder + "base_meshes.gtn", tree,
    MakeOptions(tree, 64, 0, 1, 4, LayerSpacing::Histogram), { merges / 3, merges / 2 });
  return 0;
}
