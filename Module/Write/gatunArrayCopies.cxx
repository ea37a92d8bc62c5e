// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunArrayCopies.h"

#include "gatunContainer.h"
#include "gatunParallel.h"
#include "gatunRoundedArrays.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <unordered_map>

namespace gatun
{
namespace
{
std::size_t CountTuples(const ArrayDescription& array, std::uint64_t points, std::uint64_t cells)
{
  return static_cast<std::size_t>(array.Where == Association::Point ? points : cells);
}

bool CanBeEqual(const ArrayDescription& l, const ArrayDescription& r)
{
  return l.Where == r.Where && l.Type == r.Type;
}

/** A hash of the values of a component. */
std::uint64_t HashComponent(
  const ArrayDescription& array, const void* values, std::size_t tuples, std::size_t component)
{
  constexpr std::size_t atOnce = 8192;
  const auto size = SizeOf(array.Type);
  const auto stride = size * array.Components;
  // No values may have no address.
  const auto* next =
    tuples == 0 ? nullptr : static_cast<const std::uint8_t*>(values) + component * size;
  std::vector<std::uint8_t> gathered(size * std::min(atOnce, tuples));
  RunningChecksum sum;
  for (std::size_t done = 0; done < tuples;)
  {
    const auto count = std::min(atOnce, tuples - done);
    for (std::size_t i = 0; i < count; ++i, next += stride)
    {
      std::memcpy(gathered.data() + i * size, next, size);
    }
    sum.Add({ gathered.data(), count * size });
    done += count;
  }
  return sum.Get();
}
}

//------------------------------------------------------------------------------
void CopySurvey::Add(const std::vector<ArrayDescription>& arrays,
  std::span<const void* const> values, std::uint64_t points, std::uint64_t cells)
{
  struct Component
  {
    std::size_t Array, Number, Place;
  };
  std::vector<Component> components;
  std::size_t place = 0;
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const bool isAlone = std::none_of(arrays.begin(), arrays.end(),
      [&](const ArrayDescription& other)
      { return &other != &arrays[a] && CanBeEqual(other, arrays[a]); });
    for (std::size_t c = 0; c < arrays[a].Components; ++c, ++place)
    {
      if (!isAlone && values[a] && CountTuples(arrays[a], points, cells) > 0)
      {
        components.push_back({ a, c, place });
      }
    }
  }
  this->Hashes.resize(place, 0);
  ParallelFor(components.size(),
    [&](std::size_t i)
    {
      const auto [a, c, at] = components[i];
      this->Hashes[at] +=
        HashComponent(arrays[a], values[a], CountTuples(arrays[a], points, cells), c);
    });
}

//------------------------------------------------------------------------------
void CopySurvey::Put(ByteWriter& out) const
{
  out.PutVarint(this->Hashes.size());
  for (const auto hash : this->Hashes)
  {
    out.Put(hash);
  }
}

//------------------------------------------------------------------------------
void CopySurvey::Add(ByteReader& in)
{
  const auto count = in.GetCount(sizeof(std::uint64_t));
  this->Hashes.resize(std::max<std::size_t>(this->Hashes.size(), count), 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Hashes[i] += in.Get<std::uint64_t>();
  }
}

//------------------------------------------------------------------------------
ArrayCopies CopySurvey::Finish(
  const std::vector<ArrayDescription>& arrays, const std::vector<ArrayError>& errors) const
{
  ArrayCopies copies(arrays.size());
  std::vector<std::size_t> begins(arrays.size(), 0);
  for (std::size_t a = 1; a < arrays.size(); ++a)
  {
    begins[a] = begins[a - 1] + arrays[a - 1].Components;
  }
  if (this->Hashes.empty())
  {
    return copies;
  }
  // Arrays of many components come first, so that those of few can be copied from them.
  std::vector<std::uint32_t> order(arrays.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
    [&](std::uint32_t l, std::uint32_t r) { return arrays[l].Components > arrays[r].Components; });
  struct Source
  {
    std::uint32_t Array;
    std::unordered_map<std::uint64_t, std::uint32_t> Components; // by their hashes
  };
  std::vector<Source> sources;
  for (const auto a : order)
  {
    const std::span hashes(this->Hashes.data() + begins[a], arrays[a].Components);
    const auto source = std::find_if(sources.begin(), sources.end(),
      [&](const Source& candidate)
      {
        return CanBeEqual(arrays[candidate.Array], arrays[a]) &&
          FindBound(errors, arrays[candidate.Array]) == FindBound(errors, arrays[a]) &&
          std::all_of(hashes.begin(), hashes.end(),
            [&](std::uint64_t hash) { return hash != 0 && candidate.Components.contains(hash); });
      });
    if (source == sources.end())
    {
      auto& added = sources.emplace_back(Source{ a, {} });
      for (std::uint32_t c = 0; c < hashes.size(); ++c)
      {
        added.Components.emplace(hashes[c], c);
      }
      continue;
    }
    auto& copy = copies[a].emplace(ArrayCopy{ source->Array, {} });
    for (const auto hash : hashes)
    {
      copy.Components.push_back(source->Components.at(hash));
    }
  }
  return copies;
}

//------------------------------------------------------------------------------
void CheckCopies(const ArrayCopies& copies, const std::vector<ArrayDescription>& arrays,
  std::span<const void* const> values, std::uint64_t points, std::uint64_t cells)
{
  for (std::size_t a = 0; a < copies.size(); ++a)
  {
    if (!copies[a])
    {
      continue;
    }
    const auto size = SizeOf(arrays[a].Type);
    const auto& source = arrays[copies[a]->Source];
    const auto tuples = CountTuples(arrays[a], points, cells);
    for (std::size_t c = 0; c < arrays[a].Components; ++c)
    {
      const auto* one = static_cast<const std::uint8_t*>(values[a]) + c * size;
      const auto* other = static_cast<const std::uint8_t*>(values[copies[a]->Source]) +
        copies[a]->Components[c] * size;
      for (std::size_t i = 0; i < tuples; ++i)
      {
        if (std::memcmp(one, other, size) != 0)
        {
          ThrowInvalid("arrays '" + arrays[a].Name + "' and '" + source.Name +
            "' differ, but their hashes are equal");
        }
        one += size * arrays[a].Components;
        other += size * source.Components;
      }
    }
  }
}
}
