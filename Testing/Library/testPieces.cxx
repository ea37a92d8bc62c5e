// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Reading through the C interface: pieces, regions, surfaces, images.

#include "gatunBlock.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace
{
using namespace gatun::test;

constexpr int Count = 9;

/** A file of a block in small chunks, which all tests read. */
std::string MakeFile(const std::string& name, std::uint32_t keep = 7)
{
  const auto path = PathOf(name);
  auto options = Make<gatun_options>();
  options.keep_order = keep;
  options.chunk_size = 64;
  Block(Count).Write(path, options);
  return path;
}

using Corners = std::array<std::array<double, 3>, 4>;

/** The cells by their number, as places of their corners. */
std::map<std::int32_t, Corners> CellsOf(const BlockPiece& piece)
{
  std::map<std::int32_t, Corners> cells;
  for (std::size_t cell = 0; cell < piece.Numbers.size(); ++cell)
  {
    auto& corners = cells[piece.Numbers[cell]];
    for (std::size_t i = 0; i < 4; ++i)
    {
      const auto point = static_cast<std::size_t>(piece.Cells[4 * cell + i]);
      std::copy_n(
        piece.Points.begin() + static_cast<std::ptrdiff_t>(3 * point), 3, corners[i].begin());
      EXPECT_EQ(piece.Field[point], corners[i][0] + 2 * corners[i][1] + 3 * corners[i][2]);
    }
    std::sort(corners.begin(), corners.end());
  }
  EXPECT_EQ(cells.size(), piece.Numbers.size());
  return cells;
}

std::map<std::int32_t, Corners> CellsOf(const Block& block)
{
  BlockPiece piece;
  piece.Points = block.Points;
  piece.Cells = block.Cells;
  piece.Field = block.Field;
  piece.Numbers = block.Numbers;
  return CellsOf(piece);
}

double AreaOf(const BlockPiece& piece, std::size_t triangle)
{
  std::array<std::array<double, 3>, 3> at{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto point = static_cast<std::size_t>(piece.Cells[3 * triangle + i]);
    std::copy_n(piece.Points.begin() + static_cast<std::ptrdiff_t>(3 * point), 3, at[i].begin());
  }
  std::array<double, 3> a{};
  std::array<double, 3> b{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    a[i] = at[1][i] - at[0][i];
    b[i] = at[2][i] - at[0][i];
  }
  return std::hypot(
           a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]) /
    2;
}

TEST(LibraryPieces, RestoreTheOrder)
{
  const Block block(Count);
  const OpenedFile file(MakeFile("order.gtn"));
  const auto piece = ReadPiece(file, MakeRequest());
  EXPECT_EQ(piece.Sizes.cell_type, 10u);
  EXPECT_EQ(piece.Points, block.Points);
  EXPECT_EQ(piece.Cells, block.Cells);
  EXPECT_EQ(piece.Field, block.Field);
  EXPECT_EQ(piece.Numbers, block.Numbers);
}

TEST(LibraryPieces, HaveAllCellsTogether)
{
  const OpenedFile file(MakeFile("pieces.gtn", 0));
  std::map<std::int32_t, Corners> all;
  auto request = MakeRequest();
  request.pieces = 5;
  for (request.piece = 0; request.piece < request.pieces; ++request.piece)
  {
    const auto cells = CellsOf(ReadPiece(file, request));
    EXPECT_FALSE(cells.empty());
    for (const auto& cell : cells)
    {
      EXPECT_TRUE(all.insert(cell).second);
    }
  }
  EXPECT_EQ(all, CellsOf(Block(Count)));
}

TEST(LibraryPieces, HaveGhosts)
{
  const OpenedFile file(MakeFile("ghosts.gtn", 0));
  auto request = MakeRequest();
  request.pieces = 4;
  request.piece = 1;
  const auto own = CellsOf(ReadPiece(file, request));
  request.ghost_levels = 1;
  const auto more = CellsOf(ReadPiece(file, request));
  std::set<std::array<double, 3>> points;
  for (const auto& [number, corners] : own)
  {
    points.insert(corners.begin(), corners.end());
  }
  for (const auto& [number, corners] : CellsOf(Block(Count)))
  {
    const bool touches = std::any_of(
      corners.begin(), corners.end(), [&](const auto& corner) { return points.count(corner) > 0; });
    EXPECT_EQ(more.count(number), touches ? 1u : 0u);
  }
}

TEST(LibraryPieces, OfAnExactRegion)
{
  const OpenedFile file(MakeFile("region.gtn", 0));
  auto request = MakeRequest();
  request.flags |= GATUN_IN_BOX | GATUN_IN_RANGE;
  const double box[6] = { 0.21, 0.32, 0.4, 0.9, -1, 0.3 };
  std::copy_n(box, 6, request.box);
  request.range_array = 0;
  request.range_component = -1;
  request.range[0] = 1.3;
  request.range[1] = 1.6;
  const auto loose = CellsOf(ReadPiece(file, request));
  request.flags |= GATUN_EXACT;
  const auto exact = CellsOf(ReadPiece(file, request));
  EXPECT_LT(exact.size(), loose.size());
  std::size_t expected = 0;
  for (const auto& [number, corners] : CellsOf(Block(Count)))
  {
    bool meets = true;
    std::array<double, 4> values{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto less = [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; };
      const auto [low, high] = std::minmax_element(corners.begin(), corners.end(), less);
      meets = meets && (*low)[axis] <= box[2 * axis + 1] && (*high)[axis] >= box[2 * axis];
    }
    std::transform(corners.begin(), corners.end(), values.begin(),
      [](const auto& at) { return at[0] + 2 * at[1] + 3 * at[2]; });
    meets = meets && *std::min_element(values.begin(), values.end()) <= 1.6 &&
      *std::max_element(values.begin(), values.end()) >= 1.3;
    EXPECT_EQ(exact.count(number), meets ? 1u : 0u) << number;
    expected += meets;
  }
  EXPECT_GT(expected, 0u);
}

TEST(LibraryPieces, OfAContour)
{
  const OpenedFile file(MakeFile("contour.gtn", 0));
  const double isovalue = 2.3;
  auto contour = Make<gatun_contour>();
  contour.values = &isovalue;
  contour.value_count = 1;
  contour.normals = 1;
  auto sizes = Make<gatun_sizes>();
  gatun_piece* piece = nullptr;
  const auto request = MakeRequest();
  ASSERT_OK(gatun_prepare_contour(file, &request, &contour, &sizes, nullptr, nullptr, &piece));
  BlockPiece surface;
  surface.Read(piece, sizes, true);
  ASSERT_EQ(sizes.cell_type, 5u);
  ASSERT_GT(sizes.cells, 0u);
  const double length = std::sqrt(14.);
  for (std::size_t i = 0; i < sizes.points; ++i)
  {
    EXPECT_NEAR(surface.Field[i], isovalue, 1e-12);
    EXPECT_NEAR(
      surface.Points[3 * i] + 2 * surface.Points[3 * i + 1] + 3 * surface.Points[3 * i + 2],
      isovalue, 1e-12);
    EXPECT_NEAR(surface.Normals[3 * i + 2], -3 / length, 1e-6);
  }
}

TEST(LibraryPieces, OfASlice)
{
  const OpenedFile file(MakeFile("slice.gtn", 0));
  auto request = MakeRequest();
  request.origin[2] = 0.37;
  request.normal[2] = -2;
  auto sizes = Make<gatun_sizes>();
  gatun_piece* piece = nullptr;
  ASSERT_OK(gatun_prepare_slice(file, &request, &sizes, nullptr, nullptr, &piece));
  BlockPiece slice;
  slice.Read(piece, sizes);
  double area = 0;
  for (std::size_t triangle = 0; triangle < sizes.cells; ++triangle)
  {
    area += AreaOf(slice, triangle);
  }
  EXPECT_NEAR(area, 1, 1e-12);
  for (std::size_t i = 0; i < sizes.points; ++i)
  {
    EXPECT_NEAR(slice.Points[3 * i + 2], 0.37, 1e-12);
    EXPECT_NEAR(slice.Field[i],
      slice.Points[3 * i] + 2 * slice.Points[3 * i + 1] + 3 * slice.Points[3 * i + 2], 1e-12);
  }
}

TEST(LibraryPieces, AsAnImage)
{
  const OpenedFile file(MakeFile("image.gtn", 0));
  auto image = Make<gatun_image>();
  image.width = 16;
  image.height = 12;
  const double colors[] = { 0, 1, 0.5, 0.25 };
  const double opacities[] = { 0, 0.2 };
  image.colors = colors;
  image.color_count = 1;
  image.opacities = opacities;
  image.opacity_count = 1;
  image.unit_distance = 0.5;
  image.position[0] = image.focal_point[0] = 0.5;
  image.position[1] = image.focal_point[1] = 0.5;
  image.position[2] = 5;
  image.parallel_scale = 1;
  std::vector<float> pixels(4 * image.width * image.height);
  const auto buffer = BufferOf(pixels);
  ASSERT_OK(gatun_render(file, &image, &buffer, nullptr, nullptr));
  // The cube covers half of the height. Its opacity over a length of two units:
  const double opacity = 1 - 0.8 * 0.8;
  const auto* const middle = &pixels[4 * (6 * image.width + 8)];
  EXPECT_NEAR(middle[3], opacity, 1e-5);
  EXPECT_NEAR(middle[0], opacity, 1e-5);
  EXPECT_NEAR(middle[1], opacity / 2, 1e-5);
  EXPECT_NEAR(middle[2], opacity / 4, 1e-5);
  EXPECT_EQ(pixels[3], 0);
  const auto covered = std::count_if(pixels.begin(), pixels.end(), [](float v) { return v > 0; });
  EXPECT_EQ(covered, 4 * 6 * 6);
}

TEST(LibraryPieces, AsAnImageByDefault)
{
  const OpenedFile file(MakeFile("default.gtn", 0));
  auto image = Make<gatun_image>();
  image.width = 40;
  image.height = 40;
  std::vector<float> pixels(4 * image.width * image.height);
  const auto buffer = BufferOf(pixels);
  for (const auto blend : { GATUN_COMPOSITE, GATUN_MAXIMUM, GATUN_X_RAY })
  {
    image.blend = blend;
    ASSERT_OK(gatun_render(file, &image, &buffer, nullptr, nullptr));
    std::size_t seen = 0;
    for (std::size_t i = 3; i < pixels.size(); i += 4)
    {
      seen += pixels[i] > 0;
    }
    EXPECT_GT(seen, 700u);
    EXPECT_LT(seen, 1600u);
  }
}
TEST(LibraryPieces, AsAnImageWithLightAndScaledOpacity)
{
  const OpenedFile file(MakeFile("shaded.gtn", 0));
  auto image = Make<gatun_image>();
  image.width = image.height = 24;
  const auto draw = [&]
  {
    std::vector<float> pixels(4 * image.width * image.height);
    const auto buffer = BufferOf(pixels);
    EXPECT_OK(gatun_render(file, &image, &buffer, nullptr, nullptr));
    return pixels;
  };
  const auto plain = draw();
  image.shade = 1;
  const auto shaded = draw();
  // The gradient is constant, so that all colors change by the same factors.
  EXPECT_NE(shaded, plain);
  image.shade = 0;
  image.opacity_scale = 0.25;
  const auto thin = draw();
  for (std::size_t i = 3; i < plain.size(); i += 4)
  {
    EXPECT_NEAR(shaded[i], plain[i], 1e-5);
    EXPECT_LE(thin[i], plain[i]);
  }
  const auto middle = 4 * (12 * image.width + 12) + 3;
  EXPECT_LT(thin[middle], plain[middle]);
  // Opacity is over the unit distance: a quarter is not that of the whole ray.
  EXPECT_GT(thin[middle], plain[middle] / 8);
  image.opacity_scale = -1;
  std::vector<float> pixels(4 * image.width * image.height);
  const auto buffer = BufferOf(pixels);
  EXPECT_EQ(gatun_render(file, &image, &buffer, nullptr, nullptr), GATUN_INVALID_INPUT);
}
}
