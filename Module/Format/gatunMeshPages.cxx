// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshPages.h"

#include "gatunCellCodec.h"
#include "gatunChunkCodec.h"
#include "gatunTableParts.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace gatun
{
namespace
{
constexpr std::uint64_t MostPoints = std::numeric_limits<std::uint32_t>::max(); // of a block

/** Checks that there are not more points than their streams can contain. */
void CheckPoints(std::uint64_t points, std::uint64_t geometryBytes, const char* what)
{
  Check(points == 0 || points / MaxItemsPerByte + 1 <= geometryBytes, what);
}

void PutBlockStreams(ByteWriter& out, const BlockEntry& block, std::uint8_t keep)
{
  PutStream(out, block.Geometry);
  if (keep & KeepPoints)
  {
    PutStream(out, block.Order);
  }
}

void GetBlockStreams(ByteReader& in, BlockEntry& block, std::uint8_t keep)
{
  block.Geometry = GetStream(in);
  if (keep & KeepPoints)
  {
    block.Order = GetStream(in);
  }
  Check(block.Points <= MostPoints, "a block has too many points");
  CheckPoints(
    block.Points, block.Geometry.Length, "a block claims more points than its stream can hold");
}

/** A stream whose length the summary has. */
void PutPosition(ByteWriter& out, const StreamRef& stream)
{
  out.PutVarint(stream.Offset);
  out.Put(stream.Sum);
}

StreamRef GetPosition(ByteReader& in, std::uint64_t length)
{
  StreamRef stream;
  stream.Length = length;
  stream.Offset = in.GetVarint();
  stream.Sum = in.Get<std::uint64_t>();
  return stream;
}

void PutAscending(ByteWriter& out, const std::vector<std::uint32_t>& numbers)
{
  out.PutVarint(numbers.size());
  std::uint32_t last = 0;
  for (const auto number : numbers)
  {
    out.PutVarint(number - last);
    last = number;
  }
}

/** Numbers that ascend and are below end. missing: the message if they are not below. */
std::vector<std::uint32_t> GetAscending(ByteReader& in, std::uint64_t end, const char* missing)
{
  std::vector<std::uint32_t> numbers(in.GetCount(1));
  std::uint64_t last = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const auto step = in.GetVarint();
    Check(i == 0 || step > 0, "the chunks of a group, or the blocks of a chunk, do not ascend");
    Check(step < end && last + step < end, missing);
    last += step;
    numbers[i] = static_cast<std::uint32_t>(last);
  }
  return numbers;
}

//------------------------------------------------------------------------------
Bytes WriteSummary(std::span<const ChunkEntry> chunks)
{
  ByteWriter out;
  for (const auto& chunk : chunks)
  {
    out.PutVarint(chunk.Info.Tets);
    out.PutVarint(chunk.Info.OwnPoints);
    out.PutVarint(chunk.Info.SharedPoints);
    out.PutVarint(chunk.Connectivity.Length);
    out.PutVarint(chunk.Geometry.Length);
    for (const auto& range : chunk.Info.Box)
    {
      PutRange(out, range);
    }
  }
  return Pack(out, SmallTable);
}

void PutBlock(ByteWriter& out, const BlockEntry& block, std::uint8_t keep)
{
  out.PutVarint(block.Groups.size());
  for (const auto& group : block.Groups)
  {
    out.PutVarint(group.Points);
    PutAscending(out, group.Chunks);
  }
  PutBlockStreams(out, block, keep);
}

void PutChunk(ByteWriter& out, const ChunkEntry& chunk, std::uint8_t keep)
{
  PutPosition(out, chunk.Connectivity);
  PutPosition(out, chunk.Geometry);
  for (const auto& [flag, stream] : { std::pair(KeepPoints, &chunk.PointOrder),
         std::pair(KeepCells, &chunk.CellOrder), std::pair(KeepCorners, &chunk.Corners) })
  {
    if (keep & flag)
    {
      PutStream(out, *stream);
    }
  }
  std::vector<std::uint32_t> blocks;
  for (const auto& part : chunk.Shared)
  {
    if (blocks.empty() || blocks.back() != part.Block)
    {
      blocks.push_back(part.Block);
    }
  }
  PutAscending(out, blocks);
}

Bytes WriteDetails(
  std::span<const ChunkEntry> chunks, std::span<const BlockEntry> blocks, std::uint8_t keep)
{
  ByteWriter out;
  for (const auto& block : blocks)
  {
    PutBlock(out, block, keep);
  }
  for (const auto& chunk : chunks)
  {
    PutChunk(out, chunk, keep);
  }
  return Pack(out, SmallTable);
}
}

//------------------------------------------------------------------------------
std::size_t MeshIndex::GetChunksOfPage(std::size_t page) const
{
  return std::min(ChunksPerPage, this->Chunks - page * ChunksPerPage);
}

//------------------------------------------------------------------------------
std::uint64_t MeshIndex::GetNumberOfBlocks() const
{
  return this->Pages.empty() ? 0 : this->Pages.back().FirstBlock + this->Pages.back().Blocks;
}

//------------------------------------------------------------------------------
std::uint64_t MeshIndex::GetSharedPoints() const
{
  return this->Pages.empty() ? 0 : this->Pages.back().FirstPoint + this->Pages.back().Points;
}

//------------------------------------------------------------------------------
Bytes MeshIndex::Write(std::uint8_t keep) const
{
  ByteWriter out;
  for (const auto& palette : this->Palettes)
  {
    PutPalette(out, palette);
  }
  PutBlockStreams(out, this->Unused, keep);
  out.PutVarint(this->Chunks);
  for (const auto& page : this->Pages)
  {
    PutStream(out, page.Summary);
    PutStream(out, page.Details);
    out.PutVarint(page.Blocks);
    out.PutVarint(page.Points);
    out.PutVarint(page.GeometryBytes);
  }
  return Pack(out, SmallTable);
}

//------------------------------------------------------------------------------
MeshIndex MeshIndex::Read(std::span<const std::uint8_t> bytes, const MetaTable& meta)
{
  const auto data = Unpack(bytes, SmallTable);
  ByteReader in(data);
  MeshIndex index;
  for (auto& palette : index.Palettes)
  {
    palette = GetPalette(in, meta.CoordinateType);
    Check(!palette.IsCopy(), "coordinates are copied from an array");
    Check(!palette.Rounding, "coordinates have a bound of errors");
  }
  index.Unused.Points = meta.UnusedPoints;
  GetBlockStreams(in, index.Unused, meta.Keep);
  const auto chunks = in.GetVarint();
  constexpr std::size_t leastPageBytes = 2 * 10 + 3;
  Check(chunks <= std::numeric_limits<std::uint32_t>::max() &&
      GetPageCount(static_cast<std::size_t>(chunks)) <= in.GetRemaining() / leastPageBytes,
    "the table has fewer pages than chunks need");
  index.Chunks = static_cast<std::size_t>(chunks);
  index.Pages.resize(GetPageCount(index.Chunks));
  std::uint64_t blocks = 0;
  std::uint64_t points = 0;
  for (auto& page : index.Pages)
  {
    page.Summary = GetStream(in);
    page.Details = GetStream(in);
    page.Blocks = in.GetVarint();
    page.Points = in.GetVarint();
    page.GeometryBytes = in.GetVarint();
    Check(page.Blocks <= page.Points && page.Points <= meta.Points - points,
      "the blocks have more points than the mesh");
    CheckPoints(
      page.Points, page.GeometryBytes, "blocks claim more points than their streams can hold");
    page.FirstBlock = blocks;
    page.FirstPoint = points;
    blocks += page.Blocks;
    points += page.Points;
  }
  Check(blocks <= MostPoints, "there are too many blocks");
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the table");
  return index;
}

//------------------------------------------------------------------------------
MeshIndex MakeMeshIndex(const MeshTable& table)
{
  MeshIndex index;
  index.Palettes = table.Palettes;
  index.Unused = table.Unused;
  index.Chunks = table.Chunks.size();
  index.Pages.resize(GetPageCount(index.Chunks));
  auto block = table.Blocks.begin();
  for (std::size_t p = 0; p < index.Pages.size(); ++p)
  {
    auto& page = index.Pages[p];
    page.FirstBlock = static_cast<std::uint64_t>(block - table.Blocks.begin());
    page.FirstPoint = block == table.Blocks.end() ? table.GetSharedPoints() : block->FirstPoint;
    const auto isHere = [&](const BlockEntry& entry)
    { return entry.Groups.front().Chunks.front() / ChunksPerPage == p; };
    for (; block != table.Blocks.end() && isHere(*block); ++block)
    {
      ++page.Blocks;
      page.Points += block->Points;
      page.GeometryBytes += block->Geometry.Length;
    }
  }
  return index;
}

//------------------------------------------------------------------------------
void WriteMeshPages(MeshIndex& index, const MeshTable& table, std::uint8_t keep, const PutPage& put)
{
  const std::span chunks(table.Chunks);
  const std::span blocks(table.Blocks);
  for (std::size_t p = 0; p < index.Pages.size(); ++p)
  {
    auto& page = index.Pages[p];
    const auto first = p * ChunksPerPage;
    const auto here = chunks.subspan(first, index.GetChunksOfPage(p));
    page.Summary = put(WriteSummary(here));
    page.Details = put(WriteDetails(here,
      blocks.subspan(
        static_cast<std::size_t>(page.FirstBlock), static_cast<std::size_t>(page.Blocks)),
      keep));
  }
}

//------------------------------------------------------------------------------
namespace
{
/** Sets the sizes of a chunk's cells and checks them. */
void SetSizes(ChunkInfo& info, const CellTable* cells, std::size_t chunk, std::uint64_t stream)
{
  const CellSizes sizes = cells ? cells->Chunks[chunk] : CellSizes{};
  info.IsTetrahedral = sizes.IsTetrahedral;
  if (sizes.IsTetrahedral)
  {
    Check(info.Tets >= 1 && info.Tets <= MaxChunkTets,
      "a chunk has an impossible number of tetrahedra");
    Check(info.Tets / MaxItemsPerByte + 1 <= stream,
      "a chunk claims more tetrahedra than its stream can hold");
    info.Cells = info.Tets;
  }
  else
  {
    const auto values = sizes.GetMostPoints();
    Check(info.Tets <= values, "a chunk has more tetrahedra than its cells can consist of");
    Check(sizes.Cells / MaxItemsPerByte + 1 <= stream && values / MaxCornersPerByte + 1 <= stream,
      "a chunk claims more cells than its stream can hold");
    info.Cells = sizes.Cells;
  }
  const auto most = sizes.IsTetrahedral ? 4 * info.Tets : sizes.GetMostPoints();
  Check(info.SharedPoints <= most && info.OwnPoints <= most - info.SharedPoints,
    "a chunk has more points than its cells can use");
}
}

//------------------------------------------------------------------------------
void ChunkSummaries::Add(
  std::span<const std::uint8_t> summary, const MeshIndex& index, const CellTable* cells)
{
  const auto first = this->Infos.size();
  const auto count = index.GetChunksOfPage(first / ChunksPerPage);
  const auto data = Unpack(summary, SmallTable);
  ByteReader in(data);
  Check(count <= in.GetRemaining() / (5 + 48), "the chunks of a page are not all there");
  for (auto chunk = first; chunk < first + count; ++chunk)
  {
    ChunkInfo info;
    info.Tets = in.GetVarint();
    info.OwnPoints = in.GetVarint();
    info.SharedPoints = in.GetVarint();
    const auto connectivity = GetSmall(in);
    const auto geometry = GetSmall(in);
    for (auto& range : info.Box)
    {
      range = GetRange(in);
    }
    SetSizes(info, cells, chunk, connectivity);
    this->Infos.push_back(info);
    this->Lengths.push_back({ connectivity, geometry });
  }
  Check(in.GetRemaining() == 0, "there are bytes behind the end of a page");
}

//------------------------------------------------------------------------------
void ChunkSummaries::Finish(MeshIndex& index, const MetaTable& meta, std::uint64_t fileSize)
{
  // Streams may overlap, but the streams that justify the counts must not overlap entirely.
  std::uint64_t left = fileSize;
  const auto take = [&](std::uint64_t bytes)
  {
    Check(bytes <= left, "the streams are longer than the file");
    left -= bytes;
  };
  for (const auto& page : index.Pages)
  {
    take(page.GeometryBytes);
  }
  take(index.Unused.Geometry.Length);
  std::uint64_t point = index.GetSharedPoints();
  std::uint64_t tet = 0;
  std::uint64_t cell = 0;
  for (std::size_t chunk = 0; chunk < this->Infos.size(); ++chunk)
  {
    auto& info = this->Infos[chunk];
    take(this->Lengths[chunk].Connectivity);
    take(this->Lengths[chunk].Geometry);
    info.FirstTet = tet;
    info.FirstCell = cell;
    info.FirstPoint = point;
    tet += info.Tets;
    cell += info.Cells;
    point += info.OwnPoints;
  }
  index.Unused.FirstPoint = point;
  Check(tet == meta.Tets, "the chunks' tetrahedra do not add up to the mesh's");
  Check(meta.UnusedPoints <= meta.Points && point == meta.Points - meta.UnusedPoints,
    "the chunks' points do not add up to the mesh's");
}

//------------------------------------------------------------------------------
namespace
{
BlockEntry GetBlock(ByteReader& in, std::size_t page, std::size_t chunks, std::uint8_t keep)
{
  BlockEntry block;
  block.Groups.resize(in.GetCount(4));
  Check(!block.Groups.empty(), "a block has no groups");
  for (auto& group : block.Groups)
  {
    group.Points = GetSmall(in);
    Check(group.Points >= 1, "a group has no points");
    block.Points += group.Points;
    group.Chunks = GetAscending(in, chunks, "a group names a chunk that is not there");
    Check(group.Chunks.size() >= 2, "a group is shared by fewer than two chunks");
    Check(group.Chunks.front() / ChunksPerPage == page, "a block is not in the page of its chunks");
  }
  GetBlockStreams(in, block, keep);
  return block;
}

MeshPage::Chunk GetChunk(
  ByteReader& in, const ChunkLengths& lengths, std::uint64_t blocks, std::uint8_t keep)
{
  MeshPage::Chunk chunk;
  auto& entry = chunk.Entry;
  entry.Connectivity = GetPosition(in, lengths.Connectivity);
  entry.Geometry = GetPosition(in, lengths.Geometry);
  for (const auto& [flag, stream] : { std::pair(KeepPoints, &entry.PointOrder),
         std::pair(KeepCells, &entry.CellOrder), std::pair(KeepCorners, &entry.Corners) })
  {
    if (keep & flag)
    {
      *stream = GetStream(in);
    }
  }
  chunk.Blocks = GetAscending(in, blocks, "a chunk names a block that is not there");
  return chunk;
}
}

//------------------------------------------------------------------------------
MeshPage MeshPage::Read(std::span<const std::uint8_t> details, std::size_t page,
  const MeshIndex& index, std::span<const ChunkLengths> lengths, std::uint8_t keep)
{
  const auto& ref = index.Pages[page];
  const auto data = Unpack(details, SmallTable);
  ByteReader in(data);
  MeshPage result;
  Check(ref.Blocks <= in.GetRemaining() / 5, "the blocks of a page are not all there");
  auto point = ref.FirstPoint;
  std::uint64_t bytes = 0;
  for (std::uint64_t b = 0; b < ref.Blocks; ++b)
  {
    auto& block = result.Blocks.emplace_back(GetBlock(in, page, index.Chunks, keep));
    block.FirstPoint = point;
    point += block.Points;
    bytes += block.Geometry.Length;
  }
  Check(point == ref.FirstPoint + ref.Points && bytes == ref.GeometryBytes,
    "the blocks of a page are not those that the table has");
  const auto first = page * ChunksPerPage;
  const auto count = index.GetChunksOfPage(page);
  for (std::size_t c = 0; c < count; ++c)
  {
    // The blocks of a chunk begin with those of lower chunks.
    result.Chunks.push_back(GetChunk(in, lengths[first + c], ref.FirstBlock + ref.Blocks, keep));
  }
  Check(in.GetRemaining() == 0, "there are bytes behind the end of a page");
  return result;
}

//------------------------------------------------------------------------------
std::uint64_t MeshPage::GetBytes() const
{
  std::uint64_t bytes = sizeof(*this) + this->Chunks.capacity() * sizeof(Chunk) +
    this->Blocks.capacity() * sizeof(BlockEntry);
  for (const auto& chunk : this->Chunks)
  {
    bytes += chunk.Blocks.capacity() * sizeof(std::uint32_t);
  }
  for (const auto& block : this->Blocks)
  {
    for (const auto& group : block.Groups)
    {
      bytes += sizeof(SharedGroup) + group.Chunks.capacity() * sizeof(std::uint32_t);
    }
  }
  return bytes;
}

//------------------------------------------------------------------------------
void AddParts(const BlockEntry& block, std::uint32_t number, std::uint32_t chunk,
  std::vector<ChunkEntry::Part>& parts)
{
  const auto before = parts.size();
  std::uint64_t inBlock = 0;
  for (std::uint32_t g = 0; g < block.Groups.size(); ++g)
  {
    const auto& group = block.Groups[g];
    if (std::binary_search(group.Chunks.begin(), group.Chunks.end(), chunk))
    {
      parts.push_back({ number, g, group.Points, inBlock, block.FirstPoint + inBlock });
    }
    inBlock += group.Points;
  }
  Check(parts.size() > before, "a chunk names a block that has none of its points");
}
}
