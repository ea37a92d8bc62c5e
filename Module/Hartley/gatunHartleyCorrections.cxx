// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyCorrections.h"

#include "gatunError.h"
#include "gatunHartleyBlocks.h"
#include "gatunHartleyTransform.h"
#include "gatunHartleyVoxels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace gatun
{
namespace
{
// The largest distance of a voxel from its value for each kind of correction: none, the last bit of
// the voxel, its last four bits.
constexpr double FarthestPlain = 0.49;
constexpr double FarthestParity = 0.98;
constexpr double FarthestNibble = 7.9;
constexpr unsigned NibbleBits = 4;

/** The nearest integer to a value with the given last bits. */
double GetNearest(double value, unsigned bits, std::uint64_t last)
{
  const double period = static_cast<double>(1u << bits);
  const auto offset = static_cast<double>(last);
  return offset + period * std::floor((value - offset) / period + 0.5);
}

/** Codes and returns a voxel minus the base. The encoder passes the true voxel. */
template <typename Coder>
double CodeVoxel(
  Coder& coder, HartleyCorrectionModels& models, double value, double truth, double length)
{
  const double error = std::abs(value - truth);
  const auto bits = Coder::Encoding ? static_cast<std::uint64_t>(truth) : 0;
  const bool wrong = coder.Bit(models.Wrong[models.Recent], !(error <= FarthestPlain));
  models.Recent = 2 * (models.Recent & 1) + wrong;
  double voxel = 0;
  if (!wrong)
  {
    voxel = std::floor(value + 0.5);
  }
  else if (!coder.Bit(models.Far, !(error <= FarthestParity)))
  {
    voxel = GetNearest(value, 1, coder.Raw(bits & 1, 1));
  }
  else if (!coder.Bit(models.Farther, !(error <= FarthestNibble)))
  {
    voxel = GetNearest(value, NibbleBits, coder.Raw(bits & 15, NibbleBits));
  }
  else
  {
    const auto width = static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(length)));
    voxel = static_cast<double>(coder.Raw(bits, width));
  }
  return std::clamp(voxel, 0.0, length);
}

/** Calls visit(index) for the voxels of a block that are inside the volume. */
template <typename Visit>
void ForEachVoxel(const HartleyLayout& layout, const HartleyLayout::Triple& place, Visit&& visit)
{
  const auto filled = layout.GetFilled(place);
  for (std::uint32_t z = 0; z < filled[2]; ++z)
  {
    for (std::uint32_t y = 0; y < filled[1]; ++y)
    {
      const std::size_t row = layout.Block[0] * (y + std::size_t{ layout.Block[1] } * z);
      for (std::uint32_t x = 0; x < filled[0]; ++x)
      {
        visit(row + x);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
Bytes EncodeHartleyCorrections(const VolumeInput& input, const HartleyLayout& layout,
  std::size_t chunk, const HartleyQuantizer& quantizer, const Range& range,
  std::span<const std::int64_t> integers)
{
  const auto count = layout.GetVoxelsPerBlock();
  const double length = range.Max - range.Min;
  HartleyTransform transform(layout.Block);
  std::vector<double> values(count);
  std::vector<double> truth(count);
  EntropyEncoder coder;
  HartleyCorrectionModels models;
  ForEachHartleyBlock(layout, chunk,
    [&](std::size_t block, const HartleyLayout::Triple& place)
    {
      quantizer.Restore(integers.subspan(block * count, count), values);
      transform.Inverse(values);
      LoadBlock(input, layout, place, range.Min, truth);
      ForEachVoxel(layout, place,
        [&](std::size_t i) { CodeVoxel(coder, models, values[i], truth[i], length); });
    });
  return coder.Finish();
}

//------------------------------------------------------------------------------
HartleyCorrector::HartleyCorrector(
  std::span<const std::uint8_t> stream, const HartleyLayout& layout, const Range& range)
  : Coder(stream)
  , Layout(layout)
  , Length(range.Max - range.Min)
{
}

//------------------------------------------------------------------------------
void HartleyCorrector::Correct(const HartleyLayout::Triple& place, std::span<double> values)
{
  ForEachVoxel(this->Layout, place,
    [&](std::size_t i)
    {
      const double value = values.empty() ? 0 : values[i];
      const double voxel = CodeVoxel(this->Coder, this->Models, value, 0, this->Length);
      if (!values.empty())
      {
        values[i] = voxel;
      }
    });
}
}
