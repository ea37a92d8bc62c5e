// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunVolumeSurvey.h"

#include "gatunHartleyFile.h"
#include "gatunHartleyLayout.h"
#include "gatunParallel.h"
#include "gatunSpread.h"
#include "gatunWithType.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace gatun
{
namespace
{
using Triple = HartleyLayout::Triple;

// Chunks that are in memory at the same time.
constexpr std::size_t ChunksAtOnce = 4;

// The blocks of volumes in memory, of which only the chunks are used.
constexpr std::uint32_t BlockSize = 8;

struct VoxelPart
{
  Triple First{};
  Triple End{};

  std::size_t CountVoxels() const
  {
    return std::size_t{ this->End[0] - this->First[0] } * (this->End[1] - this->First[1]) *
      (this->End[2] - this->First[2]);
  }
};

VoxelPart GetPart(const HartleyLayout& layout, std::size_t chunk)
{
  const auto blocks = layout.GetBlocksOfChunk(chunk);
  VoxelPart part;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    part.First[axis] = blocks.First[axis] * layout.Block[axis];
    part.End[axis] = std::min(blocks.End[axis] * layout.Block[axis], layout.Size[axis]);
  }
  return part;
}

/** Adds the voxels of a part to a histogram. */
using AddPart = std::function<void(const VoxelPart& part, ValueHistogram& histogram)>;

void Fill(const HartleyLayout& layout, const AddPart& add, ValueHistogram& histogram)
{
  const std::vector<std::size_t> chunks = SpreadNumbers(layout.GetNumberOfChunks());
  std::uint64_t voxels = 0;
  for (std::size_t next = 0; next < chunks.size() && voxels < MostSurveyedVoxels;)
  {
    const std::size_t taken = std::min(ChunksAtOnce, chunks.size() - next);
    std::vector<ValueHistogram> parts(taken, histogram.MakeEmpty());
    ParallelFor(taken, [&](std::size_t i) { add(GetPart(layout, chunks[next + i]), parts[i]); });
    for (std::size_t i = 0; i < taken; ++i)
    {
      histogram.Add(parts[i]);
      voxels += GetPart(layout, chunks[next + i]).CountVoxels();
    }
    next += taken;
  }
}

template <typename Value>
void AddValue(Value value, ValueHistogram& histogram)
{
  const auto number = static_cast<double>(value);
  if (std::isfinite(number))
  {
    histogram.Add(number, number, 1);
  }
}

ValueSurvey Survey(const VolumeInput& volume, const HartleyLayout& layout, const Range& values,
  const std::optional<Range>& range, const AddPart& add)
{
  ValueSurvey survey;
  survey.Volume = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    double square = 0;
    for (std::size_t row = 0; row < 3; ++row)
    {
      const double direction = volume.Direction[3 * row + axis];
      square += direction * direction;
    }
    const double length =
      (volume.Size[axis] - 1.0) * std::abs(volume.Spacing[axis]) * std::sqrt(square);
    survey.Box[axis] = { 0, length };
    survey.Volume *= length;
  }
  const auto fill = [&](ValueHistogram& histogram) { Fill(layout, add, histogram); };
  if (range)
  {
    survey.Values = ValueHistogram(*range);
    fill(survey.Values);
  }
  else
  {
    survey.Values = MakeValueHistogram(values, fill);
  }
  return survey;
}
}

//------------------------------------------------------------------------------
ValueSurvey SurveyVolume(const VolumeInput& volume, const std::optional<Range>& range)
{
  const HartleyLayout layout = HartleyLayout::Make(volume.Size, BlockSize);
  ValueSurvey survey;
  WithType(volume.Type, volume.Values,
    [&](const auto* voxels)
    {
      const auto forEach = [&](const VoxelPart& part, auto&& use)
      {
        for (auto z = part.First[2]; z < part.End[2]; ++z)
        {
          for (auto y = part.First[1]; y < part.End[1]; ++y)
          {
            const auto* row = voxels + (std::size_t{ z } * volume.Size[1] + y) * volume.Size[0];
            for (auto x = part.First[0]; x < part.End[0]; ++x)
            {
              use(row[x]);
            }
          }
        }
      };
      Range values = Range::MakeEmpty();
      forEach({ {}, volume.Size },
        [&](auto value)
        {
          const auto number = static_cast<double>(value);
          values.Include(std::isfinite(number) ? number : std::nan(""));
        });
      survey = Survey(volume, layout, values, range,
        [&](const VoxelPart& part, ValueHistogram& histogram)
        { forEach(part, [&](auto value) { AddValue(value, histogram); }); });
    });
  return survey;
}

//------------------------------------------------------------------------------
ValueSurvey SurveyVolume(const HartleyFile& file, const std::optional<Range>& range)
{
  const VolumeInput& volume = file.GetVolume();
  return Survey(volume, file.GetLayout(), file.GetRange(), range,
    [&](const VoxelPart& part, ValueHistogram& histogram)
    {
      std::vector<std::byte> voxels(part.CountVoxels() * SizeOf(volume.Type));
      file.GetVoxels(part.First, part.End, voxels.data());
      WithType(volume.Type, voxels.data(),
        [&](const auto* typed)
        {
          for (std::size_t i = 0; i < part.CountVoxels(); ++i)
          {
            AddValue(typed[i], histogram);
          }
        });
    });
}
}
