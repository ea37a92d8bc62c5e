// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartition.h"

#include "gatunBisection.h"
#include "gatunLayerPartition.h"
#include "gatunLocalIds.h"
#include "gatunMeshCheck.h"
#include "gatunMorton.h"
#include "gatunParallel.h"
#include "gatunTetSeparation.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <numeric>
#include <span>
#include <utility>

namespace gatun
{
namespace
{
constexpr std::size_t PointsPerTask = 1u << 16;

// Buckets of layers with less than this fraction of a chunk are joined with others.
constexpr std::uint32_t SmallestPart = 16;

/** All cells as one bucket. */
LayerBuckets MakeOneBucket(const MeshAccess& mesh)
{
  LayerBuckets all;
  all.Cells.resize(static_cast<std::size_t>(mesh.GetMesh().Cells));
  std::iota(all.Cells.begin(), all.Cells.end(), 0u);
  all.Start.assign(1, 0);
  if (!all.Cells.empty())
  {
    all.Start.push_back(all.Cells.size());
  }
  return all;
}

/** The number of cells of about limit items, if all cells have so many items. */
std::uint32_t CountChunkCells(std::uint64_t cells, std::uint64_t items, std::uint32_t limit)
{
  const auto ratio = static_cast<double>(std::max<std::uint64_t>(cells, 1)) /
    static_cast<double>(std::max<std::uint64_t>(items, 1));
  return static_cast<std::uint32_t>(std::max(1.0, static_cast<double>(limit) * ratio));
}

/** The same for cells of a mesh with so many tetrahedra. */
std::uint32_t CountChunkCells(
  const MeshAccess& mesh, std::uint64_t cells, std::uint64_t tets, const ChunkLimits& limits)
{
  const auto ofTets = CountChunkCells(cells, tets, limits.Size);
  if (limits.Points == 0)
  {
    return ofTets;
  }
  // Chunks have more points a cell than the mesh, because they share points. If many points of the
  // mesh are unused, there are more cells.
  const auto& all = mesh.GetMesh();
  const auto ofPoints = CountChunkCells(all.Cells, all.Points, limits.Points - limits.Points / 8);
  return std::clamp(ofPoints, ofTets, limits.Size);
}

/** Finds the layers and their buckets. */
LayerBuckets MakeBuckets(const MeshAccess& mesh, const ChunkLimits& limits, LayerPartition& layers)
{
  const LayerValues values(layers.Array, layers.Request);
  layers.Result.Array = layers.Request.Array;
  layers.Result.Component = layers.Request.Component;
  layers.Result.Spacing = layers.Request.Spacing;
  layers.Result.Bounds = FindLayerBounds(mesh, values, layers.Request.Spacing,
    layers.Request.Count > 0 ? layers.Request.Count : GetDefaultLayers(mesh.EstimateTets()));
  const auto chunkCells = CountChunkCells(mesh, mesh.GetMesh().Cells, mesh.EstimateTets(), limits);
  return SortByLayers(mesh, values, layers.Result, chunkCells / SmallestPart);
}

/** The number of cells of a chunk of each bucket. */
std::vector<std::uint32_t> FindChunkCells(
  const MeshAccess& mesh, const LayerBuckets& buckets, const ChunkLimits& limits)
{
  std::vector<std::uint32_t> counts(buckets.Start.size() - 1, limits.Size);
  if (!mesh.IsTetrahedral())
  {
    ParallelFor(counts.size(),
      [&](std::size_t b)
      {
        const std::span cells(
          buckets.Cells.data() + buckets.Start[b], buckets.Start[b + 1] - buckets.Start[b]);
        counts[b] = CountChunkCells(mesh, cells.size(), mesh.EstimateTets(cells), limits);
      });
  }
  return counts;
}

/** The use of a shared point by a chunk. */
struct Use
{
  std::uint32_t Point;
  std::uint32_t Chunk;
  auto operator<=>(const Use&) const = default;
};

/** Which chunks use a point: none, if it is 0; or one with the number plus 1, and others with this
 * flag. */
using Users = std::uint32_t;
constexpr Users UsedByOthers = 0x80000000u;

/** Finds the users of points. Returns for each chunk the points that it uses after another one has
 * been noted, in any order. */
std::vector<std::vector<std::uint32_t>> FindUsers(
  const MeshAccess& mesh, const Partition& parts, std::span<std::atomic<Users>> users)
{
  std::vector<std::vector<std::uint32_t>> shared(parts.GetChunkCount());
  ParallelFor(shared.size(),
    [&](std::size_t c)
    {
      LocalIds others(0);
      const auto self = static_cast<Users>(c + 1);
      const auto note = [&](std::uint32_t point)
      {
        auto& user = users[point];
        Users noted = user.load(std::memory_order_relaxed);
        if (noted == 0 && user.compare_exchange_strong(noted, self, std::memory_order_relaxed))
        {
          return;
        }
        if ((noted & ~UsedByOthers) != self)
        {
          if ((noted & UsedByOthers) == 0)
          {
            user.fetch_or(UsedByOthers, std::memory_order_relaxed);
          }
          others.Add(point);
        }
      };
      // Which points are not yet noted is random, so that they are collected without branches.
      std::array<std::uint32_t, 1024> found;
      const std::function<void(std::size_t)> noteFound = [&](std::size_t count)
      { std::for_each(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), note); };
      std::size_t count = 0;
      const auto add = [&](std::uint64_t point)
      {
        found[count] = static_cast<std::uint32_t>(point);
        count += (users[point].load(std::memory_order_relaxed) & ~UsedByOthers) != self;
        if (count == found.size())
        {
          noteFound(count);
          count = 0;
        }
      };
      const auto cells = parts.GetCells(c);
      for (std::size_t i = 0; i < cells.size(); ++i)
      {
        mesh.FetchAhead(cells, i);
        mesh.ForEachPoint(cells[i], add);
      }
      noteFound(count);
      shared[c] = others.GetPoints();
    });
  return shared;
}

/** Finds the own and the unused points, and returns the uses of shared points by point and chunk.
 */
std::vector<Use> FindShared(const MeshAccess& mesh, Partition& out)
{
  std::vector<std::atomic<Users>> users(static_cast<std::size_t>(mesh.GetMesh().Points));
  const auto others = FindUsers(mesh, out, users);
  out.OwnPoints.assign(others.size(), {});
  out.UnusedPoints.clear();
  std::vector<Use> all;
  for (std::uint32_t p = 0; p < users.size(); ++p)
  {
    const Users noted = users[p].load(std::memory_order_relaxed);
    const std::uint32_t chunk = (noted & ~UsedByOthers) - 1;
    if (noted == 0)
    {
      out.UnusedPoints.push_back(p);
    }
    else if (noted == chunk + 1)
    {
      out.OwnPoints[chunk].push_back(p);
    }
    else
    {
      all.push_back({ p, chunk });
    }
  }
  for (std::uint32_t c = 0; c < others.size(); ++c)
  {
    for (const auto p : others[c])
    {
      all.push_back({ p, c });
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/** Divides chunks with too many points. Returns whether there were some. */
bool DivideLarge(const MeshAccess& mesh, std::uint32_t most, const std::vector<Use>& uses,
  const std::function<bool(double)>& progress, Partition& out)
{
  std::vector<std::uint64_t> points(out.GetChunkCount());
  std::transform(out.OwnPoints.begin(), out.OwnPoints.end(), points.begin(),
    [](const auto& own) { return own.size(); });
  for (const auto& use : uses)
  {
    ++points[use.Chunk];
  }
  std::vector<std::uint32_t> partCells(points.size());
  bool hasLarge = false;
  for (std::size_t c = 0; c < points.size(); ++c)
  {
    const auto cells = static_cast<std::uint32_t>(out.ChunkStart[c + 1] - out.ChunkStart[c]);
    const bool isLarge = points[c] > most && cells > 1;
    hasLarge = hasLarge || isLarge;
    partCells[c] = isLarge ? CountChunkCells(cells, points[c], most) : cells;
  }
  if (hasLarge)
  {
    out.ChunkStart = Bisect(mesh, out.Cells, out.ChunkStart, partCells, progress);
  }
  return hasLarge;
}

struct PlacedPoint
{
  std::uint64_t Morton;
  std::uint32_t Point;
  auto operator<=>(const PlacedPoint&) const = default;
};

/** Sorts the shared points by the chunks that use them. */
void GroupShared(const MeshAccess& mesh, const std::vector<Use>& uses, Partition& out)
{
  const auto box = FindBox(mesh);
  std::map<ChunkGroup, std::vector<PlacedPoint>> groups;
  ChunkGroup chunks;
  for (std::size_t i = 0; i < uses.size();)
  {
    const auto point = uses[i].Point;
    chunks.clear();
    for (; i < uses.size() && uses[i].Point == point; ++i)
    {
      chunks.push_back(uses[i].Chunk);
    }
    groups[chunks].push_back({ FindMortonCode(mesh, box, point), point });
  }
  for (auto& [users, points] : groups)
  {
    std::sort(points.begin(), points.end());
    auto& sorted = out.SharedPoints[users];
    sorted.reserve(points.size());
    for (const auto& p : points)
    {
      sorted.push_back(p.Point);
    }
    points = {};
  }
}
}

//------------------------------------------------------------------------------
Bounds FindBox(const MeshAccess& mesh)
{
  const auto points = mesh.GetMesh().Points;
  std::vector<Bounds> boxes((points + PointsPerTask - 1) / PointsPerTask);
  ParallelFor(boxes.size(),
    [&](std::size_t task)
    {
      const auto end = std::min<std::uint64_t>(points, (task + 1) * PointsPerTask);
      for (std::uint64_t p = task * PointsPerTask; p < end; ++p)
      {
        mesh.Include(boxes[task], p);
      }
    });
  Bounds all;
  for (const auto& box : boxes)
  {
    all.Include(box);
  }
  return all;
}

//------------------------------------------------------------------------------
std::uint32_t GetDefaultChunkSize(std::uint64_t number, bool hasLayers)
{
  // Points between chunks are expensive, and small chunks keep more threads busy, with less memory
  // for each of them.
  constexpr std::uint64_t large = 1'000'000;
  constexpr std::uint64_t huge = 10'000'000;
  const std::uint32_t most = number > huge ? 262144 : number > large ? 131072 : 65536;
  // An isosurface needs few chunks of a file with layers.
  return hasLayers ? most / 4 : most;
}

//------------------------------------------------------------------------------
std::uint64_t FindMortonCode(const MeshAccess& mesh, const Bounds& box, std::uint64_t point)
{
  return GetMortonCode(box,
    { mesh.GetCoordinate(point, 0), mesh.GetCoordinate(point, 1), mesh.GetCoordinate(point, 2) });
}

//------------------------------------------------------------------------------
Partition MakePartition(const MeshAccess& mesh, const ChunkLimits& limits,
  const std::function<bool(double)>& progress, LayerPartition* layers)
{
  CheckCells(mesh);
  Partition result;
  auto buckets = layers ? MakeBuckets(mesh, limits, *layers) : MakeOneBucket(mesh);
  SeparateTets(mesh, buckets);
  const auto chunkCells = FindChunkCells(mesh, buckets, limits);
  result.Cells = std::move(buckets.Cells);
  result.ChunkStart = Bisect(mesh, result.Cells, buckets.Start, chunkCells, progress);
  auto uses = FindShared(mesh, result);
  while (limits.Points > 0 && DivideLarge(mesh, limits.Points, uses, progress, result))
  {
    uses = FindShared(mesh, result);
  }
  if (layers)
  {
    const LayerValues values(layers->Array, layers->Request);
    layers->Result.Chunks.resize(result.GetChunkCount());
    ParallelFor(result.GetChunkCount(),
      [&](std::size_t c)
      {
        layers->Result.Chunks[c] = FindLayerSpan(mesh, values, layers->Result,
          std::span(result.Cells)
            .subspan(result.ChunkStart[c], result.ChunkStart[c + 1] - result.ChunkStart[c]));
      });
  }
  GroupShared(mesh, uses, result);
  return result;
}
}
