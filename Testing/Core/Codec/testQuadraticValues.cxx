// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkCodec.h"
#include "gatunError.h"
#include "gatunExactValues.h"
#include "gatunFloatEnvironment.h"
#include "gatunQuadraticCoder.h"
#include "gatunQuadraticMesh.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
using namespace gatun;
using namespace gatun::test;

constexpr double Inf = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::array QuadraticModes{ SpatialMode::Quadratic, SpatialMode::PlainQuadratic,
  SpatialMode::CorrectedQuadratic };

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

TEST(QuadraticValues, SmoothValuesOfAllTypesRoundTrip)
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

TEST(QuadraticValues, CorrectionsMakeSmoothComponentsShorter)
{
  const auto meshHeld = MakeMesh(12);
  const auto& mesh = *meshHeld;
  const QuadraticFit fit(mesh.Walk, mesh.GetPlaces());
  auto without = mesh.Context;
  without.Quadratic = &fit;
  const std::array domains{ Domain(ScalarType::Float64), Domain(ScalarType::Float32),
    Domain(ScalarType::Float64) };
  std::vector<ComponentKeys> truth;
  for (std::size_t c = 0; c < domains.size(); ++c)
  {
    truth.push_back(MakeKeys(mesh, domains[c], 1 + static_cast<double>(c)));
  }
  const FloatEnvironment guard;
  auto keys = truth;
  const auto stream = EncodePointValues(mesh.Context, domains, keys);
  EXPECT_EQ(ArrayModes::Read(stream).Spatial, SpatialMode::CorrectedQuadratic);
  EXPECT_LT(stream.size(), EncodePointValues(without, domains, keys).size());
  for (const auto v : mesh.Context.OwnIds)
  {
    for (auto& component : keys)
    {
      component.Now[v] = 0;
    }
  }
  DecodePointValues(stream, mesh.Context, domains, keys);
  for (std::size_t c = 0; c < keys.size(); ++c)
  {
    EXPECT_EQ(keys[c].Now, truth[c].Now);
  }
}

/** The same by each quadratic mode, whatever others would need. */
void ExpectQuadraticRoundTrip(
  const ChunkMesh& mesh, const Domain& domain, const ComponentKeys& truth)
{
  const FloatEnvironment guard;
  for (const auto spatial : QuadraticModes)
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

TEST(QuadraticValues, ValuesThatAreNotFiniteRoundTrip)
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

TEST(QuadraticValues, ValuesAtSingularNeighborhoodsRoundTrip)
{
  const auto mesh = MakeMesh(6, MoveToSingular);
  const auto straight = MakeMesh(6);
  const Domain domain(ScalarType::Float32);
  ExpectQuadraticRoundTrip(*mesh, domain, MakeKeys(*straight, domain, 1));
}

TEST(QuadraticValues, ChunksOfOnePointRoundTrip)
{
  const auto mesh = MakeMesh(1, [](double* p) { p[0] = p[1] = p[2] = 2; });
  const Domain domain(ScalarType::Float32);
  ExpectQuadraticRoundTrip(*mesh, domain, MakeKeys(*mesh, domain, 1));
}

TEST(QuadraticValues, NoiseKeepsTheFasterModes)
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

TEST(QuadraticValues, ModesThatAreNotAllowedAreRejected)
{
  const auto meshHeld = MakeMesh(8);
  const auto& mesh = *meshHeld;
  const Domain domain(ScalarType::Float64);
  std::vector<ComponentKeys> keys{ MakeKeys(mesh, domain, 1) };
  keys[0].Before.assign(keys[0].Now.size(), domain.FromNumber(0));
  auto stream = EncodePointValues(mesh.Context, { &domain, 1 }, keys);
  ASSERT_TRUE(IsQuadratic(ArrayModes::Read(stream).Spatial));
  auto context = mesh.Context;
  context.Quadratic = nullptr;
  for (const auto mode : QuadraticModes)
  {
    stream[0] = static_cast<std::uint8_t>(mode);
    stream[1] = 0;
    EXPECT_THROW(DecodePointValues(stream, context, { &domain, 1 }, keys), Error);
    EXPECT_THROW(DecodeCellValues(stream, { mesh.Walk.Parents }, { &domain, 1 }, keys), Error);
    stream[1] = 1;
    EXPECT_THROW(ArrayModes::Read(stream), Error);
    EXPECT_THROW(DecodePointValues(stream, mesh.Context, { &domain, 1 }, keys), Error);
  }
  const QuadraticFit withoutCorrections(mesh.Walk, mesh.GetPlaces());
  context.Quadratic = &withoutCorrections;
  const CellContext cells{ mesh.Walk.Parents, &withoutCorrections };
  stream[0] = 5;
  stream[1] = 0;
  EXPECT_THROW(DecodePointValues(stream, context, { &domain, 1 }, keys), Error);
  EXPECT_THROW(DecodeCellValues(stream, cells, { &domain, 1 }, keys), Error);
  stream[0] = 6;
  EXPECT_THROW(ArrayModes::Read(stream), Error);
  EXPECT_THROW(DecodePointValues(stream, mesh.Context, { &domain, 1 }, keys), Error);
}

TEST(QuadraticValues, AnyStreamGivesKeysOrAnError)
{
  const auto meshHeld = MakeMesh(4, MoveToSingular);
  const auto& mesh = *meshHeld;
  const Domain domain(ScalarType::Float64);
  std::mt19937 random(11);
  for (unsigned round = 0; round < 300; ++round)
  {
    Bytes stream{ static_cast<std::uint8_t>(3 + round % 3),
      static_cast<std::uint8_t>(round % 2 * 2) };
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
