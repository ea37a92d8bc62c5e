// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The cache of decoded chunks: what is in it is not decoded again, it never holds more than it may,
// and nobody sees a difference but in time.

#include "gatunChunkCache.h"

#include "../gatunSanitizer.h"
#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunFileWriter.h"
#include "gatunParallel.h"
#include "gatunPieceDecoder.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace
{
using namespace gatun;
using namespace gatun::test;

constexpr std::uint64_t Unlimited = ~std::uint64_t{ 0 };
constexpr std::size_t CachedSteps = 21; // more than are walked at once
constexpr std::size_t Pieces = 8;

/** A file with several chunks and steps: a point and a cell array of doubles, one of few values. */
std::shared_ptr<const FileReader> MakeFile(
  const std::string& name, std::uint8_t keep, std::uint32_t chunkTets = 200)
{
  const auto path = (std::filesystem::path(GATUN_TEST_TEMP) / name).string();
  const auto mesh = MakeCubes(9, 0.2);
  std::vector<ArrayDescription> arrays(3);
  arrays[0].Name = "field";
  arrays[0].Type = ScalarType::Float64;
  arrays[1].Name = "noise";
  arrays[1].Where = Association::Cell;
  arrays[1].Type = ScalarType::Float64;
  arrays[2].Name = "few";
  arrays[2].Components = 2;
  WriterOptions options;
  options.ChunkSize = chunkTets;
  options.Keep = keep;
  options.KeyStepInterval = 19;
  FileWriter writer(path, mesh.GetInput(), arrays, options);
  std::mt19937 random(4);
  for (std::size_t step = 0; step < CachedSteps; ++step)
  {
    const auto time = static_cast<double>(step);
    std::vector<double> field, noise;
    std::vector<float> few;
    for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
    {
      field.push_back(std::sin(mesh.Coordinates[3 * p] + 0.1 * time) + mesh.Coordinates[3 * p + 1]);
      few.push_back(static_cast<float>(p % 3));
      few.push_back(static_cast<float>(step));
    }
    for (std::size_t t = 0; t < mesh.GetTets(); ++t)
    {
      noise.push_back(static_cast<double>(random() % 1000) + time);
    }
    const std::array<const void*, 3> values{ field.data(), noise.data(), few.data() };
    writer.WriteStep(values, {}, true, time);
  }
  writer.Finish();
  return std::make_shared<FileReader>(path);
}

/** All that a decoder gives for a request. */
struct Answer
{
  Answer(PieceDecoder& decoder, const PieceRequest& request)
  {
    decoder.SetRequest(request);
    const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
    const auto tets = static_cast<std::size_t>(decoder.GetNumberOfCells());
    this->Points.resize(3 * points);
    this->Ids.resize(4 * tets);
    this->GlobalPoints.resize(points);
    this->GlobalCells.resize(tets);
    this->PointGhosts.resize(points);
    this->CellGhosts.resize(tets);
    PieceTarget target;
    target.Points = this->Points.data();
    target.Connectivity = this->Ids.data();
    target.GlobalPointIds = this->GlobalPoints.data();
    target.GlobalCellIds = this->GlobalCells.data();
    target.PointGhosts = this->PointGhosts.data();
    target.CellGhosts = this->CellGhosts.data();
    for (const auto array : request.Arrays)
    {
      const auto& description = decoder.GetFile()->GetArrays()[array];
      const auto count = description.Where == Association::Point ? points : tets;
      this->Values.emplace_back(count * description.Components * SizeOf(description.Type));
    }
    for (auto& values : this->Values)
    {
      target.Arrays.push_back(values.data());
    }
    decoder.Fill(target);
  }

  bool operator==(const Answer&) const = default;

  std::vector<double> Points;
  std::vector<std::int64_t> Ids, GlobalPoints, GlobalCells;
  std::vector<unsigned char> PointGhosts, CellGhosts;
  std::vector<std::vector<std::uint8_t>> Values;
};

PieceRequest AskFor(const FileReader& file, std::size_t piece, std::size_t pieces, unsigned ghosts,
  std::size_t step, std::vector<std::uint32_t> arrays = { 0, 1, 2 })
{
  PieceRequest request;
  const auto chunks = file.GetChunks().size();
  for (auto c = piece * chunks / pieces; c < (piece + 1) * chunks / pieces; ++c)
  {
    request.Chunks.push_back(static_cast<std::uint32_t>(c));
  }
  request.GhostLevels = ghosts;
  request.Step = step;
  request.Arrays = std::move(arrays);
  return request;
}

/** Pieces, ghosts and steps in an order that nothing is gained from. */
std::vector<PieceRequest> MakeRequests(const FileReader& file)
{
  std::vector<PieceRequest> requests;
  std::mt19937 random(5);
  for (int i = 0; i < 15; ++i)
  {
    const std::size_t pieces = 1 + random() % 5;
    auto request = AskFor(
      file, random() % pieces, pieces, static_cast<unsigned>(random() % 3), random() % CachedSteps);
    if (random() % 3 == 0)
    {
      request.Arrays.erase(request.Arrays.begin() + random() % 3);
    }
    requests.push_back(request);
  }
  return requests;
}

std::vector<Answer> GetRightAnswers(
  const std::shared_ptr<const FileReader>& file, const std::vector<PieceRequest>& requests)
{
  std::vector<Answer> right;
  for (const auto& request : requests)
  {
    PieceDecoder decoder(std::make_shared<ChunkCache>(file, 0));
    right.emplace_back(decoder, request);
  }
  return right;
}

TEST(ChunkCache, PiecesWithGhostsDecodeEachChunkOnce)
{
  const auto file = MakeFile("cache_once.gtn", KeepNone);
  const auto chunks = file->GetChunks().size();
  ASSERT_GT(chunks, 2 * Pieces);
  const auto sweep = [&](const std::shared_ptr<ChunkCache>& cache)
  {
    const auto before = file->GetBytesRead();
    for (std::size_t p = 0; p < Pieces; ++p)
    {
      PieceDecoder decoder(cache);
      Answer(decoder, AskFor(*file, p, Pieces, 1, 0));
    }
    return file->GetBytesRead() - before;
  };
  file->GetStatistics(); // reads the tables, which are not counted here
  const auto all = std::make_shared<ChunkCache>(file, Unlimited);
  const auto bytes = sweep(all);
  EXPECT_EQ(all->GetStatistics().MeshesDecoded, chunks);
  EXPECT_EQ(all->GetStatistics().ArraysDecoded, 3 * chunks);
  EXPECT_GT(all->GetStatistics().MeshesFound, chunks);
  EXPECT_EQ(sweep(all), 0u) << "bytes read for what is there";
  EXPECT_EQ(all->GetStatistics().MeshesDecoded, chunks);

  const auto nothing = std::make_shared<ChunkCache>(file, 0);
  EXPECT_GT(sweep(nothing), 2 * bytes);
  EXPECT_GT(nothing->GetStatistics().MeshesDecoded, 2 * chunks);
  EXPECT_EQ(nothing->GetStatistics().Bytes, 0u);
  EXPECT_EQ(nothing->GetStatistics().MeshesFound, 0u);

  all->Clear();
  EXPECT_EQ(all->GetStatistics().Bytes, 0u);
  EXPECT_EQ(sweep(all), bytes);
}

TEST(ChunkCache, OtherArraysAndStepsDecodeNoMesh)
{
  const auto file = MakeFile("cache_arrays.gtn", KeepAll);
  const auto chunks = file->GetChunks().size();
  const auto cache = std::make_shared<ChunkCache>(file, Unlimited);
  PieceDecoder decoder(cache);
  Answer(decoder, AskFor(*file, 0, 1, 0, 0, { 1 }));
  EXPECT_EQ(cache->GetStatistics().ArraysDecoded, chunks);
  Answer(decoder, AskFor(*file, 0, 1, 0, 0, { 0, 1 }));
  EXPECT_EQ(cache->GetStatistics().ArraysDecoded, 2 * chunks);
  // One step on decodes one step.
  for (std::size_t step = 1; step < CachedSteps; ++step)
  {
    Answer(decoder, AskFor(*file, 0, 1, 0, step, { 0, 1 }));
    EXPECT_EQ(cache->GetStatistics().ArraysDecoded, (2 + 2 * step) * chunks);
  }
  // And those before are still there.
  Answer(decoder, AskFor(*file, 0, 1, 0, 7, { 0 }));
  EXPECT_EQ(cache->GetStatistics().ArraysDecoded, 2 * CachedSteps * chunks);
  EXPECT_EQ(cache->GetStatistics().MeshesDecoded, chunks);
}

TEST(ChunkCache, HoldsNeverMoreThanItsBudgetAndChangesNothing)
{
  for (const std::uint8_t keep : { KeepNone, KeepAll })
  {
    const auto file = MakeFile("cache_budget.gtn", keep);
    const auto requests = MakeRequests(*file);
    const auto right = GetRightAnswers(file, requests);
    for (const std::uint64_t budget : { std::uint64_t{ 1 }, std::uint64_t{ 2000 },
           std::uint64_t{ 30000 }, std::uint64_t{ 200000 }, std::uint64_t{ 500000 }, Unlimited })
    {
      const auto cache = std::make_shared<ChunkCache>(file, budget);
      PieceDecoder decoder(cache);
      for (std::size_t i = 0; i < requests.size(); ++i)
      {
        EXPECT_EQ(Answer(decoder, requests[i]), right[i]) << budget << ", request " << i;
        const auto now = cache->GetStatistics();
        ASSERT_LE(now.Bytes, now.PeakBytes);
        ASSERT_LE(now.PeakBytes, budget);
        // One by one parts go when there is no room for another, not all at once.
        EXPECT_TRUE(i < 4 || budget < 30000 || now.Bytes > budget / 2 || budget > 200000);
      }
      // A smaller budget holds at once.
      cache->SetBudget(budget / 3);
      EXPECT_LE(cache->GetStatistics().Bytes, budget / 3);
      EXPECT_EQ(Answer(decoder, requests[0]), right[0]);
      EXPECT_LE(cache->GetStatistics().PeakBytes, budget / 3);
    }
  }
}

TEST(ChunkCache, WhatFitsOfAMeshIsNotDecodedAgain)
{
  const auto file = MakeFile("cache_part.gtn", KeepNone);
  const auto chunks = file->GetChunks().size();
  const auto all = std::make_shared<ChunkCache>(file, Unlimited);
  PieceDecoder whole(all);
  Answer(whole, AskFor(*file, 0, 1, 0, 0, {}));
  // Going through more than fits, again and again, still finds what was left of the last time.
  const auto half = std::make_shared<ChunkCache>(file, all->GetStatistics().Bytes / 2);
  PieceDecoder decoder(half);
  Answer(decoder, AskFor(*file, 0, 1, 0, 0, {}));
  for (int i = 0; i < 3; ++i)
  {
    const auto before = half->GetStatistics().MeshesDecoded;
    Answer(decoder, AskFor(*file, 0, 1, 0, 0, {}));
    EXPECT_LT(half->GetStatistics().MeshesDecoded - before, 7 * chunks / 10);
  }
}

TEST(ChunkCache, CountsEveryByte)
{
#if defined(GATUN_HAS_SANITIZER) || !defined(__GLIBC__)
  GTEST_SKIP() << "only glibc tells how much memory is in use";
#else
  // It tells of its first arena only; other threads are to use that too.
  ::mallopt(M_ARENA_MAX, 1);
  for (const std::uint8_t keep : { KeepNone, KeepAll })
  {
    const auto file = MakeFile("cache_bytes.gtn", keep, 4000);
    const auto cache = std::make_shared<ChunkCache>(file, Unlimited);
    for (const std::size_t step : { 0, 1, 4, 8, 12, 16, 20 })
    {
      PieceDecoder decoder(cache);
      Answer(decoder, AskFor(*file, 0, 1, 0, step));
    }
    const auto inUse = []
    {
      const auto memory = ::mallinfo2();
      return static_cast<double>(memory.uordblks + memory.hblkhd);
    };
    const auto counted = static_cast<double>(cache->GetStatistics().Bytes);
    const auto before = inUse();
    // What a thread has freed it may keep for itself until it ends.
    std::thread([&] { cache->Clear(); }).join();
    const auto freed = before - inUse();
    EXPECT_GT(counted, 5e5);
    EXPECT_NEAR(freed / counted, 1, 0.02);
  }
#endif
}

TEST(ChunkCache, ServesSeveralThreads)
{
  const auto file = MakeFile("cache_threads.gtn", KeepAll);
  const auto requests = MakeRequests(*file);
  const auto right = GetRightAnswers(file, requests);
  for (const auto budget : { std::uint64_t{ 300000 }, Unlimited })
  {
    const auto cache = std::make_shared<ChunkCache>(file, budget);
    std::atomic<int> wrong{ 0 };
    ParallelFor(4 * requests.size(),
      [&](std::size_t i)
      {
        PieceDecoder decoder(cache);
        const auto r = (7 * i) % requests.size();
        wrong += Answer(decoder, requests[r]) != right[r];
        cache->SetBudget(budget - i);
      });
    EXPECT_EQ(wrong, 0);
    EXPECT_LE(cache->GetStatistics().PeakBytes, budget);
  }
}

TEST(ChunkCache, KeepsNothingOfWhatFailed)
{
  const auto path = (std::filesystem::path(GATUN_TEST_TEMP) / "cache_once.gtn").string();
  const auto file = MakeFile("cache_once.gtn", KeepNone);
  const auto cache = std::make_shared<ChunkCache>(file, Unlimited);
  PieceDecoder decoder(cache);
  const auto request = AskFor(*file, 0, 1, 0, 3);
  const Answer right(decoder, request);
  cache->Clear();
  int asked = 0;
  try
  {
    decoder.SetRequest(request);
    std::vector<double> points(3 * decoder.GetNumberOfPoints());
    PieceTarget target;
    target.Points = points.data();
    // A calling thread that is left without work is not asked.
    decoder.Fill(target, [&](double) { return ++asked < 3; });
    EXPECT_LT(asked, 3);
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Aborted);
  }
  EXPECT_EQ(Answer(decoder, request), right);
}
}
