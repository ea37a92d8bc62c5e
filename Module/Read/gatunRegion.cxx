// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunRegion.h"

#include "gatunError.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>

namespace gatun
{
namespace
{
bool Meets(const Range& a, const Range& b)
{
  return !a.IsEmpty() && a.Min <= b.Max && a.Max >= b.Min;
}

bool Meets(const Bounds& box, const Region::Plane& plane)
{
  Range sides = Range::MakeEmpty();
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    std::array<double, 3> point{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      point[axis] = corner >> axis & 1 ? box[axis].Max : box[axis].Min;
    }
    sides.Include(plane.Evaluate(point));
  }
  return !box.IsEmpty() && sides.Min <= 0 && sides.Max >= 0;
}

void Check(const FileReader& file, const Region::Values& values)
{
  const auto& arrays = file.GetArrays();
  if (values.Array >= arrays.size() || values.Component < -1 ||
    (values.Component >= 0 &&
      static_cast<std::uint32_t>(values.Component) >= arrays[values.Array].Components))
  {
    ThrowInvalid("the file has no such array or component", file.GetPath());
  }
}
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> FindChunks(
  const FileReader& file, const Region& region, std::size_t step, std::size_t merges)
{
  if (region.Interval)
  {
    Check(file, *region.Interval);
  }
  const auto isOutside = [&](std::uint32_t chunk)
  {
    if (region.Box || region.Section)
    {
      const auto box = file.GetChunkBounds(chunk, merges, step);
      for (std::size_t axis = 0; region.Box && axis < 3; ++axis)
      {
        if (!Meets(box[axis], (*region.Box)[axis]))
        {
          return true;
        }
      }
      if (region.Section && !Meets(box, *region.Section))
      {
        return true;
      }
    }
    return region.Interval &&
      !(step < file.GetNumberOfSteps() &&
        Meets(GetRange(file.GetChunkRanges(region.Interval->Array, step, chunk, merges),
                region.Interval->Component),
          region.Interval->Within));
  };
  std::vector<std::uint32_t> chunks(file.GetChunks().size());
  std::iota(chunks.begin(), chunks.end(), 0u);
  std::erase_if(chunks, isOutside);
  return chunks;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> GetPiece(
  const std::vector<std::uint32_t>& chunks, std::size_t piece, std::size_t pieces)
{
  if (piece >= pieces)
  {
    return {};
  }
  const auto at = [&](std::size_t i)
  { return chunks.begin() + static_cast<std::ptrdiff_t>(chunks.size() * i / pieces); };
  return { at(piece), at(piece + 1) };
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> Surround(const FileReader& file,
  const std::vector<std::uint32_t>& chunks, const std::vector<std::uint32_t>& universe,
  unsigned levels)
{
  const auto isOutside = [&](std::uint32_t c)
  { return !universe.empty() && !std::binary_search(universe.begin(), universe.end(), c); };
  auto all = chunks;
  auto last = chunks;
  for (unsigned level = 0; level < levels && !last.empty(); ++level)
  {
    std::vector<std::uint32_t> next;
    for (const auto c : last)
    {
      const auto near = file.GetNeighbors(c);
      next.insert(next.end(), near.begin(), near.end());
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    std::erase_if(next, isOutside);
    last.clear();
    std::set_difference(next.begin(), next.end(), all.begin(), all.end(), std::back_inserter(last));
    std::vector<std::uint32_t> merged;
    std::merge(all.begin(), all.end(), last.begin(), last.end(), std::back_inserter(merged));
    all.swap(merged);
  }
  return all;
}
}
