// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Isosurfaces of files against those of the decoded mesh, which testSurface.cxx is about.

#include "gatunError.h"
#include "gatunFileSurfaceSamples.h"
#include "gatunParallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

namespace gatun::test
{
//------------------------------------------------------------------------------
TEST(FileSurface, IsThatOfTheDecodedMesh)
{
  for (const std::uint32_t chunkTets : { 64u, 500u, 65536u })
  {
    const auto file = MakeFile("surface.gtn", chunkTets, 3);
    FileSurface extractor(file);
    for (const std::size_t step : { 0, 2, 1 })
    {
      for (const auto& request : { AskFor({ 4.3 }, FieldArray, -1, step),
             AskFor({ 4.3 }, FieldArray, 0, step), AskFor({ 9.1, 20, 33.3 }, VectorArray, 0, step),
             AskFor({ 5, 30 }, VectorArray, 2, step), AskFor({ 12, 40 }, VectorArray, -1, step) })
      {
        for (const auto type : { ScalarType::Float64, ScalarType::Float32 })
        {
          auto typed = request;
          typed.Options.CoordinateType = type;
          const auto expected = GetTriangles(MakeSlowly(file, typed), type);
          ASSERT_GT(expected.size(), 50u);
          EXPECT_EQ(GetTriangles(extractor.Extract(typed), type), expected);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(FileSurface, CarriesTheArraysThatAreAskedFor)
{
  const auto file = MakeFile("carried.gtn", 300);
  FileSurface extractor(file);
  using Arrays = std::vector<std::uint32_t>;
  for (const std::uint32_t array : { FieldArray, VectorArray })
  {
    auto request = AskFor({ 7 }, array);
    const auto whole = MakeSlowly(file, request);
    for (const Arrays& arrays :
      { Arrays{}, Arrays{ 0 }, Arrays{ 1 }, Arrays{ 2 }, Arrays{ 0, 2 }, Arrays{ 1, 2 } })
    {
      request.Arrays = arrays;
      // Of the whole, those arrays only.
      auto expected = GetTriangles(whole, ScalarType::Float64);
      for (auto& triangle : expected)
      {
        for (auto& corner : triangle.Corners)
        {
          std::vector<double> kept(corner.begin(), corner.begin() + 3);
          if (std::count(arrays.begin(), arrays.end(), 0u) > 0)
          {
            kept.push_back(corner[3]);
          }
          if (std::count(arrays.begin(), arrays.end(), 1u) > 0)
          {
            kept.insert(kept.end(), corner.begin() + 4, corner.end());
          }
          corner = kept;
        }
        triangle.Material =
          std::count(arrays.begin(), arrays.end(), 2u) > 0 ? triangle.Material : 0;
      }
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(GetTriangles(extractor.Extract(request), ScalarType::Float64, arrays), expected);
    }
  }
}

//------------------------------------------------------------------------------
TEST(FileSurface, DecodesJustTheChunksThatItPassesThrough)
{
  const auto file = MakeFile("chunks.gtn", 64, 2);
  FileSurface extractor(file);
  const auto& chunks = file->GetChunks();
  ASSERT_GT(chunks.size(), 40u);
  const auto check = [&](const FileSurfaceRequest& request)
  {
    const auto expected = FindSlowly(file, request);
    EXPECT_EQ(extractor.FindChunks(request), expected);
    extractor.Extract(request);
    EXPECT_EQ(extractor.GetStatistics().Chunks, expected.size());
    std::uint64_t tets = 0;
    for (const auto chunk : expected)
    {
      tets += chunks[chunk].Tets;
    }
    EXPECT_EQ(extractor.GetStatistics().Tets, tets);
    return expected.size();
  };
  std::size_t some = 0;
  for (const std::size_t step : { 0, 1 })
  {
    for (const double value : { -5.0, 0.2, 4.0, 7.9, 100.0 })
    {
      some += check(AskFor({ value }, FieldArray, -1, step));
      some += check(AskFor({ value }, VectorArray, 1, step));
      some += check(AskFor({ value, value + 1 }, VectorArray, -1, step));
    }
  }
  EXPECT_GT(some, 100u);
  // The ends of the range of a chunk: the lower one is outside, the upper one inside.
  for (std::size_t chunk = 0; chunk < chunks.size(); chunk += 7)
  {
    const auto range = file->GetChunkRanges(FieldArray, 0, chunk)[0];
    check(AskFor({ range.Min }));
    check(AskFor({ range.Max }));
    const auto has = [&](double value)
    {
      const auto found = extractor.FindChunks(AskFor({ value }));
      return std::binary_search(found.begin(), found.end(), chunk);
    };
    EXPECT_FALSE(has(range.Min));
    EXPECT_TRUE(has(range.Max));
  }
}

//------------------------------------------------------------------------------
TEST(FileSurface, ReadsNoMoreThanItNeeds)
{
  const auto file = MakeFile("bytes.gtn", 64, 1, MakeCubes(12, 0.2));
  FileSurface extractor(file, 64u << 20);
  file->GetStatistics(); // reads the tables, which are not counted here
  const auto opened = file->GetBytesRead();
  const auto range = file->GetRanges(FieldArray, 0)[0];
  for (const double value : { range.Min, range.Min - 1, range.Max + 1e-6 })
  {
    EXPECT_EQ(extractor.Extract(AskFor({ value })).GetNumberOfTriangles(), 0u);
    EXPECT_EQ(extractor.GetStatistics().Chunks, 0u);
  }
  EXPECT_EQ(extractor.Extract(AskFor({})).GetNumberOfPoints(), 0u);
  EXPECT_EQ(file->GetBytesRead(), opened);

  // One chunk at a time: two that need the same shared points at once may both read them.
  const auto readBy = [&](FileSurface& surface, const std::vector<double>& values)
  {
    const auto begin = file->GetBytesRead();
    ParallelFor(1, [&](std::size_t) { surface.Extract(AskFor(values)); });
    return file->GetBytesRead() - begin;
  };
  const auto few = readBy(extractor, { range.Max });
  EXPECT_GT(few, 0u);
  EXPECT_LT(extractor.GetStatistics().Chunks, file->GetChunks().size() / 10);

  // Once more: all of it is there. Without a cache, all but what chunks share has to be read again.
  extractor.Extract(AskFor({ range.Max }));
  EXPECT_EQ(file->GetBytesRead() - opened, few);
  extractor.SetCacheBudget(0);
  std::uint64_t ofChunks = 0;
  for (const auto chunk : extractor.FindChunks(AskFor({ range.Max })))
  {
    ofChunks += file->GetChunkMeshBytes(chunk);
    for (const auto array : AskFor({}).Arrays)
    {
      ofChunks += file->GetChunkArrayBytes(chunk, array, 0);
    }
  }
  extractor.Extract(AskFor({ range.Max }));
  EXPECT_EQ(file->GetBytesRead() - opened, few + ofChunks);

  // What chunks share is kept no longer than needed, which is not before the last of them.
  EXPECT_EQ(readBy(extractor, { range.Max }), few);
  const std::vector<double> middle = { (range.Min + range.Max) / 2 };
  FileSurface keeper(file, 64u << 20);
  const auto many = readBy(keeper, middle);
  EXPECT_GT(many, few);
  EXPECT_EQ(readBy(extractor, middle), many);
  EXPECT_EQ(readBy(extractor, middle), many);
  EXPECT_EQ(readBy(keeper, middle), 0u);

  // Every chunk is far more than those few.
  const auto before = file->GetBytesRead();
  FileSurface other(file);
  std::vector<double> values;
  for (std::size_t chunk = 0; chunk < file->GetChunks().size(); ++chunk)
  {
    values.push_back(file->GetChunkRanges(FieldArray, 0, chunk)[0].Max);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  other.Extract(AskFor(values));
  EXPECT_EQ(other.GetStatistics().Chunks, file->GetChunks().size());
  EXPECT_LT(few, (file->GetBytesRead() - before) / 4);
}

//------------------------------------------------------------------------------
TEST(FileSurface, PiecesMakeTheWhole)
{
  const auto file = MakeFile("pieces.gtn", 100);
  FileSurface extractor(file);
  for (const bool normals : { false, true })
  {
    auto request = AskFor({ 2.2, 5.7 });
    request.Options.Normals = normals;
    const auto whole = extractor.Extract(request);
    const auto expected = GetTriangles(whole, ScalarType::Float64);
    const auto chunks = extractor.GetStatistics().Chunks;
    const auto expectedNormals = normals ? GetNormals(whole) : GetNormals(Surface({}, {}));
    for (const unsigned pieces : { 1u, 2u, 3u, 7u, 1000u })
    {
      request.Pieces = pieces;
      std::vector<FoundTriangle> found;
      std::size_t used = 0;
      std::size_t around = 0;
      for (request.Piece = 0; request.Piece < pieces; ++request.Piece)
      {
        const auto surface = extractor.Extract(request);
        const auto part = GetTriangles(surface, ScalarType::Float64);
        found.insert(found.end(), part.begin(), part.end());
        used += extractor.GetStatistics().Chunks;
        around += extractor.GetStatistics().Chunks > chunks / pieces + 1 ? 1 : 0;
        if (normals)
        {
          // To the last bit, also where pieces meet.
          for (const auto& [point, normal] : GetNormals(surface))
          {
            ASSERT_EQ(normal, expectedNormals.at(point));
          }
        }
      }
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected) << pieces;
      if (!normals || pieces == 1)
      {
        EXPECT_EQ(used, chunks); // each once
      }
      else
      {
        EXPECT_GT(around, 0u); // for the normals
      }
    }
    request.Piece = 0;
    request.Pieces = 1;
  }
}

//------------------------------------------------------------------------------
TEST(FileSurface, NormalsOfPiecesAreSumsInTheOrderOfTheFile)
{
  // Values so far apart that what is left of a sum where large ones cancel depends on the order.
  const auto mesh = MakeCubes(12, 0);
  Values values(mesh);
  std::mt19937 random(5);
  for (float& value : values.Field)
  {
    const float kinds[] = { -0x1p60f, -1, 1, 0x1p60f };
    value = kinds[random() % 4];
  }
  WriterOptions options;
  options.ChunkSize = 64;
  const auto path = TempPath("file-surface-order.gtn");
  FileWriter writer(path, mesh.GetInput(), Values::Describe(), options);
  writer.WriteStep(values.Get());
  writer.Finish();
  FileSurface extractor(std::make_shared<const FileReader>(path));
  auto request = AskFor({ 0 });
  request.Options.Normals = true;
  const auto expected = GetNormals(extractor.Extract(request));
  request.Pieces = 9;
  for (request.Piece = 0; request.Piece < request.Pieces; ++request.Piece)
  {
    std::size_t different = 0;
    for (const auto& [point, normal] : GetNormals(extractor.Extract(request)))
    {
      different += normal != expected.at(point) ? 1 : 0;
    }
    EXPECT_EQ(different, 0u);
  }
}

//------------------------------------------------------------------------------
TEST(FileSurface, AfterMergesIsThatOfTheSimplifiedMesh)
{
  const auto file = MakeTreeFile("merged.gtn");
  const auto tree = std::make_shared<const MergeTree>(file->GetMergeTree());
  const std::size_t most = tree->GetMerges().size();
  ASSERT_GT(most, 400u);
  for (const std::size_t merges : { std::size_t{ 1 }, most / 3, most - 60, most })
  {
    FileSurface extractor(file, ChunkCache::DefaultBudget, tree, merges);
    for (const std::size_t step : { 1, 0 })
    {
      for (auto request :
        { AskFor({ 3.7 }, FieldArray, -1, step), AskFor({ 10, 20 }, VectorArray, -1, step) })
      {
        request.Options.Normals = true;
        const auto slow = MakeSlowly(file, request, merges);
        const auto whole = extractor.Extract(request);
        const auto expected = GetTriangles(slow, ScalarType::Float64);
        EXPECT_FALSE(expected.empty());
        EXPECT_EQ(GetTriangles(whole, ScalarType::Float64), expected);
        EXPECT_EQ(GetNormals(whole), GetNormals(slow));
        std::vector<FoundTriangle> found;
        request.Pieces = 4;
        for (request.Piece = 0; request.Piece < 4; ++request.Piece)
        {
          const auto surface = extractor.Extract(request);
          const auto part = GetTriangles(surface, ScalarType::Float64);
          found.insert(found.end(), part.begin(), part.end());
          const auto normals = GetNormals(whole);
          for (const auto& [point, normal] : GetNormals(surface))
          {
            ASSERT_EQ(normal, normals.at(point));
          }
        }
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected);
      }
    }
    // Chunks stay out of it whose ranges after the merges do not have the value.
    Range range;
    for (std::size_t chunk = 0; chunk < file->GetChunks().size(); ++chunk)
    {
      range.Include(file->GetChunkRanges(FieldArray, 0, chunk)[0]);
    }
    const double value = range.Min + 0.99 * (range.Max - range.Min);
    std::size_t with = 0;
    for (std::size_t chunk = 0; chunk < file->GetChunks().size(); ++chunk)
    {
      const Range after = file->GetChunkRanges(FieldArray, 0, chunk, merges)[0];
      with += after.Min <= value && value <= after.Max;
    }
    extractor.Extract(AskFor({ value }));
    EXPECT_LE(extractor.GetStatistics().Chunks, with);
    EXPECT_TRUE(merges > 1 || with < file->GetChunks().size());
  }
}

//------------------------------------------------------------------------------
TEST(FileSurface, LeavesOutWhatIsNotFinite)
{
  const auto mesh = MakeCubes(8, 0.2);
  Values values(mesh);
  for (std::size_t i = 0; i < values.Field.size(); i += 17)
  {
    values.Field[i] =
      i % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
    values.Vector[3 * i + 1] = -std::numeric_limits<double>::infinity();
  }
  WriterOptions options;
  options.ChunkSize = 100;
  const auto path = TempPath("file-surface-infinite.gtn");
  FileWriter writer(path, mesh.GetInput(), Values::Describe(), options);
  writer.WriteStep(values.Get());
  writer.Finish();
  const auto file = std::make_shared<const FileReader>(path);
  FileSurface extractor(file);
  for (const auto& request : { AskFor({ 3.3 }), AskFor({ 10 }, VectorArray, 0),
         AskFor({ 10 }, VectorArray, 1), AskFor({ 10 }, VectorArray, -1) })
  {
    auto plain = request;
    plain.Arrays = { 2 }; // what is carried may be NaN, which equals nothing
    const auto slow = MakeSlowly(file, request);
    EXPECT_GT(slow.GetNumberOfTriangles(), 50u);
    const auto places = [](const std::vector<FoundTriangle>& triangles)
    {
      std::vector<std::vector<double>> all;
      for (const auto& t : triangles)
      {
        all.push_back({ t.Material });
        std::vector<std::vector<double>> corners;
        for (const auto& corner : t.Corners)
        {
          corners.push_back({ corner.begin(), corner.begin() + 3 });
        }
        std::rotate(
          corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        for (const auto& corner : corners)
        {
          all.back().insert(all.back().end(), corner.begin(), corner.end());
        }
      }
      std::sort(all.begin(), all.end());
      return all;
    };
    EXPECT_EQ(places(GetTriangles(extractor.Extract(plain), ScalarType::Float64, { 2 })),
      places(GetTriangles(slow, ScalarType::Float64)));
  }
}

//------------------------------------------------------------------------------
TEST(FileSurface, DoesNotDependOnThreadsNorOnTheCache)
{
  const auto file = MakeFile("threads.gtn", 64);
  auto request = AskFor({ 2.2, 5.7 });
  request.Options.Normals = true;
  const auto bytesBy = [&](FileSurface& extractor)
  {
    const auto surface = extractor.Extract(request);
    std::vector<double> points(3 * surface.GetNumberOfPoints());
    surface.FillPoints(points.data());
    std::vector<float> normals(points.size());
    surface.FillNormals(normals.data());
    return std::tuple(points, normals, surface.GetTriangles());
  };
  const auto bytesOf = [&](std::uint64_t budget)
  {
    FileSurface extractor(file, budget);
    return bytesBy(extractor);
  };
  const auto expected = bytesOf(ChunkCache::DefaultBudget);
  ASSERT_GT(std::get<0>(expected).size(), 1000u);
  EXPECT_EQ(bytesOf(0), expected);
  EXPECT_EQ(bytesOf(5000), expected);
  ParallelFor(1, [&](std::size_t) { EXPECT_EQ(bytesOf(0), expected); });

  // What one extractor has decoded another one finds in a cache that they share.
  const auto cache = std::make_shared<ChunkCache>(file);
  FileSurface first(cache);
  FileSurface second(cache);
  EXPECT_EQ(bytesBy(first), expected);
  const auto decoded = cache->GetStatistics().MeshesDecoded;
  EXPECT_GT(decoded, 0u);
  EXPECT_EQ(bytesBy(second), expected);
  EXPECT_EQ(cache->GetStatistics().MeshesDecoded, decoded);
}

//------------------------------------------------------------------------------
TEST(FileSurface, RefusesWhatMakesNoSense)
{
  const auto file = MakeFile("refuses.gtn", 300, 2);
  FileSurface extractor(file);
  const double infinity = std::numeric_limits<double>::infinity();
  const auto expectRefused = [&](const std::string& words, auto&& change)
  {
    auto request = AskFor({ 1, 2 });
    change(request);
    const auto check = [&](auto&& ask)
    {
      try
      {
        ask();
        ADD_FAILURE() << words;
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.Code, ErrorCode::InvalidInput);
        const std::string text = error.what();
        EXPECT_EQ(text.find(file->GetPath() + ": "), 0u) << text;
        EXPECT_NE(text.find(words), std::string::npos) << text;
      }
    };
    check([&] { extractor.Extract(request); });
    check([&] { extractor.FindChunks(request); });
  };
  using Request = FileSurfaceRequest;
  expectRefused("no such point array", [](Request& r) { r.Array = 3; });
  expectRefused("no such point array", [](Request& r) { r.Array = MaterialArray; });
  expectRefused("'field' has no component 1", [](Request& r) { r.Component = 1; });
  expectRefused("'field' has no component -2", [](Request& r) { r.Component = -2; });
  expectRefused("'vector' has no component 3",
    [](Request& r)
    {
      r.Array = VectorArray;
      r.Component = 3;
    });
  expectRefused("no time step 2", [](Request& r) { r.Step = 2; });
  expectRefused("no such array", [](Request& r) { r.Arrays = { 0, 3 }; });
  expectRefused("no such array", [](Request& r) { r.Arrays = { 1, 0 }; });
  expectRefused("no such array", [](Request& r) { r.Arrays = { 1, 1 }; });
  for (const double bad : { infinity, -infinity, std::numeric_limits<double>::quiet_NaN() })
  {
    expectRefused("finite", [=](Request& r) { r.Options.Values = { bad }; });
    expectRefused("finite", [=](Request& r) { r.Options.Values = { 0, bad }; });
  }
  expectRefused("ascending", [](Request& r) { r.Options.Values = { 2, 1 }; });
  expectRefused("different", [](Request& r) { r.Options.Values = { 1, 1 }; });
  expectRefused("no such piece", [](Request& r) { r.Piece = 1; });
  expectRefused("no such piece", [](Request& r) { r.Pieces = 0; });
  EXPECT_GT(extractor.Extract(AskFor({ 1, 2 })).GetNumberOfTriangles(), 0u);
}

//------------------------------------------------------------------------------
TEST(FileSurface, StopsWhenAskedAndGoesOn)
{
  const auto file = MakeFile("stops.gtn", 64);
  for (const bool coarse : { false, true })
  {
    const auto one = coarse ? MakeTreeFile("stops-tree.gtn") : file;
    const auto tree = coarse ? std::make_shared<const MergeTree>(one->GetMergeTree()) : nullptr;
    FileSurface extractor(one, 0, tree, coarse ? 100 : 0);
    const auto expected = extractor.Extract(AskFor({ 3.3 })).GetTriangles();
    int stopped = 0;
    for (int after = 0; after < 50; ++after)
    {
      int left = after;
      double last = 0;
      try
      {
        const auto surface = extractor.Extract(AskFor({ 3.3 }),
          [&](double fraction)
          {
            EXPECT_GE(fraction, last);
            EXPECT_LE(fraction, 1);
            last = fraction;
            return left-- > 0;
          });
        EXPECT_EQ(surface.GetTriangles(), expected);
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.Code, ErrorCode::Aborted);
        ++stopped;
      }
    }
    EXPECT_GT(stopped, 0);
    EXPECT_EQ(extractor.Extract(AskFor({ 3.3 })).GetTriangles(), expected);
  }
}

//------------------------------------------------------------------------------
TEST(FileSurface, OfADamagedFileIsRightOrAnError)
{
  const auto file = MakeFile("sound.gtn", 64, 1, MakeCubes(3, 0.2));
  const auto request = AskFor({ 1.3 });
  const auto expected = GetTriangles(MakeSlowly(file, request), ScalarType::Float64);
  ASSERT_GT(expected.size(), 10u);
  std::ifstream in(file->GetPath(), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  const auto path = TempPath("file-surface-unsound.gtn");
  const auto isRight = [&](const std::string& content)
  {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
    try
    {
      FileSurface extractor(std::make_shared<const FileReader>(path));
      EXPECT_EQ(GetTriangles(extractor.Extract(request), ScalarType::Float64), expected);
      return true;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(std::string(error.what()).find(path + ": "), 0u) << error.what();
      return false;
    }
  };
  EXPECT_TRUE(isRight(bytes));
  std::size_t accepted = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    auto flipped = bytes;
    flipped[i] = static_cast<char>(flipped[i] ^ (1 << (i % 8)));
    accepted += isRight(flipped);
    if (i % 5 == 0)
    {
      EXPECT_FALSE(isRight(bytes.substr(0, i)));
    }
  }
  // Only where a chunk is that is not needed, or what nobody reads.
  EXPECT_LT(accepted, bytes.size() / 2);

  // Damaged after it was opened.
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
  FileSurface extractor(std::make_shared<const FileReader>(path));
  std::string zeros = bytes;
  std::fill(zeros.begin() + 64, zeros.end(), '\0');
  std::ofstream(path, std::ios::binary | std::ios::trunc) << zeros;
  try
  {
    extractor.Extract(request);
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Corrupt);
    EXPECT_EQ(std::string(error.what()).find(path + ": "), 0u) << error.what();
  }
}
}
