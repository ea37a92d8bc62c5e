// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartition.h"

#include "gatunLayerPartition.h"
#include "gatunMorton.h"
#include "gatunParallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace gatun
{
namespace
{
constexpr std::size_t TetsPerTask = 1u << 16;

// Smaller groups are stored together with others of the same first chunk.
constexpr std::uint32_t LargeGroup = 256;

/** Four times the centroid along an axis. NaN comes first. */
float GetCentroid(const MeshAccess& mesh, std::uint32_t tet, unsigned axis)
{
  double sum = 0;
  for (unsigned i = 0; i < 4; ++i)
  {
    sum += mesh.GetCoordinate(mesh.GetId(tet, i), axis);
  }
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::isnan(sum) ? -largest : std::clamp(sum, -largest, largest));
}

struct Centroid
{
  float Place;
  std::uint32_t Tet;

  bool operator<(const Centroid& other) const
  {
    return this->Place < other.Place || (this->Place == other.Place && this->Tet < other.Tet);
  }
};

struct Part
{
  std::size_t Begin;
  std::size_t End;
};

void CheckIds(const MeshAccess& mesh)
{
  const auto& input = mesh.GetMesh();
  const auto tasks = (input.Tets + TetsPerTask - 1) / TetsPerTask;
  ParallelFor(tasks,
    [&](std::size_t task)
    {
      const auto end = std::min<std::uint64_t>(input.Tets, (task + 1) * TetsPerTask);
      for (std::uint64_t t = task * TetsPerTask; t < end; ++t)
      {
        for (unsigned i = 0; i < 4; ++i)
        {
          const auto id = mesh.GetId(t, i);
          if (id >= input.Points)
          {
            throw Error(ErrorCode::InvalidInput,
              "cell " + std::to_string(t) + " uses point " +
                std::to_string(static_cast<std::int64_t>(id)) + ", but the mesh has only " +
                std::to_string(input.Points) + " points");
          }
        }
      }
    });
}

/** Divides a part along its longest axis. Returns the position of the second half. */
std::size_t Halve(
  const MeshAccess& mesh, std::vector<Centroid>& items, const Part& part, std::uint32_t chunkTets)
{
  Bounds box;
  for (auto i = part.Begin; i < part.End; ++i)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      box[axis].Include(GetCentroid(mesh, items[i].Tet, axis));
    }
  }
  unsigned longest = 0;
  for (unsigned axis = 1; axis < 3; ++axis)
  {
    if (box[axis].Max - box[axis].Min > box[longest].Max - box[longest].Min)
    {
      longest = axis;
    }
  }
  for (auto i = part.Begin; i < part.End; ++i)
  {
    items[i].Place = GetCentroid(mesh, items[i].Tet, longest);
  }
  // All chunks end up with about the same number of tetrahedra.
  const auto count = part.End - part.Begin;
  const auto chunks = (count + chunkTets - 1) / chunkTets;
  const auto middle = part.Begin + count * (chunks / 2) / chunks;
  const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(part.Begin), at(middle), at(part.End));
  return middle;
}

// Buckets of layers with less than this fraction of a chunk are joined with others.
constexpr std::uint32_t SmallestPart = 16;

/** All tetrahedra as one bucket. */
LayerBuckets MakeOneBucket(const MeshAccess& mesh)
{
  LayerBuckets all;
  all.Tets.resize(static_cast<std::size_t>(mesh.GetMesh().Tets));
  std::iota(all.Tets.begin(), all.Tets.end(), 0u);
  all.Start.assign(1, 0);
  if (!all.Tets.empty())
  {
    all.Start.push_back(all.Tets.size());
  }
  return all;
}

/** Finds the layers and their buckets. */
LayerBuckets MakeBuckets(const MeshAccess& mesh, std::uint32_t chunkTets, LayerPartition& layers)
{
  const LayerValues values(layers.Array, layers.Request);
  layers.Result.Array = layers.Request.Array;
  layers.Result.Component = layers.Request.Component;
  layers.Result.Spacing = layers.Request.Spacing;
  layers.Result.Bounds = FindLayerBounds(mesh, values, layers.Request.Spacing,
    layers.Request.Count > 0 ? layers.Request.Count : GetDefaultLayers(mesh.GetMesh().Tets));
  return SortByLayers(mesh, values, layers.Result, chunkTets / SmallestPart);
}

void CutIntoChunks(const MeshAccess& mesh, std::uint32_t chunkTets, LayerBuckets buckets,
  Partition& out, const std::function<bool(double)>& progress)
{
  const auto count = buckets.Tets.size();
  std::vector<Centroid> items(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    items[i] = { 0, buckets.Tets[i] };
  }
  std::vector<Part> parts;
  for (std::size_t i = 0; i + 1 < buckets.Start.size(); ++i)
  {
    parts.push_back({ buckets.Start[i], buckets.Start[i + 1] });
  }
  buckets = {};
  for (bool cut = true; cut;)
  {
    std::vector<std::size_t> middles(parts.size(), 0);
    ParallelFor(parts.size(),
      [&](std::size_t i)
      {
        const auto& part = parts[i];
        middles[i] =
          part.End - part.Begin > chunkTets ? Halve(mesh, items, part, chunkTets) : part.End;
      });
    std::vector<Part> next;
    cut = false;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      next.push_back({ parts[i].Begin, middles[i] });
      if (middles[i] < parts[i].End)
      {
        next.push_back({ middles[i], parts[i].End });
        cut = true;
      }
    }
    parts.swap(next);
    if (progress && !progress(0))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
  }
  out.Tets.resize(count);
  out.ChunkStart.assign(1, 0);
  for (const auto& part : parts)
  {
    out.ChunkStart.push_back(part.End);
  }
  ParallelFor(parts.size(),
    [&](std::size_t i)
    {
      const auto& part = parts[i];
      for (auto t = part.Begin; t < part.End; ++t)
      {
        out.Tets[t] = items[t].Tet;
      }
      std::sort(out.Tets.begin() + static_cast<std::ptrdiff_t>(part.Begin),
        out.Tets.begin() + static_cast<std::ptrdiff_t>(part.End));
    });
}

Bounds GetBox(const MeshAccess& mesh)
{
  Bounds box;
  for (std::uint64_t p = 0; p < mesh.GetMesh().Points; ++p)
  {
    mesh.Include(box, p);
  }
  return box;
}

/** The use of a shared point by a chunk. */
struct Use
{
  std::uint32_t Point;
  std::uint32_t Chunk;
  auto operator<=>(const Use&) const = default;
};

/** Marks each point as unused or own, and returns the uses of shared points. */
std::vector<Use> FindShared(const MeshAccess& mesh, Partition& out)
{
  std::vector<Use> uses;
  std::vector<std::uint32_t> firstChunk(mesh.GetMesh().Points, Partition::Unused);
  out.SharedIndex.assign(mesh.GetMesh().Points, Partition::Unused);
  for (std::size_t c = 0; c < out.GetChunkCount(); ++c)
  {
    const auto chunk = static_cast<std::uint32_t>(c);
    for (auto t = out.ChunkStart[c]; t < out.ChunkStart[c + 1]; ++t)
    {
      for (unsigned i = 0; i < 4; ++i)
      {
        const auto p = static_cast<std::uint32_t>(mesh.GetId(out.Tets[t], i));
        if (firstChunk[p] == Partition::Unused)
        {
          firstChunk[p] = chunk;
          out.SharedIndex[p] = Partition::OwnPoint;
        }
        else if (firstChunk[p] != chunk && (uses.empty() || uses.back() != Use{ p, chunk }))
        {
          uses.push_back({ p, chunk });
          if (out.SharedIndex[p] == Partition::OwnPoint)
          {
            out.SharedIndex[p] = 0; // a shared point
            uses.push_back({ p, firstChunk[p] });
          }
        }
      }
    }
  }
  std::sort(uses.begin(), uses.end());
  uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
  return uses;
}

struct PlacedPoint
{
  std::uint64_t Morton;
  std::uint32_t Point;
  auto operator<=>(const PlacedPoint&) const = default;
};

void GroupShared(const MeshAccess& mesh, const std::vector<Use>& uses, Partition& out)
{
  const auto box = GetBox(mesh);
  std::map<std::vector<std::uint32_t>, std::vector<PlacedPoint>> groups;
  std::vector<std::uint32_t> chunks;
  for (std::size_t i = 0; i < uses.size();)
  {
    const auto point = uses[i].Point;
    chunks.clear();
    for (; i < uses.size() && uses[i].Point == point; ++i)
    {
      chunks.push_back(uses[i].Chunk);
    }
    groups[chunks].push_back({ GetMortonCode(box,
                                 { mesh.GetCoordinate(point, 0), mesh.GetCoordinate(point, 1),
                                   mesh.GetCoordinate(point, 2) }),
      point });
  }

  // Large groups are blocks of their own. The small groups of a first chunk form one block.
  const auto addGroup = [&](BlockEntry& block, const std::vector<std::uint32_t>& users,
                          std::vector<PlacedPoint>& points)
  {
    std::sort(points.begin(), points.end());
    block.Groups.push_back({ users, static_cast<std::uint32_t>(points.size()) });
    block.Points += points.size();
    for (const auto& p : points)
    {
      out.SharedIndex[p.Point] = static_cast<std::uint32_t>(out.SharedPoints.size());
      out.SharedPoints.push_back(p.Point);
    }
  };
  for (auto first = groups.begin(); first != groups.end();)
  {
    auto last = first;
    while (last != groups.end() && last->first[0] == first->first[0])
    {
      ++last;
    }
    BlockEntry rest;
    for (const bool large : { true, false })
    {
      for (auto it = first; it != last; ++it)
      {
        if ((it->second.size() >= LargeGroup) != large)
        {
          continue;
        }
        if (large)
        {
          addGroup(out.Blocks.emplace_back(), it->first, it->second);
        }
        else
        {
          addGroup(rest, it->first, it->second);
        }
      }
    }
    if (!rest.Groups.empty())
    {
      out.Blocks.push_back(std::move(rest));
    }
    first = last;
  }
}
}

Partition MakePartition(const MeshAccess& mesh, std::uint32_t chunkTets,
  const std::function<bool(double)>& progress, LayerPartition* layers)
{
  const auto& input = mesh.GetMesh();
  constexpr std::uint64_t most = 0xfffffff0u;
  if (input.Points > most || input.Tets > most)
  {
    throw Error(ErrorCode::InvalidInput, "a mesh of more than 2^32 points or cells is too large");
  }
  CheckIds(mesh);
  Partition result;
  CutIntoChunks(mesh, chunkTets,
    layers ? MakeBuckets(mesh, chunkTets, *layers) : MakeOneBucket(mesh), result, progress);
  if (layers)
  {
    const LayerValues values(layers->Array, layers->Request);
    layers->Result.Chunks.resize(result.GetChunkCount());
    ParallelFor(result.GetChunkCount(),
      [&](std::size_t c)
      {
        layers->Result.Chunks[c] = FindLayerSpan(mesh, values, layers->Result,
          std::span(result.Tets)
            .subspan(result.ChunkStart[c], result.ChunkStart[c + 1] - result.ChunkStart[c]));
      });
  }
  GroupShared(mesh, FindShared(mesh, result), result);
  for (std::uint32_t p = 0; p < input.Points; ++p)
  {
    if (result.SharedIndex[p] == Partition::Unused)
    {
      result.UnusedPoints.push_back(p);
    }
  }
  return result;
}
}
