// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Where the time goes when a .gtn file is decoded: takes the core's steps one by one, all chunks of
// one before those of the next, on one thread, and prints JSON.

#include "benchHarness.h"

#include "gtnThreads.h"

#include "gatunArrayCodec.h"
#include "gatunChunkCodec.h"
#include "gatunContainer.h"
#include "gatunFileReader.h"
#include "gatunFileReaderInternals.h"
#include "gatunFloatEnvironment.h"
#include "gatunPieceDecoder.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <memory>
#include <numeric>
#include <optional>

namespace
{

using bench::SecondsOf;

/** The streams of a chunk, as they are in the file. */
struct Streams
{
  gatun::Bytes Connectivity;
  gatun::Bytes Geometry;
  std::vector<gatun::Bytes> Arrays;
};

using Components = std::vector<gatun::ComponentKeys>;

Components MakeKeys(std::size_t components, std::size_t count)
{
  Components keys(components);
  for (auto& component : keys)
  {
    component.Now.resize(count);
  }
  return keys;
}

/** Decodes a file at its first step, and keeps all that a stage has made for the next one. */
class Stages
{
public:
  explicit Stages(const std::string& path)
    : File(std::make_shared<gatun::FileReader>(path))
    , Content(gatun::InternalsOf(*File))
  {
  }

  void Read();
  void Checksum() const;
  void DecodeBlocks();
  void DecodeMeshes();
  void FitNeighbors();
  void DecodeArrays();
  void DecodeAll() const;

  const gatun::FileReader& GetFile() const { return *this->File; }

private:
  std::size_t CountArrays() const
  {
    return this->Content.GetSteps().empty() ? 0 : this->Content.Meta.Arrays.size();
  }
  gatun::ChunkFrame MakeFrame(std::size_t chunk) const;
  void DecodeArray(std::size_t chunk, std::size_t array);

  std::shared_ptr<const gatun::FileReader> File;
  const gatun::FileReader::Internals& Content;
  std::vector<Streams> Chunks;
  std::vector<Streams> Blocks;
  std::vector<std::vector<gatun::PointKeys>> BlockPoints;
  std::vector<std::vector<Components>> BlockArrays;
  std::vector<std::optional<gatun::ChunkMesh>> Meshes;
  std::vector<std::optional<gatun::QuadraticFit>> CellFits; // of each chunk
};

void Stages::Read()
{
  const auto& tables = this->Content.GetTables();
  for (std::size_t b = 0; b < tables.GetNumberOfBlocks(); ++b)
  {
    Streams streams;
    streams.Geometry = this->Content.File.Read(tables.GetBlock(b)->Geometry, "a block");
    for (std::size_t a = 0; a < this->CountArrays(); ++a)
    {
      const bool ofPoints = this->Content.Meta.Arrays[a].Where == gatun::Association::Point;
      streams.Arrays.push_back(ofPoints
          ? this->Content.File.Read(tables.GetBlockValues(b, a, 0), "an array")
          : gatun::Bytes{});
    }
    this->Blocks.push_back(std::move(streams));
  }
  for (std::size_t c = 0; c < tables.GetChunks().size(); ++c)
  {
    Streams streams;
    const auto chunk = tables.GetChunk(c);
    streams.Connectivity = this->Content.File.Read(chunk->Connectivity, "a chunk");
    streams.Geometry = this->Content.File.Read(chunk->Geometry, "a chunk");
    for (std::size_t a = 0; a < this->CountArrays(); ++a)
    {
      streams.Arrays.push_back(this->Content.File.Read(tables.GetChunkValues(c, a, 0), "an array"));
    }
    this->Chunks.push_back(std::move(streams));
  }
}

void Stages::Checksum() const
{
  std::uint64_t sum = 0;
  for (const auto* list : { &this->Blocks, &this->Chunks })
  {
    for (const Streams& streams : *list)
    {
      sum ^= gatun::Checksum(streams.Connectivity) ^ gatun::Checksum(streams.Geometry);
      for (const auto& array : streams.Arrays)
      {
        sum ^= gatun::Checksum(array);
      }
    }
  }
  if (sum == 1) // so that nothing is left out
  {
    std::fputs("\n", stderr);
  }
}

void Stages::DecodeBlocks()
{
  for (std::size_t b = 0; b < this->Blocks.size(); ++b)
  {
    const auto count = static_cast<std::size_t>(this->Content.GetTables().GetBlock(b)->Points);
    Components keys = MakeKeys(3, count);
    gatun::DecodeCellValues(this->Blocks[b].Geometry, {}, this->Content.Domains, keys);
    std::vector<gatun::PointKeys> points(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      points[i] = { keys[0].Now[i], keys[1].Now[i], keys[2].Now[i] };
    }
    this->BlockPoints.push_back(std::move(points));
    std::vector<Components> arrays(this->CountArrays());
    std::optional<gatun::QuadraticFit> fit;
    for (std::size_t a = 0; a < arrays.size(); ++a)
    {
      const auto& array = this->Content.Meta.Arrays[a];
      if (array.Where == gatun::Association::Point)
      {
        arrays[a] = MakeKeys(array.Components, count);
        const auto& stream = this->Blocks[b].Arrays[a];
        if (!fit && gatun::IsQuadratic(gatun::ArrayModes::Read(stream).Spatial))
        {
          fit.emplace(gatun::GetPlaces(this->BlockPoints.back(), this->Content.Domains));
        }
        gatun::DecodeCellValues(
          stream, { {}, fit ? &*fit : nullptr }, this->Content.MakeDomains(a, 0), arrays[a]);
      }
    }
    this->BlockArrays.push_back(std::move(arrays));
  }
}

gatun::ChunkFrame Stages::MakeFrame(std::size_t chunk) const
{
  const auto held = this->Content.GetTables().GetChunk(chunk);
  const auto& entry = *held;
  gatun::ChunkFrame frame;
  frame.Tets = static_cast<std::uint32_t>(entry.Info.Tets);
  frame.OwnPoints = static_cast<std::uint32_t>(entry.Info.OwnPoints);
  frame.Box = entry.Info.Box;
  frame.Domains = this->Content.Domains;
  frame.SharedUsers = this->Content.GetTables().GetSharedUsers(chunk);
  for (const auto& part : entry.Shared)
  {
    const auto begin =
      this->BlockPoints[part.Block].begin() + static_cast<std::ptrdiff_t>(part.FirstInBlock);
    frame.SharedKeys.insert(frame.SharedKeys.end(), begin, begin + part.Points);
  }
  return frame;
}

void Stages::DecodeMeshes()
{
  this->Meshes.resize(this->Chunks.size());
  for (std::size_t c = 0; c < this->Chunks.size(); ++c)
  {
    this->Meshes[c].emplace(gatun::DecodeChunk(
      this->MakeFrame(c), this->Chunks[c].Connectivity, this->Chunks[c].Geometry));
  }
}

void Stages::FitNeighbors()
{
  for (std::size_t c = 0; c < this->Chunks.size(); ++c)
  {
    const auto isUsed = [&](auto&& isMode, gatun::Association where)
    {
      bool isFound = false;
      for (std::size_t a = 0; a < this->CountArrays(); ++a)
      {
        isFound = isFound ||
          (this->Content.Meta.Arrays[a].Where == where &&
            isMode(gatun::ArrayModes::Read(this->Chunks[c].Arrays[a]).Spatial));
      }
      return isFound;
    };
    auto& mesh = *this->Meshes[c];
    if (isUsed(
          [](auto mode) { return mode == gatun::SpatialMode::Fit; }, gatun::Association::Point))
    {
      mesh.Fit.emplace(mesh.Walk, mesh.GetPlaces());
    }
    if (isUsed(gatun::IsQuadratic, gatun::Association::Point))
    {
      mesh.Quadratic.emplace(mesh.Walk, mesh.GetPlaces());
    }
    this->CellFits.emplace_back();
    if (isUsed(gatun::IsQuadratic, gatun::Association::Cell))
    {
      this->CellFits.back().emplace(mesh.FitCells());
    }
    mesh.MakeContext(gatun::ContextFits::None);
  }
}

void Stages::DecodeArray(std::size_t chunk, std::size_t array)
{
  gatun::ChunkMesh& mesh = *this->Meshes[chunk];
  const auto& description = this->Content.Meta.Arrays[array];
  const auto& stream = this->Chunks[chunk].Arrays[array];
  const auto domains = this->Content.MakeDomains(array, 0);
  if (description.Where == gatun::Association::Cell)
  {
    Components keys = MakeKeys(description.Components, mesh.Walk.Parents.size());
    const auto& fit = this->CellFits[chunk];
    gatun::DecodeCellValues(stream, { mesh.Walk.Parents, fit ? &*fit : nullptr }, domains, keys);
    return;
  }
  Components keys = MakeKeys(description.Components, mesh.Keys.size());
  std::vector<std::pair<std::uint32_t, std::size_t>> places;
  const auto entry = this->Content.GetTables().GetChunk(chunk);
  for (const auto& part : entry->Shared)
  {
    for (std::uint64_t i = 0; i < part.Points; ++i)
    {
      places.emplace_back(part.Block, static_cast<std::size_t>(part.FirstInBlock + i));
    }
  }
  for (gatun::Vertex v = 0; v < mesh.Walk.Sources.size(); ++v)
  {
    if (mesh.Walk.IsShared(v))
    {
      const auto& [block, place] = places[mesh.Walk.Sources[v] & ~gatun::Topology::SharedFlag];
      for (std::size_t c = 0; c < keys.size(); ++c)
      {
        keys[c].Now[v] = this->BlockArrays[block][array][c].Now[place];
      }
    }
  }
  gatun::DecodePointValues(stream, mesh.Context, domains, keys);
}

void Stages::DecodeArrays()
{
  for (std::size_t c = 0; c < this->Chunks.size(); ++c)
  {
    for (std::size_t a = 0; a < this->CountArrays(); ++a)
    {
      this->DecodeArray(c, a);
    }
  }
}

void Stages::DecodeAll() const
{
  gatun::PieceDecoder decoder(this->File);
  gatun::PieceRequest request;
  request.Chunks.resize(this->Content.GetTables().GetChunks().size());
  std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
  request.WithUnusedPoints = true;
  request.RestoreOrder = false;
  request.Arrays.resize(this->CountArrays());
  std::iota(request.Arrays.begin(), request.Arrays.end(), 0u);
  decoder.SetRequest(request);
  const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
  const auto tets = static_cast<std::size_t>(decoder.GetNumberOfCells());
  // Uninitialised, as the arrays of VTK are.
  std::vector<std::unique_ptr<std::uint8_t[]>> memory;
  const auto make = [&](std::size_t bytes) -> void*
  { return memory.emplace_back(new std::uint8_t[bytes]).get(); };
  gatun::PieceTarget target;
  target.Points = make(3 * points * gatun::SizeOf(this->File->GetCoordinateType()));
  target.Connectivity = make(4 * tets * sizeof(std::int64_t));
  for (std::size_t a = 0; a < this->CountArrays(); ++a)
  {
    const auto& array = this->Content.Meta.Arrays[a];
    target.Arrays.push_back(make(gatun::SizeOf(array.Type) * array.Components *
      (array.Where == gatun::Association::Point ? points : tets)));
  }
  decoder.Fill(target);
}

struct Stage
{
  const char* Name;
  double Seconds;
};

std::vector<Stage> RunOnce(const std::string& path)
{
  const gatun::FloatEnvironment guard;
  std::vector<Stage> stages;
  std::unique_ptr<Stages> work;
  const auto time = [&](const char* name, const std::function<void()>& run) {
    stages.push_back({ name, SecondsOf(run) });
  };
  time("directory", [&] { work = std::make_unique<Stages>(path); });
  time("all at once", [&] { work->DecodeAll(); });
  time("read and check", [&] { work->Read(); });
  time("check alone", [&] { work->Checksum(); });
  time("shared points", [&] { work->DecodeBlocks(); });
  time("connectivity and geometry", [&] { work->DecodeMeshes(); });
  time("neighbor fit", [&] { work->FitNeighbors(); });
  time("arrays", [&] { work->DecodeArrays(); });
  return stages;
}

void Measure(const std::string& path, int rounds)
{
  std::vector<bench::Operation> stages;
  for (int round = 0; round <= rounds; ++round)
  {
    const std::vector<Stage> once = RunOnce(path);
    for (std::size_t i = 0; i < once.size(); ++i)
    {
      if (round == 0)
      {
        stages.push_back({ once[i].Name, {}, 0, once[i].Seconds });
      }
      else
      {
        stages[i].Seconds.push_back(once[i].Seconds);
      }
    }
  }
  Json::Value json;
  json["threads"] = 1;
  json["tets"] = gatun::FileReader(path).GetNumberOfTets();
  json["stages"] = Json::arrayValue;
  for (const bench::Operation& stage : stages)
  {
    Json::Value stageJson;
    stageJson["stage"] = stage.Name;
    bench::AddTimes(stageJson, stage);
    json["stages"].append(stageJson);
  }
  std::fputs(gtn::JsonText(json).c_str(), stdout);
}

} // anonymous namespace

int main(int argc, char* argv[])
{
  CLI::App app("Tells where the time goes when a .gtn file is decoded.", "gatunBenchmarkStages");
  std::string file;
  int rounds = 5;
  app.add_option("FILE", file, "A .gtn file")->required();
  app.add_option("--rounds", rounds, "Rounds, after one to warm up")->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  try
  {
    gtn::SetThreads(1);
    Measure(file, rounds);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "gatunBenchmarkStages: %s\n", error.what());
    return 1;
  }
  return 0;
}
