// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes those golden files that need private functions of the core: makeGolden FOLDER. Testing/
// Python/make_golden.py runs it. For each file it prints checksums of what was written: of a mesh
// its coordinates, the points of its cells, and its arrays at each step, if the order is kept, and
// of a volume its voxels, if they come back exactly.

#include "gatunError.h"
#include "gatunHartleyFile.h"
#include "gatunHartleySample.h"
#include "gatunSurfaceTrees.h"

#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <numeric>
#include <random>

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
TreeSample MakeAnyMerges()
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
TreeSample MakeAnySurfaceMerges()
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

std::string GetSum(std::span<const std::uint8_t> bytes)
{
  std::array<char, 18> text{};
  std::snprintf(
    text.data(), text.size(), " %016llx", static_cast<unsigned long long>(Checksum(bytes)));
  return text.data();
}

template <typename T>
std::string GetSum(const std::vector<T>& values)
{
  return GetSum(std::span<const std::uint8_t>(
    reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)));
}

/** Writes a file with dependencies. levels: for each base mesh, which part of the merges comes
 * before. */
void Write(const std::string& folder, const std::string& name, const TreeSample& sample,
  std::uint32_t chunkTets, const std::vector<double>& levels = {}, int layers = 0,
  std::uint8_t keep = KeepAll)
{
  WriterOptions options;
  options.Coding = Profile::Small;
  options.ChunkSize = chunkTets;
  options.Keep = keep;
  options.Dependencies = true;
  options.KeyStepInterval = 2;
  if (layers > 0)
  {
    options.Layers.emplace();
    options.Layers->Component = 1;
    options.Layers->Count = static_cast<std::uint32_t>(layers);
    options.Layers->Spacing = LayerSpacing::Histogram;
    options.Layers->Values = sample.Steps[0][0].data();
  }
  std::vector<std::uint32_t> merges;
  for (const auto part : levels)
  {
    const auto all = static_cast<double>(sample.Tree.GetMerges().size());
    merges.push_back(static_cast<std::uint32_t>(
      sample.Tree.CountWholeMerges(static_cast<std::size_t>(part * all))));
  }
  WriteTreeSample(folder + "/" + name + ".gtn", sample, options, merges);
  if (keep != KeepAll)
  {
    return;
  }
  std::cout << name << ".gtn"
            << (sample.CoordinateType == ScalarType::Float32 ? GetSum(sample.Singles)
                                                             : GetSum(sample.Coordinates))
            << GetSum(sample.Ids);
  for (const auto& step : sample.Steps)
  {
    for (const Bytes& values : step)
    {
      std::cout << GetSum(std::span<const std::uint8_t>(values));
    }
  }
  std::cout << "\n";
}

void WriteMeshes(const std::string& folder)
{
  Write(folder, "two_tets", MakeTwoTets(), 0, {}, 0, KeepNone);
  Write(folder, "seam", MakeSeam(), 0, {}, 0, KeepNone);
  Write(folder, "base_meshes", MakeTreeSample(4, 1), 64, { 1.0 / 3, 0.5, 1 }, 4);
  auto steps = MakeTreeSample(3, 3);
  steps.CoordinateType = ScalarType::Float32;
  steps.Field.resize(1);
  steps.Field[0].Name = "once";
  steps.Field[0].Type = ScalarType::Float64;
  steps.Field[0].VTKType = 11;
  steps.Field[0].Values.assign(8, 3);
  Write(folder, "base_meshes_at_steps", steps, 80, { 0.4 });
  Write(folder, "any_merges", MakeAnyMerges(), 64);
  Write(folder, "merges_of_odd_points", MakeOdd(), 64);
  auto mergeCounts = MakeTreeSample(8, 1); // so many points have two
  mergeCounts.Arrays.clear();
  mergeCounts.Steps.assign(1, {});
  Write(folder, "merge_counts", mergeCounts, 500);
  Write(folder, "surface_base_meshes", MakeSurfaceSample(10, 8, 2), 64, { 0.3, 0.6 });
  Write(folder, "surface_any_merges", MakeAnySurfaceMerges(), 64);
}

void WriteVolume(const std::string& folder, const std::string& name, const SampleVolume& volume,
  std::uint32_t blockSize, const HartleyRateControl& rateControl)
{
  HartleyWriterOptions options;
  options.BlockSize = blockSize;
  options.RateControl = rateControl;
  WriteHartleyFile(folder + "/" + name + ".ghv", volume.Input, options);
  if (rateControl.Mode == HartleyRateMode::RMSError && rateControl.Value == 0)
  {
    std::cout << name << ".ghv" << GetSum(volume.Data) << "\n";
  }
}

void WriteVolumes(const std::string& folder)
{
  using Mode = HartleyRateMode;
  auto placed = MakePhantom({ 21, 18, 13 }, ScalarType::Int16);
  placed.Input.Name = "density";
  placed.Input.VTKType = 4;
  placed.Input.Origin = { 1, -2, 3.5 };
  placed.Input.Spacing = { 0.5, 0.25, 2 };
  placed.Input.Direction = { 0, 1, 0, -1, 0, 0, 0, 0, 1 };
  placed.Input.FirstIndex = { -4, 0, 7 };
  WriteVolume(folder, "placed_volume", placed, 8, { Mode::Quality, 50, 1.5 });
  WriteVolume(folder, "small_volume",
    MakeVolume({ 4, 2, 2 }, ScalarType::UInt8,
      [](auto x, auto y, auto z) { return 10 * x + 3 * y + 7 * z * z; }),
    2, { Mode::RMSError, 1, 0 });
  WriteVolume(folder, "volume_of_floats", MakePhantom({ 40, 33, 32 }, ScalarType::Float32), 32,
    { Mode::PSNR, 30, 0 });
  WriteVolume(folder, "thin_volume", MakePhantom({ 100, 1, 37 }, ScalarType::Int8), 64,
    { Mode::RMSError, 1, 0 });
  WriteVolume(folder, "one_block", MakePhantom({ 31, 22, 17 }, ScalarType::UInt8), 0,
    { Mode::RMSError, 2, 0 });
  WriteVolume(
    folder, "segments", MakePhantom({ 72, 64, 60 }, ScalarType::UInt8), 0, { Mode::PSNR, 25, 0 });
  WriteVolume(folder, "lossless_volume", MakePhantom({ 20, 17, 11 }, ScalarType::Int16), 8,
    { Mode::RMSError, 0, 0 });
  WriteVolume(folder, "corrections",
    MakeVolume({ 16, 16, 16 }, ScalarType::Int32,
      [](auto x, auto y, auto z)
      {
        return x == 5 && y == 9 ? 1000 * z
          : x == 7 && y == z    ? 2147483647.0
                                : 3.9 * (GetNoise(x, y, z) > 0.99);
      }),
    16, { Mode::RMSError, 0, 0 });
  WriteVolume(folder, "constant_volume",
    MakeVolume({ 20, 20, 20 }, ScalarType::UInt64, [](auto, auto, auto) { return 7; }), 8, {});
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: makeGolden FOLDER\n";
    return 2;
  }
  try
  {
    WriteMeshes(argv[1]);
    WriteVolumes(argv[1]);
  }
  catch (const Error& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
