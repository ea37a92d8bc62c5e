// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunHostileTrees_h
#define gatunHostileTrees_h

// A good file with a merge tree, which tests change, and all that can be asked of it.

#include "gatunHostile.h"
#include "gatunMergeDependencies.h"
#include "gatunPieceDecoder.h"
#include "gatunTreeImage.h"
#include "gatunVerifyFile.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace gatun::test
{
inline constexpr std::size_t Steps = 2;

/** Several chunks with shared points, unused points, steps, and two base meshes. */
inline const TreeImage& GetGoodImage()
{
  static const TreeImage image = []
  {
    const auto path = GetPath("sample.gtn");
    WriterOptions options;
    options.ChunkSize = 64;
    options.Keep = KeepAll;
    const auto sample = MakeTreeSample(3, Steps);
    const auto merges = static_cast<std::uint32_t>(sample.Tree.GetMerges().size());
    WriteTreeSample(path, sample, options, { merges / 3, merges / 2 });
    TreeImage made(path);
    // More merge counts than so few points get. The ranges of the last hold for all.
    made.Tree.MergeCounts = { 2, merges / 2, merges };
    for (auto& boxes : made.Tree.Boxes)
    {
      boxes.resize(3, boxes.back());
    }
    for (auto& step : made.TreeSteps)
    {
      for (auto& chunks : step.Ranges)
      {
        for (auto& ranges : chunks)
        {
          ranges.resize(3, ranges.back());
        }
      }
    }
    return made;
  }();
  return image;
}

inline PieceRequest AskForAll(const FileReader& file, std::size_t merges)
{
  PieceRequest request;
  request.Chunks.resize(file.GetChunks().size());
  std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
  request.WithUnusedPoints = true;
  if (file.GetNumberOfSteps() > 0)
  {
    request.Arrays.resize(file.GetArrays().size());
    std::iota(request.Arrays.begin(), request.Arrays.end(), 0u);
    request.Step = file.GetNumberOfSteps() - 1;
  }
  request.Merges = merges;
  request.Form = file.IsSurface() ? PieceForm::Original : PieceForm::Tetrahedra;
  return request;
}

inline void Decode(const std::shared_ptr<const FileReader>& file, const PieceRequest& request)
{
  PieceDecoder decoder(file);
  decoder.SetRequest(request);
  const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
  const auto tets = static_cast<std::size_t>(decoder.GetNumberOfCells());
  std::vector<double> coordinates(3 * points);
  std::vector<std::int64_t> ids(static_cast<std::size_t>(decoder.GetConnectivitySize()), -1);
  std::vector<std::int64_t> offsets(tets + 1, -1);
  std::vector<std::uint8_t> types(tets);
  std::vector<unsigned char> ghosts(points);
  std::vector<Bytes> values;
  PieceTarget target;
  target.Points = coordinates.data();
  target.Connectivity = ids.data();
  target.PointGhosts = ghosts.data();
  if (!decoder.IsTetrahedral())
  {
    target.Offsets = offsets.data();
    target.Types = types.data();
  }
  for (const auto a : request.Arrays)
  {
    const auto& array = file->GetArrays()[a];
    values.emplace_back(
      (array.Where == Association::Point ? points : tets) * array.Components * SizeOf(array.Type));
    target.Arrays.push_back(values.back().data());
  }
  decoder.Fill(target);
  if (!decoder.IsTetrahedral())
  {
    ASSERT_TRUE(std::is_sorted(offsets.begin(), offsets.end()) && offsets[0] == 0);
    ASSERT_EQ(static_cast<std::size_t>(offsets.back()), ids.size());
  }
  for (const auto id : ids)
  {
    ASSERT_TRUE(id >= 0 && static_cast<std::size_t>(id) < points);
  }
}

/** All that can be asked of a file with a tree: meshes after merges, whole and in pieces, bounds,
 * dependencies, base meshes. */
inline void ReadTree(const std::shared_ptr<const FileReader>& file)
{
  const auto tree = std::make_shared<const MergeTree>(file->GetMergeTree());
  const auto all = tree->GetMerges().size();
  for (const auto merges : std::set<std::size_t>{ 0, std::min<std::size_t>(1, all), all / 2, all })
  {
    auto request = AskForAll(*file, merges);
    request.Tree = tree;
    Decode(file, request);
    for (std::size_t chunk = 0; chunk < file->GetChunks().size(); ++chunk)
    {
      file->GetChunkBounds(chunk, merges);
      for (const auto a : request.Arrays)
      {
        file->GetChunkRanges(a, request.Step, chunk, merges);
      }
    }
    if (request.Chunks.size() > 1)
    {
      request.Chunks = { 0 };
      request.GhostLevels = 1;
      Decode(file, request);
    }
  }
  if (file->HasDependencies())
  {
    file->ReadDependencies(*tree);
  }
  for (std::size_t level = 0; level < file->GetLevels().size(); ++level)
  {
    ReadTree(file->OpenLevel(level));
  }
}

inline void ReadTree(const std::string& path)
{
  ReadTree(std::make_shared<const FileReader>(path));
}

/** Changes a good file and expects that reading its tree fails like this, and verifying too. */
inline void ExpectRefused(const std::string& what, const std::function<void(TreeImage&)>& change,
  ErrorCode code = ErrorCode::Corrupt, const TreeImage& good = GetGoodImage())
{
  auto image = good;
  change(image);
  const auto path = PutFile("changed.gtn", image.Build());
  EXPECT_GATUN_ERROR(code, path, what, [&] { ReadTree(path); });
  EXPECT_GATUN_ERROR(code, path, what, [&] { VerifyFile(FileReader(path)); });
}
}

#endif
