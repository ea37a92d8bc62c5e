// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayDecoder.h"

#include "gatunChunkCache.h"
#include "gatunFileReader.h"
#include "gatunPieceDecoder.h"
#include "gatunWithType.h"

#include <numeric>
#include <vector>

namespace gatun
{
//------------------------------------------------------------------------------
RayBlock DecodeRayBlock(
  const std::shared_ptr<ChunkCache>& parts, const RayValues& values, std::size_t chunk)
{
  const FileReader& file = *parts->GetFile();
  PieceDecoder decoder(parts);
  PieceRequest request;
  request.Chunks = { static_cast<std::uint32_t>(chunk) };
  request.Arrays = { values.Array };
  // Colors may be those of another array, or of other components of the same.
  const RayHueValues& hues = values.Hues;
  const bool hasOther = hues.Channels > 0 && hues.Array != values.Array;
  const bool isFirst = hues.Array < values.Array;
  if (hasOther)
  {
    request.Arrays.insert(
      isFirst ? request.Arrays.begin() : request.Arrays.end(), hues.Array); // ascending
  }
  request.Step = values.Step;
  request.RestoreOrder = false;
  decoder.SetRequest(request);

  const auto& array = file.GetArrays()[values.Array];
  const auto& hueArray = file.GetArrays()[hues.Channels > 0 ? hues.Array : values.Array];
  const auto points = decoder.GetNumberOfPoints();
  const auto tets = decoder.GetNumberOfCells();
  const auto count = [&](const ArrayDescription& described)
  { return described.Where == Association::Cell ? tets : points; };
  const auto size = [&](const ArrayDescription& described)
  { return count(described) * described.Components * SizeOf(described.Type); };
  const auto coordinateType = file.GetCoordinateType();
  std::vector<std::byte> coordinates(3 * points * SizeOf(coordinateType));
  std::vector<std::byte> raw(size(array));
  std::vector<std::byte> rawHues(hasOther ? size(hueArray) : 0);
  RayBlock block;
  block.Tets.resize(tets);
  block.Parents.resize(tets);
  static_assert(sizeof(RayBlock::Tet) == 4 * sizeof(std::int32_t));
  PieceTarget target;
  target.Points = coordinates.data();
  target.Connectivity = block.Tets.data();
  target.WideIds = false;
  target.CellParents = block.Parents.data();
  target.Arrays = { raw.data() };
  if (hasOther)
  {
    target.Arrays.insert(isFirst ? target.Arrays.begin() : target.Arrays.end(), rawHues.data());
  }
  decoder.Fill(target);

  block.Points.resize(points);
  WithType(coordinateType, coordinates.data(),
    [&](const auto* p)
    {
      for (std::size_t i = 0; i < points; ++i)
      {
        block.Points[i] = { static_cast<double>(p[3 * i]), static_cast<double>(p[3 * i + 1]),
          static_cast<double>(p[3 * i + 2]), 0 };
      }
    });
  WithComponent(array.Type, raw.data(), array.Components, values.Component,
    [&](auto&& getValue) { block.SetValues(array.Where, getValue); });
  if (hues.Channels > 0)
  {
    std::vector<std::uint32_t> all(count(hueArray));
    std::iota(all.begin(), all.end(), 0u);
    const RayValuesInput input{ hueArray.Where, hueArray.Type, hueArray.Components, hues.Component,
      hasOther ? rawHues.data() : raw.data() };
    TakeHues({ input, hues.Channels }, all, block.Hues);
  }
  return block;
}
}
