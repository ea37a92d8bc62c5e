// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPortVolume.h"

#include "gatunHartleyFile.h"

#include <algorithm>

namespace gatun::port
{
//------------------------------------------------------------------------------
void AddVolume(Line& line, const std::string& path)
{
  const HartleyFile file(path);
  for (std::size_t i = 0; i < file.GetLayout().GetNumberOfChunks(); ++i)
  {
    const auto chunk = file.GetChunk(i);
    std::vector<std::uint32_t> indices;
    std::vector<double> values;
    for (const auto& term : chunk->Terms)
    {
      indices.push_back(term.Index);
      values.push_back(static_cast<double>(term.Value));
    }
    line.Decoded.Add(indices);
    line.Decoded.Add(values);
  }
  auto volume = file.GetVolume();
  const auto& size = volume.Size;
  std::vector<std::uint8_t> voxels(
    std::size_t{ size[0] } * size[1] * size[2] * SizeOf(volume.Type));
  file.GetVoxels({}, size, voxels.data());
  line.Encoded["voxels"].Add(voxels);

  volume.Values = voxels.data();
  const auto& block = file.GetLayout().Block;
  HartleyWriterOptions options;
  options.BlockSize = block == size ? 0 : *std::max_element(block.begin(), block.end());
  options.RateControl = file.GetRateControl();
  AddBytesOf(line.Encoded["volume"],
    [&](const std::string& out) { WriteHartleyFile(out, volume, options); });
}
}
