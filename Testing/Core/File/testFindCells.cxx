// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A mesh is found in another one if it has some of its cells, and not if a reader would get
// anything else than this mesh.

#include "gatunFindCells.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace
{
using namespace gatun;
using test::TestMesh;

/** Without some of the first cells, with all points. */
TestMesh LeaveOut(const TestMesh& mesh, std::size_t cells)
{
  TestMesh part = mesh;
  part.Ids.erase(part.Ids.begin(), part.Ids.begin() + static_cast<std::ptrdiff_t>(4 * cells));
  return part;
}

/** Without the points that no cell uses, but with so many of them. */
std::vector<std::uint64_t> DropPoints(TestMesh& mesh, std::size_t kept)
{
  std::vector<bool> isUsed(mesh.GetPoints(), false);
  for (const auto id : mesh.Ids)
  {
    isUsed[static_cast<std::size_t>(id)] = true;
  }
  std::vector<std::uint64_t> points;
  std::vector<std::int64_t> numbers(mesh.GetPoints(), -1);
  std::vector<double> coordinates;
  for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
  {
    if (isUsed[p] || kept > 0)
    {
      kept -= isUsed[p] ? 0 : 1;
      numbers[p] = static_cast<std::int64_t>(points.size());
      points.push_back(p);
      coordinates.insert(coordinates.end(), &mesh.Coordinates[3 * p], &mesh.Coordinates[3 * p] + 3);
    }
  }
  for (auto& id : mesh.Ids)
  {
    id = numbers[static_cast<std::size_t>(id)];
  }
  mesh.Coordinates = std::move(coordinates);
  return points;
}

TEST(FindCells, FindsCellsThatAreLeft)
{
  const auto mesh = test::MakeCubes(3, 0.2);
  auto part = LeaveOut(mesh, 30);
  std::vector<std::uint64_t> left(mesh.GetTets() - 30);
  std::iota(left.begin(), left.end(), std::uint64_t{ 30 });
  auto found = FindCells(mesh.GetInput(), part.GetInput());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->Cells, left);
  EXPECT_FALSE(found->DropsPoints);
  EXPECT_FALSE(found->HaveMoved);

  part.Coordinates[7] += 1;
  found = FindCells(mesh.GetInput(), part.GetInput());
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->HaveMoved);

  part = LeaveOut(mesh, 30);
  const auto points = DropPoints(part, 0);
  ASSERT_LT(points.size(), mesh.GetPoints());
  found = FindCells(mesh.GetInput(), part.GetInput());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->Cells, left);
  EXPECT_TRUE(found->DropsPoints);
  EXPECT_EQ(found->Points, points);
}

TEST(FindCells, FindsNothingElse)
{
  const auto mesh = test::MakeCubes(3, 0.2);
  const auto isFound = [&](const TestMesh& part)
  { return FindCells(mesh.GetInput(), part.GetInput()).has_value(); };
  EXPECT_FALSE(isFound(mesh));                              // no cell has died
  EXPECT_TRUE(isFound(LeaveOut(mesh, mesh.GetTets() / 2))); // one half is left
  EXPECT_FALSE(isFound(LeaveOut(mesh, mesh.GetTets() / 2 + 1)));

  auto part = LeaveOut(mesh, 30);
  DropPoints(part, 1); // a reader leaves out all that are not used
  EXPECT_FALSE(isFound(part));

  part = LeaveOut(mesh, 30);
  DropPoints(part, 0);
  part.Coordinates[1] += 1; // fewer points, and one has moved
  EXPECT_FALSE(isFound(part));

  part = LeaveOut(mesh, 30);
  std::swap_ranges(part.Ids.begin(), part.Ids.begin() + 4, part.Ids.begin() + 4); // another order
  EXPECT_FALSE(isFound(part));

  part = LeaveOut(mesh, 30);
  std::rotate(part.Ids.begin(), part.Ids.begin() + 1, part.Ids.begin() + 3); // of corners, too
  EXPECT_FALSE(isFound(part));

  part = LeaveOut(mesh, 30);
  part.Ids[0] = -1; // no such point
  EXPECT_FALSE(isFound(part));
}

TEST(FindCells, CellsHaveTheSameTypes)
{
  constexpr std::uint8_t quad = 9;
  const auto mesh = test::MakeCubes(3, 0.2);
  const auto part = LeaveOut(mesh, 30);
  const std::vector<std::uint8_t> types(mesh.GetTets(), 10);
  std::vector<std::uint8_t> partTypes(part.GetTets(), 10);
  std::vector<std::int64_t> offsets(mesh.GetTets() + 1);
  for (std::size_t cell = 0; cell < offsets.size(); ++cell)
  {
    offsets[cell] = static_cast<std::int64_t>(4 * cell);
  }
  auto all = mesh.GetInput();
  auto some = part.GetInput();
  all.Types = types.data();
  some.Types = partTypes.data();
  all.Offsets = some.Offsets = offsets.data();
  EXPECT_TRUE(FindCells(all, some));
  partTypes[17] = quad;
  EXPECT_FALSE(FindCells(all, some));
}
}
