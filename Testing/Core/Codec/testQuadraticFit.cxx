// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkCodec.h"
#include "gatunError.h"
#include "gatunExactValues.h"
#include "gatunFloatEnvironment.h"
#include "gatunNeighborLists.h"
#include "gatunQuadraticCoder.h"
#include "gatunQuadraticLanes.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <span>
#include <utility>

namespace
{
using namespace gatun;
using namespace gatun::test;

constexpr double Inf = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/** A chunk of n^3 cubes, some vertices of which are shared. move: changes places. */
std::unique_ptr<const ChunkMesh> MakeMesh(
  std::int64_t n, const std::function<void(double*)>& move = [](double*) {})
{
  TestMesh mesh = MakeCubes(n, 0.2);
  ChunkFrame frame;
  const Domain domain(ScalarType::Float64);
  frame.Domains = { domain, domain, domain };
  frame.Box = { Range{ -1, n + 1.0 }, Range{ -1, n + 1.0 }, Range{ -1, n + 1.0 } };
  std::vector<PointKeys> shared, own;
  std::vector<std::uint32_t> number(mesh.GetPoints());
  for (const bool isShared : { true, false })
  {
    for (std::size_t v = 0; v < number.size(); ++v)
    {
      double* p = mesh.Coordinates.data() + 3 * v;
      if ((v % 7 == 0) == isShared)
      {
        number[v] = static_cast<std::uint32_t>(shared.size() + own.size());
        move(p);
        (isShared ? shared : own)
          .push_back({ domain.Read(p), domain.Read(p + 1), domain.Read(p + 2) });
      }
    }
  }
  std::vector<std::array<std::uint32_t, 4>> tets(mesh.GetTets());
  for (std::size_t i = 0; i < mesh.Ids.size(); ++i)
  {
    tets[i / 4][i % 4] = number[static_cast<std::size_t>(mesh.Ids[i])];
  }
  frame.Tets = static_cast<std::uint32_t>(tets.size());
  frame.OwnPoints = static_cast<std::uint32_t>(own.size());
  frame.SharedKeys = shared;
  frame.SharedUsers.assign(shared.size(), 1);
  auto result = std::make_unique<ChunkMesh>(EncodeChunk(frame, tets, own).Mesh);
  result->MakeContext(true); // with pointers into it
  return result;
}

//------------------------------------------------------------------------------
// Lists of neighbors

/** Own vertices, and the vertices that they know at most two edges away, by sets. */
std::vector<std::set<Vertex>> FindKnown(const ChunkMesh& mesh)
{
  const auto& walk = mesh.Walk;
  const auto count = walk.Sources.size();
  std::vector<std::set<Vertex>> edges(count);
  for (const auto& [a, b] : walk.EdgeLog)
  {
    edges[a].insert(b);
    edges[b].insert(a);
  }
  std::vector<std::set<Vertex>> result;
  for (Vertex v = 0; v < count; ++v)
  {
    if (walk.IsShared(v))
    {
      continue;
    }
    const auto isKnown = [&](Vertex u) { return walk.IsShared(u) || u < v; };
    auto& known = result.emplace_back();
    for (const auto u : edges[v])
    {
      if (isKnown(u))
      {
        known.insert(u);
        std::copy_if(edges[u].begin(), edges[u].end(), std::inserter(known, known.end()),
          [&](Vertex w) { return w != v && isKnown(w); });
      }
    }
  }
  return result;
}

TEST(QuadraticFit, NeighborsAreTheNearestKnownVertices)
{
  const FloatEnvironment guard;
  const auto meshHeld = MakeMesh(6);
  const auto& mesh = *meshHeld;
  const auto places = mesh.GetPlaces();
  const auto lists = NeighborLists::OfWalk(mesh.Walk, places);
  const auto known = FindKnown(mesh);
  ASSERT_EQ(lists.GetCenters(), known.size());
  std::size_t full = 0;
  for (std::size_t own = 0; own < known.size(); ++own)
  {
    const auto v = mesh.Context.OwnIds[own];
    const auto distance = [&](Vertex u)
    {
      double square = 0;
      for (unsigned i = 0; i < 3; ++i)
      {
        square += (places[u][i] - places[v][i]) * (places[u][i] - places[v][i]);
      }
      return static_cast<float>(square);
    };
    const auto list = lists.Of(own);
    const std::set<Vertex> found(list.begin(), list.end());
    EXPECT_EQ(found.size(), list.size());
    EXPECT_EQ(list.size(), std::min(NeighborLists::MaxNeighbors, known[own].size()));
    EXPECT_TRUE(std::is_sorted(list.begin(), list.end(),
      [&](Vertex a, Vertex b) { return std::pair(distance(a), a) < std::pair(distance(b), b); }));
    float farthest = 0;
    for (const auto u : list)
    {
      EXPECT_TRUE(known[own].count(u)) << v << " " << u;
      farthest = std::max(farthest, distance(u));
    }
    for (const auto u : known[own])
    {
      EXPECT_TRUE(found.count(u) || distance(u) >= farthest) << v << " " << u;
    }
    full += list.size() == NeighborLists::MaxNeighbors && list.size() < known[own].size();
  }
  EXPECT_GT(full, known.size() / 4); // otherwise nothing was chosen
}

//------------------------------------------------------------------------------
// Weights

/** Lanes with different numbers of neighbors at random places. */
QuadraticLanes MakeLanes(unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<float> place(0, 0.6f);
  QuadraticLanes lanes{};
  for (std::size_t lane = 0; lane < QuadraticLanes::Count; ++lane)
  {
    const std::size_t count = (seed + 5 * lane) % (NeighborLists::MaxNeighbors + 1);
    for (std::size_t i = 0; i < count; ++i)
    {
      lanes.X[i][lane] = place(random);
      lanes.Y[i][lane] = lane == 3 ? 0 : place(random);              // in a plane
      lanes.Z[i][lane] = lane == 3 || lane == 4 ? 0 : place(random); // on a line; in a plane
      lanes.Used[i][lane] = 1;
      lanes.Share[i][lane] = i % 3 == 0 ? 0.0f : 1.0f;
    }
    lanes.PerNeighbor[lane] = 3 / static_cast<float>(std::max<std::size_t>(count, 1));
    lanes.Neighbors = std::max(lanes.Neighbors, count);
  }
  return lanes;
}

TEST(QuadraticFit, AllVersionsGiveTheSameBits)
{
  const auto best = GetBestQuadraticWeights();
  if (best == GetPortableQuadraticWeights())
  {
    GTEST_SKIP() << "this processor has only the portable version";
  }
  for (unsigned seed = 0; seed < 500; ++seed)
  {
    auto one = MakeLanes(seed);
    auto other = one;
    best(one);
    GetPortableQuadraticWeights()(other);
    for (std::size_t i = 0; i < one.Neighbors; ++i)
    {
      for (std::size_t lane = 0; lane < QuadraticLanes::Count; ++lane)
      {
        const auto expectSame = [&](float a, float b)
        {
          EXPECT_TRUE(std::isnan(a) ? std::isnan(b) : std::memcmp(&a, &b, sizeof(a)) == 0)
            << seed << " " << i << " " << lane << " " << a << " " << b;
        };
        expectSame(one.Quadratic[i][lane], other.Quadratic[i][lane]);
        expectSame(one.Linear[i][lane], other.Linear[i][lane]);
        expectSame(one.Share[i][lane], other.Share[i][lane]);
      }
    }
  }
}

TEST(QuadraticFit, OtherLanesAndTheirPaddingChangeNothing)
{
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    auto together = MakeLanes(seed);
    for (std::size_t lane = 0; lane < QuadraticLanes::Count; ++lane)
    {
      auto alone = MakeLanes(seed);
      const auto count = (seed + 5 * lane) % (NeighborLists::MaxNeighbors + 1);
      alone.Neighbors = count;
      GetBestQuadraticWeights()(alone);
      auto all = together;
      GetBestQuadraticWeights()(all);
      for (std::size_t i = 0; i < count; ++i)
      {
        EXPECT_EQ(alone.Quadratic[i][lane], all.Quadratic[i][lane]);
        EXPECT_EQ(alone.Linear[i][lane], all.Linear[i][lane]);
        EXPECT_EQ(alone.Share[i][lane], all.Share[i][lane]);
      }
    }
  }
}

TEST(QuadraticFit, PredictsQuadraticFunctions)
{
  const FloatEnvironment guard;
  const auto meshHeld = MakeMesh(7);
  const auto& mesh = *meshHeld;
  const auto places = mesh.GetPlaces();
  const auto value = [](const std::array<double, 3>& p)
  { return 3 + p[0] - 2 * p[1] + 0.5 * p[0] * p[2] - 0.25 * p[1] * p[1]; };
  double quadratic = 0, linear = 0;
  std::size_t count = 0;
  for (std::size_t own = 0; own < mesh.Context.OwnIds.size(); ++own)
  {
    const auto neighbors = mesh.Quadratic->Of(own);
    if (neighbors.GetCount() < NeighborLists::MaxNeighbors)
    {
      continue;
    }
    const double truth = value(places[mesh.Context.OwnIds[own]]);
    double a = 0, b = 0;
    for (std::size_t i = 0; i < neighbors.GetCount(); ++i)
    {
      const double difference = value(places[neighbors.Ids[i]]) - truth;
      a += neighbors.Quadratic[i] * difference;
      b += neighbors.Linear[i] * difference;
    }
    quadratic += std::abs(a);
    linear += std::abs(b);
    ++count;
  }
  ASSERT_GT(count, 50u);
  EXPECT_LT(quadratic, 0.2 * linear);
}

/** Moves vertices so that neighborhoods are singular in several ways. */
void MoveToSingular(double* p)
{
  if (p[0] > 4)
  {
    p[0] = 5; // a plane
  }
  if (p[2] < 1.5)
  {
    p[1] = p[2] = 0; // a line
  }
  if (p[1] > 3.5)
  {
    p[0] = p[1] = p[2] = 3; // a point
  }
  if (p[2] > 4.5)
  {
    p[0] = p[1] > 2 ? NaN : Inf;
    p[1] *= 1e300;
  }
}

TEST(QuadraticFit, WeightsOfSingularNeighborhoodsAreFiniteAndSmall)
{
  const auto meshHeld = MakeMesh(6, MoveToSingular);
  const auto& mesh = *meshHeld;
  std::size_t equal = 0;
  for (std::size_t own = 0; own < mesh.Context.OwnIds.size(); ++own)
  {
    const auto neighbors = mesh.Quadratic->Of(own);
    double quadratic = 0, linear = 0, share = 0;
    for (std::size_t i = 0; i < neighbors.GetCount(); ++i)
    {
      quadratic += std::abs(neighbors.Quadratic[i]);
      linear += std::abs(neighbors.Linear[i]);
      share += neighbors.Shares[i];
      equal += neighbors.Quadratic[i] == 1 / static_cast<float>(neighbors.GetCount());
    }
    EXPECT_LE(quadratic, 1.001e4);
    EXPECT_LE(linear, 1.001e4);
    EXPECT_TRUE(share == 0 || std::abs(share - 1) < 1e-5) << share;
  }
  EXPECT_GT(equal, 0u); // some weights had to be replaced
}

//------------------------------------------------------------------------------
// Streams

/** Encodes and decodes values by all modes. Returns the spatial mode. */
SpatialMode ExpectRoundTrip(const ChunkMesh& mesh, const Domain& domain, const ComponentKeys& truth)
{
  std::vector<ComponentKeys> keys{ truth };
  const FloatEnvironment guard;
  const auto stream = EncodePointValues(mesh.Context, { &domain, 1 }, keys);
  std::vector<ComponentKeys> found{ truth };
  for (const auto v : mesh.Context.OwnIds)
  {
    found[0].Now[v] = 0;
  }
  DecodePointValues(stream, mesh.Context, { &domain, 1 }, found);
  EXPECT_EQ(found[0].Now, truth.Now);
  return ArrayModes::Read(stream).Spatial;
}

double Smooth(const std::array<double, 3>& p)
{
  return std::sin(0.4 * p[0]) * std::cos(0.3 * p[1] - 0.2 * p[2]) + 0.1 * p[0] * p[2];
}

ComponentKeys MakeKeys(const ChunkMesh& mesh, const Domain& domain, double factor)
{
  ComponentKeys keys;
  for (const auto& place : mesh.GetPlaces())
  {
    const double value = Smooth(place) * factor;
    keys.Now.push_back(domain.FromNumber(value));
  }
  return keys;
}

TEST(QuadraticFit, SmoothValuesOfAllTypesRoundTrip)
{
  const auto meshHeld = MakeMesh(8);
  const auto& mesh = *meshHeld;
  for (const auto type : { ScalarType::Float32, ScalarType::Float64, ScalarType::Int32,
         ScalarType::UInt64, ScalarType::Int64 })
  {
    const bool isFloat = type == ScalarType::Float32 || type == ScalarType::Float64;
    const Domain domain(type);
    const auto keys = MakeKeys(mesh, domain, isFloat ? 1 : 1e8);
    EXPECT_TRUE(IsQuadratic(ExpectRoundTrip(mesh, domain, keys)));
  }
}

/** The same by both quadratic modes, whatever others would need. */
void ExpectQuadraticRoundTrip(
  const ChunkMesh& mesh, const Domain& domain, const ComponentKeys& truth)
{
  const FloatEnvironment guard;
  for (const auto spatial : { SpatialMode::Quadratic, SpatialMode::PlainQuadratic })
  {
    for (const auto temporal : { TemporalMode::None, TemporalMode::Change })
    {
      if (temporal != TemporalMode::None && truth.Before.empty())
      {
        continue;
      }
      auto keys = truth;
      EntropyEncoder encoder;
      const OwnPoints places{ mesh.Context };
      CodeQuadratic(encoder, spatial, temporal, places, ExactValues(domain), keys);
      const auto stream = encoder.Finish();
      EntropyDecoder decoder(stream);
      for (const auto v : mesh.Context.OwnIds)
      {
        keys.Now[v] = 0;
      }
      CodeQuadratic(decoder, spatial, temporal, places, ExactValues(domain), keys);
      EXPECT_EQ(keys.Now, truth.Now);
    }
  }
}

TEST(QuadraticFit, ValuesThatAreNotFiniteRoundTrip)
{
  const auto meshHeld = MakeMesh(8);
  const auto& mesh = *meshHeld;
  const Domain domain(ScalarType::Float64);
  const std::array odd{ NaN, Inf, -Inf, -0.0, 5e-324, -NaN, 1e308, -1e308 };
  for (const std::size_t count : { std::size_t{ 6 }, odd.size() })
  {
    auto keys = MakeKeys(mesh, domain, 1);
    for (std::size_t v = 0; v < keys.Now.size(); v += 23)
    {
      keys.Now[v] = domain.Read(&odd[v % count]);
    }
    if (count == 6)
    {
      EXPECT_TRUE(IsQuadratic(ExpectRoundTrip(mesh, domain, keys)));
    }
    keys.Before = MakeKeys(mesh, domain, 1.01).Now;
    for (std::size_t v = 3; v < keys.Now.size(); v += 13)
    {
      keys.Before[v] = domain.Read(&odd[v % count]);
    }
    ExpectQuadraticRoundTrip(mesh, domain, keys);
  }
}

/** Encodes one component after the other by the mode plain quadratic, and decodes all of them. */
void ExpectComponentsRoundTrip(const ChunkMesh& mesh, std::span<const Domain> domains,
  TemporalMode temporal, const std::vector<ComponentKeys>& truth)
{
  const FloatEnvironment guard;
  EntropyEncoder encoder;
  auto keys = truth;
  for (std::size_t c = 0; c < keys.size(); ++c)
  {
    CodeQuadratic(encoder, SpatialMode::PlainQuadratic, temporal, OwnPoints{ mesh.Context },
      ExactValues(domains[c]), keys[c]);
    for (const auto v : mesh.Context.OwnIds)
    {
      keys[c].Now[v] = 0;
    }
  }
  Bytes stream{ static_cast<std::uint8_t>(SpatialMode::PlainQuadratic),
    static_cast<std::uint8_t>(temporal) };
  const auto body = encoder.Finish();
  stream.insert(stream.end(), body.begin(), body.end());
  DecodePointValues(stream, mesh.Context, domains, keys);
  for (std::size_t c = 0; c < keys.size(); ++c)
  {
    EXPECT_EQ(keys[c].Now, truth[c].Now) << "component " << c << " of " << keys.size();
  }
}

TEST(QuadraticFit, ComponentsDecodedTogetherAreThoseEncodedOneByOne)
{
  const auto meshHeld = MakeMesh(8);
  const auto& mesh = *meshHeld;
  const std::array odd{ NaN, Inf, -Inf, -0.0, 1e38, -1e38 };
  for (const auto type : { ScalarType::Float32, ScalarType::Float64, ScalarType::Int32 })
  {
    const Domain domain(type);
    const auto toKey = [&](double number)
    {
      const std::array single{ static_cast<float>(number), 0.0F }; // as long as a double
      return type == ScalarType::Float32 ? domain.Read(single.data())
        : type == ScalarType::Float64    ? domain.Read(&number)
                                         : domain.FromNumber(number);
    };
    for (std::size_t count = 1; count <= 9; ++count)
    {
      std::vector<ComponentKeys> keys;
      for (std::size_t c = 0; c < count; ++c)
      {
        const double factor = (type == ScalarType::Int32 ? 1e6 : 1) * (1 + static_cast<double>(c));
        keys.push_back(MakeKeys(mesh, domain, factor));
        keys[c].Before = MakeKeys(mesh, domain, 1.01 * factor).Now;
        for (std::size_t v = c; v < keys[c].Now.size() && count > 4; v += 17 + c)
        {
          keys[c].Now[v] = toKey(odd[v % odd.size()]);
          keys[c].Before[(v + 1) % keys[c].Before.size()] = toKey(odd[(v + 1) % odd.size()]);
        }
      }
      const std::vector<Domain> domains(count, domain);
      ExpectComponentsRoundTrip(mesh, domains, TemporalMode::None, keys);
      ExpectComponentsRoundTrip(mesh, domains, TemporalMode::Change, keys);
    }
  }
}

TEST(QuadraticFit, ValuesAtSingularNeighborhoodsRoundTrip)
{
  const auto mesh = MakeMesh(6, MoveToSingular);
  const auto straight = MakeMesh(6);
  const Domain domain(ScalarType::Float32);
  ExpectQuadraticRoundTrip(*mesh, domain, MakeKeys(*straight, domain, 1));
}

TEST(QuadraticFit, ChunksOfOnePointRoundTrip)
{
  const auto mesh = MakeMesh(1, [](double* p) { p[0] = p[1] = p[2] = 2; });
  const Domain domain(ScalarType::Float32);
  ExpectQuadraticRoundTrip(*mesh, domain, MakeKeys(*mesh, domain, 1));
}

TEST(QuadraticFit, NoiseKeepsTheFasterModes)
{
  const auto meshHeld = MakeMesh(8);
  const auto& mesh = *meshHeld;
  const Domain domain(ScalarType::Float32);
  ComponentKeys keys;
  std::mt19937 random(3);
  for (std::size_t v = 0; v < mesh.Keys.size(); ++v)
  {
    keys.Now.push_back(domain.FromNumber(1 + 1e-3 * static_cast<double>(random() % 1000)));
  }
  EXPECT_FALSE(IsQuadratic(ExpectRoundTrip(mesh, domain, keys)));
}

TEST(QuadraticFit, ModesThatAreNotAllowedAreRejected)
{
  const auto meshHeld = MakeMesh(8);
  const auto& mesh = *meshHeld;
  const Domain domain(ScalarType::Float64);
  std::vector<ComponentKeys> keys{ MakeKeys(mesh, domain, 1) };
  keys[0].Before.assign(keys[0].Now.size(), domain.FromNumber(0));
  auto stream = EncodePointValues(mesh.Context, { &domain, 1 }, keys);
  ASSERT_EQ(stream[0], 3);
  auto context = mesh.Context;
  context.Quadratic = nullptr;
  for (const auto mode : { SpatialMode::Quadratic, SpatialMode::PlainQuadratic })
  {
    stream[0] = static_cast<std::uint8_t>(mode);
    stream[1] = 0;
    EXPECT_THROW(DecodePointValues(stream, context, { &domain, 1 }, keys), Error);
    EXPECT_THROW(DecodeCellValues(stream, { mesh.Walk.Parents }, { &domain, 1 }, keys), Error);
    stream[1] = 1;
    EXPECT_THROW(ArrayModes::Read(stream), Error);
    EXPECT_THROW(DecodePointValues(stream, mesh.Context, { &domain, 1 }, keys), Error);
  }
  stream[0] = 5;
  stream[1] = 0;
  EXPECT_THROW(ArrayModes::Read(stream), Error);
  EXPECT_THROW(DecodePointValues(stream, mesh.Context, { &domain, 1 }, keys), Error);
}

TEST(QuadraticFit, AnyStreamGivesKeysOrAnError)
{
  const auto meshHeld = MakeMesh(4, MoveToSingular);
  const auto& mesh = *meshHeld;
  const Domain domain(ScalarType::Float64);
  std::mt19937 random(11);
  for (unsigned round = 0; round < 300; ++round)
  {
    Bytes stream{ 3, static_cast<std::uint8_t>(round % 2 * 2) };
    for (unsigned i = 0; i < 600; ++i)
    {
      stream.push_back(static_cast<std::uint8_t>(i == 0 ? 100 + round % 28 : random()));
    }
    std::vector<ComponentKeys> keys(1);
    for (std::size_t v = 0; v < mesh.Keys.size(); ++v)
    {
      keys[0].Now.push_back(std::uint64_t{ random() } << 32 | random());
      keys[0].Before.push_back(std::uint64_t{ random() } << 32 | random());
    }
    try
    {
      const FloatEnvironment guard;
      DecodePointValues(stream, mesh.Context, { &domain, 1 }, keys);
    }
    catch (const Error&)
    {
      continue;
    }
  }
}
}
