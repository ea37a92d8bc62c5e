// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileSlice.h"

#include "gatunBytes.h"
#include "gatunError.h"
#include "gatunPieceDecoder.h"
#include "gatunWithType.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
constexpr std::uint64_t TetsAtOnce = std::uint64_t{ 2 } << 20;

/** The section of the chunks of a request. */
std::vector<SurfacePart> Cut(PieceDecoder& decoder, const PieceRequest& request,
  const Region::Plane& plane, const SurfaceOptions& options)
{
  decoder.SetRequest(request);
  const auto& file = *decoder.GetFile();
  const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
  const auto tets = static_cast<std::size_t>(decoder.GetNumberOfCells());
  const auto type = file.GetCoordinateType();
  Bytes coordinates(points * 3 * SizeOf(type));
  std::vector<std::int32_t> narrow;
  std::vector<std::int64_t> wide;
  PieceTarget target;
  target.Points = coordinates.data();
  target.WideIds = points > 0x7fffffff;
  (target.WideIds ? wide.resize(4 * tets) : narrow.resize(4 * tets));
  target.Connectivity = target.WideIds ? static_cast<void*>(wide.data()) : narrow.data();
  SurfaceInput input;
  std::vector<Bytes> values;
  values.reserve(request.Arrays.size());
  for (const auto number : request.Arrays)
  {
    const auto& array = file.GetArrays()[number];
    const bool ofPoints = array.Where == Association::Point;
    auto& bytes =
      values.emplace_back((ofPoints ? points : tets) * array.Components * SizeOf(array.Type));
    target.Arrays.push_back(bytes.data());
    (ofPoints ? input.PointArrays : input.CellArrays)
      .push_back({ bytes.data(), array.Type, array.Components });
  }
  decoder.Fill(target);
  std::vector<double> distances(points);
  WithType(type, coordinates.data(),
    [&](const auto* xyz)
    {
      for (std::size_t i = 0; i < points; ++i)
      {
        distances[i] = plane.Evaluate({ static_cast<double>(xyz[3 * i]),
          static_cast<double>(xyz[3 * i + 1]), static_cast<double>(xyz[3 * i + 2]) });
      }
    });
  input.Mesh = { points, target.Connectivity, target.WideIds, distances.data(), true };
  input.Points = { coordinates.data(), type, 3 };
  return MakeSurfaceParts(input, options, tets);
}
}

//------------------------------------------------------------------------------
Surface ExtractSlice(const std::shared_ptr<ChunkCache>& cache, const PieceRequest& request,
  const Region::Plane& plane, ScalarType coordinateType,
  const std::function<bool(double)>& progress)
{
  const auto& file = *cache->GetFile();
  Region region;
  region.Section = plane;
  const auto near = FindChunks(file, region, request.Step, request.Merges);
  std::vector<std::uint32_t> chunks;
  std::set_intersection(near.begin(), near.end(), request.Chunks.begin(), request.Chunks.end(),
    std::back_inserter(chunks));
  SurfaceOptions options;
  options.Values = { 0 };
  options.CoordinateType = coordinateType;
  PieceDecoder decoder(cache);
  PieceRequest part = request;
  part.Form = PieceForm::Tetrahedra;
  part.GhostLevels = 0;
  part.WithUnusedPoints = false;
  std::vector<SurfacePart> parts;
  for (std::size_t first = 0; first < chunks.size();)
  {
    if (progress && !progress(static_cast<double>(first) / static_cast<double>(chunks.size())))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
    part.Chunks.clear();
    for (std::uint64_t tets = 0; first < chunks.size() && tets < TetsAtOnce; ++first)
    {
      tets += file.GetChunks()[chunks[first]].Tets;
      part.Chunks.push_back(chunks[first]);
    }
    auto more = Cut(decoder, part, plane, options);
    std::move(more.begin(), more.end(), std::back_inserter(parts));
  }
  return Surface(std::move(parts), coordinateType);
}
}
