// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyTables.h"

#include "gatunHartleyBlocks.h"
#include "gatunHartleyOrder.h"
#include "gatunHartleyVoxels.h"
#include "gatunVersion.h"
#include "gatunWithType.h"

#include <cmath>
#include <limits>
#include <type_traits>

namespace gatun
{
namespace
{
constexpr double ShiftUnits = 256;
constexpr double LargestStep = 1e36;
constexpr std::uint8_t FlagLossless = 1;

double GetFinite(ByteReader& in, const char* what)
{
  const auto value = in.Get<double>();
  if (!std::isfinite(value))
  {
    ThrowCorrupt(std::string(what) + " is not a finite number");
  }
  return value;
}

double GetBetween(ByteReader& in, double least, double most, const char* what)
{
  const auto value = in.Get<double>();
  if (!(value >= least && value <= most))
  {
    ThrowCorrupt(std::string(what) + " is out of range");
  }
  return value;
}

std::uint32_t GetSize(ByteReader& in)
{
  const auto size = in.GetVarint();
  if (size > std::numeric_limits<std::uint32_t>::max())
  {
    ThrowCorrupt("a size is too large");
  }
  return static_cast<std::uint32_t>(size);
}

/** Whether a type can represent both ends of a range. */
bool Holds(ScalarType type, const Range& range)
{
  bool holds = false;
  WithType(type, nullptr,
    [&](const auto* typed)
    {
      using T = std::remove_cv_t<std::remove_pointer_t<decltype(typed)>>;
      // Integers are limited to the exact range of doubles.
      const double least = std::is_floating_point_v<T> || sizeof(T) < 8
        ? static_cast<double>(std::numeric_limits<T>::lowest())
        : std::is_signed_v<T> ? -LargestVoxelInteger
                              : 0;
      const double most = std::is_floating_point_v<T> || sizeof(T) < 8
        ? static_cast<double>(std::numeric_limits<T>::max())
        : LargestVoxelInteger;
      holds = range.Min >= least && range.Max <= most &&
        (std::is_floating_point_v<T> ||
          (range.Min == std::floor(range.Min) && range.Max == std::floor(range.Max)));
    });
  return holds;
}

void Put(ByteWriter& out, const StreamRef& stream, std::uint64_t& end)
{
  out.PutVarint(stream.Offset - end);
  out.PutVarint(stream.Length);
  out.Put(stream.Sum);
  end = stream.Offset + stream.Length;
}

StreamRef GetStream(ByteReader& in, std::uint64_t& end)
{
  StreamRef stream;
  const auto gap = in.GetVarint();
  stream.Length = in.GetVarint();
  stream.Sum = in.Get<std::uint64_t>();
  constexpr auto most = std::uint64_t{ 1 } << 62;
  if (gap > most || stream.Length > most || end > most)
  {
    ThrowCorrupt("a stream is too far away");
  }
  stream.Offset = end + gap;
  end = stream.Offset + stream.Length;
  return stream;
}

// The minimum size of a stream's entry, and of a chunk's entry without its streams.
constexpr std::uint64_t StreamBytes = 10;
constexpr std::uint64_t ChunkBytes = 1;
}

//------------------------------------------------------------------------------
std::size_t CountHartleyStreams(const HartleyLayout& layout)
{
  return (layout.GetVoxelsPerBlock() + HartleyOrder::SegmentLength - 1) /
    HartleyOrder::SegmentLength;
}

//------------------------------------------------------------------------------
Bytes HartleyMeta::Write() const
{
  ByteWriter out;
  out.PutString(this->WriterVersion);
  for (const auto size : this->Volume.Size)
  {
    out.PutVarint(size);
  }
  out.PutVarint(this->BlockSize);
  out.Put(static_cast<std::uint8_t>(this->Volume.Type));
  out.Put(this->Volume.VTKType);
  out.PutString(this->Volume.Name);
  for (const double value : this->Volume.Origin)
  {
    out.Put(value);
  }
  for (const double value : this->Volume.Spacing)
  {
    out.Put(value);
  }
  for (const double value : this->Volume.Direction)
  {
    out.Put(value);
  }
  for (const auto index : this->Volume.FirstIndex)
  {
    out.Put(index);
  }
  out.Put(this->Values.Min);
  out.Put(this->Values.Max);
  out.Put(this->Lossless ? FlagLossless : std::uint8_t{ 0 });
  out.Put(this->Steps.Step);
  out.Put(this->Steps.Weight);
  for (const double shift : this->Steps.Shifts)
  {
    out.Put(static_cast<std::int16_t>(std::lround(shift * ShiftUnits)));
  }
  out.Put(static_cast<std::uint8_t>(this->RateControl.Mode));
  out.Put(this->RateControl.Value);
  out.Put(this->RMSError);
  out.Put(this->MaximumError);
  return std::move(out.Data);
}

//------------------------------------------------------------------------------
HartleyMeta HartleyMeta::Read(std::span<const std::uint8_t> bytes)
{
  ByteReader in(bytes);
  HartleyMeta meta;
  meta.WriterVersion = in.GetString();
  for (auto& size : meta.Volume.Size)
  {
    size = GetSize(in);
  }
  meta.BlockSize = GetSize(in);
  try
  {
    meta.Layout = HartleyLayout::Make(meta.Volume.Size, meta.BlockSize);
  }
  catch (const Error& error)
  {
    ThrowCorrupt(error.what());
  }
  const auto type = in.Get<std::uint8_t>();
  if (type < static_cast<std::uint8_t>(ScalarType::Int8) ||
    type > static_cast<std::uint8_t>(ScalarType::Float64))
  {
    ThrowCorrupt("there is no type " + std::to_string(type));
  }
  meta.Volume.Type = static_cast<ScalarType>(type);
  meta.Volume.VTKType = in.Get<std::int32_t>();
  meta.Volume.Name = in.GetString();
  for (double& value : meta.Volume.Origin)
  {
    value = GetFinite(in, "the origin");
  }
  for (double& value : meta.Volume.Spacing)
  {
    value = GetFinite(in, "the spacing");
  }
  for (double& value : meta.Volume.Direction)
  {
    value = GetFinite(in, "the direction");
  }
  for (auto& index : meta.Volume.FirstIndex)
  {
    index = in.Get<std::int32_t>();
  }
  meta.Values.Min = GetFinite(in, "the smallest voxel");
  meta.Values.Max = GetFinite(in, "the largest voxel");
  if (!(meta.Values.Max - meta.Values.Min >= 0 &&
        meta.Values.Max - meta.Values.Min <= LargestVoxelRange) ||
    !Holds(meta.Volume.Type, meta.Values))
  {
    ThrowCorrupt("the range of the voxels is not possible");
  }
  const auto flags = in.Get<std::uint8_t>();
  if (flags > FlagLossless)
  {
    ThrowCorrupt("there is no flag " + std::to_string(flags));
  }
  meta.Lossless = flags & FlagLossless;
  meta.Steps.Step =
    GetBetween(in, std::numeric_limits<double>::min(), LargestStep, "the step of the quantizer");
  meta.Steps.Weight = GetBetween(in, 0, 4, "the weight of frequencies");
  meta.RateControl.FrequencyWeight = meta.Steps.Weight;
  for (double& shift : meta.Steps.Shifts)
  {
    shift = in.Get<std::int16_t>() / ShiftUnits;
    if (std::abs(shift) > 0.5)
    {
      ThrowCorrupt("a shift of the quantizer is out of range");
    }
  }
  meta.Steps.Nearest = meta.Lossless;
  const auto kind = in.Get<std::uint8_t>();
  if (kind > static_cast<std::uint8_t>(HartleyRateMode::BitsPerVoxel))
  {
    ThrowCorrupt("there is no rate control mode " + std::to_string(kind));
  }
  meta.RateControl.Mode = static_cast<HartleyRateMode>(kind);
  meta.RateControl.Value = GetFinite(in, "the quality");
  constexpr double most = std::numeric_limits<double>::max();
  meta.RMSError = GetBetween(in, 0, most, "the error");
  meta.MaximumError = GetBetween(in, 0, most, "the largest error");
  if (in.GetRemaining() != 0)
  {
    ThrowCorrupt("there are bytes after their end");
  }
  return meta;
}

//------------------------------------------------------------------------------
std::uint64_t HartleyChunkEntry::GetBytes() const
{
  std::uint64_t bytes = this->Corrections.Length;
  for (const auto& stream : this->Streams)
  {
    bytes += stream.Length;
  }
  return bytes;
}

//------------------------------------------------------------------------------
Bytes HartleyTable::Write(const HartleyMeta& meta) const
{
  ByteWriter out;
  std::uint64_t end = 0;
  for (const auto& chunk : this->Chunks)
  {
    out.PutVarint(chunk.Terms);
    for (const auto& stream : chunk.Streams)
    {
      Put(out, stream, end);
    }
    if (meta.HasCorrections())
    {
      Put(out, chunk.Corrections, end);
    }
  }
  return std::move(out.Data);
}

//------------------------------------------------------------------------------
HartleyTable HartleyTable::Read(std::span<const std::uint8_t> bytes, const HartleyMeta& meta)
{
  ByteReader in(bytes);
  const auto& layout = meta.Layout;
  const std::uint64_t count = layout.GetNumberOfChunks();
  const std::uint64_t streams = CountHartleyStreams(layout);
  const auto bytesEach = ChunkBytes + StreamBytes * (streams + meta.HasCorrections());
  if (count > in.GetRemaining() / bytesEach)
  {
    ThrowCorrupt("there are fewer chunks than the volume needs");
  }
  HartleyTable table;
  table.Chunks.resize(static_cast<std::size_t>(count));
  std::uint64_t end = 0;
  for (std::size_t i = 0; i < table.Chunks.size(); ++i)
  {
    auto& chunk = table.Chunks[i];
    chunk.Terms = in.GetVarint();
    if (chunk.Terms > CountHartleyBlocks(layout, i) * layout.GetVoxelsPerBlock())
    {
      ThrowCorrupt("chunk " + std::to_string(i) + " has more coefficients than its blocks");
    }
    chunk.Streams.reserve(static_cast<std::size_t>(streams));
    for (std::uint64_t s = 0; s < streams; ++s)
    {
      chunk.Streams.push_back(GetStream(in, end));
    }
    if (meta.HasCorrections())
    {
      chunk.Corrections = GetStream(in, end);
    }
  }
  if (in.GetRemaining() != 0)
  {
    ThrowCorrupt("there are bytes after its end");
  }
  return table;
}
}
