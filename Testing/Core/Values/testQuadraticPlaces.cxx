// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Quadratic prediction on cells, and on the points of blocks.

#include "gatunArrayCodec.h"
#include "gatunEntropy.h"
#include "gatunFloatEnvironment.h"
#include "gatunNeighborLists.h"
#include "gatunQuadraticFit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
using Place = std::array<double, 3>;

double Distance(const Place& a, const Place& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double Smooth(const Place& p)
{
  return std::sin(0.4 * p[0]) * std::cos(0.3 * p[1] - 0.2 * p[2]) + 0.1 * p[0] * p[2];
}

/** Hexahedra of a grid of n * n * n cells, whose corners are moved a little. */
struct Cells
{
  explicit Cells(unsigned n, double move = 0.3)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> offset(-move, move);
    const auto number = [n](unsigned x, unsigned y, unsigned z)
    { return (z * (n + 1) + y) * (n + 1) + x; };
    for (unsigned z = 0; z <= n; ++z)
    {
      for (unsigned y = 0; y <= n; ++y)
      {
        for (unsigned x = 0; x <= n; ++x)
        {
          this->Points.push_back({ x + offset(random), y + offset(random), z + offset(random) });
        }
      }
    }
    this->Starts.push_back(0);
    for (unsigned cell = 0; cell < n * n * n; ++cell)
    {
      const unsigned x = cell % n, y = cell / n % n, z = cell / n / n;
      for (unsigned corner = 0; corner < 8; ++corner)
      {
        this->Corners.push_back(
          number(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2 & 1)));
      }
      this->Starts.push_back(static_cast<std::uint32_t>(this->Corners.size()));
      Place middle{};
      for (unsigned i = 0; i < 24; ++i)
      {
        middle[i % 3] += this->Points[this->Corners[this->Corners.size() - 8 + i / 3]][i % 3] / 8;
      }
      this->Middles.push_back(middle);
    }
  }

  std::vector<Place> Points;
  std::vector<Place> Middles;
  std::vector<std::uint32_t> Starts, Corners;
};

/** Points on a wavy surface, in the order of neighbors. */
std::vector<Place> MakeBlock(unsigned n)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> offset(-0.3, 0.3);
  std::vector<Place> places;
  for (unsigned i = 0; i < n * n; ++i)
  {
    const double x = i / n + offset(random), y = i % n + offset(random);
    places.push_back({ x, y, 2 * std::sin(0.2 * x) });
  }
  return places;
}

void ExpectSorted(std::span<const Vertex> list, const std::vector<Place>& places, Vertex center)
{
  EXPECT_LE(list.size(), NeighborLists::MaxNeighbors);
  EXPECT_EQ(std::set<Vertex>(list.begin(), list.end()).size(), list.size());
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    EXPECT_LT(list[i], center);
    EXPECT_TRUE(i == 0 ||
      Distance(places[list[i - 1]], places[center]) <=
        Distance(places[list[i]], places[center]) * (1 + 1e-6));
  }
}

//------------------------------------------------------------------------------
// Lists

TEST(QuadraticPlaces, NeighborsOfCellsAreTheNearestEarlierOnes)
{
  const Cells cells(7);
  const auto lists = NeighborLists::OfCells(cells.Starts, cells.Corners, cells.Middles);
  ASSERT_EQ(lists.GetCenters(), cells.Middles.size());
  const auto cornersOf = [&](Vertex cell)
  {
    return std::set<std::uint32_t>(
      cells.Corners.begin() + cells.Starts[cell], cells.Corners.begin() + cells.Starts[cell + 1]);
  };
  for (Vertex cell = 0; cell < cells.Middles.size(); ++cell)
  {
    const auto list = lists.Of(cell);
    ExpectSorted(list, cells.Middles, cell);
    const auto own = cornersOf(cell);
    std::set<Vertex> known; // a corner of hexahedra has at most eight of them
    for (Vertex other = 0; other < cell; ++other)
    {
      const auto corners = cornersOf(other);
      if (std::any_of(own.begin(), own.end(),
            [&](std::uint32_t corner) { return corners.count(corner) > 0; }))
      {
        known.insert(other);
      }
    }
    EXPECT_EQ(list.size(), std::min(known.size(), NeighborLists::MaxCells));
    for (const auto u : list)
    {
      EXPECT_EQ(known.count(u), 1u);
    }
  }
}

TEST(QuadraticPlaces, CellsOfManyCornersHaveNoNeighbors)
{
  std::vector<std::uint32_t> starts{ 0, 4, 74, 78 }, corners{ 0, 1, 2, 3 };
  for (std::uint32_t i = 0; i < 70; ++i)
  {
    corners.push_back(i);
  }
  corners.insert(corners.end(), { 2, 3, 4, 5 });
  const std::vector<Place> places(3);
  const auto lists = NeighborLists::OfCells(starts, corners, places);
  EXPECT_EQ(lists.Of(1).size(), 0u);
  EXPECT_EQ(lists.Of(2).size(), 2u);
}

TEST(QuadraticPlaces, NeighborsInBlocksAreNear)
{
  const auto places = MakeBlock(40);
  const auto lists = NeighborLists::OfBlock(places);
  ASSERT_EQ(lists.GetCenters(), places.size());
  std::size_t same = 0;
  for (Vertex v = 1; v < places.size(); ++v)
  {
    const auto list = lists.Of(v);
    ExpectSorted(list, places, v);
    ASSERT_FALSE(list.empty());
    Vertex nearest = 0;
    for (Vertex u = 1; u < v; ++u)
    {
      nearest = Distance(places[u], places[v]) < Distance(places[nearest], places[v]) ? u : nearest;
    }
    same += list.front() == nearest ? 1 : 0;
    EXPECT_LE(list.size(), v);
  }
  EXPECT_GT(same, places.size() * 99 / 100);
}

TEST(QuadraticPlaces, BlocksOfOddPlacesHaveLists)
{
  const double inf = std::numeric_limits<double>::infinity();
  const double most = std::numeric_limits<double>::max();
  for (const auto& odd : { Place{ 1, 1, 1 }, Place{ inf, 0, -inf }, Place{ std::nan(""), 1, 2 },
         Place{ most, -most, most } })
  {
    std::vector<Place> places(5000, Place{ 1, 1, 1 });
    for (std::size_t i = 0; i < places.size(); i += 3)
    {
      places[i] = odd;
    }
    const auto lists = NeighborLists::OfBlock(places);
    EXPECT_EQ(lists.Of(4999).size(), NeighborLists::MaxNeighbors);
    const FloatEnvironment guard;
    const QuadraticFit fit(places);
    const auto last = fit.Of(4999);
    for (std::size_t i = 0; i < last.GetCount(); ++i)
    {
      EXPECT_TRUE(std::isfinite(last.Quadratic[i]) && std::isfinite(last.Linear[i]));
    }
  }
}

//------------------------------------------------------------------------------
// Streams

/** Encodes and decodes values with all modes. Returns the stream, and the values in keys. */
Bytes RoundTrip(const CellContext& context, const Domain& domain, ComponentKeys& keys)
{
  const FloatEnvironment guard;
  const auto before = keys.Before;
  auto stream = EncodeCellValues(context, { &domain, 1 }, { &keys, 1 });
  ComponentKeys found{ std::vector<Key>(keys.Now.size()), before };
  DecodeCellValues(stream, context, { &domain, 1 }, { &found, 1 });
  EXPECT_EQ(found.Now, keys.Now);
  return stream;
}

ComponentKeys MakeKeys(const std::vector<Place>& places, const Domain& domain, double factor)
{
  ComponentKeys keys;
  for (const auto& place : places)
  {
    keys.Now.push_back(domain.FromNumber(Smooth(place) * factor));
  }
  return keys;
}

/** Expects that smooth values come back, and that the mode quadratic is used and helps. */
void ExpectSmoothRoundTrips(const CellContext& context, const std::vector<Place>& places)
{
  for (const auto type : { ScalarType::Float32, ScalarType::Float64, ScalarType::Int32 })
  {
    const Domain domain(type);
    const auto actual = MakeKeys(places, domain, type == ScalarType::Int32 ? 1e7 : 1);
    auto keys = actual;
    const auto stream = RoundTrip(context, domain, keys);
    EXPECT_EQ(keys.Now, actual.Now);
    EXPECT_TRUE(IsQuadratic(ArrayModes::Read(stream).Spatial));
    const auto other = EncodeCellValues({ context.Parents }, { &domain, 1 }, { &keys, 1 });
    EXPECT_LT(stream.size(), other.size());

    // Changes of quadratic predictions.
    keys.Before = MakeKeys(places, domain, type == ScalarType::Int32 ? 1.03e7 : 1.03).Now;
    EXPECT_LT(RoundTrip(context, domain, keys).size(), stream.size());
    EXPECT_EQ(keys.Now, actual.Now);
  }
}

TEST(QuadraticPlaces, SmoothValuesOnCellsRoundTrip)
{
  const FloatEnvironment guard;
  const Cells cells(12, 0.05);
  std::vector<std::uint32_t> parents(cells.Middles.size());
  for (std::uint32_t i = 0; i < parents.size(); ++i)
  {
    parents[i] = i - 1; // Topology::NoTet for the first
  }
  const auto fit = FitCells(cells.Starts, cells.Corners, cells.Points);
  ExpectSmoothRoundTrips({ parents, &fit }, cells.Middles);
}

TEST(QuadraticPlaces, SmoothValuesOnBlocksRoundTrip)
{
  const FloatEnvironment guard;
  const auto places = MakeBlock(40);
  const QuadraticFit fit(places);
  ExpectSmoothRoundTrips({ {}, &fit }, places);
}

TEST(QuadraticPlaces, BoundedValuesKeepTheirBound)
{
  const FloatEnvironment guard;
  const auto places = MakeBlock(40);
  const QuadraticFit fit(places);
  std::vector<std::uint32_t> parents(places.size(), 0);
  parents[0] = Topology::NoTet;
  for (const double bound : { 1e-1, 1e-3, 1e-6 })
  {
    const auto rounding =
      MakeQuantizer(ScalarType::Float64, { ErrorKind::Absolute, bound }, FiniteRange{});
    ASSERT_TRUE(rounding);
    const Domain domain(ScalarType::Float64, rounding);
    const auto actual = MakeKeys(places, domain, 1);
    auto keys = actual;
    const auto stream = RoundTrip({ parents, &fit }, domain, keys);
    EXPECT_TRUE(IsQuadratic(ArrayModes::Read(stream).Spatial));
    double largest = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      largest =
        std::max(largest, std::abs(domain.ToNumber(keys.Now[i]) - domain.ToNumber(actual.Now[i])));
    }
    EXPECT_LE(largest, bound);
    EXPECT_GT(largest, 0.5 * bound);
    auto others = actual;
    EXPECT_LT(stream.size(), EncodeCellValues({ parents }, { &domain, 1 }, { &others, 1 }).size());

    // Values of blocks are on the lattice.
    auto snapped = actual;
    for (auto& key : snapped.Now)
    {
      key = rounding.ToLattice(ScalarType::Float64, key);
    }
    auto block = snapped;
    RoundTrip({ {}, &fit }, domain, block);
    EXPECT_EQ(block.Now, snapped.Now);
  }
}

TEST(QuadraticPlaces, StreamsWithoutPlacesAreRejected)
{
  const FloatEnvironment guard;
  const auto places = MakeBlock(20);
  const QuadraticFit fit(places);
  const Domain domain(ScalarType::Float32);
  auto keys = MakeKeys(places, domain, 1);
  const auto stream = RoundTrip({ {}, &fit }, domain, keys);
  ASSERT_TRUE(IsQuadratic(ArrayModes::Read(stream).Spatial));
  EXPECT_THROW(DecodeCellValues(stream, {}, { &domain, 1 }, { &keys, 1 }), Error);
}
}
}
