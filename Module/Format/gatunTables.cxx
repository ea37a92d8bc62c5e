// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTables.h"

#include "gatunCellCodec.h"
#include "gatunChunkCodec.h"
#include "gatunCompress.h"
#include "gatunTableParts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace gatun
{
namespace
{
// The maximum number of values in a stream. Each takes a decision of at least 2^-15.5 bits.
constexpr std::uint64_t MaxValuesPerByte = 1u << 19;

// The maximum number of entries in all lists of neighbors, plus that for each chunk.
constexpr std::uint64_t MaxNeighbors = 2u << 20;
constexpr std::uint64_t MaxNeighborsPerChunk = 1024;

void PutPalette(ByteWriter& out, const PaletteRef& palette)
{
  out.PutVarint(palette.Count);
  if (palette.Count > 0)
  {
    PutStream(out, palette.Stream);
  }
}

PaletteRef GetPalette(ByteReader& in)
{
  PaletteRef palette;
  palette.Count = in.GetVarint();
  if (palette.Count > 0)
  {
    palette.Stream = GetStream(in);
    Check(palette.Count / MaxItemsPerByte <= palette.Stream.Length, "a palette is too large");
  }
  return palette;
}

/** Checks that there are less than 2^32 points and not more than their stream can contain. */
void CheckPoints(std::uint64_t points, const StreamRef& geometry)
{
  Check(points < (std::uint64_t{ 1 } << 32), "a block has too many points");
  Check(points == 0 || points / MaxItemsPerByte + 1 <= geometry.Length,
    "a block claims more points than its stream can hold");
}

/** Checks that there are not more values than their stream can contain. */
void CheckValues(const ArrayDescription& array, std::uint64_t tuples, const StreamRef& stream)
{
  Check(tuples * array.Components / MaxValuesPerByte <= stream.Length,
    "an array claims more values than its stream can hold");
}

}

//------------------------------------------------------------------------------
Bytes MetaTable::Write() const
{
  ByteWriter out;
  out.PutString(this->WriterVersion);
  out.PutVarint(this->Points);
  out.PutVarint(this->Tets);
  out.PutVarint(this->UnusedPoints);
  out.Put(static_cast<std::uint8_t>(this->CoordinateType));
  out.Put(static_cast<std::uint8_t>(this->WideIds));
  out.Put(static_cast<std::uint8_t>(this->HasTime));
  out.Put(this->Keep);
  out.PutVarint(this->ChunkTets);
  out.PutVarint(this->KeyStepInterval);
  for (const auto& range : this->Box)
  {
    PutRange(out, range);
  }
  PutArrays(out, this->Arrays);
  return Pack(out, SmallTable);
}

MetaTable MetaTable::Read(std::span<const std::uint8_t> bytes)
{
  const auto data = Unpack(bytes, SmallTable);
  ByteReader in(data);
  MetaTable meta;
  meta.WriterVersion = in.GetString();
  meta.Points = in.GetVarint();
  meta.Tets = in.GetVarint();
  meta.UnusedPoints = in.GetVarint();
  meta.CoordinateType = GetScalarType(in);
  Check(IsFloating(meta.CoordinateType), "the coordinates have an unknown type");
  meta.WideIds = in.Get<std::uint8_t>() != 0;
  meta.HasTime = in.Get<std::uint8_t>() != 0;
  meta.Keep = in.Get<std::uint8_t>();
  Check(meta.Keep <= KeepAll, "the kept order is unknown");
  meta.ChunkTets = GetSmall(in);
  meta.KeyStepInterval = GetSmall(in);
  for (auto& range : meta.Box)
  {
    range = GetRange(in);
  }
  meta.Arrays = GetArrays(in);
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the meta data");
  return meta;
}

//------------------------------------------------------------------------------
Bytes MeshTable::Write(std::uint8_t keep) const
{
  ByteWriter out;
  for (const auto& palette : this->Palettes)
  {
    PutPalette(out, palette);
  }
  const auto putBlock = [&](const BlockEntry& block)
  {
    PutStream(out, block.Geometry);
    if (keep & KeepPoints)
    {
      PutStream(out, block.Order);
    }
  };
  out.PutVarint(this->Blocks.size());
  for (const auto& block : this->Blocks)
  {
    out.PutVarint(block.Groups.size());
    for (const auto& group : block.Groups)
    {
      out.PutVarint(group.Points);
      out.PutVarint(group.Chunks.size());
      std::uint32_t last = 0;
      for (const auto chunk : group.Chunks)
      {
        out.PutVarint(chunk - last);
        last = chunk;
      }
    }
    putBlock(block);
  }
  putBlock(this->Unused);
  out.PutVarint(this->Chunks.size());
  for (const auto& chunk : this->Chunks)
  {
    out.PutVarint(chunk.Info.Tets);
    out.PutVarint(chunk.Info.OwnPoints);
    out.PutVarint(0); // reserved
    out.PutVarint(0);
    for (const auto& range : chunk.Info.Box)
    {
      PutRange(out, range);
    }
    PutStream(out, chunk.Connectivity);
    PutStream(out, chunk.Geometry);
    if (keep & KeepPoints)
    {
      PutStream(out, chunk.PointOrder);
    }
    if (keep & KeepCells)
    {
      PutStream(out, chunk.CellOrder);
    }
    if (keep & KeepCorners)
    {
      PutStream(out, chunk.Corners);
    }
  }
  return Pack(out, SmallTable);
}

namespace
{
/** Takes the sizes of a chunk's cells from the table of cells and checks them. */
void CheckChunk(ChunkEntry& chunk, const CellSizes& sizes)
{
  const auto tets = chunk.Info.Tets;
  if (sizes.IsTetrahedral)
  {
    Check(tets >= 1 && tets <= MaxChunkTets, "a chunk has an impossible number of tetrahedra");
    Check(tets / MaxItemsPerByte + 1 <= chunk.Connectivity.Length,
      "a chunk claims more tetrahedra than its stream can hold");
    const auto count = static_cast<std::uint32_t>(tets);
    chunk.Sizes = { true, count, 4 * count, 0, 0 };
  }
  else
  {
    const auto values = std::uint64_t{ sizes.Corners } + sizes.FaceValues;
    Check(tets <= values, "a chunk has more tetrahedra than its cells can consist of");
    Check(sizes.Cells / MaxItemsPerByte + 1 <= chunk.Connectivity.Length &&
        values / MaxCornersPerByte + 1 <= chunk.Connectivity.Length,
      "a chunk claims more cells than its stream can hold");
    chunk.Sizes = sizes;
  }
  chunk.Info.Cells = chunk.Sizes.Cells;
  chunk.Info.IsTetrahedral = chunk.Sizes.IsTetrahedral;
  Check(chunk.Info.OwnPoints <= chunk.Sizes.GetMostPoints(),
    "a chunk has more points than its cells can use");
}
}

MeshTable MeshTable::Read(
  std::span<const std::uint8_t> bytes, const MetaTable& meta, const CellTable* cells)
{
  const auto data = Unpack(bytes, SmallTable);
  ByteReader in(data);
  MeshTable mesh;
  for (auto& palette : mesh.Palettes)
  {
    palette = GetPalette(in);
  }
  const auto getBlock = [&](BlockEntry& block)
  {
    block.Geometry = GetStream(in);
    if (meta.Keep & KeepPoints)
    {
      block.Order = GetStream(in);
    }
    CheckPoints(block.Points, block.Geometry);
  };
  mesh.Blocks.resize(in.GetCount(2));
  for (auto& block : mesh.Blocks)
  {
    block.Groups.resize(in.GetCount(4));
    for (auto& group : block.Groups)
    {
      const auto points = in.GetVarint();
      Check(points >= 1 && points < (std::uint64_t{ 1 } << 32), "a group has no points");
      group.Points = static_cast<std::uint32_t>(points);
      block.Points += points;
      group.Chunks.resize(in.GetCount(1));
      Check(group.Chunks.size() >= 2, "a group is shared by fewer than two chunks");
      std::uint64_t last = 0;
      for (std::size_t i = 0; i < group.Chunks.size(); ++i)
      {
        const auto step = in.GetVarint();
        Check((i == 0 || step > 0) && step < (std::uint64_t{ 1 } << 32),
          "the chunks of a group do not ascend");
        last += step;
        Check(last < (std::uint64_t{ 1 } << 32), "a group names a chunk that is not there");
        group.Chunks[i] = static_cast<std::uint32_t>(last);
      }
    }
    getBlock(block);
  }
  mesh.Unused.Points = meta.UnusedPoints;
  getBlock(mesh.Unused);
  mesh.Chunks.resize(in.GetCount(4 + 48));
  Check(!cells || cells->Chunks.size() == mesh.Chunks.size(),
    "the table of cells is not that of the chunks");
  for (std::size_t c = 0; c < mesh.Chunks.size(); ++c)
  {
    auto& chunk = mesh.Chunks[c];
    chunk.Info.Tets = in.GetVarint();
    chunk.Info.OwnPoints = in.GetVarint();
    const auto level = GetSmall(in); // reserved
    const auto bucket = GetSmall(in);
    Check(level == 0 && bucket == 0,
      "a chunk belongs to a level or bucket, which this version does not know");
    for (auto& range : chunk.Info.Box)
    {
      range = GetRange(in);
    }
    chunk.Connectivity = GetStream(in);
    chunk.Geometry = GetStream(in);
    if (meta.Keep & KeepPoints)
    {
      chunk.PointOrder = GetStream(in);
    }
    if (meta.Keep & KeepCells)
    {
      chunk.CellOrder = GetStream(in);
    }
    if (meta.Keep & KeepCorners)
    {
      chunk.Corners = GetStream(in);
    }
    CheckChunk(chunk, cells ? cells->Chunks[c] : CellSizes{});
  }
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the table");
  mesh.LinkGroups();
  mesh.NumberAll(meta);
  return mesh;
}

std::uint64_t MeshTable::GetNumberOfCells() const
{
  return this->Chunks.empty() ? 0
                              : this->Chunks.back().Info.FirstCell + this->Chunks.back().Info.Cells;
}

std::uint64_t MeshTable::GetSharedPoints() const
{
  return this->Blocks.empty() ? 0 : this->Blocks.back().FirstPoint + this->Blocks.back().Points;
}

void MeshTable::LinkGroups()
{
  std::uint64_t point = 0;
  for (std::uint32_t b = 0; b < this->Blocks.size(); ++b)
  {
    auto& block = this->Blocks[b];
    block.FirstPoint = point;
    point += block.Points;
    std::uint64_t inBlock = 0;
    for (std::uint32_t g = 0; g < block.Groups.size(); ++g)
    {
      const auto& group = block.Groups[g];
      Check(group.Chunks.back() < this->Chunks.size(), "a group names a chunk that is not there");
      for (const auto c : group.Chunks)
      {
        this->Chunks[c].Shared.push_back({ b, g, inBlock });
        this->Chunks[c].Info.SharedPoints += group.Points;
      }
      inBlock += group.Points;
    }
  }
  this->FindNeighbors();
}

void MeshTable::FindNeighbors()
{
  std::uint64_t total = 0;
  std::vector<std::uint32_t> seenBy(this->Chunks.size(), 0xffffffffu);
  for (std::uint32_t c = 0; c < this->Chunks.size(); ++c)
  {
    std::vector<std::uint32_t> near;
    seenBy[c] = c;
    for (const auto& part : this->Chunks[c].Shared)
    {
      for (const auto other : this->Blocks[part.Block].Groups[part.Group].Chunks)
      {
        if (seenBy[other] != c)
        {
          seenBy[other] = c;
          near.push_back(other);
        }
      }
    }
    total += near.size();
    Check(total <= MaxNeighbors + MaxNeighborsPerChunk * this->Chunks.size(),
      "too many chunks share points with too many others");
    std::sort(near.begin(), near.end());
    near.shrink_to_fit();
    this->Chunks[c].Info.Neighbors = std::move(near);
  }
}

void MeshTable::CheckLengths(std::uint64_t fileSize) const
{
  // Streams may overlap, but the streams that justify the counts must not overlap entirely.
  std::uint64_t left = fileSize;
  const auto take = [&](const StreamRef& stream)
  {
    Check(stream.Length <= left, "the streams are longer than the file");
    left -= stream.Length;
  };
  for (const auto& block : this->Blocks)
  {
    take(block.Geometry);
  }
  take(this->Unused.Geometry);
  for (const auto& chunk : this->Chunks)
  {
    take(chunk.Connectivity);
    take(chunk.Geometry);
  }
}

void MeshTable::NumberAll(const MetaTable& meta)
{
  std::uint64_t point = this->GetSharedPoints();
  std::uint64_t tet = 0;
  std::uint64_t cell = 0;
  for (auto& chunk : this->Chunks)
  {
    auto& info = chunk.Info;
    const auto most = chunk.Sizes.GetMostPoints();
    Check(info.SharedPoints <= most && info.OwnPoints <= most - info.SharedPoints,
      "a chunk has more points than its cells can use");
    info.FirstTet = tet;
    info.FirstCell = cell;
    info.FirstPoint = point;
    tet += info.Tets;
    cell += info.Cells;
    point += info.OwnPoints;
  }
  this->Unused.FirstPoint = point;
  Check(tet == meta.Tets, "the chunks' tetrahedra do not add up to the mesh's");
  Check(meta.UnusedPoints <= meta.Points && point == meta.Points - meta.UnusedPoints,
    "the chunks' points do not add up to the mesh's");
}

std::vector<std::uint32_t> MeshTable::GetSharedUsers(std::size_t chunk) const
{
  const auto& entry = this->Chunks[chunk];
  const auto& near = entry.Info.Neighbors;
  std::vector<std::uint32_t> users;
  users.reserve(static_cast<std::size_t>(entry.Info.SharedPoints));
  for (const auto& part : entry.Shared)
  {
    const auto& group = this->Blocks[part.Block].Groups[part.Group];
    std::uint32_t mask = 0;
    // Bit 31 is the last to be set, because the group's chunks and the neighbors ascend.
    for (auto c = group.Chunks.begin(); c != group.Chunks.end() && mask >> 31 == 0; ++c)
    {
      if (*c != chunk)
      {
        const auto place = std::lower_bound(near.begin(), near.end(), *c) - near.begin();
        mask |= 1u << std::min<std::ptrdiff_t>(place, 31);
      }
    }
    users.insert(users.end(), group.Points, mask);
  }
  return users;
}

//------------------------------------------------------------------------------
bool ArrayStep::HasPalette() const
{
  return std::any_of(
    this->Palettes.begin(), this->Palettes.end(), [](const PaletteRef& p) { return p.Count > 0; });
}

Bytes StepTable::Write() const
{
  ByteWriter out;
  out.Put(this->Time);
  out.Put(static_cast<std::uint8_t>(this->Key));
  PutStream(out, this->Field);
  for (const auto& array : this->Arrays)
  {
    for (const auto& palette : array.Palettes)
    {
      PutPalette(out, palette);
    }
    for (const auto& range : array.Ranges)
    {
      PutRange(out, range);
    }
    for (std::size_t c = 0; c < array.Chunks.size(); ++c)
    {
      for (const auto& range : array.ChunkRanges[c])
      {
        PutRange(out, range);
      }
      PutStream(out, array.Chunks[c]);
    }
    for (const auto& stream : array.Blocks)
    {
      PutStream(out, stream);
    }
  }
  return Pack(out, SmallStep);
}

StepTable StepTable::Read(
  std::span<const std::uint8_t> bytes, const MetaTable& meta, const MeshTable& mesh)
{
  const auto data = Unpack(bytes, SmallStep);
  ByteReader in(data);
  StepTable step;
  step.Time = in.Get<double>();
  Check(!std::isnan(step.Time), "a time is not a number");
  step.Key = in.Get<std::uint8_t>() != 0;
  step.Field = GetStream(in);
  step.Arrays.resize(meta.Arrays.size());
  for (std::size_t a = 0; a < step.Arrays.size(); ++a)
  {
    const auto& description = meta.Arrays[a];
    auto& array = step.Arrays[a];
    const bool isOfPoints = description.Where == Association::Point;
    const auto ranges = GetRangeCount(description.Components);
    Check(description.Components <= in.GetRemaining(), "the table of a step ends too early");
    array.Palettes.resize(description.Components);
    for (auto& palette : array.Palettes)
    {
      palette = GetPalette(in);
    }
    array.Ranges.resize(ranges);
    for (auto& range : array.Ranges)
    {
      range = GetRange(in);
    }
    Check(mesh.Chunks.size() <= in.GetRemaining() / (1 + 16 * ranges),
      "the table of a step ends too early");
    array.Chunks.resize(mesh.Chunks.size());
    array.ChunkRanges.resize(mesh.Chunks.size());
    for (std::size_t c = 0; c < mesh.Chunks.size(); ++c)
    {
      array.ChunkRanges[c].resize(ranges);
      for (auto& range : array.ChunkRanges[c])
      {
        range = GetRange(in);
      }
      array.Chunks[c] = GetStream(in);
      const auto& info = mesh.Chunks[c].Info;
      CheckValues(description, isOfPoints ? info.OwnPoints : info.Cells, array.Chunks[c]);
    }
    if (isOfPoints)
    {
      array.Blocks.resize(mesh.Blocks.size() + 1);
      for (std::size_t b = 0; b < array.Blocks.size(); ++b)
      {
        array.Blocks[b] = GetStream(in);
        const auto& block = b < mesh.Blocks.size() ? mesh.Blocks[b] : mesh.Unused;
        CheckValues(description, block.Points, array.Blocks[b]);
      }
    }
  }
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the table of a step");
  return step;
}
}
