// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunVerifyFile.h"

#include "gatunBoundaryCheck.h"
#include "gatunChunkCache.h"
#include "gatunDependencyCheck.h"
#include "gatunFileReaderInternals.h"
#include "gatunMeshDependencies.h"
#include "gatunPartDecoder.h"
#include "gatunPieceCells.h"
#include "gatunPieceDecoder.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gatun
{
namespace
{
/** Checks that original numbers are distinct. */
class PermutationCheck
{
public:
  PermutationCheck(const FileReader& file, std::uint64_t count, const char* what)
    : File(file)
    , What(what)
    , Seen(static_cast<std::size_t>(count), false)
  {
  }

  void Add(std::int64_t number)
  {
    auto seen = this->Seen[static_cast<std::size_t>(number)];
    if (seen)
    {
      InternalsOf(this->File)
        .File.Fail(ErrorCode::Corrupt,
          "the original order is damaged: it names " + (this->What + std::to_string(number)) +
            " twice");
    }
    seen = true;
  }

private:
  const FileReader& File;
  const char* What;
  std::vector<bool> Seen;
};

/** Counts the cells of each type. */
class TypeCheck
{
public:
  /** types: of the cells, or null if all are tetrahedra. */
  void Add(const std::uint8_t* types, std::size_t cells)
  {
    for (std::size_t c = 0; c < cells; ++c)
    {
      ++this->Counts[types ? types[c] : TetraType];
    }
  }

  /** Throws if the file claims other numbers. */
  void Compare(const FileReader& file) const
  {
    for (const auto& type : file.GetCellTypes())
    {
      const auto count = this->Counts[type.Type];
      if (count != type.Cells)
      {
        InternalsOf(file).File.Fail(ErrorCode::Corrupt,
          "there are " + std::to_string(count) + " cells of type " + std::to_string(type.Type) +
            " instead of " + std::to_string(type.Cells));
      }
    }
  }

private:
  std::array<std::uint64_t, 256> Counts{};
};

/** For decoders, which do not own the file then. */
std::shared_ptr<const FileReader> Borrow(const FileReader& file)
{
  return { &file, [](const FileReader*) {} };
}

/** Decodes the points of all blocks, including those that no chunk needs. */
void VerifyBlocks(const PartDecoder& parts)
{
  const auto& tables = parts.Content().GetTables();
  const auto count = tables.GetNumberOfBlocks();
  for (std::size_t block = 0; block <= count; ++block) // the unused points are the last block
  {
    if (tables.GetBlock(block)->Points > 0)
    {
      parts.GetBlockPoints(static_cast<std::uint32_t>(block));
    }
  }
}

/** Decodes what pieces of original cells do not need: the tetrahedra of other cells and the order
 * of corners. */
void VerifyCells(const PartDecoder& parts, std::span<const std::uint32_t> chunks)
{
  const bool keepsCorners = (parts.GetFile()->GetKeptOrder() & KeepCorners) != 0;
  const auto pointsOf = [&](std::uint32_t block) { return parts.GetBlockPoints(block); };
  for (const auto chunk : chunks)
  {
    const bool isSplit = !parts.GetFile()->GetChunks()[chunk].IsTetrahedral;
    if (!isSplit && !keepsCorners)
    {
      continue;
    }
    auto mesh = parts.FindMesh(chunk);
    mesh = mesh ? mesh : parts.DecodeMesh(chunk, pointsOf);
    if (isSplit)
    {
      parts.SplitCells(chunk, *mesh);
    }
    if (keepsCorners)
    {
      parts.GetCells(chunk, *mesh, true);
    }
  }
}

/** Decodes the dependencies of merges. Throws if other merges can be done together than by those
 * that doing all merges gives. Large meshes are left out: that takes the memory for all of them. */
void VerifyDependencies(const std::shared_ptr<const FileReader>& file, const MergeTree& tree,
  const std::function<bool(double)>& progress)
{
  constexpr std::uint64_t largeMesh = 16'000'000;
  const auto dependencies = file->ReadDependencies(tree);
  const auto cells = file->IsSurface() ? file->GetNumberOfCells() : file->GetNumberOfTets();
  const auto found = cells <= largeMesh ? FindDependencies(file, tree, progress) : std::nullopt;
  if (found && !AreEquivalent(dependencies, *found))
  {
    InternalsOf(*file).File.Fail(
      ErrorCode::Corrupt, "the dependencies of merges are not those of the mesh");
  }
}

/** Decodes the merges and their dependencies. */
void VerifyTree(const FileReader& file, const std::function<bool(double)>& progress)
{
  const MergeTree tree = file.GetMergeTree();
  if (file.HasDependencies())
  {
    VerifyDependencies(Borrow(file), tree, progress);
  }
}

/** Decodes all streams once, some chunks at a time. */
void VerifyStreams(const FileReader& file, const std::function<bool(double)>& progress)
{
  // Enough for the meshes of these chunks, which all time steps need.
  constexpr std::size_t chunksAtOnce = 16;
  constexpr std::uint64_t budget = std::uint64_t{ 128 } << 20;
  const auto cache = std::make_shared<ChunkCache>(Borrow(file), budget);
  const PartDecoder parts(cache);
  VerifyBlocks(parts);
  const auto chunks = file.GetChunks().size();
  const auto rounds = std::max<std::size_t>(1, (chunks + chunksAtOnce - 1) / chunksAtOnce);
  // All values are in the mesh with all cells, which is verified, too.
  const bool hasAll = file.HasAllCells();
  const auto steps = hasAll ? std::max<std::size_t>(1, file.GetNumberOfSteps()) : 1;
  const auto& content = InternalsOf(file);
  PermutationCheck points(file, content.Meta.Points, "point ");
  PermutationCheck cells(file, content.GetTables().GetNumberOfCells(), "cell ");
  TypeCheck types;
  std::uint64_t pointsFound = 0;
  BoundaryCheck boundary(file);
  for (std::size_t round = 0; round < rounds; ++round)
  {
    PieceRequest request;
    for (auto c = round * chunksAtOnce; c < std::min(chunks, (round + 1) * chunksAtOnce); ++c)
    {
      request.Chunks.push_back(static_cast<std::uint32_t>(c));
    }
    for (std::uint32_t a = 0; hasAll && file.GetNumberOfSteps() > 0 && a < file.GetArrays().size();
         ++a)
    {
      request.Arrays.push_back(a);
    }
    request.WithUnusedPoints = round == 0;
    request.Form = PieceForm::Original;
    PieceDecoder decoder(cache);
    boundary.BeginPart(rounds > 1);
    for (std::size_t step = 0; step < steps; ++step)
    {
      request.Step = step;
      decoder.SetRequest(request);
      const auto pointCount = static_cast<std::size_t>(decoder.GetNumberOfPoints());
      const auto cellCount = static_cast<std::size_t>(decoder.GetNumberOfCells());
      std::vector<std::int64_t> pointIds(pointCount), cellIds(cellCount);
      std::vector<unsigned char> pointGhosts(pointCount);
      std::vector<std::vector<std::uint8_t>> values;
      const bool needsPoints = file.HasBoundary() || file.HasMovingPoints();
      Bytes coordinates(needsPoints ? pointCount * 3 * SizeOf(file.GetCoordinateType()) : 0);
      PieceCells memory(decoder.IsTetrahedral(), cellCount,
        static_cast<std::size_t>(decoder.GetConnectivitySize()),
        static_cast<std::size_t>(decoder.GetFacesSize()));
      PieceTarget target = memory.GetTarget();
      target.Points = coordinates.empty() ? nullptr : coordinates.data();
      target.GlobalPointIds = pointIds.data();
      target.GlobalCellIds = cellIds.data();
      target.PointGhosts = pointGhosts.data();
      for (const auto a : request.Arrays)
      {
        const auto& array = file.GetArrays()[a];
        values.emplace_back((array.Where == Association::Point ? pointCount : cellCount) *
          array.Components * SizeOf(array.Type));
        target.Arrays.push_back(values.back().data());
      }
      const auto first = static_cast<double>(round * steps + step);
      const auto all = static_cast<double>(rounds * steps);
      decoder.Fill(
        target, [&](double part) { return !progress || progress((first + part) / all); });
      for (std::size_t p = 0; step == 0 && p < pointCount; ++p)
      {
        if (pointGhosts[p] == 0)
        {
          ++pointsFound;
          points.Add(pointIds[p]);
        }
      }
      for (std::size_t c = 0; step == 0 && c < cellCount; ++c)
      {
        cells.Add(cellIds[c]);
      }
      types.Add(target.Types, step == 0 ? cellCount : 0);
      boundary.AddStep(request, target, pointCount, cellCount);
    }
    VerifyCells(parts, request.Chunks);
  }
  types.Compare(file);
  if (pointsFound != file.GetNumberOfPoints())
  {
    InternalsOf(file).File.Fail(ErrorCode::Corrupt,
      "there are " + std::to_string(pointsFound) + " points instead of " +
        std::to_string(file.GetNumberOfPoints()));
  }
  boundary.Compare();
}
}

//------------------------------------------------------------------------------
bool VerifyFile(const FileReader& file, const std::function<bool(double)>& progress)
{
  const FileReader::Internals& content = InternalsOf(file);
  try
  {
    if (!file.HasAllCells()) // the mesh with all cells is verified, too
    {
      VerifyStreams(file, progress);
      return true;
    }
    content.File.CheckSections([&](double done) { return !progress || progress(0.1 * done); });
    for (std::size_t step = 0; step < file.GetNumberOfSteps(); ++step)
    {
      file.GetFieldData(step);
    }
    content.GetTables().CheckGroups();
    content.CheckLayers();
    VerifyStreams(file, [&](double done) { return !progress || progress(0.1 + 0.9 * done); });
    if (file.HasMergeTree())
    {
      VerifyTree(file, [&](double) { return !progress || progress(1); });
    }
    if (file.HasBoundary() &&
      !VerifyFile(*file.OpenBoundary(), [&](double) { return !progress || progress(1); }))
    {
      return false;
    }
    for (std::size_t level = 0; level < file.GetLevels().size(); ++level)
    {
      const auto base = file.OpenLevel(level);
      if (!VerifyFile(*base, [&](double) { return !progress || progress(1); }))
      {
        return false;
      }
    }
    for (std::size_t mesh = 1; mesh < file.GetNumberOfMeshes(); ++mesh)
    {
      if (!VerifyFile(*file.OpenMesh(mesh), [&](double) { return !progress || progress(1); }))
      {
        return false;
      }
    }
    return true;
  }
  catch (const Error& error)
  {
    if (error.Code == ErrorCode::Aborted)
    {
      return false;
    }
    throw;
  }
}
}
