// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyFile.h"

#include "gatunError.h"
#include "gatunHartleyBlocks.h"
#include "gatunHartleyCodec.h"
#include "gatunHartleyCorrections.h"
#include "gatunHartleyEncoder.h"
#include "gatunHartleyOrder.h"
#include "gatunHartleyTables.h"
#include "gatunHartleyTransform.h"
#include "gatunHartleyVoxels.h"
#include "gatunInputFile.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace gatun
{
namespace
{
constexpr const char* MetaName = "the meta data";
constexpr const char* TableName = "the table of chunks";

std::string GetChunkName(std::size_t chunk)
{
  return "chunk " + std::to_string(chunk);
}

/** The blocks that have some voxels. */
struct BlockBox
{
  BlockBox(const HartleyLayout& layout, const HartleyLayout::Triple& first,
    const HartleyLayout::Triple& end)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      if (first[axis] >= end[axis] || end[axis] > layout.Size[axis])
      {
        ThrowInvalid("voxels " + std::to_string(first[axis]) + " to " + std::to_string(end[axis]) +
          " of " + std::to_string(layout.Size[axis]) + " were requested");
      }
      this->First[axis] = first[axis] / layout.Block[axis];
      this->End[axis] = (end[axis] - 1) / layout.Block[axis] + 1;
    }
  }

  bool Contains(const HartleyLayout::Triple& place) const
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      if (place[axis] < this->First[axis] || place[axis] >= this->End[axis])
      {
        return false;
      }
    }
    return true;
  }

  /** The chunks that have such blocks. */
  std::vector<std::size_t> FindChunks(const HartleyLayout& layout) const
  {
    std::vector<std::size_t> chunks;
    const auto all = layout.GetChunks();
    for (auto z = this->First[2] / layout.Chunk[2]; z * layout.Chunk[2] < this->End[2]; ++z)
    {
      for (auto y = this->First[1] / layout.Chunk[1]; y * layout.Chunk[1] < this->End[1]; ++y)
      {
        for (auto x = this->First[0] / layout.Chunk[0]; x * layout.Chunk[0] < this->End[0]; ++x)
        {
          chunks.push_back(x + std::size_t{ all[0] } * (y + std::size_t{ all[1] } * z));
        }
      }
    }
    return chunks;
  }

  HartleyLayout::Triple First{};
  HartleyLayout::Triple End{};
};
}

//------------------------------------------------------------------------------
struct HartleyFile::Internals
{
  Internals(std::shared_ptr<const ByteSource> source, const std::string& name);

  const HartleyLayout& GetLayout() const { return this->Meta.Layout; }
  std::shared_ptr<const HartleyOrder> GetOrder() const;
  const HartleyQuantizer& GetQuantizer() const;
  HartleyIntegers GetIntegers(std::size_t chunk) const;

  /** Calls use(place, values) with the voxels, minus the base, of the blocks of a chunk for which
   * isWanted(place) is true. */
  template <typename IsWanted, typename Use>
  void DecodeBlocks(std::size_t chunk, IsWanted&& isWanted, Use&& use) const;

  InputFile File;
  HartleyMeta Meta;
  HartleyTable Table;

private:
  // Their size depends on the block size. They are made when a chunk is decoded first.
  mutable std::once_flag OrderIsMade;
  mutable std::shared_ptr<const HartleyOrder> Order;
  mutable std::once_flag QuantizerIsMade;
  mutable std::unique_ptr<const HartleyQuantizer> Quantizer;
};

//------------------------------------------------------------------------------
HartleyFile::Internals::Internals(std::shared_ptr<const ByteSource> source, const std::string& name)
  : File(std::move(source), name, VolumeContainer)
{
  const auto meta = this->File.FindSection(SectionMeta, MetaName);
  this->Meta = this->File.Guarded(
    MetaName, meta, [&] { return HartleyMeta::Read(this->File.Read(meta, MetaName)); });
  const auto table = this->File.FindSection(SectionTable, TableName);
  this->Table = this->File.Guarded(TableName, table,
    [&] { return HartleyTable::Read(this->File.Read(table, TableName), this->Meta); });
  for (std::size_t chunk = 0; chunk < this->Table.Chunks.size(); ++chunk)
  {
    const auto& entry = this->Table.Chunks[chunk];
    const auto check = [&](const StreamRef& stream)
    {
      if (stream.Offset > this->File.GetSize() ||
        stream.Length > this->File.GetSize() - stream.Offset)
      {
        this->File.Fail(ErrorCode::Corrupt,
          std::string(TableName) + " is damaged: " + GetChunkName(chunk) +
            " extends beyond the end of the file");
      }
    };
    std::for_each(entry.Streams.begin(), entry.Streams.end(), check);
    check(entry.Corrections);
    if (entry.Streams.size() > 1)
    {
      for (std::size_t segment = 0; segment < entry.Streams.size(); ++segment)
      {
        if (entry.Streams[segment].Length <
          GetLeastHartleySegmentBytes(this->GetLayout().GetVoxelsPerBlock(), segment))
        {
          this->File.Fail(ErrorCode::Corrupt,
            std::string(TableName) + " is damaged: " + GetChunkName(chunk) + " is too short");
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<const HartleyOrder> HartleyFile::Internals::GetOrder() const
{
  const auto make = [&] { return std::make_shared<const HartleyOrder>(this->GetLayout().Block); };
  // That of a whole volume takes several times the memory of the volume, and there is only one
  // chunk to decode.
  if (this->GetLayout().IsWhole())
  {
    return make();
  }
  std::call_once(this->OrderIsMade, [&] { this->Order = make(); });
  return this->Order;
}

//------------------------------------------------------------------------------
const HartleyQuantizer& HartleyFile::Internals::GetQuantizer() const
{
  std::call_once(this->QuantizerIsMade,
    [&]
    {
      this->Quantizer =
        std::make_unique<const HartleyQuantizer>(this->GetLayout().Block, this->Meta.Steps);
    });
  return *this->Quantizer;
}

//------------------------------------------------------------------------------
HartleyIntegers HartleyFile::Internals::GetIntegers(std::size_t chunk) const
{
  const auto& entry = this->Table.Chunks[chunk];
  const auto name = GetChunkName(chunk);
  const auto order = this->GetOrder();
  const auto grid = GetHartleyGrid(this->GetLayout(), chunk);
  HartleyIntegers integers(
    CountHartleyBlocks(this->GetLayout(), chunk) * this->GetLayout().GetVoxelsPerBlock(), 0);
  ParallelFor(entry.Streams.size(),
    [&](std::size_t segment)
    {
      const auto& stream = entry.Streams[segment];
      this->File.Guarded(name, stream,
        [&]
        {
          const auto bytes = this->File.Read(stream, name);
          if (entry.Streams.size() == 1)
          {
            DecodeHartleyBlocks(*order, grid, bytes, integers);
          }
          else
          {
            DecodeHartleySegment(*order, segment, bytes, integers);
          }
        });
    });
  const auto zeros = std::count(integers.begin(), integers.end(), 0);
  if (integers.size() - static_cast<std::size_t>(zeros) != entry.Terms)
  {
    this->File.Fail(ErrorCode::Corrupt,
      name + " at byte " + std::to_string(entry.Streams.front().Offset) +
        " is damaged: its number of coefficients is wrong");
  }
  return integers;
}

//------------------------------------------------------------------------------
template <typename IsWanted, typename Use>
void HartleyFile::Internals::DecodeBlocks(std::size_t chunk, IsWanted&& isWanted, Use&& use) const
{
  const auto integers = this->GetIntegers(chunk);
  const auto& entry = this->Table.Chunks[chunk];
  const auto name = "the corrections of " + GetChunkName(chunk);
  const auto count = this->GetLayout().GetVoxelsPerBlock();
  const bool corrected = this->Meta.HasCorrections();
  const auto& quantizer = this->GetQuantizer();
  this->File.Guarded(name, entry.Corrections,
    [&]
    {
      Bytes bytes;
      std::optional<HartleyCorrector> corrector;
      if (corrected)
      {
        bytes = this->File.Read(entry.Corrections, name);
        corrector.emplace(bytes, this->GetLayout(), this->Meta.Values);
      }
      HartleyTransform transform(this->GetLayout().Block);
      std::vector<double> values(count);
      ForEachHartleyBlock(this->GetLayout(), chunk,
        [&](std::size_t block, const HartleyLayout::Triple& place)
        {
          const bool wanted = isWanted(place);
          if (wanted)
          {
            quantizer.Restore(std::span(integers).subspan(block * count, count), values);
            transform.Inverse(values);
          }
          if (corrected)
          {
            corrector->Correct(place, wanted ? std::span(values) : std::span<double>());
          }
          if (wanted)
          {
            use(place, values);
          }
        });
    });
}

//------------------------------------------------------------------------------
bool HartleyFile::CanRead(const std::string& path) noexcept
{
  return BeginsAs(path, VolumeContainer);
}

//------------------------------------------------------------------------------
HartleyFile::HartleyFile(const std::string& path)
  : HartleyFile(OpenFile(path), path)
{
}

//------------------------------------------------------------------------------
HartleyFile::HartleyFile(std::shared_ptr<const ByteSource> source, const std::string& name)
  : Data(std::make_unique<Internals>(std::move(source), name))
{
}

//------------------------------------------------------------------------------
HartleyFile::~HartleyFile() = default;

//------------------------------------------------------------------------------
const std::string& HartleyFile::GetPath() const
{
  return this->Data->File.GetPath();
}

//------------------------------------------------------------------------------
const VolumeInput& HartleyFile::GetVolume() const
{
  return this->Data->Meta.Volume;
}

//------------------------------------------------------------------------------
const HartleyRateControl& HartleyFile::GetRateControl() const
{
  return this->Data->Meta.RateControl;
}

//------------------------------------------------------------------------------
bool HartleyFile::IsLossless() const
{
  return this->Data->Meta.Lossless;
}

//------------------------------------------------------------------------------
const std::string& HartleyFile::GetWriterVersion() const
{
  return this->Data->Meta.WriterVersion;
}

//------------------------------------------------------------------------------
std::uint32_t HartleyFile::GetFormatVersion() const
{
  return this->Data->File.GetVersion();
}

//------------------------------------------------------------------------------
std::uint64_t HartleyFile::GetFileBytes() const
{
  return this->Data->File.GetSize();
}

//------------------------------------------------------------------------------
std::uint64_t HartleyFile::GetNumberOfTerms() const
{
  std::uint64_t terms = 0;
  for (const auto& chunk : this->Data->Table.Chunks)
  {
    terms += chunk.Terms;
  }
  return terms;
}

//------------------------------------------------------------------------------
double HartleyFile::GetRMSError() const
{
  return this->Data->Meta.RMSError;
}

//------------------------------------------------------------------------------
double HartleyFile::GetMaximumError() const
{
  return this->Data->Meta.MaximumError;
}

//------------------------------------------------------------------------------
std::uint64_t HartleyFile::GetChunkBytes(std::size_t chunk) const
{
  return this->Data->Table.Chunks[chunk].GetBytes();
}

//------------------------------------------------------------------------------
std::uint64_t HartleyFile::GetBytesRead() const
{
  return this->Data->File.GetBytesRead();
}

//------------------------------------------------------------------------------
const HartleyLayout& HartleyFile::GetLayout() const
{
  return this->Data->GetLayout();
}

//------------------------------------------------------------------------------
double HartleyFile::GetBase() const
{
  return this->Data->Meta.Values.Min;
}

//------------------------------------------------------------------------------
Range HartleyFile::GetRange() const
{
  return this->Data->Meta.Values;
}

//------------------------------------------------------------------------------
std::shared_ptr<const HartleyChunk> HartleyFile::GetChunk(std::size_t chunk) const
{
  const auto& self = *this->Data;
  return self.File.Guarded(GetChunkName(chunk), self.Table.Chunks[chunk].Streams.front(),
    [&]
    {
      return HartleyEncoder::MakeTerms(
        self.GetQuantizer(), self.GetLayout().GetVoxelsPerBlock(), self.GetIntegers(chunk));
    });
}

//------------------------------------------------------------------------------
std::vector<ByteRange> HartleyFile::GetByteRanges(
  const HartleyLayout::Triple& first, const HartleyLayout::Triple& end) const
{
  const auto& layout = this->GetLayout();
  std::vector<ByteRange> ranges;
  for (const auto chunk : BlockBox(layout, first, end).FindChunks(layout))
  {
    const auto& entry = this->Data->Table.Chunks[chunk];
    for (const auto& stream : entry.Streams)
    {
      this->Data->File.AddRanges(stream, ranges);
    }
    this->Data->File.AddRanges(entry.Corrections, ranges);
  }
  return ranges;
}

//------------------------------------------------------------------------------
void HartleyFile::GetVoxels(const HartleyLayout::Triple& first, const HartleyLayout::Triple& end,
  void* values, const std::function<bool(double)>& progress) const
{
  const auto& layout = this->GetLayout();
  const BlockBox blocks(layout, first, end);
  const auto isWanted = [&](const HartleyLayout::Triple& place) { return blocks.Contains(place); };
  const auto chunks = blocks.FindChunks(layout);
  if (const auto& source = this->Data->File.GetSource(); source.IsRemote())
  {
    source.Fetch(JoinRanges(this->GetByteRanges(first, end), 0));
  }
  const VoxelBox box{ first, end, this->GetVolume().Type, values };
  ForEachHartleyChunk(
    chunks.size(),
    [&](std::size_t i)
    {
      this->Data->DecodeBlocks(chunks[i], isWanted,
        [&](const HartleyLayout::Triple& place, std::span<const double> block)
        { StoreBlock(block, layout, place, this->GetBase(), this->GetRange(), box); });
    },
    progress);
}

//------------------------------------------------------------------------------
void HartleyFile::Verify(const std::function<bool(double)>& progress) const
{
  constexpr double sums = 0.2; // of the time
  const auto getPart = [&](double begin, double end) -> std::function<bool(double)>
  {
    if (!progress)
    {
      return {};
    }
    return [=, &progress](double done) { return progress(begin + done * (end - begin)); };
  };
  this->Data->File.CheckSections(getPart(0, sums));
  ForEachHartleyChunk(
    this->GetLayout().GetNumberOfChunks(),
    [&](std::size_t chunk)
    {
      this->GetChunk(chunk);
      if (this->Data->Meta.HasCorrections())
      {
        this->Data->DecodeBlocks(
          chunk, [](const auto&) { return false; }, [](const auto&, const auto&) {});
      }
    },
    getPart(sums, 1));
}
}
