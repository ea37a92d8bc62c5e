// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Streams of the modes Quadratic and PlainQuadratic.

#include "gatunArrayCodec.h"
#include "gatunError.h"
#include "gatunExactValues.h"
#include "gatunFloatEnvironment.h"
#include "gatunPlainCoder.h"
#include "gatunQuadraticCoder.h"
#include "gatunQuadraticMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <vector>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** Encodes and decodes values by all modes. Returns the spatial mode. */
SpatialMode ExpectStreamRoundTrip(
  const QuadraticMesh& mesh, const Domain& domain, const ComponentKeys& actual)
{
  std::vector<ComponentKeys> keys{ actual };
  const FloatEnvironment guard;
  const auto stream = EncodePointValues(mesh.Context.GetPoints(), { &domain, 1 }, keys);
  std::vector<ComponentKeys> found{ actual };
  for (const auto v : mesh.OwnIds)
  {
    found[0].Now[v] = 0;
  }
  DecodePointValues(stream, mesh.Context.GetPoints(), { &domain, 1 }, found);
  EXPECT_EQ(found[0].Now, actual.Now);
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

TEST(QuadraticStreams, SmoothValuesOfAllTypesRoundTrip)
{
  const auto meshHeld = MakeMesh(8);
  const auto& mesh = *meshHeld;
  for (const auto type : { ScalarType::Float32, ScalarType::Float64, ScalarType::Int32,
         ScalarType::UInt64, ScalarType::Int64 })
  {
    const bool isFloat = type == ScalarType::Float32 || type == ScalarType::Float64;
    const Domain domain(type);
    const auto keys = MakeKeys(mesh, domain, isFloat ? 1 : 1e8);
    EXPECT_TRUE(IsQuadratic(ExpectStreamRoundTrip(mesh, domain, keys)));
  }
}

/** Codes a component by one of the quadratic modes. */
template <typename Coder>
void CodeByMode(Coder& coder, SpatialMode spatial, TemporalMode temporal, const QuadraticMesh& mesh,
  const Domain& domain, ComponentKeys& keys)
{
  const OwnPoints places{ mesh.Context.GetPoints() };
  if (spatial == SpatialMode::Quadratic)
  {
    CodeQuadratic(coder, temporal, places, ExactValues(domain), keys);
  }
  else
  {
    CodePlain(coder, temporal, places, false, { &domain, 1 }, { &keys, 1 });
  }
}

/** The same by both quadratic modes, whatever others would need. */
void ExpectQuadraticRoundTrip(
  const QuadraticMesh& mesh, const Domain& domain, const ComponentKeys& actual)
{
  const FloatEnvironment guard;
  for (const auto spatial : { SpatialMode::Quadratic, SpatialMode::PlainQuadratic })
  {
    for (const auto temporal : { TemporalMode::None, TemporalMode::Change })
    {
      if (temporal != TemporalMode::None && actual.Before.empty())
      {
        continue;
      }
      auto keys = actual;
      EntropyEncoder encoder;
      CodeByMode(encoder, spatial, temporal, mesh, domain, keys);
      const auto stream = encoder.Finish();
      EntropyDecoder decoder(stream);
      for (const auto v : mesh.OwnIds)
      {
        keys.Now[v] = 0;
      }
      CodeByMode(decoder, spatial, temporal, mesh, domain, keys);
      EXPECT_EQ(keys.Now, actual.Now);
    }
  }
}

TEST(QuadraticStreams, ValuesThatAreNotFiniteRoundTrip)
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
      EXPECT_TRUE(IsQuadratic(ExpectStreamRoundTrip(mesh, domain, keys)));
    }
    keys.Before = MakeKeys(mesh, domain, 1.01).Now;
    for (std::size_t v = 3; v < keys.Now.size(); v += 13)
    {
      keys.Before[v] = domain.Read(&odd[v % count]);
    }
    ExpectQuadraticRoundTrip(mesh, domain, keys);
  }
}

/** Encodes one component after the other by the mode plain quadratic, and decodes all of them.
 * Returns the keys. */
std::vector<ComponentKeys> ExpectComponentsRoundTrip(const QuadraticMesh& mesh,
  std::span<const Domain> domains, TemporalMode temporal, const std::vector<ComponentKeys>& actual)
{
  const FloatEnvironment guard;
  EntropyEncoder encoder;
  auto keys = actual;
  auto encoded = actual;
  for (std::size_t c = 0; c < keys.size(); ++c)
  {
    CodePlain(encoder, temporal, OwnPoints{ mesh.Context.GetPoints() }, false,
      domains.subspan(c, 1), std::span(encoded).subspan(c, 1));
    for (const auto v : mesh.OwnIds)
    {
      keys[c].Now[v] = 0;
    }
  }
  Bytes stream{ static_cast<std::uint8_t>(SpatialMode::PlainQuadratic),
    static_cast<std::uint8_t>(temporal) };
  const auto body = encoder.Finish();
  stream.insert(stream.end(), body.begin(), body.end());
  DecodePointValues(stream, mesh.Context.GetPoints(), domains, keys);
  for (std::size_t c = 0; c < keys.size(); ++c)
  {
    EXPECT_EQ(keys[c].Now, encoded[c].Now) << "component " << c << " of " << keys.size();
    EXPECT_TRUE(domains[c].GetQuantizer() || keys[c].Now == actual[c].Now) << "component " << c;
  }
  return keys;
}

TEST(QuadraticStreams, ComponentsDecodedTogetherAreThoseEncodedOneByOne)
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

TEST(QuadraticStreams, BoundedComponentsDecodedTogetherKeepTheirBounds)
{
  const auto meshHeld = MakeMesh(8);
  const auto& mesh = *meshHeld;
  const std::array odd{ NaN, Inf, -Inf, 1e300, 0.0, -1e300 };
  for (const auto kind : { ErrorKind::Absolute, ErrorKind::Pointwise })
  {
    std::vector<Domain> domains;
    std::vector<ComponentKeys> keys;
    std::vector<Quantizer> roundings;
    for (const double bound : { 1e-1, 1e-3, 0.0, 1e-6, 1e-2 })
    {
      roundings.push_back(bound > 0
          ? MakeQuantizer(ScalarType::Float64, { kind, bound }, FiniteRange{})
          : Quantizer()); // an exact component among the others
      domains.emplace_back(ScalarType::Float64, roundings.back());
      keys.push_back(MakeKeys(mesh, domains.back(), 1 + bound));
      keys.back().Before = MakeKeys(mesh, domains.back(), 1.01).Now;
      for (std::size_t v = keys.size(); v < keys.back().Now.size(); v += 29)
      {
        keys.back().Now[v] = domains.back().Read(&odd[v % odd.size()]);
        keys.back().Before[(v + 1) % keys.back().Now.size()] = keys.back().Now[v];
      }
    }
    for (const auto temporal : { TemporalMode::None, TemporalMode::Change })
    {
      const auto found = ExpectComponentsRoundTrip(mesh, domains, temporal, keys);
      for (std::size_t c = 0; c < keys.size(); ++c)
      {
        const auto isWithin = [&](Vertex v)
        { return roundings[c].IsWithin(ScalarType::Float64, keys[c].Now[v], found[c].Now[v]); };
        const auto& own = mesh.OwnIds;
        EXPECT_TRUE(!roundings[c] || std::all_of(own.begin(), own.end(), isWithin)) << c;
        EXPECT_EQ(found[c].Now == keys[c].Now, !roundings[c]) << c;
      }
    }
  }
}

TEST(QuadraticStreams, ValuesAtSingularNeighborhoodsRoundTrip)
{
  const auto mesh = MakeMesh(6, MoveToSingular);
  const auto straight = MakeMesh(6);
  const Domain domain(ScalarType::Float32);
  ExpectQuadraticRoundTrip(*mesh, domain, MakeKeys(*straight, domain, 1));
}

TEST(QuadraticStreams, ChunksOfOnePointRoundTrip)
{
  const auto mesh = MakeMesh(1, [](double* p) { p[0] = p[1] = p[2] = 2; });
  const Domain domain(ScalarType::Float32);
  ExpectQuadraticRoundTrip(*mesh, domain, MakeKeys(*mesh, domain, 1));
}

TEST(QuadraticStreams, NoiseKeepsTheFasterModes)
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
  EXPECT_FALSE(IsQuadratic(ExpectStreamRoundTrip(mesh, domain, keys)));
}

TEST(QuadraticStreams, ModesThatAreNotAllowedAreRejected)
{
  const auto meshHeld = MakeMesh(8);
  const auto& mesh = *meshHeld;
  const Domain domain(ScalarType::Float64);
  std::vector<ComponentKeys> keys{ MakeKeys(mesh, domain, 1) };
  keys[0].Before.assign(keys[0].Now.size(), domain.FromNumber(0));
  auto stream = EncodePointValues(mesh.Context.GetPoints(), { &domain, 1 }, keys);
  ASSERT_EQ(stream[0], 3);
  auto context = mesh.Context.GetPoints();
  context.Quadratic = nullptr;
  for (const auto mode : { SpatialMode::Quadratic, SpatialMode::PlainQuadratic })
  {
    stream[0] = static_cast<std::uint8_t>(mode);
    stream[1] = 0;
    EXPECT_THROW(DecodePointValues(stream, context, { &domain, 1 }, keys), Error);
    EXPECT_THROW(DecodeCellValues(stream, { mesh.Walk.Parents }, { &domain, 1 }, keys), Error);
    stream[1] = 1;
    EXPECT_THROW(ArrayModes::Read(stream), Error);
    EXPECT_THROW(DecodePointValues(stream, mesh.Context.GetPoints(), { &domain, 1 }, keys), Error);
  }
  stream[0] = 6;
  stream[1] = 0;
  EXPECT_THROW(ArrayModes::Read(stream), Error);
  // Points of a mesh that was walked have no gates of a tree.
  stream[0] = static_cast<std::uint8_t>(SpatialMode::Fast);
  EXPECT_THROW(DecodePointValues(stream, mesh.Context.GetPoints(), { &domain, 1 }, keys), Error);
}

/** Decodes the residuals of a stream that write(coder, model) makes. */
template <typename Write>
void DecodeResiduals(bool isBounded, Write&& write)
{
  EntropyEncoder encoder;
  LengthModel model;
  write(encoder, model);
  const auto stream = encoder.Finish();
  EntropyDecoder decoder(stream);
  PlainResiduals residuals(64, 0);
  residuals.IsBounded = isBounded;
  residuals.Code(decoder, 1);
}

TEST(QuadraticStreams, ResidualsThatDoNotExistAreRejected)
{
  constexpr int spread = 20; // at first
  for (const int length : { 46, 47, 63, 64 })
  {
    const auto write = [&](EntropyEncoder& coder, LengthModel& model)
    {
      model.Code(coder, spread, length);
      coder.Raw(0, 64); // the residual, or that the value is 0
    };
    EXPECT_NO_THROW(DecodeResiduals(false, write)) << length;
    if (length == 47 || length == 63)
    {
      EXPECT_THROW(DecodeResiduals(true, write), Error) << length;
    }
    else
    {
      EXPECT_NO_THROW(DecodeResiduals(true, write)) << length;
    }
  }
  for (const unsigned kind : { 0u, 1u, 2u, 3u })
  {
    const auto write = [&](EntropyEncoder& coder, LengthModel& model)
    {
      model.Code(coder, spread, 64);
      coder.Raw(kind, 2);
      coder.Raw(5, 64);
    };
    if (kind == 3)
    {
      EXPECT_THROW(DecodeResiduals(true, write), Error);
    }
    else
    {
      EXPECT_NO_THROW(DecodeResiduals(true, write)) << kind;
    }
  }
}

TEST(QuadraticStreams, AnyStreamGivesKeysOrAnError)
{
  const auto meshHeld = MakeMesh(4, MoveToSingular);
  const auto& mesh = *meshHeld;
  const Domain domain(ScalarType::Float64);
  std::mt19937 random(11);
  for (unsigned round = 0; round < 300; ++round)
  {
    const auto mode = round % 4 < 2 ? SpatialMode::Quadratic : SpatialMode::PlainQuadratic;
    Bytes stream{ static_cast<std::uint8_t>(mode), static_cast<std::uint8_t>(round % 2 * 2) };
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
      DecodePointValues(stream, mesh.Context.GetPoints(), { &domain, 1 }, keys);
    }
    catch (const Error&)
    {
      continue;
    }
  }
}
}
