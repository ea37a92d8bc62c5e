// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The search for shared vertices against one that follows the words of the specification.

#include "gatunSharedSearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace
{
using namespace gatun;

LatticePoint Pick(std::mt19937& random, unsigned steps)
{
  const auto pick = [&] { return static_cast<float>(random() % steps) * (255.0F / 256.0F); };
  return { pick(), pick(), pick(), 0 };
}

/** The search of section 8.13: over all vertices of a row, met or not. */
class PlainSearch
{
public:
  explicit PlainSearch(std::vector<LatticePoint> points)
    : Points(std::move(points))
    , IsMet(this->Points.size(), false)
    , Depth(std::clamp((static_cast<int>(std::bit_width(this->Points.size())) - 4) / 2, 0, 6))
  {
    for (std::uint32_t i = 0; i < this->Points.size(); ++i)
    {
      const auto& p = this->Points[i];
      this->Rows[{ this->CellOf(p.Z), this->CellOf(p.Y) }].push_back({ this->CellOf(p.X), i });
    }
    for (auto& row : this->Rows)
    {
      std::sort(row.second.begin(), row.second.end());
    }
  }

  void Meet(std::uint32_t index) { this->IsMet[index] = true; }

  template <typename GetRanks>
  std::vector<std::uint32_t> Find(const GatePlane& plane, float reach, GetRanks&& getRanks) const
  {
    const auto sides = std::array{ plane.U, plane.V, plane.V - plane.U };
    float longest = 0;
    for (const auto& side : sides)
    {
      longest = std::max(longest, Dot(side, side));
    }
    const float limit = reach * reach * longest;
    const float radius = std::sqrt(limit);
    const auto middle = [](float a, float b, float c) { return (a + b + c) * (1.0F / 3.0F); };
    const LatticePoint center{ middle(plane.A.X, plane.B.X, plane.C.X),
      middle(plane.A.Y, plane.B.Y, plane.C.Y), middle(plane.A.Z, plane.B.Z, plane.C.Z), 0 };
    std::vector<std::pair<float, std::uint32_t>> hits;
    unsigned patience = SharedSearch::Patience;
    for (const int z : this->Outwards(center.Z - radius, center.Z + radius))
    {
      for (const int y : this->Outwards(center.Y - radius, center.Y + radius))
      {
        unsigned inGroup = 0;
        const auto row = this->Rows.find({ z, y });
        for (const auto& [x, index] : row == this->Rows.end() ? Row{} : row->second)
        {
          if (x < this->CellOf(center.X - radius) || x > this->CellOf(center.X + radius))
          {
            continue;
          }
          if (inGroup % 4 == 0 && patience-- == 0)
          {
            return Sort(hits);
          }
          ++inGroup;
          const auto places = Splat(this->Points[index]);
          const auto g = places - Splat(center);
          const auto distances = Dot(g, g);
          const float rank = getRanks(places, distances)[0];
          if (!this->IsMet[index] && distances[0] <= limit && rank < NeverRank)
          {
            hits.emplace_back(rank, index);
          }
        }
      }
    }
    return Sort(hits);
  }

private:
  using Row = std::vector<std::pair<int, std::uint32_t>>; // cell, index

  static std::vector<std::uint32_t> Sort(std::vector<std::pair<float, std::uint32_t>> hits)
  {
    std::stable_sort(
      hits.begin(), hits.end(), [](const auto& l, const auto& r) { return l.first < r.first; });
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < hits.size() && i < SharedSearch::Most; ++i)
    {
      result.push_back(hits[i].second);
    }
    return result;
  }

  int CellOf(float number) const
  {
    return std::clamp(
      static_cast<int>(std::ldexp(number, this->Depth - 8)), 0, (1 << this->Depth) - 1);
  }

  std::vector<int> Outwards(float low, float high) const
  {
    const int a = this->CellOf(low);
    const int b = this->CellOf(high);
    std::vector<int> result{ (a + b) / 2 };
    for (int i = 1; static_cast<int>(result.size()) < b - a + 1; ++i)
    {
      for (const int cell : { result[0] + i, result[0] - i })
      {
        if (cell >= a && cell <= b)
        {
          result.push_back(cell);
        }
      }
    }
    return result;
  }

  const std::vector<LatticePoint> Points;
  std::vector<bool> IsMet;
  const int Depth;
  std::map<std::pair<int, int>, Row> Rows; // by z and y
};

std::vector<std::uint32_t> TakeAll(SharedSearch& search)
{
  std::vector<std::uint32_t> result;
  while (result.size() < SharedSearch::Most)
  {
    const auto next = search.TakeNext();
    if (next == NoVertex)
    {
      break;
    }
    result.push_back(next);
  }
  return result;
}

/** Compares both searches for random gates, while vertices are removed. Returns how many gates had
 * a vertex. Steps: the places along an axis; few of them give equal ranks and long rows. */
template <typename MakeRanks>
unsigned Compare(std::size_t vertices, unsigned steps, float reach, MakeRanks&& makeRanks)
{
  std::mt19937 random(static_cast<unsigned>(vertices) + steps);
  std::vector<LatticePoint> points(vertices);
  std::generate(points.begin(), points.end(), [&] { return Pick(random, steps); });
  SharedSearch search(points);
  PlainSearch plain(points);
  unsigned found = 0;
  for (int i = 0; i < 200; ++i)
  {
    const auto a = Pick(random, steps);
    const auto b = Pick(random, steps);
    const auto c = Pick(random, steps);
    const GatePlane plane(a, b, c);
    const GateCircle circle(plane);
    const auto ranks = makeRanks(plane, circle);
    search.Begin(plane, reach, ranks);
    const auto list = TakeAll(search);
    EXPECT_EQ(list, plain.Find(plane, reach, ranks));
    found += !list.empty();
    for (const auto index : list)
    {
      EXPECT_FALSE(search.IsGone(index));
      search.Remove(index);
      plain.Meet(index);
      EXPECT_TRUE(search.IsGone(index));
    }
  }
  return found;
}
}

TEST(SharedSearch, FindsTheBestVerticesFirst)
{
  const auto spheres = [](const GatePlane& plane, const GateCircle& circle)
  { return [&](const Vec3x4& places, Float4) { return circle.GetSpheres(plane, places); }; };
  const auto distances = [](const GatePlane& plane, const GateCircle&)
  {
    return [&](const Vec3x4& places, Float4 squares)
    { return plane.SelectInFront(places, squares); };
  };
  for (const std::size_t vertices : { 0, 1, 2, 3, 5, 100, 5000, 20000 })
  {
    for (const unsigned steps : { 3u, 9u, 256u })
    {
      for (const float reach : { 0.2F, 1.25F, 3.0F })
      {
        const auto found =
          Compare(vertices, steps, reach, spheres) + Compare(vertices, steps, reach, distances);
        EXPECT_TRUE(vertices < 5000 || reach < 1 || found > 50) << vertices << " " << steps;
      }
    }
  }
}

TEST(SharedSearch, PassesOverRanksThatAreNotNumbers)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto never = [](const GatePlane&, const GateCircle&)
  { return [](const Vec3x4&, Float4) { return Splat(NeverRank); }; };
  const auto odd = [nan](const GatePlane&, const GateCircle&)
  {
    return [nan](const Vec3x4& places, Float4)
    { return SelectGreater(places.X, Splat(100.0F), Splat(nan), places.Y); };
  };
  EXPECT_EQ(Compare(1000, 256, 3.0F, never), 0u);
  EXPECT_GT(Compare(1000, 256, 3.0F, odd), 50u);
}
