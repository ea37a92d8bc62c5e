// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBytes.h"
#include "gatunCellShapes.h"
#include "gatunPieceDecoder.h"
#include "gatunSharedFile.h"
#include "gatunSurfaceDetail.h"
#include "gatunWithType.h"

#include <numeric>

namespace gatun
{
//------------------------------------------------------------------------------
std::shared_ptr<const SurfaceDetail> ReadSurfaceDetail(SharedFile& file, std::size_t level,
  std::size_t step, const std::function<bool(double)>& progress)
{
  constexpr double ofReading = 0.3;
  const auto report = [&](double done) { return !progress || progress(done); };
  const SharedFile::Place place = file.GetLevel(level);
  PieceDecoder decoder(file.MakeView(place.File, true));
  PieceRequest request;
  request.Chunks.resize(place.File->GetChunks().size());
  std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
  request.Step = step;
  request.Form = PieceForm::Original;
  request.WithUnusedPoints = true;
  request.RestoreOrder = false; // the order of the file, in which merges name points
  decoder.SetRequest(request);

  const ScalarType type = place.File->GetCoordinateType();
  const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
  const auto cells = static_cast<std::size_t>(decoder.GetNumberOfCells());
  Bytes coordinates(3 * SizeOf(type) * points);
  std::vector<std::uint32_t> corners(static_cast<std::size_t>(decoder.GetConnectivitySize()));
  std::vector<std::uint32_t> begins(cells + 1);
  std::vector<std::uint8_t> types(cells);
  PieceTarget target;
  target.Points = coordinates.data();
  target.Connectivity = corners.data();
  target.WideIds = false;
  target.Offsets = begins.data();
  target.Types = types.data();
  decoder.Fill(target, [&](double done) { return report(ofReading * done); });

  std::vector<SurfaceDetail::Point> places(points);
  WithType(type, coordinates.data(),
    [&](const auto* p)
    {
      for (std::size_t i = 0; i < 3 * points; ++i)
      {
        places[i / 3][i % 3] = static_cast<double>(p[i]);
      }
    });
  std::vector<SurfaceDetail::Triangle> triangles;
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    if (types[cell] == TriangleType)
    {
      const auto* const corner = corners.data() + begins[cell];
      triangles.push_back({ corner[0], corner[1], corner[2] });
    }
  }
  const auto reportRest = [&](double done) { return report(ofReading + (1 - ofReading) * done); };
  // Those in the file, if it has any.
  auto dependencies = file.GetDependencies(*place.File, reportRest);
  if (!dependencies)
  {
    dependencies = std::make_shared<const MergeDependencies>(*place.Tree, triangles, reportRest);
  }
  return std::make_shared<const SurfaceDetail>(
    place.Tree, std::move(dependencies), places, triangles);
}
}
