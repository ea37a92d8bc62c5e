// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The face table against a map of all faces.

#include "gatunFaceTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace
{
using namespace gatun;

using Tets = std::vector<FaceTable::Tet>;

/** The faces with the same corners, ascending, for each set of corners. */
std::map<std::array<std::uint32_t, 3>, std::vector<std::uint32_t>> FindGroups(const Tets& tets)
{
  std::map<std::array<std::uint32_t, 3>, std::vector<std::uint32_t>> groups;
  for (std::uint32_t t = 0; t < tets.size(); ++t)
  {
    if (std::set<std::uint32_t>(tets[t].begin(), tets[t].end()).size() < 4)
    {
      continue;
    }
    for (std::uint32_t i = 0; i < 4; ++i)
    {
      std::array<std::uint32_t, 3> corners{ tets[t][(i + 1) % 4], tets[t][(i + 2) % 4],
        tets[t][(i + 3) % 4] };
      std::sort(corners.begin(), corners.end());
      groups[corners].push_back(4 * t + i);
    }
  }
  return groups;
}

void ExpectRight(const Tets& tets)
{
  const FaceTable table(tets);
  ASSERT_EQ(table.Rows.size(), tets.size());
  std::vector<std::uint32_t> rows(tets.size());
  std::iota(rows.begin(), rows.end(), 0u);
  table.RestoreInput(rows);
  EXPECT_TRUE(std::is_permutation(rows.begin(), rows.end(), table.Places.begin()));
  // Faces of the input and of rows.
  const auto inputOf = [&](std::uint32_t face) { return 4 * rows[face / 4] + face % 4; };
  const auto rowOf = [&](std::uint32_t face) { return 4 * table.Places[face / 4] + face % 4; };
  const auto overOf = [&](std::uint32_t face)
  { return table.Rows[rowOf(face) / 4].Over[face % 4]; };
  std::vector<std::uint32_t> over(4 * tets.size(), FaceTable::None);
  std::size_t groups = 0;
  for (const auto& [corners, faces] : FindGroups(tets))
  {
    if (faces.size() == 2)
    {
      over[faces[0]] = rowOf(faces[1]);
      over[faces[1]] = rowOf(faces[0]);
    }
    if (faces.size() < 3)
    {
      continue;
    }
    ++groups;
    const auto number = overOf(faces[0]);
    ASSERT_TRUE(FaceTable::IsGroup(number));
    ASSERT_LT(FaceTable::GetGroup(number), table.Firsts.size());
    std::vector<std::uint32_t> found;
    for (auto face = table.Firsts[FaceTable::GetGroup(number)]; face != FaceTable::None;
         face = table.Next[face])
    {
      found.push_back(inputOf(face));
      over[found.back()] = number;
    }
    EXPECT_EQ(found, faces);
  }
  EXPECT_EQ(table.Firsts.size(), groups);
  for (std::uint32_t face = 0; face < over.size(); ++face)
  {
    EXPECT_EQ(overOf(face), over[face]);
    EXPECT_EQ(inputOf(rowOf(face)), face);
    EXPECT_EQ(table.Rows[rowOf(face) / 4].Corners, tets[face / 4]);
  }
  for (std::size_t row = 1; row < rows.size(); ++row)
  {
    const auto lowestOf = [&](std::size_t r)
    { return *std::min_element(tets[rows[r]].begin(), tets[rows[r]].end()); };
    EXPECT_LE(lowestOf(row - 1), lowestOf(row));
  }
}

/** Tetrahedra with random corners below some number. */
Tets MakeFaceSoup(std::size_t count, std::uint32_t points)
{
  std::mt19937 random(points);
  Tets tets(count);
  for (auto& tet : tets)
  {
    for (auto& corner : tet)
    {
      corner = static_cast<std::uint32_t>(random() % points);
    }
  }
  return tets;
}
}

TEST(FaceTable, FindsTheFacesOfSoups)
{
  ExpectRight({});
  ExpectRight({ { 3, 2, 1, 0 } });
  ExpectRight({ { 3, 2, 2, 0 } }); // degenerate
  for (const std::uint32_t points : { 4u, 5u, 9u, 30u, 3000u })
  {
    ExpectRight(MakeFaceSoup(2000, points));
  }
}

TEST(FaceTable, FindsTheFacesOfLargeNumbers)
{
  // Pairs of them do not fit 32 bits, up to those that just do.
  for (const std::uint32_t first : { 65400u, 65500u, 65533u, 1000000u })
  {
    auto soup = MakeFaceSoup(2000, 30);
    for (auto& tet : soup)
    {
      for (auto& corner : tet)
      {
        corner += first;
      }
    }
    ExpectRight(soup);
  }
}

TEST(FaceTable, FindsTheFacesOfFans)
{
  // Vertex 0 is the lowest corner of most faces, so its bucket is sorted instead of hashed.
  Tets fan;
  for (std::uint32_t i = 0; i < 5000; ++i)
  {
    fan.push_back({ 2 + (i + 1) % 5000, 0, 2 + i, 1 });
  }
  ExpectRight(fan);
  auto twice = fan;
  twice.insert(twice.end(), fan.begin(), fan.begin() + 3000);
  ExpectRight(twice);
}
