// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayDecoder.h"

#include "gatunChunkCache.h"
#include "gatunPieceDecoder.h"
#include "gatunWithType.h"

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
  request.Step = values.Step;
  request.RestoreOrder = false;
  decoder.SetRequest(request);

  const auto& array = file.GetArrays()[values.Array];
  const bool ofCells = array.Where == Association::Cell;
  const auto points = decoder.GetNumberOfPoints();
  const auto tets = decoder.GetNumberOfCells();
  const auto coordinateType = file.GetCoordinateType();
  std::vector<std::byte> coordinates(3 * points * SizeOf(coordinateType));
  std::vector<std::byte> raw((ofCells ? tets : points) * array.Components * SizeOf(array.Type));
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
  return block;
}
}
