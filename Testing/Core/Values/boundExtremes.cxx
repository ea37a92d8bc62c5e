// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Encodes and decodes values that are hard to round, with bounds of all kinds, and checks each one
// in whole numbers: boundExtremes COUNT [SEED]. The exit code is 1 if any value is wrong.

#include "gatunArrayCodec.h"
#include "gatunArrayContext.h"
#include "gatunDomainSurvey.h"
#include "gatunError.h"
#include "gatunExactBound.h"
#include "gatunExtremeValues.h"
#include "gatunFloatEnvironment.h"
#include "gatunQuadraticFit.h"
#include "gatunTestMeshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <map>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** Where values are: on the points of a chunk, its cells, or a block; each without and with the
 * quadratic modes, and in the mode fast. */
class Contexts
{
public:
  static constexpr unsigned Count = 9;

  Contexts()
  {
    const auto mesh = MakeCubes(11, 0.2);
    const Domain domain(ScalarType::Float64);
    ChunkFrame frame;
    frame.Tets = static_cast<std::uint32_t>(mesh.GetTets());
    frame.OwnPoints = static_cast<std::uint32_t>(mesh.GetPoints());
    frame.Box = { Range{ -1, 13 }, Range{ -1, 13 }, Range{ -1, 13 } };
    frame.Domains = { domain, domain, domain };
    std::vector<std::array<std::uint32_t, 4>> tets(mesh.GetTets());
    for (std::size_t i = 0; i < 4 * tets.size(); ++i)
    {
      tets[i / 4][i % 4] = static_cast<std::uint32_t>(mesh.Ids[i]);
    }
    std::vector<PointKeys> keys(mesh.GetPoints());
    for (std::size_t i = 0; i < 3 * keys.size(); ++i)
    {
      keys[i / 3][i % 3] = domain.FromNumber(mesh.Coordinates[i]);
    }
    this->Chunk = EncodeChunk(frame, tets, keys).Mesh;
    this->FastChunk = EncodeChunk(frame, tets, keys, Profile::Fast).Mesh;
    this->Points.emplace(this->Chunk, ContextFits::All);
    this->CellFit.emplace(FitCells(this->Chunk));
    this->BlockFit.emplace(this->Chunk.GetPlaces());
    this->Plain = this->Points->GetPoints();
    this->Plain.Quadratic = nullptr;
    this->Fast.Mesh = &this->FastChunk.Walk;
  }

  bool IsBlock(unsigned which) const { return which >= 6; }
  std::size_t GetSize(unsigned which) const
  {
    return which / 3 == 1 ? this->Chunk.Walk.Parents.size() : this->Chunk.Keys.size();
  }

  Bytes Encode(unsigned which, const Domain& domain, ComponentKeys& keys) const
  {
    return which < 3 ? EncodePointValues(this->GetPoints(which), { &domain, 1 }, { &keys, 1 })
                     : EncodeCellValues(this->GetCells(which), { &domain, 1 }, { &keys, 1 });
  }

  void Decode(unsigned which, const Bytes& stream, const Domain& domain, ComponentKeys& keys) const
  {
    if (which < 3)
    {
      DecodePointValues(stream, this->GetPoints(which), { &domain, 1 }, { &keys, 1 });
    }
    else
    {
      DecodeCellValues(stream, this->GetCells(which), { &domain, 1 }, { &keys, 1 });
    }
  }

private:
  const PointContext& GetPoints(unsigned which) const
  {
    return which % 3 == 0 ? this->Plain : which % 3 == 1 ? this->Points->GetPoints() : this->Fast;
  }
  CellContext GetCells(unsigned which) const
  {
    CellContext context;
    if (!this->IsBlock(which))
    {
      const auto& chunk = which % 3 == 2 ? this->FastChunk : this->Chunk;
      context.Parents = chunk.Walk.Parents;
    }
    const auto& fit = this->IsBlock(which) ? this->BlockFit : this->CellFit;
    context.Quadratic = which % 3 == 1 ? &*fit : nullptr;
    context.Coding = which % 3 == 2 ? Profile::Fast : Profile::Small;
    return context;
  }

  ChunkMesh Chunk;
  ChunkMesh FastChunk;
  std::optional<ArrayContext> Points;
  PointContext Plain;
  PointContext Fast;
  std::optional<QuadraticFit> CellFit;
  std::optional<QuadraticFit> BlockFit;
};

struct Counts
{
  std::uint64_t Values = 0;
  std::uint64_t Rounded = 0;
  std::uint64_t Wrong = 0;
};

class Extremes
{
public:
  explicit Extremes(std::uint64_t seed)
    : Random(seed)
  {
  }

  /** Checks a stream of values of any type. */
  void Run()
  {
    switch (this->Random() % 20)
    {
      case 0:
        return this->Check<std::int8_t>(ScalarType::Int8);
      case 1:
        return this->Check<std::uint8_t>(ScalarType::UInt8);
      case 2:
        return this->Check<std::int16_t>(ScalarType::Int16);
      case 3:
        return this->Check<std::uint16_t>(ScalarType::UInt16);
      case 4:
        return this->Check<std::int32_t>(ScalarType::Int32);
      case 5:
        return this->Check<std::uint32_t>(ScalarType::UInt32);
      case 6:
        return this->Check<std::int64_t>(ScalarType::Int64);
      case 7:
        return this->Check<std::uint64_t>(ScalarType::UInt64);
      default:
        return this->Random() % 2 ? this->Check<float>(ScalarType::Float32)
                                  : this->Check<double>(ScalarType::Float64);
    }
  }

  std::uint64_t GetValues() const { return this->Values; }

  /** Prints how far a long run is. */
  void ReportProgress() const
  {
    std::uint64_t wrong = 0;
    for (const auto& [name, counts] : this->Found)
    {
      wrong += counts.Wrong;
    }
    std::fprintf(stderr, "%llu values, %llu wrong\n", static_cast<unsigned long long>(this->Values),
      static_cast<unsigned long long>(wrong));
  }

  /** Prints what was checked. Returns whether all is right. */
  bool Report() const
  {
    std::uint64_t wrong = 0;
    for (const auto& [name, counts] : this->Found)
    {
      std::printf("%-28s %12llu values %12llu rounded %6llu wrong\n", name.c_str(),
        static_cast<unsigned long long>(counts.Values),
        static_cast<unsigned long long>(counts.Rounded),
        static_cast<unsigned long long>(counts.Wrong));
      wrong += counts.Wrong;
    }
    std::printf("%llu values, %llu wrong\n", static_cast<unsigned long long>(this->Values),
      static_cast<unsigned long long>(wrong));
    return wrong == 0;
  }

private:
  template <typename T>
  void Check(ScalarType type)
  {
    const auto which = static_cast<unsigned>(this->Random() % Contexts::Count);
    const auto pattern = this->Random() % ExtremePatterns.size();
    const auto kinds = IsFloating(type) ? 4u : 2u;
    const auto kind = static_cast<ErrorKind>(1 + this->Random() % kinds);
    std::vector<T> values(this->All.GetSize(which));
    ExtremeValues<T>(this->Random).Fill(pattern, values);
    const auto bound = MakeExtremeBound<T>(kind, GetSize(values), this->Random);
    const RoundingRequest request{ bound, this->All.IsBlock(which) || this->Random() % 4 == 0 };
    const auto domain =
      FindDomain(type, values.data(), values.size(), 1, 0, PaletteUse::Array, nullptr, request);
    ComponentKeys keys;
    for (const auto& value : values)
    {
      const Key key = domain.Read(&value);
      keys.Now.push_back(request.OnLattice && domain.GetQuantizer()
          ? domain.GetQuantizer().ToLattice(type, key)
          : key);
    }
    if (domain.IsPlain() && this->Random() % 4 == 0)
    {
      std::vector<T> before(values.size());
      ExtremeValues<T>(this->Random).Fill(pattern, before);
      for (const auto& value : before)
      {
        keys.Before.push_back(domain.Read(&value));
      }
    }
    const auto found = this->RoundTrip(which, domain, keys);
    auto name = std::string(ToString(bound));
    name = name.substr(0, name.find(':')) + ", " + ExtremePatterns.at(pattern);
    this->Compare(this->Found[name], domain, bound, values, found);
  }

  std::vector<Key> RoundTrip(unsigned which, const Domain& domain, ComponentKeys& keys) const
  {
    ComponentKeys found{ std::vector<Key>(keys.Now.size()), keys.Before };
    const auto stream = this->All.Encode(which, domain, keys);
    this->All.Decode(which, stream, domain, found);
    if (found.Now != keys.Now)
    {
      throw std::runtime_error("the decoder has other values than the encoder");
    }
    return std::move(found.Now);
  }

  template <typename T>
  void Compare(Counts& counts, const Domain& domain, const ErrorBound& bound,
    const std::vector<T>& values, const std::vector<Key>& found)
  {
    const ExactBound<T> exact(bound, values.data(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      T back{};
      domain.Write(found[i], &back);
      const bool isSame = std::memcmp(&back, &values[i], sizeof back) == 0;
      counts.Rounded += isSame ? 0 : 1;
      counts.Wrong += isSame || exact.IsWithin(values[i], back) ? 0 : 1;
    }
    counts.Values += values.size();
    this->Values += values.size();
  }

  /** The largest magnitude. */
  template <typename T>
  static double GetSize(const std::vector<T>& values)
  {
    double size = 0;
    for (const auto value : values)
    {
      const double magnitude = std::abs(static_cast<double>(value));
      size = std::isfinite(magnitude) ? std::max(size, magnitude) : size;
    }
    return size;
  }

  std::mt19937_64 Random;
  const FloatEnvironment Guard;
  const Contexts All;
  std::map<std::string, Counts> Found;
  std::uint64_t Values = 0;
};
}

int main(int count, char* arguments[])
{
  if (count < 2 || count > 3)
  {
    std::fprintf(stderr, "boundExtremes COUNT [SEED]\n");
    return 2;
  }
  try
  {
    Extremes extremes(count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1);
    const auto wanted = std::strtoull(arguments[1], nullptr, 10);
    constexpr std::uint64_t part = 50'000'000;
    for (std::uint64_t next = part; extremes.GetValues() < wanted;)
    {
      extremes.Run();
      if (extremes.GetValues() >= next)
      {
        extremes.ReportProgress();
        next += part;
      }
    }
    return extremes.Report() ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "boundExtremes: %s\n", error.what());
    return 1;
  }
}
