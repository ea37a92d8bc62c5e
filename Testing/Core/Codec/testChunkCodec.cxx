// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunChunkCodec.h"

#include "gatunError.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace
{
using namespace gatun;
using namespace gatun::test;

using Tets = std::vector<std::array<std::uint32_t, 4>>;

/** A chunk as the writer would hand it to the codec. */
struct ChunkCase
{
  ChunkFrame Frame;
  Tets Elements;
  std::vector<PointKeys> OwnKeys;
};

struct CaseOptions
{
  ScalarType Type = ScalarType::Float64;
  bool Palettes = false;
  std::function<bool(const double*)> IsShared = [](const double*) { return false; };
};

PointKeys ReadKeys(const PointDomain& domains, ScalarType type, const double* point)
{
  PointKeys keys{};
  for (unsigned i = 0; i < 3; ++i)
  {
    // Two, as GCC 12 believes that eight bytes might be read.
    const std::array<float, 2> narrow{ static_cast<float>(point[i]), 0 };
    keys[i] =
      type == ScalarType::Float32 ? domains[i].Read(narrow.data()) : domains[i].Read(&point[i]);
  }
  return keys;
}

PointDomain MakeDomains(const TestMesh& mesh, const CaseOptions& options)
{
  PointDomain domains;
  for (unsigned i = 0; i < 3; ++i)
  {
    domains[i] = Domain(options.Type);
    if (options.Palettes)
    {
      std::set<Key> keys;
      for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
      {
        keys.insert(ReadKeys(domains, options.Type, &mesh.Coordinates[3 * p])[i]);
      }
      domains[i] = Domain(options.Type, std::make_shared<const Palette>(keys.begin(), keys.end()));
    }
  }
  return domains;
}

ChunkCase MakeCase(const TestMesh& mesh, const CaseOptions& options = {})
{
  ChunkCase result;
  auto& frame = result.Frame;
  frame.Domains = MakeDomains(mesh, options);
  std::vector<char> used(mesh.GetPoints(), 0);
  for (const auto id : mesh.Ids)
  {
    used[static_cast<std::size_t>(id)] = 1;
  }
  std::vector<std::uint32_t> local(mesh.GetPoints(), 0);
  std::uint32_t count = 0;
  for (const bool shared : { true, false })
  {
    for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
    {
      const double* point = &mesh.Coordinates[3 * p];
      if (!used[p] || options.IsShared(point) != shared)
      {
        continue;
      }
      local[p] = count++;
      const auto keys = ReadKeys(frame.Domains, options.Type, point);
      (shared ? frame.SharedKeys : result.OwnKeys).push_back(keys);
      for (unsigned i = 0; i < 3; ++i)
      {
        const double value = frame.Domains[i].ToValue(keys[i]);
        if (std::isfinite(value))
        {
          frame.Box[i].Min = std::min(frame.Box[i].Min, value);
          frame.Box[i].Max = std::max(frame.Box[i].Max, value);
        }
      }
    }
  }
  frame.SharedUsers.assign(frame.SharedKeys.size(), 1);
  for (std::size_t t = 0; t < mesh.GetTets(); ++t)
  {
    std::array<std::uint32_t, 4> tet{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      tet[i] = local[static_cast<std::size_t>(mesh.Ids[4 * t + i])];
    }
    result.Elements.push_back(tet);
  }
  frame.Tets = static_cast<std::uint32_t>(result.Elements.size());
  frame.OwnPoints = static_cast<std::uint32_t>(result.OwnKeys.size());
  return result;
}

/** Encodes, decodes, and compares every tetrahedron, corner for corner, and every key. */
EncodedChunk ExpectRoundTrip(const ChunkCase& chunk)
{
  auto encoded = EncodeChunk(chunk.Frame, chunk.Elements, chunk.OwnKeys);
  const auto mesh = DecodeChunk(chunk.Frame, encoded.Connectivity, encoded.Geometry);
  EXPECT_EQ(mesh.Walk.Tets, encoded.Mesh.Walk.Tets);
  EXPECT_EQ(mesh.Walk.Parents, encoded.Mesh.Walk.Parents);
  EXPECT_EQ(mesh.Walk.EdgeLog, encoded.Mesh.Walk.EdgeLog);
  EXPECT_EQ(mesh.Keys, encoded.Mesh.Keys);
  EXPECT_EQ(mesh.UsedRules, encoded.Mesh.UsedRules);
  EXPECT_EQ(mesh.Rules, encoded.Mesh.Rules);

  const auto shared = static_cast<std::uint32_t>(chunk.Frame.SharedKeys.size());
  const auto inputOf = [&](Vertex v)
  {
    const auto source = mesh.Walk.Sources[v];
    return mesh.Walk.IsShared(v) ? source & ~Topology::SharedFlag
                                 : shared + encoded.OwnOrder[source];
  };
  EXPECT_EQ(mesh.Walk.Tets.size(), chunk.Elements.size());
  std::vector<char> seen(chunk.Elements.size(), 0);
  for (std::size_t t = 0; t < mesh.Walk.Tets.size(); ++t)
  {
    std::array<std::uint32_t, 4> tet{};
    std::transform(mesh.Walk.Tets[t].begin(), mesh.Walk.Tets[t].end(), tet.begin(), inputOf);
    EXPECT_EQ(RotateCorners(tet, encoded.Corners[t]), chunk.Elements[encoded.TetOrder[t]]);
    EXPECT_EQ(seen[encoded.TetOrder[t]]++, 0);
  }
  for (Vertex v = 0; v < mesh.Keys.size(); ++v)
  {
    const auto input = inputOf(v);
    EXPECT_EQ(
      mesh.Keys[v], input < shared ? chunk.Frame.SharedKeys[input] : chunk.OwnKeys[input - shared]);
  }
  return encoded;
}

double GetBitsPerTet(const EncodedChunk& chunk)
{
  return 8.0 * static_cast<double>(chunk.Connectivity.size()) /
    static_cast<double>(chunk.TetOrder.size());
}

/** Whether the corners of a tetrahedron are in the order that VTK wants. */
bool IsPositive(const TestMesh& mesh, const std::int64_t* tet)
{
  std::array<std::array<double, 3>, 3> e{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      e[i][c] = mesh.Coordinates[3 * static_cast<std::size_t>(tet[i + 1]) + c] -
        mesh.Coordinates[3 * static_cast<std::size_t>(tet[0]) + c];
    }
  }
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
    e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
    e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]) >
    0;
}

/** n * n * n cubes of five tetrahedra each, mirrored from one to the next. */
TestMesh MakeFives(std::int64_t n)
{
  auto mesh = MakeCubes(n, 0);
  mesh.Ids.clear();
  constexpr int parts[5][4] = { { 0, 3, 5, 6 }, { 0, 1, 3, 5 }, { 0, 3, 2, 6 }, { 0, 5, 6, 4 },
    { 3, 5, 7, 6 } };
  for (std::int64_t cube = 0; cube < n * n * n; ++cube)
  {
    const std::array at{ cube % n, cube / n % n, cube / n / n };
    const int mirror = (at[0] + at[1] + at[2]) % 2 ? 1 : 0;
    for (const auto& part : parts)
    {
      std::array<std::int64_t, 4> tet{};
      for (std::size_t i = 0; i < 4; ++i)
      {
        const int bits = part[i] ^ mirror;
        const auto y = at[1] + (bits >> 1 & 1);
        const auto z = at[2] + (bits >> 2 & 1);
        tet[i] = (z * (n + 1) + y) * (n + 1) + at[0] + (bits & 1);
      }
      if (!IsPositive(mesh, tet.data()))
      {
        std::swap(tet[2], tet[3]);
      }
      mesh.Ids.insert(mesh.Ids.end(), tet.begin(), tet.end());
    }
  }
  return mesh;
}

/** So many tetrahedra around one edge. */
TestMesh MakeFan(std::int64_t count)
{
  TestMesh mesh;
  mesh.Coordinates = { 0, 0, -1, 0, 0, 1 };
  for (std::int64_t i = 0; i < count; ++i)
  {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    mesh.Coordinates.insert(mesh.Coordinates.end(), { std::cos(angle), std::sin(angle), 0 });
    mesh.Ids.insert(mesh.Ids.end(), { 0, 1, 2 + i, 2 + (i + 1) % count });
  }
  return mesh;
}

/** So many tetrahedra on one triangle. */
TestMesh MakeBook(std::int64_t count)
{
  TestMesh mesh;
  mesh.Coordinates = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
  for (std::int64_t i = 0; i < count; ++i)
  {
    mesh.Coordinates.insert(mesh.Coordinates.end(), { 0.3, 0.3, 1.0 + static_cast<double>(i) });
    mesh.Ids.insert(mesh.Ids.end(), { 0, 1, 2, 3 + i });
  }
  return mesh;
}

/** Tetrahedra that touch one another nowhere. */
TestMesh MakeDust(std::int64_t count)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 1);
  TestMesh mesh;
  for (std::int64_t i = 0; i < 4 * count; ++i)
  {
    mesh.Coordinates.insert(
      mesh.Coordinates.end(), { place(random), place(random), place(random) });
    mesh.Ids.push_back(i);
  }
  return mesh;
}

bool IsLeft(const double* point)
{
  return point[0] < 1.5;
}
}

//--------------------------------------------------------------------------------------------------
TEST(ChunkCodec, KeepsGridsOfFiveTetrahedra)
{
  const auto encoded = ExpectRoundTrip(MakeCase(MakeFives(12)));
  EXPECT_LT(GetBitsPerTet(encoded), 0.5);
}

TEST(ChunkCodec, KeepsGridsOfSixTetrahedra)
{
  const auto encoded = ExpectRoundTrip(MakeCase(MakeCubes(12, 0)));
  EXPECT_LT(GetBitsPerTet(encoded), 0.5);
}

TEST(ChunkCodec, KeepsUnstructuredMeshes)
{
  ExpectRoundTrip(MakeCase(MakeCubes(12, 0.3)));
  ExpectRoundTrip(MakeCase(MakeCubes(10, 0.3), { .Type = ScalarType::Float32 }));
}

TEST(ChunkCodec, KeepsSharedVertices)
{
  for (const double jitter : { 0.0, 0.3 })
  {
    CaseOptions options;
    options.IsShared = IsLeft;
    ExpectRoundTrip(MakeCase(MakeCubes(10, jitter), options));
    options.IsShared = [](const double*) { return true; };
    ExpectRoundTrip(MakeCase(MakeCubes(6, jitter), options));
  }
}

TEST(ChunkCodec, KeepsPalettes)
{
  ExpectRoundTrip(MakeCase(MakeCubes(10, 0), { .Palettes = true }));
  ExpectRoundTrip(MakeCase(
    MakeCubes(8, 0.3), { .Type = ScalarType::Float32, .Palettes = true, .IsShared = IsLeft }));
}

TEST(ChunkCodec, KeepsTheSmallestChunks)
{
  TestMesh mesh;
  mesh.Coordinates = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  mesh.Ids = { 0, 1, 2, 3 };
  ExpectRoundTrip(MakeCase(mesh));
  ExpectRoundTrip(MakeCase(mesh, { .IsShared = IsLeft }));
  mesh.Ids = { 2, 2, 2, 2, 3, 1, 1, 0, 1, 0, 2, 3 }; // corners named twice
  ExpectRoundTrip(MakeCase(mesh));
}

TEST(ChunkCodec, KeepsEveryOrderOfCorners)
{
  auto mesh = MakeCubes(6, 0.2);
  std::mt19937 random(3);
  for (std::size_t t = 0; t < mesh.GetTets(); ++t) // half of them inverted
  {
    std::shuffle(mesh.Ids.begin() + static_cast<std::ptrdiff_t>(4 * t),
      mesh.Ids.begin() + static_cast<std::ptrdiff_t>(4 * t + 4), random);
  }
  ExpectRoundTrip(MakeCase(mesh));
}

TEST(ChunkCodec, KeepsMeshesThatAreNotManifold)
{
  ExpectRoundTrip(MakeCase(MakeSoup(50, 2000)));
  ExpectRoundTrip(MakeCase(MakeSoup(3000, 2000)));
  ExpectRoundTrip(MakeCase(MakeBook(300)));
  auto twice = MakeCubes(5, 0.2);
  const auto once = twice.Ids;
  twice.Ids.insert(twice.Ids.end(), once.begin(), once.end());
  twice.Ids.insert(twice.Ids.end(), once.begin(), once.end());
  ExpectRoundTrip(MakeCase(twice));
}

TEST(ChunkCodec, KeepsFlatMeshes)
{
  auto flat = MakeCubes(8, 0.2);
  for (std::size_t i = 2; i < flat.Coordinates.size(); i += 3)
  {
    flat.Coordinates[i] = 5;
  }
  ExpectRoundTrip(MakeCase(flat, { .IsShared = IsLeft }));
  std::fill(flat.Coordinates.begin(), flat.Coordinates.end(), -0.0);
  ExpectRoundTrip(MakeCase(flat));
}

TEST(ChunkCodec, KeepsExtremeCoordinates)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto type : { ScalarType::Float32, ScalarType::Float64 })
  {
    auto mesh = MakeCubes(6, 0.2);
    std::size_t at = 0;
    for (const double odd : { nan, -nan, infinity, -infinity, -0.0, 1e-310, 3e38, -3e38 })
    {
      mesh.Coordinates[at += 41] = odd;
    }
    ExpectRoundTrip(MakeCase(mesh, { .Type = type, .IsShared = IsLeft }));
    std::fill(mesh.Coordinates.begin(), mesh.Coordinates.end(), nan);
    ExpectRoundTrip(MakeCase(mesh, { .Type = type }));
  }
  auto far = MakeCubes(6, 0.2);
  for (auto& x : far.Coordinates)
  {
    x = 1e15 + x;
  }
  ExpectRoundTrip(MakeCase(far));
  for (auto& x : far.Coordinates)
  {
    x = (x - 1e15) * 1e307; // the extent overflows
  }
  ExpectRoundTrip(MakeCase(far));
}

TEST(ChunkCodec, HandlesLargeDegenerateMeshes)
{
  // An algorithm of quadratic cost would take hours and exceed the time limit of the test.
  auto point = MakeCubes(20, 0.2); // all in one place
  std::fill(point.Coordinates.begin(), point.Coordinates.end(), 1.0);
  const auto all = [](const double*) { return true; };
  for (const auto& mesh :
    { MakeFan(50000), MakeBook(50000), MakeDust(20000), MakeSoup(100, 30000), point })
  {
    ExpectRoundTrip(MakeCase(mesh));
    ExpectRoundTrip(MakeCase(mesh, { .IsShared = all }));
  }
}

//--------------------------------------------------------------------------------------------------
namespace
{
/** Decodes what may be damaged: a mesh that fits its frame, or an Error, nothing else. */
void ExpectNoHarm(const ChunkFrame& frame, const Bytes& connectivity, const Bytes& geometry)
{
  try
  {
    const auto mesh = DecodeChunk(frame, connectivity, geometry);
    ASSERT_EQ(mesh.Walk.Tets.size(), frame.Tets);
    ASSERT_EQ(mesh.Keys.size(), frame.OwnPoints + frame.SharedKeys.size());
    for (const auto& tet : mesh.Walk.Tets)
    {
      for (const auto v : tet)
      {
        ASSERT_LT(v, mesh.Keys.size());
      }
    }
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Corrupt);
  }
}
}

TEST(ChunkCodec, SurvivesDamage)
{
  CaseOptions palettes{ .Palettes = true, .IsShared = IsLeft };
  for (const auto& chunk : { MakeCase(MakeCubes(5, 0)), MakeCase(MakeCubes(5, 0.3), palettes),
         MakeCase(MakeSoup(40, 200)) })
  {
    const auto encoded = EncodeChunk(chunk.Frame, chunk.Elements, chunk.OwnKeys);
    for (const bool inGeometry : { false, true })
    {
      const auto& whole = inGeometry ? encoded.Geometry : encoded.Connectivity;
      const auto expectNoHarm = [&](const Bytes& damaged)
      {
        ExpectNoHarm(chunk.Frame, inGeometry ? encoded.Connectivity : damaged,
          inGeometry ? damaged : encoded.Geometry);
      };
      for (std::size_t at = 0; at < whole.size(); ++at)
      {
        auto damaged = whole;
        damaged[at] ^= static_cast<std::uint8_t>(1u << at % 8);
        expectNoHarm(damaged);
        damaged.resize(at);
        expectNoHarm(damaged);
      }
    }
  }
}

TEST(ChunkCodec, SurvivesNoise)
{
  std::mt19937 random(5);
  auto chunk = MakeCase(MakeCubes(5, 0.3), { .IsShared = IsLeft });
  for (int i = 0; i < 300; ++i)
  {
    Bytes connectivity(400);
    Bytes geometry(4000);
    std::generate(connectivity.begin(), connectivity.end(), std::ref(random));
    std::generate(geometry.begin(), geometry.end(), std::ref(random));
    connectivity[0] &= 7;
    connectivity[1] = static_cast<std::uint8_t>(8 + random() % 100);
    geometry[0] = 1;
    geometry[15] = 120;
    ExpectNoHarm(chunk.Frame, connectivity, geometry);
  }
}

//--------------------------------------------------------------------------------------------------
TEST(Entropy, ReturnsWhatWasPutIn)
{
  std::mt19937_64 random(1);
  std::array<BitModel, 3> models;
  EntropyEncoder encoder;
  std::vector<std::uint64_t> wanted;
  const auto bitOf = [](std::uint64_t r) { return (r >> 8) % 1000 < 3 + 400 * (r % 3); };
  for (int i = 0; i < 50000; ++i)
  {
    const auto r = random();
    wanted.push_back(r);
    encoder.Bit(models[r % 3], bitOf(r));
    encoder.Raw(r, static_cast<unsigned>(i % 65));
  }
  const auto stream = encoder.Finish();
  models = {};
  EntropyDecoder decoder(stream);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const auto r = wanted[i];
    ASSERT_EQ(decoder.Bit(models[r % 3]), bitOf(r));
    const auto width = i % 65;
    const auto mask = width == 64 ? ~std::uint64_t{ 0 } : (std::uint64_t{ 1 } << width) - 1;
    ASSERT_EQ(decoder.Raw(0, static_cast<unsigned>(width)), r & mask);
  }
}

TEST(Entropy, SpendsLittleOnWhatIsSure)
{
  BitModel model;
  EntropyEncoder encoder;
  for (int i = 0; i < 100000; ++i)
  {
    encoder.Bit(model, i % 10000 == 9999);
  }
  EXPECT_LT(encoder.Finish().size(), 150u);
  EXPECT_GE(model.GetProbability(), 1u);
  EXPECT_LE(model.GetProbability(), 65535u);
}

TEST(Entropy, MixesSymbolsDecisionsAndRawBits)
{
  std::mt19937_64 random(2);
  SymbolModel symbols;
  BitModel decisions;
  EntropyEncoder encoder;
  std::vector<std::uint64_t> wanted;
  for (int i = 0; i < 50000; ++i)
  {
    // All symbols at first, then few, then others: the model must adapt each time.
    const auto r = random();
    const auto most = i < 10000 ? 16u : 3u;
    const auto symbol = static_cast<unsigned>(r % most + (i > 30000 ? 13 : 0)) % 16;
    wanted.push_back(symbol | (r >> 60) << 4 | (r >> 40 & 1) << 8);
    encoder.Symbol(symbols, symbol);
    encoder.Raw(r >> 60, 4);
    encoder.Bit(decisions, (r >> 40 & 1) != 0);
  }
  const auto stream = encoder.Finish();
  symbols = {};
  decisions = {};
  EntropyDecoder decoder(stream);
  for (const auto value : wanted)
  {
    ASSERT_EQ(decoder.Symbol(symbols), value & 15);
    ASSERT_EQ(decoder.Raw(0, 4), value >> 4 & 15);
    ASSERT_EQ(decoder.Bit(decisions), (value >> 8) != 0);
  }
}

TEST(Entropy, EverySymbolKeepsAPlace)
{
  SymbolModel model;
  for (unsigned round = 0; round < 64; ++round)
  {
    for (unsigned i = 0; i < 500; ++i)
    {
      model.Update(round * 7 % SymbolModel::Symbols);
    }
    std::uint32_t sum = 0;
    for (unsigned s = 0; s < SymbolModel::Symbols; ++s)
    {
      ASSERT_EQ(model.GetStart(s), sum);
      ASSERT_GE(model.GetWidth(s), 1u);
      ASSERT_EQ(model.Find(sum), s);
      sum += model.GetWidth(s);
      ASSERT_EQ(model.Find(sum - 1), s);
    }
    ASSERT_EQ(sum, 1u << SymbolModel::Bits);
  }
}

TEST(Entropy, SymbolsTakeNearlyWhatTheirFrequenciesSay)
{
  // 1 / 2, 1 / 4, 1 / 8 and 1 / 8: 1.75 bits each.
  std::mt19937_64 random(3);
  SymbolModel model;
  EntropyEncoder encoder;
  constexpr unsigned count = 100000;
  for (unsigned i = 0; i < count; ++i)
  {
    const auto r = random() % 8;
    encoder.Symbol(model, r < 4 ? 9u : r < 6 ? 3u : r < 7 ? 0u : 15u);
  }
  EXPECT_LT(8.0 * static_cast<double>(encoder.Finish().size()), 1.80 * count);
}

TEST(ResidualModel, KeepsExtremeResidualsOfAllWidths)
{
  for (unsigned bits = 1; bits <= 64; ++bits)
  {
    std::vector<std::int64_t> residuals;
    const auto add = [&](std::uint64_t value) { // as signed numbers of so many bits
      residuals.push_back(static_cast<std::int64_t>(value << (64 - bits)) >> (64 - bits));
    };
    for (unsigned shift = 0; shift < bits; ++shift)
    {
      const std::uint64_t power = std::uint64_t{ 1 } << shift;
      for (const auto value : { power, power - 1, power + 1, ~power, 0 - power })
      {
        add(value);
      }
    }
    for (const unsigned spread : { 0u, bits / 2, bits, 64u })
    {
      ResidualModel model;
      EntropyEncoder encoder;
      for (const auto residual : residuals)
      {
        EXPECT_EQ(model.Code(encoder, spread, residual), residual);
      }
      const auto stream = encoder.Finish();
      model = {};
      EntropyDecoder decoder(stream);
      for (const auto residual : residuals)
      {
        ASSERT_EQ(model.Code(decoder, spread, 0), residual) << bits << " bits";
      }
    }
  }
}

//--------------------------------------------------------------------------------------------------
namespace
{
template <typename T>
void ExpectMonotoneAndInvertible(ScalarType type)
{
  const Domain domain(type);
  ASSERT_EQ(domain.GetBits(), 8 * sizeof(T));
  std::vector<T> values{ std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max(),
    std::numeric_limits<T>::min(), T(0), T(1), T(3), T(100) };
  if constexpr (std::is_signed_v<T>)
  {
    values.insert(values.end(), { T(-1), T(-3), T(-100) });
  }
  if constexpr (std::is_floating_point_v<T>)
  {
    const T infinity = std::numeric_limits<T>::infinity();
    values.insert(values.end(), { infinity, -infinity, T(0.1), T(-0.1) });
    values.push_back(std::numeric_limits<T>::denorm_min());
  }
  std::sort(values.begin(), values.end());
  Key before = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const Key key = domain.Read(&values[i]);
    if (i > 0)
    {
      EXPECT_EQ(before < key, values[i - 1] < values[i]);
    }
    T back{};
    domain.Write(key, &back);
    EXPECT_EQ(std::memcmp(&back, &values[i], sizeof(T)), 0);
    EXPECT_EQ(domain.ToNumber(key), static_cast<double>(values[i]));
    if (sizeof(T) < 8 && std::isfinite(domain.ToNumber(key)))
    {
      EXPECT_EQ(domain.FromNumber(domain.ToNumber(key)), key);
    }
    EXPECT_EQ(domain.Add(before, domain.Subtract(key, before)), key);
    before = key;
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double number : { infinity, -infinity, infinity - infinity })
  {
    EXPECT_EQ(domain.FromNumber(number), domain.FromNumber(0));
  }
  for (const double number : { 1e308, -1e308, 1e-320, 9.3e18, -9.3e18, 1.9e19 })
  {
    T value{};
    domain.Write(domain.FromNumber(number), &value); // the nearest there is, no overflow
    const auto low = static_cast<double>(std::numeric_limits<T>::lowest());
    const auto high = static_cast<double>(std::numeric_limits<T>::max());
    if (std::abs(number) > 1)
    {
      EXPECT_EQ(static_cast<double>(value),
        static_cast<double>(static_cast<T>(number <= low ? std::numeric_limits<T>::lowest()
            : number >= high                             ? std::numeric_limits<T>::max()
                                                         : static_cast<T>(number))));
    }
  }
}
}

TEST(Domain, IsMonotoneAndInvertible)
{
  ExpectMonotoneAndInvertible<std::int8_t>(ScalarType::Int8);
  ExpectMonotoneAndInvertible<std::uint8_t>(ScalarType::UInt8);
  ExpectMonotoneAndInvertible<std::int16_t>(ScalarType::Int16);
  ExpectMonotoneAndInvertible<std::uint16_t>(ScalarType::UInt16);
  ExpectMonotoneAndInvertible<std::int32_t>(ScalarType::Int32);
  ExpectMonotoneAndInvertible<std::uint32_t>(ScalarType::UInt32);
  ExpectMonotoneAndInvertible<std::int64_t>(ScalarType::Int64);
  ExpectMonotoneAndInvertible<std::uint64_t>(ScalarType::UInt64);
  ExpectMonotoneAndInvertible<float>(ScalarType::Float32);
  ExpectMonotoneAndInvertible<double>(ScalarType::Float64);
}

TEST(Domain, KeepsPayloadsOfNaN)
{
  const Domain domain(ScalarType::Float64);
  for (const std::uint64_t bits :
    { 0x7ff8000000000001u, 0xfff0000000000001u, 0x7fffffffffffffffu, 0xffffffffffffffffu })
  {
    std::uint64_t back = 0;
    domain.Write(domain.Read(&bits), &back);
    EXPECT_EQ(back, bits);
  }
}

TEST(Domain, RanksInAPalette)
{
  const Domain domain(
    ScalarType::UInt16, std::make_shared<const Palette>(Palette{ 2, 3, 5, 7, 1000 }));
  for (const std::uint16_t value : { 2, 3, 5, 7, 1000 })
  {
    std::uint16_t back = 0;
    domain.Write(domain.Read(&value), &back);
    EXPECT_EQ(back, value);
  }
  EXPECT_TRUE(domain.IsValid(4));
  EXPECT_FALSE(domain.IsValid(5));
  EXPECT_EQ(domain.FromNumber(1e9), 4u);
  EXPECT_EQ(domain.FromNumber(-3), 0u);
}
