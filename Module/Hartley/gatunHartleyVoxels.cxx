// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyVoxels.h"

#include "gatunError.h"
#include "gatunParallel.h"
#include "gatunWithType.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace gatun
{
namespace
{
using Triple = HartleyLayout::Triple;

[[noreturn]] void FailAt(const VolumeInput& input, std::size_t voxel, const std::string& what)
{
  ThrowInvalid("the voxel (" + std::to_string(voxel % input.Size[0]) + ", " +
    std::to_string(voxel / input.Size[0] % input.Size[1]) + ", " +
    std::to_string(voxel / input.Size[0] / input.Size[1]) + ") " + what);
}

/** Calls row(first voxel of the volume, first value of the block, number of voxels) for each row of
 * voxels of a block. */
template <typename Row>
void ForEachRow(const HartleyLayout& layout, const Triple& place, Row&& row)
{
  const auto filled = layout.GetFilled(place);
  for (std::uint32_t z = 0; z < filled[2]; ++z)
  {
    for (std::uint32_t y = 0; y < filled[1]; ++y)
    {
      const std::size_t line = place[1] * layout.Block[1] + y +
        std::size_t{ layout.Size[1] } * (place[2] * layout.Block[2] + z);
      row(place[0] * layout.Block[0] + layout.Size[0] * line,
        layout.Block[0] * (y + std::size_t{ layout.Block[1] } * z), filled[0]);
    }
  }
}
}

//------------------------------------------------------------------------------
Range GetVoxelRange(const VolumeInput& input, const std::function<bool(double)>& progress)
{
  const std::size_t slice = std::size_t{ input.Size[0] } * input.Size[1];
  struct Found
  {
    Range Values;
    std::size_t Bad = std::numeric_limits<std::size_t>::max(); // first invalid voxel
  };
  std::vector<Found> slices(input.Size[2]);
  ParallelFor(
    slices.size(),
    [&](std::size_t z)
    {
      WithType(input.Type, input.Values,
        [&](const auto* typed)
        {
          using T = std::remove_cv_t<std::remove_pointer_t<decltype(typed)>>;
          const T* const values = typed + z * slice;
          T least = values[0];
          T most = values[0];
          for (std::size_t i = 0; i < slice; ++i)
          {
            least = values[i] < least ? values[i] : least;
            most = values[i] > most ? values[i] : most;
            if constexpr (std::is_floating_point_v<T>)
            {
              if (!std::isfinite(values[i]))
              {
                slices[z].Bad = z * slice + i;
                return;
              }
            }
            else if constexpr (sizeof(T) == 8)
            {
              if (std::abs(static_cast<double>(values[i])) > LargestVoxelInteger)
              {
                slices[z].Bad = z * slice + i;
                return;
              }
            }
          }
          slices[z].Values = { static_cast<double>(least), static_cast<double>(most) };
        });
    },
    progress);
  Range range = { std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  for (const auto& found : slices)
  {
    if (found.Bad != std::numeric_limits<std::size_t>::max())
    {
      FailAt(input, found.Bad,
        IsFloating(input.Type) ? "is not a finite number"
                               : "is beyond 2^53, the exact range of double precision");
    }
    range.Min = std::min(range.Min, found.Values.Min);
    range.Max = std::max(range.Max, found.Values.Max);
  }
  const double length = range.Max - range.Min;
  if (!(length <= LargestVoxelRange) || (length > 0 && length < SmallestVoxelRange))
  {
    std::ostringstream text;
    text << "the voxels range from " << range.Min << " to " << range.Max
         << ", which is beyond single precision; scale them";
    ThrowInvalid(text.str());
  }
  return range;
}

//------------------------------------------------------------------------------
void LoadBlock(const VolumeInput& input, const HartleyLayout& layout, const Triple& place,
  double base, std::span<double> values)
{
  if (layout.GetFilled(place) != layout.Block)
  {
    std::fill(values.begin(), values.end(), 0.0);
  }
  WithType(input.Type, input.Values,
    [&](const auto* typed)
    {
      ForEachRow(layout, place,
        [&](std::size_t voxel, std::size_t value, std::size_t count)
        {
          for (std::size_t x = 0; x < count; ++x)
          {
            values[value + x] = static_cast<double>(typed[voxel + x]) - base;
          }
        });
    });
}

//------------------------------------------------------------------------------
void StoreBlock(std::span<const double> values, const HartleyLayout& layout, const Triple& place,
  double base, const Range& range, const VoxelBox& box)
{
  // The intersection of block and box.
  const auto filled = layout.GetFilled(place);
  Triple first{};
  Triple end{};
  Triple size{};
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const auto begin = place[axis] * layout.Block[axis];
    first[axis] = std::max(begin, box.First[axis]);
    end[axis] = std::min(begin + filled[axis], box.End[axis]);
    size[axis] = box.End[axis] - box.First[axis];
    if (first[axis] >= end[axis])
    {
      return;
    }
  }
  const bool integer = !IsFloating(box.Type);
  WithType(box.Type, box.Values,
    [&](const auto* typed)
    {
      using T = std::remove_cv_t<std::remove_pointer_t<decltype(typed)>>;
      auto* const out = static_cast<T*>(box.Values);
      for (auto z = first[2]; z < end[2]; ++z)
      {
        for (auto y = first[1]; y < end[1]; ++y)
        {
          T* const row = out +
            std::size_t{ size[0] } *
              (y - box.First[1] + std::size_t{ size[1] } * (z - box.First[2])) -
            box.First[0];
          const double* const from = values.data() +
            std::size_t{ layout.Block[0] } *
              (y - place[1] * layout.Block[1] +
                std::size_t{ layout.Block[1] } * (z - place[2] * layout.Block[2]));
          for (auto x = first[0]; x < end[0]; ++x)
          {
            row[x] = static_cast<T>(
              RoundVoxel(from[x - place[0] * layout.Block[0]], base, integer, range));
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
void VoxelErrors::Add(const VoxelErrors& other)
{
  this->Squares += other.Squares;
  this->Largest = std::max(this->Largest, other.Largest);
}

//------------------------------------------------------------------------------
VoxelErrors CompareBlock(std::span<const double> values, const VolumeInput& input,
  const HartleyLayout& layout, const Triple& place, double base, const Range& range)
{
  const bool integer = !IsFloating(input.Type);
  VoxelErrors errors;
  WithType(input.Type, input.Values,
    [&](const auto* typed)
    {
      using T = std::remove_cv_t<std::remove_pointer_t<decltype(typed)>>;
      ForEachRow(layout, place,
        [&](std::size_t voxel, std::size_t value, std::size_t count)
        {
          for (std::size_t x = 0; x < count; ++x)
          {
            const auto stored = static_cast<T>(RoundVoxel(values[value + x], base, integer, range));
            const double error =
              static_cast<double>(stored) - static_cast<double>(typed[voxel + x]);
            errors.Squares += error * error;
            errors.Largest = std::max(errors.Largest, std::abs(error));
          }
        });
    });
  return errors;
}
}
