// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTreeTable.h"

#include "gatunTableParts.h"

#include <algorithm>

namespace gatun
{
namespace
{
/** Reads ascending numbers of merges from 1 to most. */
std::vector<std::uint32_t> GetAscending(ByteReader& in, std::uint32_t most)
{
  std::vector<std::uint32_t> numbers(in.GetCount(1));
  Check(numbers.size() <= TreeTable::MaxMergeCounts, "there are too many merge counts or levels");
  std::uint32_t last = 0;
  for (auto& number : numbers)
  {
    number = GetSmall(in);
    Check(number > last && number <= most, "numbers of merges do not ascend");
    last = number;
  }
  return numbers;
}

void PutMergeNumbers(ByteWriter& out, const std::vector<std::uint32_t>& numbers)
{
  out.PutVarint(numbers.size());
  for (const auto number : numbers)
  {
    out.PutVarint(number);
  }
}

void PutParts(ByteWriter& out, const std::vector<TreePart>& parts)
{
  out.PutVarint(parts.size());
  for (const TreePart& part : parts)
  {
    out.PutVarint(part.Points);
    PutStream(out, part.Merges);
    PutStream(out, part.Map);
    PutStream(out, part.Dependencies);
  }
}

/** Reads the parts of a table that has the numbers of merges. */
std::vector<TreePart> GetParts(
  ByteReader& in, const TreeTable& tree, const MetaTable& meta, bool isSurface)
{
  std::vector<TreePart> parts(in.GetCount(1));
  Check(parts.empty() || parts.size() == tree.Levels.size() + 1,
    "there are not as many parts of the merges as meshes");
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    TreePart& part = parts[i];
    part.Points = GetSmall(in);
    part.Merges = GetStream(in);
    part.Map = GetStream(in);
    part.Dependencies = GetStream(in);
    Check(i > 0 ? part.Points <= meta.Points - tree.GetFirstMerge(i)
                : part.Points == CountMergeablePoints(meta, isSurface),
      "the points that may be merged are not those of the mesh");
    Check(tree.GetMergesOfPart(i) <= part.Points, "there are more merges than points");
    Check((tree.GetMergesOfPart(i) > 0) == (part.Merges.Length > 0), "the merges have no stream");
    Check((i + 1 < parts.size()) == (part.Map.Length > 0),
      "the numbers of points in a base mesh have no stream");
  }
  return parts;
}

constexpr std::uint64_t RangeBytes = 16;
}

//------------------------------------------------------------------------------
std::uint32_t CountMergeablePoints(const MetaTable& meta, bool isSurface)
{
  return static_cast<std::uint32_t>(meta.Points - (isSurface ? 0 : meta.UnusedPoints));
}

//------------------------------------------------------------------------------
Bytes TreeTable::Write() const
{
  ByteWriter out;
  out.PutVarint(this->Merges);
  PutMergeNumbers(out, this->Levels);
  PutParts(out, this->Parts);
  PutMergeNumbers(out, this->MergeCounts);
  for (const auto& mergeCounts : this->Boxes)
  {
    for (const Bounds& box : mergeCounts)
    {
      for (const Range& range : box)
      {
        PutRange(out, range);
      }
    }
  }
  return Pack(out, SmallTable);
}

//------------------------------------------------------------------------------
TreeTable TreeTable::Read(std::span<const std::uint8_t> bytes, const MetaTable& meta,
  std::size_t numberOfChunks, bool isSurface)
{
  const auto data = Unpack(bytes, SmallTable);
  ByteReader in(data);
  TreeTable tree;
  tree.Merges = GetSmall(in);
  Check(meta.Points < std::uint64_t{ 1 } << 32, "there are too many points for merges");
  Check(tree.Merges <= CountMergeablePoints(meta, isSurface), "there are more merges than points");
  tree.Levels = GetAscending(in, tree.Merges);
  tree.Parts = GetParts(in, tree, meta, isSurface);
  tree.MergeCounts = GetAscending(in, tree.Merges);
  Check(tree.Merges == 0 || (!tree.MergeCounts.empty() && tree.MergeCounts.back() == tree.Merges),
    "the last merge count is not that of all merges");
  Check(numberOfChunks * tree.MergeCounts.size() <= in.GetRemaining() / (3 * RangeBytes),
    "the bounds of chunks after merges are not all there");
  // Not assign(), of which GCC 16 warns at an offset of 2^63 (-Warray-bounds).
  tree.Boxes = std::vector(numberOfChunks, std::vector<Bounds>(tree.MergeCounts.size()));
  for (auto& mergeCounts : tree.Boxes)
  {
    for (Bounds& box : mergeCounts)
    {
      for (Range& range : box)
      {
        range = GetRange(in);
      }
    }
  }
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the table");
  return tree;
}

//------------------------------------------------------------------------------
std::size_t TreeTable::FindMergeCount(std::size_t merges) const
{
  return static_cast<std::size_t>(
    std::lower_bound(this->MergeCounts.begin(), this->MergeCounts.end(), merges) -
    this->MergeCounts.begin());
}

//------------------------------------------------------------------------------
Bytes TreeStepTable::Write() const
{
  ByteWriter out;
  for (const auto& chunks : this->Ranges)
  {
    for (const auto& mergeCounts : chunks)
    {
      for (const ArrayRanges& ranges : mergeCounts)
      {
        for (const Range& range : ranges)
        {
          PutRange(out, range);
        }
      }
    }
  }
  return Pack(out, SmallStep);
}

//------------------------------------------------------------------------------
TreeStepTable TreeStepTable::Read(std::span<const std::uint8_t> bytes, const MetaTable& meta,
  std::size_t numberOfChunks, const TreeTable& tree)
{
  const auto data = Unpack(bytes, SmallStep);
  ByteReader in(data);
  TreeStepTable step;
  for (const ArrayDescription& array : meta.Arrays)
  {
    auto& chunks = step.Ranges.emplace_back();
    if (array.Where != Association::Point)
    {
      continue;
    }
    const auto count = GetRangeCount(array.Components);
    Check(numberOfChunks * tree.MergeCounts.size() <= in.GetRemaining() / (count * RangeBytes),
      "the ranges of chunks after merges are not all there");
    chunks.assign(numberOfChunks, {});
    for (auto& mergeCounts : chunks)
    {
      mergeCounts.assign(tree.MergeCounts.size(), ArrayRanges(count));
      for (ArrayRanges& ranges : mergeCounts)
      {
        for (Range& range : ranges)
        {
          range = GetRange(in);
        }
      }
    }
  }
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the table");
  return step;
}
}
