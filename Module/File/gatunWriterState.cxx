// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunWriterState.h"

#include "gatunParallel.h"
#include "gatunVersion.h"

#include <algorithm>

namespace gatun
{
namespace
{
constexpr std::uint64_t LargeMesh = 10'000'000;
constexpr std::uint32_t DefaultChunkTets = 65536;
constexpr std::uint32_t LargeChunkTets = 262144;

std::uint16_t GetMinorVersion(const MeshInput& mesh, const WriterOptions& options)
{
  return mesh.Types  ? MinorVersionWithCells
    : options.Layers ? MinorVersionWithLayers
    : options.Tree   ? MinorVersionWithTree
                     : MinorVersionPlain;
}
}

//------------------------------------------------------------------------------
WriterState::WriterState(const std::string& path, const MeshInput& mesh,
  const std::vector<ArrayDescription>& arrays, const WriterOptions& options)
  : Mesh(mesh)
  , Options(options)
  , File(path, options.ReplaceReadOnly, GetMinorVersion(mesh, options))
{
  this->Describe(arrays);
}

//------------------------------------------------------------------------------
WriterState::WriterState(
  const WriterState& whole, const MeshInput& mesh, const WriterOptions& options)
  : Mesh(mesh)
  , Options(options)
  , File(whole.File, GetMinorVersion(mesh, options))
{
  this->Describe(whole.Meta.Arrays);
}

//------------------------------------------------------------------------------
void WriterState::Describe(const std::vector<ArrayDescription>& arrays)
{
  const MeshInput& mesh = this->Mesh.GetMesh();
  this->Meta.WriterVersion = PackageVersion();
  this->Meta.Points = mesh.Points;
  this->Meta.CoordinateType = mesh.CoordinateType;
  this->Meta.WideIds = mesh.WideIds;
  this->Meta.Keep = this->Options.Keep;
  // An isosurface needs few chunks of a file with layers; smaller ones keep more threads busy,
  // and each thread needs less memory.
  this->Meta.ChunkTets = this->Options.ChunkTets != 0
    ? this->Options.ChunkTets
    : (this->Mesh.EstimateTets() > LargeMesh ? LargeChunkTets : DefaultChunkTets) /
      (this->Options.Layers ? 4 : 1);
  this->Meta.KeyStepInterval = this->Options.KeyStepInterval;
  this->Meta.Arrays = arrays;
  this->Statistics.ArrayBytes.resize(arrays.size());
}

//------------------------------------------------------------------------------
std::span<const std::uint32_t> WriterState::GetBlockPoints(std::size_t block) const
{
  const auto& entry = this->Table.Blocks[block];
  return std::span(this->Parts.SharedPoints)
    .subspan(static_cast<std::size_t>(entry.FirstPoint), static_cast<std::size_t>(entry.Points));
}

//------------------------------------------------------------------------------
std::size_t WriterState::GetTupleCount(const ArrayDescription& array) const
{
  return static_cast<std::size_t>(
    array.Where == Association::Point ? this->Meta.Points : this->Mesh.GetMesh().Cells);
}

//------------------------------------------------------------------------------
void ForEachBatch(std::size_t chunks, const std::function<void(std::size_t)>& encode,
  const std::function<void(std::size_t, std::size_t)>& finish,
  const std::function<bool(double)>& progress)
{
  for (std::size_t first = 0; first < chunks; first += ChunksPerBatch)
  {
    const auto count = std::min(ChunksPerBatch, chunks - first);
    ParallelFor(
      count, [&](std::size_t i) { encode(first + i); },
      [&](double done)
      {
        return !progress ||
          progress((static_cast<double>(first) + done * static_cast<double>(count)) /
            static_cast<double>(chunks));
      });
    finish(first, count);
  }
}
}
