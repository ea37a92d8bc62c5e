// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Writing series through the C interface: meshes that change, appended steps, rounded points.

#include "gatunBlock.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
using namespace gatun::test;

/** A block with its buffers. */
struct Series
{
  explicit Series(int count)
    : Cube(count)
    , Mesh(Cube.GetMesh())
    , Arrays(Cube.GetArrays())
    , Buffers{ BufferOf(Cube.Field), BufferOf(Cube.Numbers) }
  {
  }

  gatun_values MakeStep(double time) const
  {
    auto step = Make<gatun_values>();
    step.arrays = this->Buffers.data();
    step.array_count = this->Buffers.size();
    step.has_time = 1;
    step.time = time;
    return step;
  }

  gatun_writer* Create(const std::string& path, const gatun_options& options) const
  {
    gatun_writer* writer = nullptr;
    EXPECT_OK(gatun_create(
      path.c_str(), &this->Mesh, this->Arrays.data(), 2, &options, nullptr, nullptr, &writer));
    return writer;
  }

  Block Cube;
  gatun_mesh Mesh;
  std::array<gatun_array, 2> Arrays;
  std::array<gatun_buffer, 2> Buffers;
};

gatun_options MakeOptions()
{
  auto options = Make<gatun_options>();
  options.keep_order = 7;
  return options;
}

void WriteStep(gatun_writer* writer, const gatun_values& step)
{
  ASSERT_OK(gatun_write_step(writer, &step, nullptr, nullptr));
}

/** The number of points at a step with half of the points left out. */
std::uint64_t CountHalf(gatun_file* file, std::uint64_t step)
{
  auto request = MakeRequest();
  request.step = step;
  request.ratio = 0.5;
  return ReadPiece(file, request).Sizes.points;
}
}

TEST(LibrarySeries, OtherMeshesHaveHierarchyAndLayers)
{
  const auto path = PathOf("others.gtn");
  const Series first(12);
  const Series other(6);
  auto options = MakeOptions();
  options.hierarchy = 1;
  options.layers = GATUN_HISTOGRAM;
  options.layer_count = 3;
  auto* writer = first.Create(path, options);
  WriteStep(writer, first.MakeStep(0));
  const auto step = other.MakeStep(1);
  ASSERT_OK(gatun_add_mesh(writer, &other.Mesh, &step, nullptr, nullptr, nullptr));
  WriteStep(writer, step);
  ASSERT_OK(gatun_finish(writer, nullptr));
  const OpenedFile file(path);
  for (const std::uint64_t number : { 0, 1 })
  {
    auto description = Make<gatun_step>();
    ASSERT_OK(gatun_get_step(file, number, &description));
    EXPECT_EQ(CountHalf(file, number), description.points - description.points / 2);
  }

  // Layers of another mesh need its values, not those of the first one.
  writer = first.Create(path, options);
  WriteStep(writer, first.MakeStep(0));
  EXPECT_EQ(
    gatun_add_mesh(writer, &other.Mesh, nullptr, nullptr, nullptr, nullptr), GATUN_INVALID_INPUT);
  gatun_discard(writer);
}

TEST(LibrarySeries, AppendsWithOptions)
{
  const auto path = PathOf("options.gtn");
  Series series(8);
  auto* writer = series.Create(path, MakeOptions());
  WriteStep(writer, series.MakeStep(0));
  ASSERT_OK(gatun_finish(writer, nullptr));

  for (auto& value : series.Cube.Field)
  {
    value = std::sin(value);
  }
  auto options = Make<gatun_options>();
  options.points_move = 1;
  options.hierarchy = 1;
  auto arrays = series.Arrays;
  arrays[0].error = "abs:0.01";
  ASSERT_OK(gatun_append(path.c_str(), arrays.data(), 2, &options, &writer));
  auto step = series.MakeStep(1);
  ASSERT_OK(gatun_add_mesh(writer, &series.Mesh, &step, nullptr, nullptr, nullptr));
  WriteStep(writer, step);
  std::vector<double> moved = series.Cube.Points;
  std::reverse(moved.begin(), moved.end());
  const auto coordinates = BufferOf(moved);
  step = series.MakeStep(2);
  step.coordinates = &coordinates;
  WriteStep(writer, step);
  ASSERT_OK(gatun_finish(writer, nullptr));

  const OpenedFile file(path);
  auto request = MakeRequest();
  request.step = 2;
  const auto read = ReadPiece(file, request);
  EXPECT_EQ(read.Points, moved);
  EXPECT_NE(read.Field, series.Cube.Field);
  for (std::size_t i = 0; i < read.Field.size(); ++i)
  {
    EXPECT_NEAR(read.Field[i], series.Cube.Field[i], 0.01);
  }
  EXPECT_EQ(CountHalf(file, 1), read.Sizes.points - read.Sizes.points / 2);

  std::swap(arrays[0], arrays[1]);
  EXPECT_EQ(gatun_append(path.c_str(), arrays.data(), 2, nullptr, &writer), GATUN_INVALID_INPUT);
}

TEST(LibrarySeries, FindsWhatRemains)
{
  const Series whole(6);
  // Without the first third of the cells, and without the points that only these use.
  const auto deleted = whole.Mesh.cells / 3;
  std::vector<std::uint64_t> wanted(whole.Mesh.cells - deleted);
  std::iota(wanted.begin(), wanted.end(), deleted);
  std::vector<std::int64_t> ids(
    whole.Cube.Cells.begin() + static_cast<std::ptrdiff_t>(4 * deleted), whole.Cube.Cells.end());
  auto part = whole.Mesh;
  part.cells = wanted.size();
  part.connectivity = ids.data();

  std::vector<std::uint64_t> cells(wanted.size());
  std::vector<std::uint64_t> points(whole.Mesh.points);
  auto toCells = BufferOf(cells);
  auto toPoints = BufferOf(points);
  auto found = Make<gatun_remaining>();
  ASSERT_OK(gatun_find_remaining(&whole.Mesh, &part, &toCells, &toPoints, &found));
  EXPECT_TRUE(found.is_part && !found.drops_points && !found.points_moved);
  EXPECT_EQ(cells, wanted);

  std::vector<std::uint64_t> used(ids.begin(), ids.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<double> places;
  for (const auto point : used)
  {
    places.insert(places.end(), &whole.Cube.Points[3 * point], &whole.Cube.Points[3 * point] + 3);
  }
  for (auto& id : ids)
  {
    id = std::lower_bound(used.begin(), used.end(), static_cast<std::uint64_t>(id)) - used.begin();
  }
  part.points = used.size();
  part.coordinates = places.data();
  ASSERT_OK(gatun_find_remaining(&whole.Mesh, &part, &toCells, &toPoints, &found));
  EXPECT_TRUE(found.is_part && found.drops_points);
  EXPECT_EQ(cells, wanted);
  points.resize(used.size());
  EXPECT_EQ(points, used);

  places[0] += 1;
  ASSERT_OK(gatun_find_remaining(&whole.Mesh, &part, &toCells, &toPoints, &found));
  EXPECT_FALSE(found.is_part);
  toCells.bytes -= 1;
  EXPECT_EQ(
    gatun_find_remaining(&whole.Mesh, &part, &toCells, &toPoints, &found), GATUN_INVALID_INPUT);
}

TEST(LibrarySeries, RoundsPoints)
{
  Series series(7);
  for (std::size_t i = 0; i < series.Cube.Points.size(); ++i)
  {
    series.Cube.Points[i] += 0.01 * std::sin(static_cast<double>(i));
  }
  std::vector<double> rounded(series.Cube.Points.size());
  auto to = BufferOf(rounded);
  double largest = 0;
  ASSERT_OK(gatun_round_points(&series.Mesh, "abs:0.001", 0, &to, &largest));
  EXPECT_TRUE(largest > 0 && largest <= 0.001);
  double difference = 0;
  for (std::size_t i = 0; i < rounded.size(); ++i)
  {
    EXPECT_EQ(rounded[i] * 1024, std::round(rounded[i] * 1024));
    difference = std::max(difference, std::abs(rounded[i] - series.Cube.Points[i]));
  }
  EXPECT_EQ(difference, largest);

  ASSERT_OK(gatun_round_points(&series.Mesh, "bits:10", 0, &to, &largest));
  auto sorted = rounded;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_LE(std::unique(sorted.begin(), sorted.end()) - sorted.begin(), 3 * 1024);
  ASSERT_OK(gatun_round_points(&series.Mesh, "abs:1e-30", 0, &to, nullptr));
  EXPECT_EQ(rounded, series.Cube.Points);
  for (const char* const wrong : { "bits:0", "bits:32", "rel:1", "abs:0", "pw:0.1", "0.1",
         "abs:1,zeros", "abs:0.5" }) // with the last one, cells turn over
  {
    EXPECT_EQ(gatun_round_points(&series.Mesh, wrong, 0, &to, nullptr), GATUN_INVALID_INPUT)
      << wrong;
  }
  EXPECT_EQ(gatun_round_points(&series.Mesh, "rel:0.1", 1, &to, nullptr), GATUN_INVALID_INPUT);
  to.bytes -= 1;
  EXPECT_EQ(gatun_round_points(&series.Mesh, "abs:0.001", 0, &to, nullptr), GATUN_INVALID_INPUT);
}

TEST(LibrarySeries, BoundsAllArraysOfFloats)
{
  const auto path = PathOf("all.gtn");
  Series series(6);
  for (auto& value : series.Cube.Field)
  {
    value = std::sin(value);
  }
  auto options = MakeOptions();
  options.error = "rel:0.01";
  auto* writer = series.Create(path, options);
  WriteStep(writer, series.MakeStep(0));
  ASSERT_OK(gatun_finish(writer, nullptr));
  const OpenedFile file(path);
  const auto read = ReadPiece(file, MakeRequest());
  EXPECT_EQ(read.Numbers, series.Cube.Numbers);
  EXPECT_NE(read.Field, series.Cube.Field);
  for (std::size_t i = 0; i < read.Field.size(); ++i)
  {
    EXPECT_NEAR(read.Field[i], series.Cube.Field[i], 0.02);
  }
}

TEST(LibrarySeries, RefusesCellsOfWrongSizes)
{
  const auto path = PathOf("sizes.gtn");
  Series series(2);
  const std::vector<std::uint8_t> types{ 10, 12 };
  const std::vector<std::int64_t> offsets{ 0, 4, 11 };
  series.Mesh.types = types.data();
  series.Mesh.offsets = offsets.data();
  series.Mesh.cells = 2;
  auto options = MakeOptions();
  gatun_writer* writer = nullptr;
  EXPECT_EQ(
    gatun_create(path.c_str(), &series.Mesh, nullptr, 0, &options, nullptr, nullptr, &writer),
    GATUN_INVALID_INPUT);
  EXPECT_NE(std::string(gatun_error()).find("cell 1 (type 12, vtkHexahedron) has 7 points, not 8"),
    std::string::npos)
    << gatun_error();
}
