// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunStepPages.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
// The maximum number of values in a stream. Each takes a decision of at least 2^-15.5 bits.
constexpr std::uint64_t MaxValuesPerByte = 1u << 19;

/** The number of arrays in the tables of a step: no coordinates if points stand still. */
std::size_t CountArrays(const MetaTable& meta, bool pointsMove)
{
  return pointsMove ? meta.Arrays.size() : meta.GetListedArrays();
}

/** The same for a step that is to be written. */
std::size_t CountArrays(const StepTable& step, const MetaTable& meta)
{
  return std::min(CountArrays(meta, step.PointsMove), step.Arrays.size());
}

Bytes WriteStepPage(
  const StepTable& step, const MetaTable& meta, const MeshIndex& mesh, std::size_t page)
{
  const auto first = page * ChunksPerPage;
  const auto& place = mesh.Pages[page];
  ByteWriter out;
  for (std::size_t a = 0; a < CountArrays(step, meta); ++a)
  {
    const auto& array = step.Arrays[a];
    for (auto chunk = first; chunk < first + mesh.GetChunksOfPage(page); ++chunk)
    {
      for (const auto& range : array.ChunkRanges[chunk])
      {
        PutRange(out, range);
      }
      PutStream(out, array.Chunks[chunk]);
    }
    if (meta.Arrays[a].Where == Association::Point)
    {
      for (auto block = place.FirstBlock; block < place.FirstBlock + place.Blocks; ++block)
      {
        PutStream(out, array.Blocks[block]);
      }
    }
  }
  return Pack(out, SmallStep);
}
}

//------------------------------------------------------------------------------
StepIndex WriteStepPages(
  const StepTable& step, const MetaTable& meta, const MeshIndex& mesh, const PutPage& put)
{
  StepIndex index{ step.Time, step.Key, step.Field, step.PointsMove, {}, {} };
  const auto arrays = CountArrays(step, meta);
  for (std::size_t a = 0; a < arrays; ++a)
  {
    const auto& array = step.Arrays[a];
    auto& entry = index.Arrays.emplace_back();
    entry.Components = static_cast<std::uint32_t>(array.Palettes.size());
    for (std::uint32_t c = 0; c < entry.Components; ++c)
    {
      if (!array.Palettes[c].IsPlain())
      {
        entry.Palettes.emplace_back(c, array.Palettes[c]);
      }
    }
    entry.Ranges = array.Ranges;
    entry.Unused = array.Blocks.empty() ? StreamRef() : array.Blocks.back();
  }
  for (std::size_t page = 0; arrays > 0 && page < mesh.Pages.size(); ++page)
  {
    index.Pages.push_back(put(WriteStepPage(step, meta, mesh, page)));
  }
  return index;
}

//------------------------------------------------------------------------------
bool StepIndex::Array::CanFollow(const Array& before) const
{
  // Keys of rounded values are plain. Both lists are in the order of the components.
  const auto next = [](auto& entry, const auto end)
  {
    while (entry != end && entry->second.Rounding)
    {
      ++entry;
    }
    return entry != end;
  };
  auto l = this->Palettes.begin();
  auto r = before.Palettes.begin();
  while (true)
  {
    const bool more = next(l, this->Palettes.end());
    if (more != next(r, before.Palettes.end()))
    {
      return false;
    }
    if (!more)
    {
      return true;
    }
    const bool areScales =
      l->second.Count == 0 && !l->second.IsCopy() && r->second.Count == 0 && !r->second.IsCopy();
    if (!areScales || l->first != r->first || !(l->second.Steps == r->second.Steps))
    {
      return false;
    }
    ++l;
    ++r;
  }
}

//------------------------------------------------------------------------------
/** Throws unless copies are whole arrays, of arrays of the same kind that have values. */
void StepIndex::CheckCopies(const MetaTable& meta) const
{
  for (std::size_t a = 0; a < this->Arrays.size(); ++a)
  {
    const auto& array = this->Arrays[a];
    const auto copies = std::count_if(array.Palettes.begin(), array.Palettes.end(),
      [](const auto& entry) { return entry.second.IsCopy(); });
    if (copies == 0)
    {
      continue;
    }
    const auto source = array.Palettes.front().second.SourceArray;
    Check(static_cast<std::uint64_t>(copies) == array.Components &&
        std::all_of(array.Palettes.begin(), array.Palettes.end(),
          [&](const auto& entry) { return entry.second.SourceArray == source; }),
      "only a part of an array is copied from another one");
    Check(source < meta.GetListedArrays() && !this->Arrays[source].IsCopy() &&
        meta.Arrays[source].Type == meta.Arrays[a].Type &&
        meta.Arrays[source].Where == meta.Arrays[a].Where &&
        std::all_of(array.Palettes.begin(), array.Palettes.end(),
          [&](const auto& entry)
          { return entry.second.SourceComponent < meta.Arrays[source].Components; }),
      "an array is copied from one that is not there");
  }
}

//------------------------------------------------------------------------------
Bytes StepIndex::Write(const MetaTable& meta) const
{
  ByteWriter out;
  out.Put(this->Time);
  out.Put(static_cast<std::uint8_t>(this->Key));
  PutStream(out, this->Field);
  if (meta.PointsMove)
  {
    out.Put(static_cast<std::uint8_t>(this->PointsMove));
  }
  const auto arrays = std::min(CountArrays(meta, this->PointsMove), this->Arrays.size());
  for (const auto& array : std::span(this->Arrays).first(arrays))
  {
    auto palette = array.Palettes.begin();
    for (std::uint32_t c = 0; c < array.Components; ++c)
    {
      const bool isThere = palette != array.Palettes.end() && palette->first == c;
      PutPalette(out, isThere ? (palette++)->second : PaletteRef());
    }
    for (const auto& range : array.Ranges)
    {
      PutRange(out, range);
    }
    PutStream(out, array.Unused);
  }
  for (const auto& page : this->Pages)
  {
    PutStream(out, page);
  }
  return Pack(out, SmallStep);
}

//------------------------------------------------------------------------------
void StepIndex::ReadArray(ByteReader& in, const ArrayDescription& description)
{
  auto& array = this->Arrays.emplace_back();
  const auto ranges = GetRangeCount(description.Components);
  Check(description.Components + 16 * ranges + 1 <= in.GetRemaining(),
    "the table of a step ends too early");
  array.Components = description.Components;
  for (std::uint32_t c = 0; c < array.Components; ++c)
  {
    const auto palette = GetPalette(in, description.Type);
    if (!palette.IsPlain())
    {
      array.Palettes.emplace_back(c, palette);
    }
  }
  array.Ranges.resize(ranges);
  for (auto& range : array.Ranges)
  {
    range = GetRange(in);
  }
  array.Unused = GetStream(in);
}

//------------------------------------------------------------------------------
StepIndex StepIndex::Read(std::span<const std::uint8_t> bytes, const MetaTable& meta,
  const MeshIndex& mesh, const StepIndex* before)
{
  const auto data = Unpack(bytes, SmallStep);
  ByteReader in(data);
  StepIndex step;
  step.Time = in.Get<double>();
  Check(!std::isnan(step.Time), "a time is not a number");
  step.Key = in.Get<std::uint8_t>() != 0;
  step.Field = GetStream(in);
  if (meta.PointsMove)
  {
    const auto move = in.Get<std::uint8_t>();
    Check(move <= 1 && (move == 1 || before), "a step has no coordinates");
    step.PointsMove = move == 1;
  }
  const auto arrays = CountArrays(meta, step.PointsMove);
  for (std::size_t a = 0; a < arrays; ++a)
  {
    const auto& description = meta.Arrays[a];
    step.ReadArray(in, description);
    const auto& array = step.Arrays.back();
    // The mesh has the coordinates of the first step.
    const bool isInMesh = meta.IsPoints(a) && !before;
    Check(!meta.IsPoints(a) ||
        std::all_of(array.Palettes.begin(), array.Palettes.end(),
          [](const auto& entry) { return static_cast<bool>(entry.second.Steps); }),
      "coordinates have a palette");
    if (description.Where == Association::Point && !array.IsCopy() && !isInMesh)
    {
      CheckValues(description, mesh.Unused.Points, array.Unused);
    }
  }
  step.CheckCopies(meta);
  const auto pages = arrays == 0 ? 0 : mesh.Pages.size();
  Check(pages <= in.GetRemaining(), "the table of a step ends too early");
  step.Pages.resize(pages);
  for (auto& page : step.Pages)
  {
    page = GetStream(in);
  }
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the table of a step");
  if (meta.PointsMove && !step.PointsMove)
  {
    step.Arrays.push_back(before->Arrays.back());
  }
  return step;
}

//------------------------------------------------------------------------------
StepPage StepPage::Read(std::span<const std::uint8_t> bytes, std::size_t page,
  const StepIndex& step, const MetaTable& meta, const MeshIndex& mesh)
{
  const auto data = Unpack(bytes, SmallStep);
  ByteReader in(data);
  const auto chunks = mesh.GetChunksOfPage(page);
  StepPage result;
  for (std::size_t a = 0; a < CountArrays(meta, step.PointsMove); ++a)
  {
    const auto& description = meta.Arrays[a];
    auto& array = result.Arrays.emplace_back();
    const auto ranges = GetRangeCount(description.Components);
    Check(chunks <= in.GetRemaining() / (1 + 16 * ranges), "a page of a step ends too early");
    array.Ranges.reserve(chunks * ranges);
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
    {
      for (std::size_t i = 0; i < ranges; ++i)
      {
        array.Ranges.push_back(GetRange(in));
      }
      array.Chunks.push_back(GetStream(in));
    }
    if (description.Where == Association::Point)
    {
      const auto blocks = mesh.Pages[page].Blocks;
      Check(blocks <= in.GetRemaining(), "a page of a step ends too early");
      array.Blocks.reserve(static_cast<std::size_t>(blocks));
      for (std::uint64_t block = 0; block < blocks; ++block)
      {
        array.Blocks.push_back(GetStream(in));
      }
    }
  }
  Check(in.GetRemaining() == 0, "there are bytes behind the end of a page of a step");
  return result;
}

//------------------------------------------------------------------------------
std::uint64_t StepPage::GetBytes() const
{
  std::uint64_t bytes = sizeof(*this) + this->Arrays.capacity() * sizeof(Array);
  for (const auto& array : this->Arrays)
  {
    bytes += array.Ranges.capacity() * sizeof(Range) +
      (array.Chunks.capacity() + array.Blocks.capacity()) * sizeof(StreamRef);
  }
  return bytes;
}

//------------------------------------------------------------------------------
void CheckValues(const ArrayDescription& array, std::uint64_t tuples, const StreamRef& stream)
{
  Check(tuples * array.Components / MaxValuesPerByte <= stream.Length,
    "an array claims more values than its stream can hold");
}
}
