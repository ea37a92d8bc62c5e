// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunNearestPicker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
using Place = std::array<double, 3>;

/** Places on a lattice of so many steps, where many distances are equal; anywhere with 0 steps. */
std::vector<Place> MakePlaces(std::mt19937& random, int steps)
{
  std::vector<Place> places(300);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  for (auto& place : places)
  {
    for (auto& x : place)
    {
      x =
        steps > 0 ? static_cast<double>(random() % static_cast<unsigned>(steps)) : anywhere(random);
    }
  }
  return places;
}

/** By sorting all. */
std::vector<Vertex> FindNearest(const std::vector<Place>& places, Vertex center,
  const std::set<Vertex>& candidates, std::size_t most)
{
  std::vector<std::pair<float, Vertex>> sorted;
  for (const auto v : candidates)
  {
    double sum = 0;
    for (unsigned k = 0; k < 3; ++k)
    {
      const double x = places[v][k] - places[center][k];
      sum += x * x;
    }
    sorted.emplace_back(static_cast<float>(sum), v);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<Vertex> nearest;
  for (std::size_t i = 0; i < std::min(most, sorted.size()); ++i)
  {
    nearest.push_back(sorted[i].second);
  }
  return nearest;
}
}

//------------------------------------------------------------------------------
TEST(NearestPicker, TakesTheNearestInTheirOrder)
{
  std::mt19937 random(11);
  for (const int steps : { 0, 1, 2, 3, 20 })
  {
    const auto places = MakePlaces(random, steps);
    for (const std::size_t most : { std::size_t{ 24 }, std::size_t{ 16 } })
    {
      NearestPicker picker(places.size(), most);
      for (Vertex center = 0; center < places.size(); ++center)
      {
        picker.Begin(center);
        std::set<Vertex> candidates;
        const auto count = random() % 120;
        for (unsigned i = 0; i < count; ++i)
        {
          const std::array<Vertex, 2> added{ static_cast<Vertex>(random() % places.size()),
            static_cast<Vertex>(random() % places.size()) };
          picker.Add(added[0]);
          picker.Add(added[1]);
          picker.Add(added[0]); // counts once
          candidates.insert(added.begin(), added.end());
        }
        candidates.erase(center);
        std::array<Vertex, NearestPicker::MaxTaken> taken{};
        const auto size = picker.TakeNearest(places, taken.data());
        const std::vector<Vertex> list(taken.begin(), taken.begin() + static_cast<int>(size));
        ASSERT_EQ(list, FindNearest(places, center, candidates, most)) << steps << " " << center;
      }
    }
  }
}
}
