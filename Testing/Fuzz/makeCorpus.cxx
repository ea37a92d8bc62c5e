// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes seeds for the fuzz targets: makeCorpus FOLDER. Each target gets a folder of its own below.

#include "makeCorpus.h"

#include "fuzzMeshes.h"
#include "gatunArrayCodec.h"
#include "gatunCellCodec.h"
#include "gatunCellMask.h"
#include "gatunEntropy.h"
#include "gatunExtents.h"
#include "gatunHartleyCodec.h"
#include "gatunHartleyFileImage.h"
#include "gatunHartleySample.h"
#include "gatunMergeCodec.h"
#include "gatunPalette.h"
#include "gatunSampleFile.h"
#include "gatunSeriesTable.h"
#include "gatunTreeSample.h"

#include <algorithm>
#include <iostream>
#include <random>

namespace
{
using namespace gatun;
namespace fs = std::filesystem;

Bytes MakeNoise(std::size_t size, std::mt19937& random)
{
  Bytes noise(size);
  for (auto& byte : noise)
  {
    byte = static_cast<std::uint8_t>(random());
  }
  return noise;
}

/** What of the noise has been taken, and the stream behind it. */
Bytes Join(const Bytes& noise, const fuzz::Input& in, std::span<const std::uint8_t> stream)
{
  Bytes all(noise.begin(), noise.end() - static_cast<std::ptrdiff_t>(in.GetRemaining()));
  all.insert(all.end(), stream.begin(), stream.end());
  return all;
}

/** Streams of coefficients that fall off with their frequency, for fuzzHartleyBlocks.cxx. */
void AddBlocks(Corpus& corpus, std::mt19937& random)
{
  for (std::uint8_t kind = 0; kind < 3; ++kind)
  {
    const auto take = [&](unsigned most)
    { return static_cast<std::uint32_t>(1 + random() % most); };
    const HartleyLayout::Triple block{ take(8), take(8), take(8) };
    const HartleyLayout::Triple grid{ take(3), take(3), take(3) };
    Bytes bytes;
    for (const auto& lengths : { block, grid })
    {
      for (const auto length : lengths)
      {
        bytes.push_back(static_cast<std::uint8_t>(length - 1));
      }
    }
    bytes.push_back(kind);
    const HartleyOrder order(block);
    const auto length = order.GetPositions().size();
    const auto blocks = kind == 1 ? 1 : std::size_t{ grid[0] } * grid[1] * grid[2];
    std::vector<std::int64_t> integers(length * blocks);
    for (std::size_t at = 0; at < integers.size(); at += length)
    {
      for (std::size_t rank = 0; rank < length; ++rank)
      {
        const auto most = static_cast<std::int64_t>(400 / (1 + rank));
        integers[at + order.GetPositions()[rank].Index] =
          static_cast<std::int64_t>(random() % static_cast<unsigned>(2 * most + 2)) - most;
      }
    }
    const auto stream = kind == 1 ? EncodeHartleySegment(order, 0, integers)
                                  : EncodeHartleyBlocks(order, grid, integers);
    bytes.insert(bytes.end(), stream.begin(), stream.end());
    corpus.Add("HartleyBlocks", bytes);
  }
}

/** Volumes, as files and as their parts, for fuzzHartleyFile.cxx. */
void AddVolumes(Corpus& corpus)
{
  const auto path = (corpus.GetFolder() / "volume.ghv").string();
  struct Setting
  {
    HartleyLayout::Triple Size;
    ScalarType Type;
    std::uint32_t BlockSize;
    double Error;
  };
  for (const auto& setting : { Setting{ { 5, 4, 3 }, ScalarType::UInt8, 2, 0 },
         { { 9, 7, 1 }, ScalarType::Int16, 4, 30 }, { { 6, 5, 4 }, ScalarType::Float32, 0, 0.1 },
         { { 66, 2, 3 }, ScalarType::UInt8, 8, 5 }, { { 66, 65, 64 }, ScalarType::UInt8, 0, 60 } })
  {
    const auto volume = test::MakePhantom(setting.Size, setting.Type);
    HartleyWriterOptions options;
    options.BlockSize = setting.BlockSize;
    options.RateControl = { HartleyRateMode::RMSError, setting.Error, 0 };
    WriteHartleyFile(path, volume.Input, options);
    const test::HartleyFileImage image(path);
    ByteWriter parts;
    const auto putPart = [&](const Bytes& part)
    {
      parts.Put(static_cast<std::uint16_t>(part.size()));
      parts.PutBytes(part);
    };
    putPart(image.Meta.Write());
    putPart(image.Table.Write(image.Meta));
    for (const auto& stream : image.Streams)
    {
      parts.PutBytes(stream);
    }
    corpus.Add("HartleyFile", parts.Data);
    corpus.Add("HartleyFile", image.Build());
  }
  fs::remove(path);
}

void AddChunks(Corpus& corpus, std::mt19937& random)
{
  const auto noise = MakeNoise(4096, random);
  fuzz::Input in(noise.data(), noise.size());
  std::uint32_t points = 0;
  const auto tets = fuzz::TakeTets(in, 60, points);
  auto frameNoise = MakeNoise(4096, random);
  const auto parse = [&](fuzz::Input& from) { return fuzz::TakeFrame(from, 400); };
  fuzz::Input first(frameNoise.data(), frameNoise.size());
  const auto shared = std::min<std::size_t>(parse(first).SharedKeys.size(), 65535);
  if (tets.empty() || shared > points)
  {
    return;
  }
  const auto setCount = [&](std::size_t at, std::size_t count)
  {
    frameNoise[at] = static_cast<std::uint8_t>(count);
    frameNoise[at + 1] = static_cast<std::uint8_t>(count >> 8);
  };
  setCount(0, tets.size());
  setCount(2, points - shared);
  fuzz::Input again(frameNoise.data(), frameNoise.size());
  const auto frame = parse(again);
  std::vector<PointKeys> own(frame.OwnPoints);
  for (auto& keys : own)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      keys[axis] = fuzz::TakeKey(in, frame.Domains[axis]);
    }
  }
  const auto add = [&](const EncodedChunk& chunk, const Bytes& geometry)
  {
    ByteWriter streams;
    streams.Put(static_cast<std::uint16_t>(chunk.Connectivity.size()));
    streams.PutBytes(chunk.Connectivity);
    streams.PutBytes(geometry);
    corpus.Add("Chunk", Join(frameNoise, again, streams.Data));
  };
  const auto fast = EncodeChunk(frame, tets, own, Profile::Fast);
  add(fast, fast.Geometry);
  const auto encoded = EncodeChunk(frame, tets, own);
  add(encoded, encoded.Geometry);
  // Such chunks get no frames from the encoder.
  auto geometry = encoded.Geometry;
  const auto rules = geometry[0] & 0x7F;
  if (geometry[0] == rules)
  {
    geometry[0] |= 0x80;
    ByteWriter weights;
    for (const int weight : { 170, 170, 135, 68, 54 })
    {
      weights.Put(static_cast<std::int16_t>(weight));
    }
    geometry.insert(geometry.begin() + 1 + 14 * rules, weights.Data.begin(), weights.Data.end());
    add(encoded, geometry);
  }
}

void AddArrays(Corpus& corpus, std::mt19937& random, Profile profile)
{
  const fuzz::SmallChunk chunk(profile);
  const auto noise = MakeNoise(8192, random);
  const auto fill = [&](fuzz::ArrayFrame& array, bool onLattice)
  {
    for (std::size_t c = 0; c < array.Keys.size(); ++c)
    {
      const auto values = MakeNoise(64, random);
      fuzz::Input in(values.data(), values.size());
      for (auto& key : array.Keys[c].Now)
      {
        key = key == 0 ? fuzz::TakeKey(in, array.Domains[c]) : key;
        const auto& rounding = array.Domains[c].GetQuantizer();
        key = onLattice && rounding ? rounding.ToLattice(array.Domains[c].GetType(), key) : key;
      }
    }
  };
  const auto isOnLattice = [](const Domain& domain) { return domain.GetQuantizer().OnLattice; };
  fuzz::Input pointNoise(noise.data(), noise.size());
  auto points = fuzz::TakePointArray(pointNoise, chunk);
  fill(points, std::any_of(points.Domains.begin(), points.Domains.end(), isOnLattice));
  corpus.Add("PointValues",
    Join(noise, pointNoise, EncodePointValues(chunk.GetContext(), points.Domains, points.Keys)));
  fuzz::Input cellNoise(noise.data(), noise.size());
  auto cells = fuzz::TakeCellArray(cellNoise);
  fill(cells,
    cells.Parents.empty() || std::any_of(cells.Domains.begin(), cells.Domains.end(), isOnLattice));
  corpus.Add("CellValues",
    Join(noise, cellNoise,
      EncodeCellValues(
        { cells.Parents, &fuzz::GetTupleFit(), profile }, cells.Domains, cells.Keys)));
}

void AddPalette(Corpus& corpus, std::mt19937& random)
{
  Palette palette(2 + random() % 20);
  Key key = 0;
  for (auto& entry : palette)
  {
    entry = key += 1 + random() % 100;
  }
  ByteWriter out;
  out.Put(std::uint8_t{ 8 });
  out.Put(std::uint8_t{ 1 });
  out.Put(static_cast<std::uint16_t>(palette.size()));
  out.PutBytes(EncodePalette(ScalarType::Float32, palette));
  corpus.Add("Palette", out.Data);
}

void AddEntropy(Corpus& corpus, std::mt19937& random)
{
  EntropyEncoder encoder;
  BitModel decisions;
  SymbolModel symbols;
  ByteWriter out;
  const std::uint16_t count = 99;
  out.Put(count);
  out.Put(std::uint8_t{ 3 });
  out.Put(std::uint8_t{ 0 });
  out.Put(std::uint8_t{ 2 });
  out.Put(std::uint8_t{ 3 | 7 << 2 });
  for (unsigned i = 0; i < count; i += 3)
  {
    encoder.Bit(decisions, random() % 5 == 0);
    encoder.Symbol(symbols, random() % 7);
    encoder.Raw(random() % 128, 7);
  }
  out.PutBytes(encoder.Finish());
  corpus.Add("Entropy", out.Data);
}

FieldData MakeField()
{
  FieldData field(2);
  field[0].Name = "numbers";
  field[0].Values.assign(24, 7);
  field[1].Name = "texts";
  field[1].IsText = true;
  field[1].Texts = { "one", "", "three" };
  field[1].ComponentNames = { "c" };
  return field;
}

/** A file of some tetrahedra, of one chunk or more. */
void WriteFile(const std::string& path, const test::TestMesh& mesh, std::uint8_t keep, int steps)
{
  WriterOptions options;
  options.ChunkSize = 64;
  options.Keep = keep;
  options.KeyStepInterval = 2;
  // Few different values make a palette.
  const auto valueOf = [keep](std::size_t i, int)
  { return keep & KeepCells ? static_cast<float>(i % 3) : 0.1f * static_cast<float>(i); };
  test::WriteSample(path, mesh, options, steps, valueOf, MakeField());
}

void AddFiles(Corpus& corpus)
{
  const auto path = (corpus.GetFolder() / "whole.gtn").string();
  auto unused = test::MakeCubes(2, 0.2);
  unused.Coordinates.insert(unused.Coordinates.end(), { 1, 2, 3, 4, 5, 6 });
  auto flat = test::MakeCubes(3, 0);
  const std::array meshes{ test::MakeCubes(1, 0.1), unused, flat, test::MakeSoup(20, 150),
    test::TestMesh{} };
  for (const auto& mesh : meshes)
  {
    for (const std::uint8_t keep : { KeepNone, KeepAll })
    {
      for (const int steps : { 0, 1, 3 })
      {
        WriteFile(path, mesh, keep, steps);
        const test::FileImage image(path);
        const auto bytes = image.Build();
        corpus.Add("File", bytes);
        corpus.Add("Sections", bytes);
        corpus.Add("Tables", GetTables(image));
        corpus.Add("Decompress", image.Meta.Write());
      }
    }
  }
  fs::remove(path);
}

/** Files whose points move, stand still, and move again. */
void AddMovingFiles(Corpus& corpus)
{
  const auto path = (corpus.GetFolder() / "moving.gtn").string();
  auto unused = test::MakeCubes(2, 0.2);
  unused.Coordinates.insert(unused.Coordinates.end(), { 1, 2, 3, 4, 5, 6 });
  for (const auto& mesh : { test::MakeCubes(1, 0.1), unused, test::MakeCubes(3, 0) })
  {
    WriterOptions options;
    options.ChunkSize = 64;
    options.KeyStepInterval = 2;
    options.PointsMove = true;
    {
      FileWriter writer(path, mesh.GetInput(), {}, options);
      for (int step = 0; step < 4; ++step)
      {
        auto moved = mesh.Coordinates;
        for (std::size_t i = 0; step > 0 && i < moved.size(); ++i)
        {
          moved[i] *= 1 + 0.25 * (step == 2 ? 1 : step);
        }
        writer.WriteStep({}, {}, true, step, {}, moved.data());
      }
      writer.Finish();
    }
    const test::FileImage image(path);
    const auto bytes = image.Build();
    corpus.Add("File", bytes);
    corpus.Add("Sections", bytes);
    corpus.Add("Tables", GetTables(image));
    corpus.Add("Decompress", image.Meta.Write());
  }
  fs::remove(path);
}

/** Tables of series, for fuzzSeries.cxx. */
void AddSeries(Corpus& corpus)
{
  CellMask mask;
  mask.IsAlive.assign(40, true);
  mask.Points = 20;
  mask.Cells = 40;
  CellMask second = mask;
  std::fill_n(second.IsAlive.begin() + 7, 12, false);
  second.Cells = 28;
  second.DropsPoints = true;
  for (const bool hasTypes : { false, true })
  {
    mask.Types.assign({ { 10, 30 }, { 12, 10 } });
    second.Types.assign({ { 10, 20 }, { 12, 8 } });
    const std::vector<StoredStep> steps{ { 0, 0, 0 }, { 0, 1, 1 }, { 1, 0, 2 }, { 0, 0, 3 } };
    const std::vector<Extent> extents{ { 100, 0 }, { 800, 16 }, { 400, 0 }, { 50, 30 } };
    ByteWriter list;
    list.PutVarint(extents.size());
    for (const auto& extent : extents)
    {
      list.PutVarint(extent.Length);
      list.PutVarint(extent.Source);
    }
    ByteWriter out;
    out.Put(static_cast<std::uint8_t>(2 + 4));
    for (const auto& table : { Decompress(WriteSeries(steps), 1 << 20), list.Data,
           Decompress(mask.Write(nullptr, hasTypes), 1 << 20),
           Decompress(second.Write(&mask, hasTypes), 1 << 20) })
    {
      out.Put(static_cast<std::uint16_t>(table.size()));
      out.PutBytes(table);
    }
    corpus.Add("Series", out.Data);
  }
}

/** Trees of any merges, as streams. */
void AddMerges(Corpus& corpus, std::mt19937& random)
{
  const std::uint16_t points = 3 + random() % 60;
  std::vector<std::uint32_t> left(points);
  std::iota(left.begin(), left.end(), 0u);
  std::shuffle(left.begin(), left.end(), random);
  std::vector<Merge> merges;
  while (left.size() > 1 + random() % 4)
  {
    const auto point = left.back();
    left.pop_back();
    merges.push_back(
      { point, left[random() % left.size()], 1e-3f * static_cast<float>(left.size()) });
  }
  const auto count = static_cast<std::uint16_t>(merges.size());
  ByteWriter out;
  out.Put(std::uint8_t{ 0 }); // of many points
  out.Put(points);
  const bool isNarrow = points + 1 < 256;
  isNarrow ? out.Put(static_cast<std::uint8_t>(count)) : out.Put(count);
  out.PutBytes(
    EncodeMerges(MergeTree(points, std::move(merges)), points, count, MergeKind::Tetrahedra));
  corpus.Add("Merges", out.Data);
}

/** Files with trees and base meshes, and their tables. */
void AddTreeFiles(Corpus& corpus)
{
  const auto path = (corpus.GetFolder() / "tree.gtn").string();
  for (const std::int64_t n : { 1, 2, 3 })
  {
    for (const std::size_t steps : { 1, 2 })
    {
      const auto sample = test::MakeTreeSample(n, steps);
      const auto merges = static_cast<std::uint32_t>(sample.Tree.GetMerges().size());
      WriterOptions options;
      options.ChunkSize = 64;
      options.Keep = steps == 1 ? KeepAll : KeepNone;
      std::vector<std::uint32_t> levels;
      if (merges > 3 && n < 3)
      {
        levels = { merges / 2, merges };
      }
      test::WriteTreeSample(path, sample, options, levels);
      const auto bytes = test::ReadFile(path);
      corpus.Add("File", bytes);
      corpus.Add("Sections", bytes);
      const auto sections = test::ReadSections(path);
      ByteWriter tables;
      for (const auto name :
        { SectionMeta, SectionTable, SectionStep, SectionTree, SectionTreeStep })
      {
        const auto table = Decompress(test::FindPayload(sections, name), 1 << 20);
        tables.Put(static_cast<std::uint16_t>(table.size()));
        tables.PutBytes(table);
      }
      corpus.Add("Tables", tables.Data);
    }
  }
  fs::remove(path);
}

/** Files with layers and their tables. */
void AddLayerFiles(Corpus& corpus)
{
  const auto path = (corpus.GetFolder() / "layers.gtn").string();
  for (const std::int64_t n : { 1, 3 })
  {
    for (const std::uint32_t count : { 1u, 2u, 7u })
    {
      const auto sample = test::MakeTreeSample(n, 1);
      WriterOptions options;
      options.ChunkSize = 64;
      options.Layers.emplace();
      options.Layers->Component = count % 3 == 2 ? -1 : 1; // a component, or lengths
      options.Layers->Count = count;
      options.Layers->Spacing = static_cast<LayerSpacing>(1 + count % 3);
      options.Layers->Values = sample.Steps[0][0].data();
      const auto merges = static_cast<std::uint32_t>(sample.Tree.GetMerges().size());
      test::WriteTreeSample(path, sample, options,
        n > 1 ? std::vector<std::uint32_t>{ merges / 2 } : std::vector<std::uint32_t>{});
      const auto bytes = test::ReadFile(path);
      corpus.Add("File", bytes);
      corpus.Add("Sections", bytes);
      const auto sections = test::ReadSections(path);
      ByteWriter tables;
      for (const auto name : { SectionMeta, SectionTable, SectionLayers })
      {
        const auto table = Decompress(test::FindPayload(sections, name), 1 << 20);
        tables.Put(static_cast<std::uint16_t>(table.size()));
        tables.PutBytes(table);
      }
      corpus.Add("Layers", tables.Data);
    }
  }
  fs::remove(path);
}
}

/** Streams of cells of any type, for fuzzCells.cxx. surfaces: whether most cells are polygons that
 * have edges in common. */
void AddCells(Corpus& corpus, std::mt19937& random, bool surfaces)
{
  auto noise = MakeNoise(4096, random);
  for (auto& byte : noise)
  {
    // TakeCells takes a polygon for these values.
    byte = surfaces && byte % 2 != 0 ? static_cast<std::uint8_t>(200 + byte % 32) : byte;
  }
  fuzz::Input in(noise.data(), noise.size());
  std::uint32_t points = 0;
  const auto cells = fuzz::TakeCells(in, 60, points);
  auto frameNoise = MakeNoise(4096, random);
  fuzz::Input first(frameNoise.data(), frameNoise.size());
  const auto shared = fuzz::TakeFrame(first, 400).SharedKeys.size();
  if (cells.Types.empty() || shared > points)
  {
    return;
  }
  const auto setCount = [](Bytes& bytes, std::size_t at, std::size_t count)
  {
    bytes[at] = static_cast<std::uint8_t>(count);
    bytes[at + 1] = static_cast<std::uint8_t>(count >> 8);
  };
  setCount(frameNoise, 0, cells.GetNumber());
  setCount(frameNoise, 2, points - shared);
  fuzz::Input again(frameNoise.data(), frameNoise.size());
  auto frame = fuzz::TakeFrame(again, 400);
  frame.Tets = 0;
  frame.Cells = { static_cast<std::uint32_t>(cells.GetNumber()),
    static_cast<std::uint32_t>(cells.Corners.size()),
    static_cast<std::uint32_t>(cells.Faces.size()) };
  std::vector<PointKeys> own(frame.OwnPoints);
  for (auto& keys : own)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      keys[axis] = fuzz::TakeKey(in, frame.Domains[axis]);
    }
  }
  ShapeTable table;
  table.Add(cells);
  for (const auto profile : { Profile::Small, Profile::Fast })
  {
    const auto encoded = EncodeCells(frame, cells, table, own, true, profile);
    ByteWriter streams;
    streams.Put(static_cast<std::uint16_t>(frame.Cells.Corners));
    streams.Put(static_cast<std::uint16_t>(frame.Cells.FaceValues));
    for (const auto& part : { table.Write(), encoded.Connectivity, encoded.Geometry })
    {
      streams.Put(static_cast<std::uint16_t>(part.size()));
      streams.PutBytes(part);
    }
    streams.PutBytes(encoded.Corners);
    corpus.Add("Cells", Join(frameNoise, again, streams.Data));
  }
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: makeCorpus FOLDER\n";
    return 2;
  }
  fs::create_directories(argv[1]);
  Corpus corpus(argv[1]);
  std::mt19937 random(1);
  for (unsigned i = 0; i < 40; ++i)
  {
    AddChunks(corpus, random);
    AddCells(corpus, random, i % 4 == 3);
    AddArrays(corpus, random, Profile::Small);
    AddArrays(corpus, random, Profile::Fast);
  }
  for (unsigned i = 0; i < 10; ++i)
  {
    AddPalette(corpus, random);
    AddEntropy(corpus, random);
    corpus.Add("RoundTripChunk", MakeNoise(40u << (i % 5), random));
    corpus.Add("RoundTripCells", MakeNoise(80u << (i % 6), random));
    corpus.Add("RoundTripFile", MakeNoise(40u << (i % 5), random));
  }
  for (unsigned i = 0; i < 20; ++i)
  {
    AddMerges(corpus, random);
  }
  AddFiles(corpus);
  AddMovingFiles(corpus);
  AddSeries(corpus);
  AddTreeFiles(corpus);
  AddLayerFiles(corpus);
  AddSmoothFiles(corpus);
  AddSeriesFiles(corpus);
  AddDeletedCellFiles(corpus);
  AddCellFiles(corpus);
  for (unsigned i = 0; i < 6; ++i)
  {
    AddBlocks(corpus, random);
  }
  AddVolumes(corpus);
  corpus.Add("FieldData", Decompress(WriteFieldData(MakeField()), 1 << 20));
  corpus.Add("FieldData", Decompress(WriteFieldData({}), 1 << 20));
  corpus.Add("Decompress", test::Store(Bytes(300, 1)));
  corpus.Add("Decompress", Compress(Bytes(100000, 1)));
  return 0;
}
