// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartAssembly.h"

#include "gatunError.h"
#include "gatunPaths.h"

#include <array>
#include <cstring>
#include <filesystem>
#include <string>
#include <type_traits>
#include <utility>

namespace gatun
{
namespace
{
// Processes have the same byte order and data types.
template <typename T>
void PutRaw(ByteWriter& out, const T& value)
{
  static_assert(std::is_trivially_copyable_v<T>);
  out.PutBytes({ reinterpret_cast<const std::uint8_t*>(&value), sizeof(T) });
}

template <typename T>
T GetRaw(ByteReader& in)
{
  static_assert(std::is_trivially_copyable_v<T>);
  T value;
  std::memcpy(&value, in.GetBytes(sizeof(T)).data(), sizeof(T));
  return value;
}

template <typename T>
void PutRaw(ByteWriter& out, std::span<const T> values)
{
  out.PutVarint(values.size());
  for (const auto& value : values)
  {
    PutRaw(out, value);
  }
}

template <typename T>
std::vector<T> GetRawVector(ByteReader& in)
{
  std::vector<T> values(static_cast<std::size_t>(in.GetCount(sizeof(T))));
  for (auto& value : values)
  {
    value = GetRaw<T>(in);
  }
  return values;
}

/** Calls use for each number of bytes. */
template <typename Statistics, typename Use>
void ForEachNumber(Statistics& s, Use&& use)
{
  use(s.FileBytes);
  use(s.ConnectivityBytes);
  use(s.GeometryBytes);
  use(s.SharedGeometryBytes);
  use(s.OrderBytes);
  use(s.FieldDataBytes);
  use(s.DirectoryBytes);
  for (auto& bytes : s.ArrayBytes)
  {
    use(bytes);
  }
}

void PutStatistics(ByteWriter& out, const FileStatistics& statistics)
{
  ForEachNumber(statistics, [&](std::uint64_t bytes) { out.PutVarint(bytes); });
}

FileStatistics GetStatistics(ByteReader& in, std::size_t arrays)
{
  FileStatistics statistics;
  statistics.ArrayBytes.resize(arrays);
  ForEachNumber(statistics, [&](std::uint64_t& bytes) { bytes = in.GetVarint(); });
  return statistics;
}

/** Calls use(stream) for the streams of a chunk. */
template <typename Entry, typename Use>
void ForEachStream(Entry& chunk, Use&& use)
{
  use(chunk.Connectivity);
  use(chunk.Geometry);
  use(chunk.PointOrder);
  use(chunk.CellOrder);
  use(chunk.Corners);
}

void PutChunk(ByteWriter& out, const ChunkEntry& chunk)
{
  ForEachStream(chunk, [&](const StreamRef& stream) { PutRaw(out, stream); });
  PutRaw(out, chunk.Sizes);
  PutRaw(out, chunk.Info.Box);
  out.PutVarint(chunk.Info.Tets);
  out.PutVarint(chunk.Info.OwnPoints);
  out.PutVarint(chunk.Info.Cells);
  out.Put<std::uint8_t>(chunk.Info.IsTetrahedral);
}

ChunkEntry GetChunk(ByteReader& in)
{
  ChunkEntry chunk;
  ForEachStream(chunk, [&](StreamRef& stream) { stream = GetRaw<StreamRef>(in); });
  chunk.Sizes = GetRaw<CellSizes>(in);
  chunk.Info.Box = GetRaw<Bounds>(in);
  chunk.Info.Tets = in.GetVarint();
  chunk.Info.OwnPoints = in.GetVarint();
  chunk.Info.Cells = in.GetVarint();
  chunk.Info.IsTetrahedral = in.Get<std::uint8_t>() != 0;
  return chunk;
}

template <typename T>
std::span<const T> GetPart(const std::vector<T>& all, std::size_t first, std::size_t count)
{
  return std::span(all).subspan(first, count);
}
}

//------------------------------------------------------------------------------
PartAssembly::PartAssembly(PartExchange& exchange, const PartAgreement& agreement,
  WriterState& state, StepSection& steps, OutputFile* common)
  : Exchange(exchange)
  , Agreement(agreement)
  , State(state)
  , Steps(steps)
  , Common(common)
{
}

//------------------------------------------------------------------------------
/** Moves a stream to its position in the common file. */
void PartAssembly::Contribution::Move(StreamRef& stream) const
{
  if (stream.Offset != 0) // there is one
  {
    stream.Offset = stream.Offset - this->Begin + this->Offset;
  }
}

//------------------------------------------------------------------------------
Bytes PartAssembly::PutOwn() const
{
  const auto& share = this->Agreement.GetOwn();
  const auto& table = this->State.Table;
  const auto& meta = this->State.Meta;
  ByteWriter out;
  out.Put(this->State.File.GetSize());
  PutRaw(out, std::span(this->State.File.GetSections()));
  PutRaw(out, table.Palettes);
  PutRaw(out, table.Unused.Geometry);
  PutRaw(out, table.Unused.Order);
  for (std::size_t c = 0; c < share.Chunks; ++c)
  {
    PutChunk(out, table.Chunks[share.FirstChunk + c]);
  }
  for (std::size_t b = 0; b < share.Blocks; ++b)
  {
    PutRaw(out, table.Blocks[share.FirstBlock + b].Geometry);
    PutRaw(out, table.Blocks[share.FirstBlock + b].Order);
  }
  out.PutVarint(meta.Tets);
  PutRaw(out, meta.Box);
  out.Put<std::uint8_t>(meta.HasTime);
  PutStatistics(out, this->State.Statistics);
  const auto& steps = this->Steps.GetSteps();
  out.PutVarint(share.Parts > 0 ? steps.size() : 0);
  for (std::size_t s = 0; share.Parts > 0 && s < steps.size(); ++s)
  {
    const auto& step = steps[s].Table;
    out.Put(step.Time);
    out.Put<std::uint8_t>(step.Key);
    PutRaw(out, step.Field);
    for (const auto& array : step.Arrays)
    {
      PutRaw(out, std::span(array.Palettes));
      PutRaw(out, std::span(array.Ranges));
      PutRaw(out, GetPart(array.Chunks, share.FirstChunk, share.Chunks));
      for (std::size_t c = 0; c < share.Chunks; ++c)
      {
        PutRaw(out, std::span(array.ChunkRanges[share.FirstChunk + c]));
      }
      PutRaw(out,
        array.Blocks.empty() ? std::span<const StreamRef>()
                             : GetPart(array.Blocks, share.FirstBlock, share.Blocks));
      PutRaw(out, array.Blocks.empty() ? StreamRef() : array.Blocks.back());
    }
  }
  return out.Data;
}

//------------------------------------------------------------------------------
PartAssembly::Contribution PartAssembly::Read(const Bytes& message, const ProcessShare& share) const
{
  ByteReader in(message);
  Contribution part;
  part.Size = in.Get<std::uint64_t>();
  part.Sections = GetRawVector<SectionRef>(in);
  part.Table.Palettes = GetRaw<std::array<PaletteRef, 3>>(in);
  part.Table.Unused.Geometry = GetRaw<StreamRef>(in);
  part.Table.Unused.Order = GetRaw<StreamRef>(in);
  for (std::size_t c = 0; c < share.Chunks; ++c)
  {
    part.Table.Chunks.push_back(GetChunk(in));
  }
  part.Table.Blocks.resize(share.Blocks);
  for (auto& block : part.Table.Blocks)
  {
    block.Geometry = GetRaw<StreamRef>(in);
    block.Order = GetRaw<StreamRef>(in);
  }
  part.Meta.Tets = in.GetVarint();
  part.Meta.Box = GetRaw<Bounds>(in);
  part.Meta.HasTime = in.Get<std::uint8_t>() != 0;
  part.Statistics = GetStatistics(in, this->State.Meta.Arrays.size());
  part.Steps.resize(static_cast<std::size_t>(in.GetCount(1)));
  for (auto& step : part.Steps)
  {
    step.Time = in.Get<double>();
    step.Key = in.Get<std::uint8_t>() != 0;
    step.Field = GetRaw<StreamRef>(in);
    step.Arrays.resize(this->State.Meta.Arrays.size());
    for (auto& array : step.Arrays)
    {
      array.Palettes = GetRawVector<PaletteRef>(in);
      array.Ranges = GetRawVector<Range>(in);
      array.Chunks = GetRawVector<StreamRef>(in);
      array.ChunkRanges.resize(share.Chunks);
      for (auto& ranges : array.ChunkRanges)
      {
        ranges = GetRawVector<Range>(in);
      }
      array.Blocks = GetRawVector<StreamRef>(in);
      array.Blocks.push_back(GetRaw<StreamRef>(in));
    }
  }
  return part;
}

//------------------------------------------------------------------------------
/** The table of a step whose values are all in their places. */
StepTable PartAssembly::MakeStep(const std::vector<Contribution>& all, std::size_t step) const
{
  const auto& shares = this->Agreement.GetShares();
  StepTable table;
  bool isFirst = true;
  for (std::size_t p = 0; p < all.size(); ++p)
  {
    if (shares[p].Parts == 0)
    {
      continue;
    }
    const auto& part = all[p].Steps[step];
    const auto move = [&](StreamRef stream)
    {
      all[p].Move(stream);
      return stream;
    };
    if (isFirst)
    {
      table = part;
      table.Field = move(table.Field);
      for (auto& array : table.Arrays)
      {
        for (auto& palette : array.Palettes)
        {
          palette.Stream = move(palette.Stream);
        }
        array.Chunks.clear();
        array.ChunkRanges.clear();
        array.Blocks.clear();
      }
    }
    for (std::size_t a = 0; a < table.Arrays.size(); ++a)
    {
      auto& array = table.Arrays[a];
      const auto& own = part.Arrays[a];
      for (std::size_t c = 0; c < array.Palettes.size(); ++c)
      {
        auto& reached = array.Palettes[c].Rounding.Reached;
        reached = std::max(reached, own.Palettes[c].Rounding.Reached);
      }
      for (std::size_t i = 0; !isFirst && i < array.Ranges.size(); ++i)
      {
        array.Ranges[i].Include(own.Ranges[i]);
      }
      array.ChunkRanges.insert(
        array.ChunkRanges.end(), own.ChunkRanges.begin(), own.ChunkRanges.end());
      for (const auto& stream : own.Chunks)
      {
        array.Chunks.push_back(move(stream));
      }
      if (this->State.Meta.Arrays[a].Where == Association::Point)
      {
        const bool isLast = p == this->Agreement.GetLast();
        for (std::size_t b = 0; b + (isLast ? 0 : 1) < own.Blocks.size(); ++b)
        {
          array.Blocks.push_back(move(own.Blocks[b]));
        }
      }
    }
    isFirst = false;
  }
  return table;
}

//------------------------------------------------------------------------------
/** Fills the tables of the first process. */
void PartAssembly::TakeTables(const std::vector<Contribution>& all)
{
  const auto& shares = this->Agreement.GetShares();
  const auto last = this->Agreement.GetLast();
  auto& table = this->State.Table;
  auto& meta = this->State.Meta;
  auto& statistics = this->State.Statistics;
  meta.Tets = 0;
  meta.Box = {};
  ForEachNumber(statistics, [](std::uint64_t& bytes) { bytes = 0; });
  for (std::size_t p = 0; p < all.size(); ++p)
  {
    const auto& part = all[p];
    const auto& share = shares[p];
    const auto move = [&](StreamRef stream)
    {
      part.Move(stream);
      return stream;
    };
    for (std::size_t c = 0; c < share.Chunks; ++c)
    {
      const auto& own = part.Table.Chunks[c];
      auto& entry = table.Chunks[share.FirstChunk + c];
      entry.Connectivity = move(own.Connectivity);
      entry.Geometry = move(own.Geometry);
      entry.PointOrder = move(own.PointOrder);
      entry.CellOrder = move(own.CellOrder);
      entry.Corners = move(own.Corners);
      entry.Sizes = own.Sizes;
      entry.Info.Box = own.Info.Box;
      entry.Info.Tets = own.Info.Tets;
      entry.Info.OwnPoints = own.Info.OwnPoints;
      entry.Info.Cells = own.Info.Cells;
      entry.Info.IsTetrahedral = own.Info.IsTetrahedral;
      this->State.Cells.Chunks[share.FirstChunk + c] = own.Sizes;
    }
    for (std::size_t b = 0; b < share.Blocks; ++b)
    {
      table.Blocks[share.FirstBlock + b].Geometry = move(part.Table.Blocks[b].Geometry);
      table.Blocks[share.FirstBlock + b].Order = move(part.Table.Blocks[b].Order);
    }
    if (share.Parts > 0 && share.FirstPart == 0)
    {
      table.Palettes = part.Table.Palettes;
      for (auto& palette : table.Palettes)
      {
        palette.Stream = move(palette.Stream);
      }
      meta.HasTime = part.Meta.HasTime;
    }
    if (p == last)
    {
      table.Unused.Geometry = move(part.Table.Unused.Geometry);
      table.Unused.Order = move(part.Table.Unused.Order);
    }
    meta.Tets += part.Meta.Tets;
    meta.Box.Include(part.Meta.Box);
    std::vector<std::uint64_t> numbers;
    ForEachNumber(part.Statistics, [&](std::uint64_t bytes) { numbers.push_back(bytes); });
    ForEachNumber(
      statistics, [&, i = std::size_t{ 0 }](std::uint64_t& sum) mutable { sum += numbers[i++]; });
  }
}

//------------------------------------------------------------------------------
/** Places the sections of all processes, and writes the tables. Returns what each process has to
 * know. */
std::vector<PartExchange::Message> PartAssembly::Assemble(
  const std::vector<PartExchange::Message>& messages)
{
  const auto& shares = this->Agreement.GetShares();
  std::vector<Contribution> all;
  const Contribution* first = nullptr;
  for (std::size_t p = 0; p < messages.size(); ++p)
  {
    all.push_back(this->Read(messages[p], shares[p]));
  }
  for (std::size_t p = 0; p < all.size(); ++p)
  {
    first = !first && shares[p].Parts > 0 ? &all[p] : first;
    const auto isSame = [](const StepTable& l, const StepTable& r) { return l.Time == r.Time; };
    if (shares[p].Parts > 0 &&
      (all[p].Meta.HasTime != first->Meta.HasTime ||
        !std::equal(all[p].Steps.begin(), all[p].Steps.end(), first->Steps.begin(),
          first->Steps.end(), isSame)))
    {
      ThrowInvalid("parts have different times");
    }
  }
  auto& file = *this->Common;
  const auto header = file.GetSize();
  for (auto& part : all)
  {
    if (part.Size > header)
    {
      part.Begin = header;
      part.Offset = file.AddSections(part.Sections, header, part.Size);
    }
  }
  for (std::size_t i = 0; first && i < first->Steps.size(); ++i)
  {
    this->State.AddStep(this->MakeStep(all, i));
  }
  this->TakeTables(all);
  this->State.WriteTables(file);
  file.AddSection(SectionMeta, this->State.Meta.Write());
  std::vector<PartExchange::Message> answers;
  for (const auto& part : all)
  {
    ByteWriter out;
    out.PutString(ToText(std::filesystem::absolute(ToPath(file.GetTemporary()))));
    out.Put(part.Begin);
    out.Put(part.Offset);
    out.Put<std::uint64_t>(part.Begin == 0 ? 0 : part.Size - part.Begin);
    answers.push_back(std::move(out.Data));
  }
  return answers;
}

//------------------------------------------------------------------------------
void PartAssembly::CopyOwn(const PartExchange::Message& message) const
{
  ByteReader in(message);
  const auto path = in.GetString();
  const auto begin = in.Get<std::uint64_t>();
  const auto offset = in.Get<std::uint64_t>();
  if (const auto bytes = in.Get<std::uint64_t>(); bytes > 0)
  {
    this->State.File.CopyTo(path, begin, offset, bytes);
  }
}

//------------------------------------------------------------------------------
FileStatistics PartAssembly::Finish()
{
  PartExchange::Message own;
  this->Exchange.Together([&] { own = this->PutOwn(); });
  const auto messages = this->Exchange.GatherInFirst(std::move(own));
  std::vector<PartExchange::Message> answers(messages.size());
  this->Exchange.Together(
    [&]
    {
      if (this->Common)
      {
        answers = this->Assemble(messages);
      }
    });
  const auto answer = this->Exchange.Exchange(std::move(answers))[0];
  this->Exchange.Together([&] { this->CopyOwn(answer); });
  ByteWriter out;
  this->Exchange.Together(
    [&]
    {
      if (this->Common)
      {
        PutStatistics(out, this->State.Commit(*this->Common));
      }
    });
  const auto statistics = this->Exchange.TakeFirst(out.Data);
  ByteReader in(statistics);
  return GetStatistics(in, this->State.Meta.Arrays.size());
}
}
