// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRaySource.h"

#include "gatunCache.h"
#include "gatunChunkCache.h"
#include "gatunError.h"
#include "gatunParallel.h"
#include "gatunPartition.h"
#include "gatunPieceDecoder.h"
#include "gatunRaySourceInternals.h"

#include <algorithm>
#include <unordered_map>

namespace gatun
{
//------------------------------------------------------------------------------
class RayBlockCache::Internals
{
public:
  Cache<std::size_t, RayBlock> Blocks;
};

//------------------------------------------------------------------------------
RayBlockCache::RayBlockCache(std::uint64_t budget)
  : RayBlockCache(std::make_shared<CacheBudget>(budget))
{
}

RayBlockCache::RayBlockCache(std::shared_ptr<CacheBudget> budget)
  : Self(new Internals{ Cache<std::size_t, RayBlock>(std::move(budget)) })
{
}

RayBlockCache::~RayBlockCache() = default;

//------------------------------------------------------------------------------
std::shared_ptr<const RayBlock> RayBlockCache::Find(std::size_t block)
{
  return this->Self->Blocks.Find(block);
}

//------------------------------------------------------------------------------
void RayBlockCache::Add(std::size_t block, std::shared_ptr<const RayBlock> made)
{
  const auto bytes = made->GetMemorySize();
  this->Self->Blocks.Keep(block, std::move(made), bytes);
}

//------------------------------------------------------------------------------
CacheStatistics RayBlockCache::GetStatistics() const
{
  return this->Self->Blocks.GetStatistics();
}

//------------------------------------------------------------------------------
Range GetDrawnRange(const ArrayRanges& ranges, int component)
{
  if (component >= 0)
  {
    return ranges[static_cast<std::size_t>(component)];
  }
  const Range& last = ranges.back();
  if (ranges.size() > 1 || last.Min >= 0 || !(last.Min <= last.Max))
  {
    return last;
  }
  return { std::max(0.0, -last.Max), std::max(-last.Min, last.Max) };
}

//------------------------------------------------------------------------------
void CheckRayValues(const FileReader& file, const RayValues& values)
{
  const auto& arrays = file.GetArrays();
  if (values.Array >= arrays.size())
  {
    throw Error(ErrorCode::InvalidInput, file.GetPath() + ": there is no such array");
  }
  const auto& array = arrays[values.Array];
  if (values.Component < -1 || values.Component >= static_cast<int>(array.Components))
  {
    throw Error(ErrorCode::InvalidInput,
      file.GetPath() + ": array '" + array.Name + "' has no component " +
        std::to_string(values.Component));
  }
  if (values.Step >= file.GetNumberOfSteps())
  {
    throw Error(ErrorCode::InvalidInput, file.GetPath() + ": there is no such time step");
  }
}

//------------------------------------------------------------------------------
RayBlock DecodeRayBlock(
  const std::shared_ptr<ChunkCache>& parts, const RayValues& values, std::size_t chunk)
{
  const FileReader& file = *parts->GetFile();
  PieceDecoder decoder(parts);
  PieceRequest request;
  request.Chunks = { static_cast<std::uint32_t>(chunk) };
  request.Arrays = { values.Array };
  request.Step = values.Step;
  request.RestoreOrder = false;
  decoder.SetRequest(request);

  const auto& array = file.GetArrays()[values.Array];
  const bool ofCells = array.Where == Association::Cell;
  const auto points = decoder.GetNumberOfPoints();
  const auto tets = decoder.GetNumberOfTets();
  const auto coordinateType = file.GetCoordinateType();
  std::vector<std::byte> coordinates(3 * points * SizeOf(coordinateType));
  std::vector<std::byte> raw((ofCells ? tets : points) * array.Components * SizeOf(array.Type));
  RayBlock block;
  block.Tets.resize(tets);
  static_assert(sizeof(RayBlock::Tet) == 4 * sizeof(std::int32_t));
  PieceTarget target;
  target.Points = coordinates.data();
  target.Connectivity = block.Tets.data();
  target.WideIds = false;
  target.Arrays = { raw.data() };
  decoder.Fill(target);

  block.Points.resize(points);
  WithType(coordinateType, coordinates.data(),
    [&](const auto* p)
    {
      for (std::size_t i = 0; i < points; ++i)
      {
        block.Points[i] = { static_cast<double>(p[3 * i]), static_cast<double>(p[3 * i + 1]),
          static_cast<double>(p[3 * i + 2]), 0 };
      }
    });
  WithValues({ array.Where, array.Type, array.Components, values.Component, raw.data() },
    [&](auto&& getValue) { block.SetValues(array.Where, getValue); });
  return block;
}

//------------------------------------------------------------------------------
// A file

class FileRaySource::Internals
{
public:
  Internals(
    std::shared_ptr<ChunkCache> parts, const RayValues& values, std::shared_ptr<CacheBudget> budget)
    : File(parts->GetFile())
    , Values(values)
    , Cache(std::move(budget))
    , Parts(std::move(parts))
  {
    CheckRayValues(*this->File, values);
  }

  std::shared_ptr<const FileReader> File;
  RayValues Values;
  RayBlockCache Cache;
  std::shared_ptr<ChunkCache> Parts; // for shared points
};

//------------------------------------------------------------------------------
FileRaySource::FileRaySource(
  std::shared_ptr<const FileReader> file, const RayValues& values, std::uint64_t budget)
{
  const auto forParts = GetBudgetForParts(budget);
  this->Self = std::make_unique<Internals>(std::make_shared<ChunkCache>(std::move(file), forParts),
    values, std::make_shared<CacheBudget>(budget - forParts));
}

FileRaySource::FileRaySource(std::shared_ptr<ChunkCache> parts, const RayValues& values)
{
  auto budget = parts->GetSharedBudget();
  this->Self = std::make_unique<Internals>(std::move(parts), values, std::move(budget));
}

FileRaySource::~FileRaySource() = default;

//------------------------------------------------------------------------------
std::size_t FileRaySource::GetNumberOfBlocks() const
{
  return this->Self->File->GetChunks().size();
}

//------------------------------------------------------------------------------
const Bounds& FileRaySource::GetBounds(std::size_t block) const
{
  return this->Self->File->GetChunks()[block].Box;
}

//------------------------------------------------------------------------------
Range FileRaySource::GetRange(std::size_t block) const
{
  const auto& values = this->Self->Values;
  return GetDrawnRange(
    this->Self->File->GetChunkRanges(values.Array, values.Step, block), values.Component);
}

//------------------------------------------------------------------------------
RaySource::Blocks FileRaySource::GetBlocks(
  std::span<const std::size_t> blocks, const Progress& progress)
{
  return FindOrMake(this->Self->Cache, blocks, progress,
    [&](std::size_t chunk, RayBlock& block)
    { block = DecodeRayBlock(this->Self->Parts, this->Self->Values, chunk); });
}

//------------------------------------------------------------------------------
// Memory

class MemoryRaySource::Internals
{
public:
  MeshAccess Mesh;
  RayValuesInput Values;
  const unsigned char* Hidden;
  RayBlockCache Cache;
  Partition Parts;
  std::vector<Bounds> Boxes;
  std::vector<Range> Ranges;

  std::span<const std::uint32_t> GetTets(std::size_t block) const
  {
    const auto first = this->Parts.ChunkStart[block];
    return { this->Parts.Tets.data() + first, this->Parts.ChunkStart[block + 1] - first };
  }

  bool IsHidden(std::uint32_t tet) const { return this->Hidden && this->Hidden[tet] != 0; }
  void Measure(std::size_t block);
  void Make(std::size_t index, RayBlock& block) const;
};

//------------------------------------------------------------------------------
MemoryRaySource::MemoryRaySource(const MeshInput& mesh, const RayValuesInput& values,
  const unsigned char* hidden, std::uint64_t budget, std::uint32_t blockTets,
  const Progress& progress)
{
  const MeshAccess access(mesh);
  this->Self.reset(new Internals{ access, values, hidden, RayBlockCache(budget),
    MakePartition(access, blockTets, progress), {}, {} });
  const auto blocks = this->Self->Parts.GetChunkCount();
  this->Self->Boxes.resize(blocks);
  this->Self->Ranges.resize(blocks);
  ParallelFor(blocks, [&](std::size_t block) { this->Self->Measure(block); });
}

MemoryRaySource::~MemoryRaySource() = default;

//------------------------------------------------------------------------------
void MemoryRaySource::Internals::Measure(std::size_t block)
{
  const bool ofCells = this->Values.Where == Association::Cell;
  WithValues(this->Values,
    [&](auto&& getValue)
    {
      for (const auto tet : this->GetTets(block))
      {
        if (this->IsHidden(tet))
        {
          continue;
        }
        for (unsigned corner = 0; corner < 4; ++corner)
        {
          const auto point = this->Mesh.GetId(tet, corner);
          this->Mesh.Extend(this->Boxes[block], point);
          gatun::Extend(this->Ranges[block], getValue(ofCells ? tet : point));
        }
      }
    });
}

//------------------------------------------------------------------------------
void MemoryRaySource::Internals::Make(std::size_t index, RayBlock& block) const
{
  std::unordered_map<std::uint64_t, std::uint32_t> places;
  std::vector<std::uint64_t> points;
  std::vector<std::uint32_t> tets;
  for (const auto tet : this->GetTets(index))
  {
    if (this->IsHidden(tet))
    {
      continue;
    }
    tets.push_back(tet);
    auto& corners = block.Tets.emplace_back();
    for (unsigned corner = 0; corner < 4; ++corner)
    {
      const auto point = this->Mesh.GetId(tet, corner);
      const auto [place, isNew] =
        places.try_emplace(point, static_cast<std::uint32_t>(points.size()));
      corners[corner] = place->second;
      if (isNew)
      {
        points.push_back(point);
        block.Points.push_back({ this->Mesh.GetCoordinate(point, 0),
          this->Mesh.GetCoordinate(point, 1), this->Mesh.GetCoordinate(point, 2), 0 });
      }
    }
  }
  WithValues(this->Values,
    [&](auto&& getValue)
    {
      const bool ofCells = this->Values.Where == Association::Cell;
      block.SetValues(
        this->Values.Where, [&](std::size_t i) { return getValue(ofCells ? tets[i] : points[i]); });
    });
}

//------------------------------------------------------------------------------
std::size_t MemoryRaySource::GetNumberOfBlocks() const
{
  return this->Self->Boxes.size();
}

//------------------------------------------------------------------------------
const Bounds& MemoryRaySource::GetBounds(std::size_t block) const
{
  return this->Self->Boxes[block];
}

//------------------------------------------------------------------------------
Range MemoryRaySource::GetRange(std::size_t block) const
{
  return this->Self->Ranges[block];
}

//------------------------------------------------------------------------------
RaySource::Blocks MemoryRaySource::GetBlocks(
  std::span<const std::size_t> blocks, const Progress& progress)
{
  return FindOrMake(this->Self->Cache, blocks, progress,
    [&](std::size_t index, RayBlock& block) { this->Self->Make(index, block); });
}
}
