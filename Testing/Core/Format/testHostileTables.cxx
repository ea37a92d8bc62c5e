// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files with valid checksums and invalid tables.

#include "gatunArrayCodec.h"
#include "gatunHostile.h"
#include "gatunVerifyFile.h"

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** Changes a good file and expects that reading all of it fails like this. */
void ExpectRefused(const std::string& what, const std::function<void(FileImage&)>& change,
  ErrorCode code = ErrorCode::Corrupt)
{
  auto image = MakeImage();
  change(image);
  const auto path = PutFile("changed.gtn", image.Build());
  EXPECT_GATUN_ERROR(code, path, what, [&] { ReadAll(path); });
}

/** Replaces META. */
void SetMeta(FileImage& image, const Bytes& bytes)
{
  image.ChangeTable = [bytes](FourCC name, std::size_t, Bytes& table)
  { table = name == SectionMeta ? bytes : table; };
}

TEST(HostileTables, TheUnchangedFileIsRead)
{
  const auto path = PutFile("same.gtn", MakeImage().Build());
  EXPECT_NO_THROW(ReadAll(path));
  EXPECT_TRUE(VerifyFile(FileReader(path)));
}

TEST(HostileTables, CountsOfTheMeshMustAddUp)
{
  ExpectRefused("the meta data at byte", [](FileImage& f) { SetMeta(f, Bytes(3, 0)); });
  ExpectRefused("tetrahedra do not add up", [](FileImage& f) { ++f.Meta.Tets; });
  ExpectRefused("points do not add up", [](FileImage& f) { ++f.Meta.Points; });
  ExpectRefused("claims more points than its stream can hold",
    [](FileImage& f)
    {
      f.Meta.UnusedPoints += 1000;
      f.Meta.Points += 1000;
    });
  ExpectRefused("points do not add up",
    [](FileImage& f) { f.Meta.Points = std::numeric_limits<std::uint64_t>::max(); });
}

TEST(HostileTables, KeysMustBePossible)
{
  const auto withKey = [](const ArrayKey& key)
  { return [key](FileImage& f) { f.Meta.Arrays.at(0).Keys = { key }; }; };
  const auto path = PutFile("keys.gtn",
    [&]
    {
      auto image = MakeImage();
      withKey({ "Class", "KEY", KeyKind::Texts, {}, { "", "b" } })(image);
      image.Meta.PointArray = { "Position", { "x", "y", "z" },
        { { "Class", "KEY", KeyKind::Double, { 1 }, {} } } };
      return image.Build();
    }());
  EXPECT_NO_THROW(ReadAll(path));
  EXPECT_EQ(FileReader(path).GetPointArray().Name, "Position");
  ExpectRefused("a key is of an unknown kind", withKey({ "C", "K", KeyKind(10), { 1 }, {} }));
  ExpectRefused("a key has no name", withKey({ "C", "", KeyKind::Integer, { 1 }, {} }));
  ExpectRefused("a key has no name", withKey({ "", "KEY", KeyKind::Integer, { 1 }, {} }));
  ExpectRefused(
    "a key of one value has another number", withKey({ "C", "K", KeyKind::Integer, { 1, 2 }, {} }));
  ExpectRefused(
    "a key of one value has another number", withKey({ "C", "K", KeyKind::Text, {}, {} }));
  ExpectRefused("points have too many names of components",
    [](FileImage& f) { f.Meta.PointArray.ComponentNames.resize(4); });
}

TEST(HostileTables, CountsOfAChunkMustBePossible)
{
  ExpectRefused("impossible number of tetrahedra",
    [](FileImage& f)
    {
      f.Meta.Tets += (std::uint64_t{ 1 } << 40) - f.Mesh.Chunks[0].Info.Tets;
      f.Mesh.Chunks[0].Info.Tets = std::uint64_t{ 1 } << 40;
    });
  ExpectRefused("impossible number of tetrahedra",
    [](FileImage& f)
    {
      f.Meta.Tets -= f.Mesh.Chunks[0].Info.Tets;
      f.Mesh.Chunks[0].Info.Tets = 0;
    });
  ExpectRefused("claims more tetrahedra than its stream can hold",
    [](FileImage& f)
    {
      f.Meta.Tets += 200000;
      f.Mesh.Chunks[0].Info.Tets += 200000;
    });
  ExpectRefused("more points than its cells can use",
    [](FileImage& f)
    {
      f.Meta.Points += 300;
      f.Mesh.Chunks[0].Info.OwnPoints += 300;
    });
  ExpectRefused("the mesh of chunk 0 at byte",
    [](FileImage& f)
    {
      ++f.Meta.Points;
      ++f.Mesh.Chunks[0].Info.OwnPoints;
    });
  ExpectRefused("the mesh of chunk 0 at byte",
    [](FileImage& f)
    {
      f.Meta.Tets += 5;
      f.Mesh.Chunks[0].Info.Tets += 5;
    });
}

TEST(HostileTables, GroupsMustBePossible)
{
  ExpectRefused("a group has no points",
    [](FileImage& f)
    {
      f.Meta.Points -= f.Mesh.Blocks[0].Groups[0].Points;
      f.Mesh.Blocks[0].Groups[0].Points = 0;
    });
  ExpectRefused("claim more points than their streams can hold",
    [](FileImage& f)
    {
      f.Meta.Points += 10000000;
      f.Mesh.Blocks[0].Groups[0].Points += 10000000;
    });
  ExpectRefused("a chunk has more points than its cells can use",
    [](FileImage& f)
    {
      f.Meta.Points += 1000;
      f.Mesh.Blocks[0].Groups[0].Points += 1000;
    });
  ExpectRefused("a block claims more points than its stream can hold",
    [](FileImage& f) { f.Mesh.Blocks[0].Geometry = {}; });
  ExpectRefused(
    "fewer than two chunks", [](FileImage& f) { f.Mesh.Blocks[0].Groups[0].Chunks.resize(1); });
  ExpectRefused("names a chunk that is not there",
    [](FileImage& f) { f.Mesh.Blocks[0].Groups[0].Chunks.back() = 77; });
  ExpectRefused("do not ascend",
    [](FileImage& f)
    {
      auto& chunks = f.Mesh.Blocks[0].Groups[0].Chunks;
      chunks[1] = chunks[0];
    });
  ExpectRefused("names a chunk that is not there",
    [](FileImage& f)
    {
      auto& chunks = f.Mesh.Blocks[0].Groups[0].Chunks;
      std::swap(chunks.front(), chunks.back());
    });
  ExpectRefused("the mesh of chunk",
    [](FileImage& f)
    {
      // A chunk gets points that its walk does not use.
      f.Mesh.Blocks[0].Groups[0].Chunks = { 0, 1, 2 };
    });
}

TEST(HostileTables, StreamsMustLieInTheFile)
{
  // An offset that no stream of the image has stays as it is.
  ExpectRefused(
    "reaches past the end of the file",
    [](FileImage& f) { f.Mesh.Chunks[0].Connectivity.Offset = std::uint64_t{ 1 } << 60; },
    ErrorCode::Truncated);
  ExpectRefused(
    "its checksum is wrong", [](FileImage& f) { f.Mesh.Chunks[0].Connectivity.Offset = 600; });
  ExpectRefused("the streams are longer than the file",
    [](FileImage& f)
    {
      f.Mesh.Chunks[0].Geometry.Offset = 600;
      f.Mesh.Chunks[0].Geometry.Length = 0xfffffff0;
    });
  ExpectRefused(
    "reaches past the end of the file",
    [](FileImage& f)
    {
      f.Steps[2].Arrays[0].Chunks[1].Offset = 600;
      f.Steps[2].Arrays[0].Chunks[1].Length = ~std::uint64_t{ 0 } - 300;
    },
    ErrorCode::Truncated);
}

TEST(HostileTables, OneStreamCannotStandForManyChunks)
{
  ExpectRefused("the streams are longer than the file",
    [](FileImage& f)
    {
      auto chunk = f.Mesh.Chunks[0];
      chunk.Info.OwnPoints = 4;
      f.Of(chunk.Connectivity).resize(4000, 0);
      for (int i = 0; i < 100; ++i)
      {
        f.Mesh.Chunks.push_back(chunk);
        f.Meta.Tets += chunk.Info.Tets;
        f.Meta.Points += chunk.Info.OwnPoints;
      }
      for (auto& step : f.Steps)
      {
        for (auto& array : step.Arrays)
        {
          array.Chunks.resize(f.Mesh.Chunks.size(), array.Chunks[0]);
          array.ChunkRanges.resize(f.Mesh.Chunks.size(), array.ChunkRanges[0]);
        }
      }
    });
}

TEST(HostileTables, PalettesMustBeWhatTheySay)
{
  const auto setPalette = [](FileImage& f, std::uint64_t count, const Bytes& stream)
  {
    auto& palette = f.Steps[2].Arrays[0].Palettes[0];
    palette.Count = count;
    f.Set(palette.Stream, stream);
  };
  const std::string what = "the palette of array 'p'";
  ExpectRefused(what, [&](FileImage& f) { setPalette(f, 3, Bytes(4, 0)); });
  ExpectRefused(what, [&](FileImage& f) { setPalette(f, 1u << 17, Bytes(1000, 0)); });
  ExpectRefused("a palette is too large",
    [&](FileImage& f) { setPalette(f, std::uint64_t{ 1 } << 40, Bytes(4, 0)); });
  ExpectRefused("the palette of the coordinates",
    [&](FileImage& f)
    {
      f.Mesh.Palettes[1].Count = 5;
      f.Set(f.Mesh.Palettes[1].Stream, Bytes(9, 1));
    });
}

TEST(HostileTables, ScalesMustBePossible)
{
  const auto setScale = [](
                          FileImage& f, ScaleKind kind, int digits, int first, std::size_t step = 2)
  {
    f.Steps[step].Arrays[0].Palettes[0].Steps = { kind, static_cast<std::uint8_t>(digits),
      static_cast<std::int8_t>(first) };
  };
  const std::string what = "a scale is impossible for its type";
  ExpectRefused(what, [&](FileImage& f) { setScale(f, ScaleKind::Shift, 64, 0); });
  ExpectRefused(what, [&](FileImage& f) { setScale(f, ScaleKind::Decimal, 16, 0); });
  ExpectRefused(what, [&](FileImage& f) { setScale(f, ScaleKind::Decimal, 3, 100); });
  ExpectRefused(what, [&](FileImage& f) { setScale(f, ScaleKind::Fixed, 23, 0); });
  ExpectRefused(what, [&](FileImage& f) { setScale(f, ScaleKind::Binary, 0, -127); });
  ExpectRefused(what,
    [&](FileImage& f) {
      f.Mesh.Palettes[2].Steps = { ScaleKind::Decimal, 0, 0 };
    });
  // Streams may not refer to keys of another scale at the step before.
  ExpectRefused("a stream needs a time step before it and there is none",
    [&](FileImage& f) { setScale(f, ScaleKind::Shift, 2, 0, 2); });
}

TEST(HostileTables, BoundsMustBePossible)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expectRefused = [](const ErrorBound& bound, double step, double reached)
  {
    ExpectRefused("a bound of errors is impossible",
      [&](FileImage& f)
      {
        auto& rounding = f.Steps[0].Arrays[0].Palettes[0].Rounding;
        rounding.Bound = bound;
        rounding.Step = step;
        rounding.Reached = reached;
      });
  };
  const ErrorBound absolute{ ErrorKind::Absolute, 1, false };
  for (const double step : { 0.0, -1.0, nan, infinity, 1e308 })
  {
    expectRefused(absolute, step, 0);
  }
  expectRefused({ ErrorKind::Absolute, nan, false }, 1, 0);
  expectRefused({ ErrorKind::Relative, 0, false }, 1, 0);
  expectRefused(absolute, 1, nan);
  expectRefused(absolute, 1, -1);
  expectRefused({ static_cast<ErrorKind>(5), 1, false }, 1, 0);
  for (const double step : { 1.0, 2.5, 1e16, nan })
  {
    expectRefused({ ErrorKind::Pointwise, 0.5, false }, step, 0);
  }
  ExpectRefused("coordinates have a bound of errors",
    [&](FileImage& f)
    {
      f.Mesh.Palettes[2].Rounding.Bound = absolute;
      f.Mesh.Palettes[2].Rounding.Step = 1;
    });
}

/** Numbers as the order of a block or of a chunk's cells. */
Bytes EncodeNumbers(ScalarType type, std::size_t count, Key first, Key step)
{
  const Domain domain(type);
  ComponentKeys keys;
  for (std::size_t i = 0; i < count; ++i)
  {
    keys.Now.push_back(first + i * step);
  }
  return EncodeCellValues({}, { &domain, 1 }, { &keys, 1 });
}

TEST(HostileTables, OrdersMustBePermutations)
{
  ExpectRefused("names cell 5 twice",
    [](FileImage& f)
    {
      auto& chunk = f.Mesh.Chunks[0];
      f.Set(chunk.CellOrder, EncodeNumbers(ScalarType::UInt32, chunk.Info.Tets, 5, 0));
    });
  ExpectRefused("the original order of the cells of chunk 0 at byte",
    [](FileImage& f)
    {
      auto& chunk = f.Mesh.Chunks[0];
      f.Set(chunk.CellOrder, EncodeNumbers(ScalarType::UInt32, chunk.Info.Tets, 1u << 31, 0));
    });
  ExpectRefused("the corners of chunk 0 at byte",
    [](FileImage& f)
    {
      auto& chunk = f.Mesh.Chunks[0];
      f.Set(chunk.Corners, EncodeNumbers(ScalarType::UInt8, chunk.Info.Tets, 12, 0));
    });
  ExpectRefused("the order of the points of block 0 at byte",
    [](FileImage& f)
    {
      auto& block = f.Mesh.Blocks[0];
      f.Set(block.Order, EncodeNumbers(ScalarType::UInt32, block.Points, 1u << 20, 0));
    });
  ExpectRefused("names point 3 twice",
    [](FileImage& f)
    {
      auto& block = f.Mesh.Blocks[0];
      f.Set(block.Order, EncodeNumbers(ScalarType::UInt32, block.Points, 3, 0));
    });
}

TEST(HostileTables, VerifyFindsABadOrderInManyChunks)
{
  const auto path = GetPath("many.gtn");
  WriterOptions options;
  options.ChunkSize = 64;
  options.Keep = KeepAll;
  WriteSample(path, MakeCubes(6, 0.2), options, 1);
  FileImage image(path);
  auto& chunks = image.Mesh.Chunks;
  ASSERT_GT(chunks.size(), 18u);
  for (auto* chunk : { &chunks.front(), &chunks.back() })
  {
    image.Set(chunk->CellOrder, EncodeNumbers(ScalarType::UInt32, chunk->Info.Tets, 0, 1));
  }
  const auto changed = PutFile("changed.gtn", image.Build());
  EXPECT_GATUN_ERROR(
    ErrorCode::Corrupt, changed, " twice", [&] { VerifyFile(FileReader(changed)); });
}

TEST(HostileTables, TimeStepsMustFollowEachOther)
{
  ExpectRefused("do not ascend", [](FileImage& f) { f.Steps[1].Time = f.Steps[0].Time; });
  ExpectRefused("do not ascend", [](FileImage& f) { std::swap(f.Steps[1], f.Steps[2]); });
  ExpectRefused("a time is not a number", [](FileImage& f) { f.Steps[1].Time = NAN; });
  ExpectRefused("needs one before it", [](FileImage& f) { f.Steps[0].Key = false; });
  ExpectRefused("has no time", [](FileImage& f) { f.Meta.HasTime = false; });
  ExpectRefused("needs a time step before it and there is none",
    [](FileImage& f)
    {
      // A stream that refers to the step before, in a step that must not.
      f.Steps[1].Key = true;
      auto bytes = f.Of(f.Steps[1].Arrays[0].Chunks[0]);
      bytes[1] = 1;
      f.Set(f.Steps[1].Arrays[0].Chunks[0], bytes);
      f.Steps.resize(2);
    });
}

TEST(HostileTables, RangesMustBeNumbers)
{
  ExpectRefused(
    "a range is not a number", [](FileImage& f) { f.Mesh.Chunks[0].Info.Box[0].Min = NAN; });
  ExpectRefused("a range is not a number", [](FileImage& f) { f.Meta.Box[2].Max = NAN; });
  ExpectRefused(
    "a range is not a number", [](FileImage& f) { f.Steps[0].Arrays[0].Ranges[0].Max = NAN; });
  // Infinite bounds are numbers; what they make of the mesh is found out by decoding.
  auto image = MakeImage();
  image.Mesh.Chunks[0].Info.Box[0].Max = HUGE_VAL;
  const auto path = PutFile("infinite.gtn", image.Build());
  try
  {
    ReadAll(path);
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Corrupt) << error.what();
  }
}

TEST(HostileTables, DescriptionsMustBeKnown)
{
  const auto setByte = [](std::size_t fromEnd, std::uint8_t value)
  {
    return [=](FileImage& f)
    {
      f.Meta.Arrays.resize(1);
      f.Steps.clear();
      auto meta = Decompress(f.Meta.Write(), 1 << 20);
      meta[meta.size() - fromEnd] = value;
      SetMeta(f, meta);
    };
  };
  // The last array: name 'p', where, type, components, i32, u32, number of names.
  ExpectRefused("neither points nor cells", setByte(12, 4)); // 2: it has keys
  ExpectRefused("a value type is unknown", setByte(11, 11));
  ExpectRefused("too many components", setByte(10, 0));
  ExpectRefused("a count is larger", setByte(1, 9));
  ExpectRefused("the coordinates have an unknown type",
    [](FileImage& f) { f.Meta.CoordinateType = ScalarType::Int32; });
  ExpectRefused("the kept order is unknown", [](FileImage& f) { f.Meta.Keep = 8; });
  ExpectRefused("bytes behind the end",
    [](FileImage& f)
    {
      auto meta = Decompress(f.Meta.Write(), 1 << 20);
      meta.push_back(0);
      SetMeta(f, meta);
    });
}

TEST(HostileTables, ArraysCannotClaimMoreValuesThanTheirStreamsHold)
{
  ExpectRefused("more values than its stream can hold",
    [](FileImage& f)
    {
      // 65536 components of each point of a chunk out of no bytes at all
      f.Meta.Arrays.resize(1);
      f.Meta.Arrays[0].Components = 65536;
      for (auto& step : f.Steps)
      {
        step.Arrays.resize(1);
        auto& array = step.Arrays[0];
        array.Palettes.resize(65536);
        array.Ranges.resize(65537);
        for (auto& ranges : array.ChunkRanges)
        {
          ranges.resize(65537);
        }
        for (auto& stream : array.Chunks)
        {
          stream = {};
        }
      }
      f.Steps.resize(1);
    });
}

//------------------------------------------------------------------------------
// Pages

/** A file whose chunks are in two pages. */
FileImage MakePages()
{
  const auto path = GetPath("pages.gtn");
  WriterOptions options;
  options.ChunkSize = 64;
  WriteSample(path, MakeCubes(15, 0.2), options, 1);
  return FileImage(path);
}

/** Expects that verifying a changed file of two pages fails like this. */
void ExpectPagesRefused(const std::string& what, const std::function<void(FileImage&)>& change)
{
  auto image = MakePages();
  change(image);
  const auto path = PutFile("changed.gtn", image.Build());
  EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path, what, [&] { VerifyFile(FileReader(path)); });
}

TEST(HostileTables, ChunksInSeveralPagesAreRead)
{
  const auto image = MakePages();
  ASSERT_GT(image.Mesh.Chunks.size(), ChunksPerPage + 50);
  const auto path = PutFile("same.gtn", image.Build());
  EXPECT_NO_THROW(ReadAll(path));
  EXPECT_TRUE(VerifyFile(FileReader(path)));
  // Chunks of the second page share points with some of the first.
  const FileReader file(path);
  bool isAcross = false;
  for (std::size_t chunk = ChunksPerPage; chunk < file.GetChunks().size(); ++chunk)
  {
    isAcross = isAcross || file.GetNeighbors(chunk).front() < ChunksPerPage;
  }
  EXPECT_TRUE(isAcross);
}

TEST(HostileTables, TheTableOfPagesMustBePossible)
{
  ExpectPagesRefused("fewer pages than chunks need",
    [](FileImage& f) { f.ChangeIndex = [](MeshIndex& index) { index.Chunks = 4'000'000'000; }; });
  ExpectPagesRefused("the chunks of a page are not all there",
    [](FileImage& f)
    {
      f.ChangeIndex = [](MeshIndex& index)
      { std::swap(index.Pages[0].Summary, index.Pages[1].Summary); };
    });
  ExpectPagesRefused("bytes behind the end of a page",
    [](FileImage& f)
    { f.ChangeIndex = [](MeshIndex& index) { index.Pages[1].Summary = index.Pages[0].Summary; }; });
  ExpectPagesRefused("blocks have more points than the mesh",
    [](FileImage& f)
    { f.ChangeIndex = [](MeshIndex& index) { index.Pages[1].Points = ~std::uint64_t{ 0 }; }; });
  ExpectPagesRefused("claim more points than their streams can hold",
    [](FileImage& f)
    { f.ChangeIndex = [](MeshIndex& index) { index.Pages[1].GeometryBytes = 1; }; });
  ExpectPagesRefused("the streams are longer than the file",
    [](FileImage& f)
    { f.ChangeIndex = [](MeshIndex& index) { index.Pages[0].GeometryBytes = 1u << 30; }; });
  ExpectPagesRefused("not those that the table has",
    [](FileImage& f) { f.ChangeIndex = [](MeshIndex& index) { ++index.Pages[0].GeometryBytes; }; });
}

/** Takes the last block of the first chunk from it. Returns its points of that block. */
std::uint64_t ForgetBlock(MeshTable& mesh)
{
  auto& parts = mesh.Chunks[0].Shared;
  const auto block = parts.back().Block;
  std::uint64_t points = 0;
  while (!parts.empty() && parts.back().Block == block)
  {
    points += parts.back().Points;
    parts.pop_back();
  }
  return points;
}

TEST(HostileTables, ChunksAndBlocksMustNameEachOther)
{
  ExpectPagesRefused("a block is not in the page of its chunks",
    [](FileImage& f)
    {
      f.ChangeIndex = [](MeshIndex& index)
      {
        index.Pages[0].Details = index.Pages[1].Details;
        index.Pages[0].Blocks = index.Pages[1].Blocks;
      };
    });
  ExpectPagesRefused("has none of its points",
    [](FileImage& f)
    {
      f.ChangeLinks = [](MeshTable& mesh)
      { mesh.Chunks[0].Shared.back().Block = mesh.Chunks[200].Shared.back().Block; };
    });
  ExpectPagesRefused("other shared points than its blocks",
    [](FileImage& f) { f.ChangeLinks = [](MeshTable& mesh) { ForgetBlock(mesh); }; });
  ExpectPagesRefused("do not name all blocks",
    [](FileImage& f)
    {
      // The sizes of the chunk agree with what it names.
      f.ChangeLinks = [](MeshTable& mesh)
      { mesh.Chunks[0].Info.SharedPoints -= ForgetBlock(mesh); };
    });
  ExpectPagesRefused("a chunk names a block that is not there",
    [](FileImage& f)
    { f.ChangeLinks = [](MeshTable& mesh) { mesh.Chunks[0].Shared.back().Block = 1u << 30; }; });
}

TEST(HostileTables, PagesOfStepsMustBeThere)
{
  const auto replace = [](std::size_t size)
  {
    return [size](FileImage& f)
    {
      f.ChangeTable = [size](FourCC name, std::size_t number, Bytes& table)
      {
        if (name == SectionPages && number == 5) // the second page of the first step
        {
          table.resize(size);
        }
      };
    };
  };
  ExpectPagesRefused("a page of a step ends too early", replace(100));
  ExpectPagesRefused("bytes behind the end of a page of a step", replace(100000));
}
}
