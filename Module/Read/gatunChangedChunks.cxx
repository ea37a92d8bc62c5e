// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunChangedChunks.h"

#include "gatunFileReaderInternals.h"

#include <algorithm>
#include <iterator>

namespace gatun
{
//------------------------------------------------------------------------------
std::vector<std::uint32_t> FindChangedChunks(
  const FileReader& file, const MergeChanges& changes, std::size_t from, std::size_t to)
{
  const auto& chunks = file.GetChunks();
  std::vector<std::uint32_t> points = changes.Find(from, to);
  std::sort(points.begin(), points.end());
  std::vector<bool> isChanged(chunks.size(), false);
  // Shared points first, block by block and group by group; then the own ones, chunk by chunk.
  auto point = points.begin();
  const TablePages& tables = InternalsOf(file).GetTables();
  for (std::size_t b = 0; b < tables.GetNumberOfBlocks() && point != points.end() &&
       *point < file.GetNumberOfSharedPoints();
       ++b)
  {
    const auto block = tables.GetBlock(b);
    std::uint64_t end = block->FirstPoint;
    for (const SharedGroup& group : block->Groups)
    {
      end += group.Points;
      const auto next = std::partition_point(
        point, points.end(), [end](std::uint32_t changed) { return changed < end; });
      for (const std::uint32_t chunk : group.Chunks)
      {
        isChanged[chunk] = isChanged[chunk] || next != point;
      }
      point = next;
    }
  }
  for (std::size_t chunk = 0; chunk < chunks.size() && point != points.end(); ++chunk)
  {
    const std::uint64_t end = chunks[chunk].FirstPoint + chunks[chunk].OwnPoints;
    const auto next = std::partition_point(
      point, points.end(), [end](std::uint32_t changed) { return changed < end; });
    isChanged[chunk] = isChanged[chunk] || next != point;
    point = next;
  }
  std::vector<std::uint32_t> changed;
  for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk)
  {
    if (isChanged[chunk])
    {
      changed.push_back(static_cast<std::uint32_t>(chunk));
    }
  }
  return changed;
}
}
