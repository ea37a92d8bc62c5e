// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzzFiles.h"

#include "gatunByteSource.h"
#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunFileReaderInternals.h"
#include "gatunMergeDependencies.h"
#include "gatunParallel.h"
#include "gatunPieceDecoder.h"
#include "gatunVerifyFile.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <numeric>
#include <vector>

namespace gatun::fuzz
{
namespace
{
// A file that announces more is opened, but not decoded, to keep runs fast.
constexpr std::uint64_t MostTets = 2048;
constexpr std::uint64_t MostPoints = 4096;
constexpr std::uint64_t MostValues = 1u << 16;
constexpr std::size_t MostChunks = 12;
constexpr std::size_t MostSteps = 5;
constexpr std::size_t MostLevels = 3;
constexpr std::size_t MostMeshes = 5;

[[noreturn]] void Stop(const std::string& why)
{
  std::cerr << why << std::endl;
  std::abort();
}

/** Tetrahedra, or cells of a surface. */
std::uint64_t CountCells(const FileReader& file)
{
  return file.IsSurface() ? file.GetNumberOfCells() : file.GetNumberOfTets();
}

bool IsSmall(const FileReader& file)
{
  std::uint64_t values = 0;
  for (const auto& array : file.GetArrays())
  {
    values += array.Components *
      (array.Where == Association::Point ? file.GetNumberOfPoints() : CountCells(file));
  }
  return CountCells(file) <= MostTets && file.GetNumberOfPoints() <= MostPoints &&
    file.GetChunks().size() <= MostChunks && file.GetNumberOfSteps() <= MostSteps &&
    values <= MostValues;
}

void DecodePiece(PieceDecoder& decoder, const FileReader& file, const PieceRequest& request)
{
  decoder.SetRequest(request);
  if (decoder.GetConnectivitySize() > MostValues)
  {
    return;
  }
  const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
  const auto cells = static_cast<std::size_t>(decoder.GetNumberOfCells());
  std::vector<double> coordinates(3 * points);
  std::vector<std::int64_t> connectivity(
    static_cast<std::size_t>(decoder.GetConnectivitySize()), -1);
  std::vector<std::int64_t> pointIds(points, -1), cellIds(cells, -1), offsets(cells + 1, -1);
  std::vector<std::uint8_t> types(cells);
  std::vector<unsigned char> pointGhosts(points, 77), cellGhosts(cells, 77);
  std::vector<std::vector<std::uint8_t>> values;
  PieceTarget target;
  target.Points = coordinates.data();
  target.Connectivity = connectivity.data();
  if (!decoder.IsTetrahedral())
  {
    target.Offsets = offsets.data();
    target.Types = types.data();
  }
  target.GlobalPointIds = pointIds.data();
  target.GlobalCellIds = cellIds.data();
  target.PointGhosts = pointGhosts.data();
  target.CellGhosts = cellGhosts.data();
  for (const auto a : request.Arrays)
  {
    const auto& array = file.GetArrays()[a];
    values.emplace_back(
      (array.Where == Association::Point ? points : cells) * array.Components * SizeOf(array.Type));
    target.Arrays.push_back(values.back().data());
  }
  decoder.Fill(target);

  const auto allBelow = [](const std::vector<std::int64_t>& ids, std::uint64_t end)
  {
    return std::all_of(ids.begin(), ids.end(),
      [&](std::int64_t id) { return id >= 0 && static_cast<std::uint64_t>(id) < end; });
  };
  // If some cells are left out, the others keep the numbers that they have in the whole mesh.
  const auto& meta = InternalsOf(file).Meta;
  const auto ofCells =
    file.IsSurface() ? InternalsOf(file).GetTables().GetNumberOfCells() : meta.Tets;
  if (!allBelow(connectivity, points) || !allBelow(pointIds, meta.Points) ||
    !allBelow(cellIds, ofCells) ||
    (!decoder.IsTetrahedral() && !allBelow(offsets, connectivity.size() + 1)))
  {
    Stop("a decoded id is out of range");
  }
  const auto isFlag = [](unsigned char ghost) { return ghost <= 1; };
  if (!std::all_of(pointGhosts.begin(), pointGhosts.end(), isFlag) ||
    !std::all_of(cellGhosts.begin(), cellGhosts.end(), isFlag))
  {
    Stop("a ghost mark was not written");
  }
}

/** After a number of merges, if any. */
void DecodePieces(const std::shared_ptr<const FileReader>& file,
  const std::shared_ptr<const MergeTree>& tree, std::size_t merges)
{
  PieceRequest all;
  all.Tree = tree;
  all.Merges = merges;
  all.Form = file->IsSurface() ? PieceForm::Original : PieceForm::Tetrahedra;
  all.Chunks.resize(file->GetChunks().size());
  std::iota(all.Chunks.begin(), all.Chunks.end(), 0u);
  all.WithUnusedPoints = true;
  if (file->GetNumberOfSteps() > 0)
  {
    all.Arrays.resize(file->GetArrays().size());
    std::iota(all.Arrays.begin(), all.Arrays.end(), 0u);
  }
  PieceDecoder decoder(file);
  const auto steps = std::max<std::size_t>(1, file->GetNumberOfSteps());
  all.Step = steps - 1;
  DecodePiece(decoder, *file, all);
  if (steps > 1)
  {
    all.Step = 0;
    DecodePiece(decoder, *file, all);
  }
  const std::size_t halves = all.Chunks.size() > 1 ? 2 : 0;
  for (std::size_t half = 0; half < halves; ++half)
  {
    auto request = all;
    request.Chunks.clear();
    for (auto c = half * all.Chunks.size() / 2; c < (half + 1) * all.Chunks.size() / 2; ++c)
    {
      request.Chunks.push_back(static_cast<std::uint32_t>(c));
    }
    request.GhostLevels = static_cast<unsigned>(1 - half);
    request.WithUnusedPoints = half == 0;
    PieceDecoder one(file);
    DecodePiece(one, *file, request);
  }
}

/** Meshes after merges, what holds for their chunks, and base meshes with the same. */
void DecodeTree(const std::shared_ptr<const FileReader>& file)
{
  if (!IsSmall(*file))
  {
    return;
  }
  const auto tree = std::make_shared<const MergeTree>(file->GetMergeTree());
  const auto all = tree->GetMerges().size();
  DecodePieces(file, tree, 0);
  if (all > 1)
  {
    DecodePieces(file, tree, 1 + all / 3);
  }
  if (all > 0)
  {
    DecodePieces(file, tree, all);
    for (std::size_t chunk = 0; chunk < file->GetChunks().size(); ++chunk)
    {
      file->GetChunkBounds(chunk, all);
      for (std::size_t array = 0; array < file->GetArrays().size(); ++array)
      {
        for (std::size_t step = 0; step < file->GetNumberOfSteps(); ++step)
        {
          file->GetChunkRanges(array, step, chunk, all / 2);
        }
      }
    }
  }
  if (file->HasDependencies())
  {
    file->ReadDependencies(*tree);
  }
  for (std::size_t level = 0; level < std::min(MostLevels, file->GetLevels().size()); ++level)
  {
    DecodeTree(file->OpenLevel(level)); // which has no base meshes itself
  }
  if (file->HasBoundary())
  {
    DecodeTree(file->OpenBoundary()); // which has neither
  }
}
}

void UseOneThread()
{
  SetNumberOfThreads(1);
}

bool DecodeFile(std::span<const std::uint8_t> bytes)
{
  const auto check = [&](const Error& error)
  {
    const std::string what = error.what();
    if (error.Path != FileName || !what.starts_with(FileName) || what.size() < FileName.size() + 8)
    {
      Stop("an error does not name the file: " + what);
    }
    if (error.Code != ErrorCode::NotGatun && error.Code != ErrorCode::UnsupportedVersion &&
      error.Code != ErrorCode::Truncated && error.Code != ErrorCode::Corrupt)
    {
      Stop("an error has the wrong code: " + what);
    }
  };
  std::shared_ptr<const FileReader> file;
  try
  {
    file = std::make_shared<FileReader>(std::make_shared<const MemorySource>(bytes), FileName);
    file->GetStatistics();
    for (std::size_t i = 0; i < std::min(MostSteps, file->GetNumberOfSteps()); ++i)
    {
      file->GetFieldData(i);
    }
  }
  catch (const Error& error)
  {
    check(error);
    return false;
  }
  if (!IsSmall(*file))
  {
    return false;
  }
  std::string failure;
  try
  {
    DecodeTree(file);
    for (std::size_t mesh = 1; mesh < std::min(MostMeshes, file->GetNumberOfMeshes()); ++mesh)
    {
      DecodeTree(file->OpenMesh(mesh));
    }
  }
  catch (const Error& error)
  {
    check(error);
    failure = error.what();
  }
  const bool decodes = failure.empty();
  try
  {
    // Verifying decodes all once more, so a file that is known to be wrong goes without mostly.
    if (decodes || file->GetStatistics().FileBytes % 8 == 0)
    {
      VerifyFile(*file);
      if (!decodes)
      {
        Stop("a file that does not decode was verified: " + failure);
      }
    }
  }
  catch (const Error& error)
  {
    check(error);
    return false;
  }
  return decodes;
}
}
