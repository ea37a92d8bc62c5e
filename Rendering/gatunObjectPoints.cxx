// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunObjectPoints.h"

#include "gatunCellArrays.h"
#include "gatunChunkCache.h"
#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunHartleyFrame.h"
#include "gatunPieceDecoder.h"
#include "gatunSharedFile.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace gatun
{
namespace
{
using Point = PointBlocks::Point;

// Of data in memory.
constexpr std::size_t PointsPerBlock = 4096;

// That are decoded to find the extremes. The chunks that reach farthest are enough, as a rule, and
// they are few.
constexpr std::size_t MostPoints = std::size_t{ 1 } << 20;

bool IsFinite(const Point& point)
{
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

void MarkUsed(vtkCellArray* cells, std::vector<bool>& used)
{
  if (!cells)
  {
    return;
  }
  const auto mark = [&](const auto* ids, vtkIdType count)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (ids[i] >= 0 && static_cast<std::size_t>(ids[i]) < used.size())
      {
        used[static_cast<std::size_t>(ids[i])] = true;
      }
    }
  };
  const auto ids = GetPointIds(cells);
  if (HasWideIds(cells))
  {
    mark(GetIntegers<vtkTypeInt64>(ids.Get()), ids->GetNumberOfValues());
  }
  else
  {
    mark(GetIntegers<vtkTypeInt32>(ids.Get()), ids->GetNumberOfValues());
  }
}

/** The ids of the points that cells use. */
std::vector<vtkIdType> FindUsed(vtkPointSet* data)
{
  std::vector<bool> used(static_cast<std::size_t>(data->GetNumberOfPoints()), false);
  if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    MarkUsed(grid->GetCells(), used);
  }
  else if (auto* const surface = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* const cells :
      { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
    {
      MarkUsed(cells, used);
    }
  }
  else
  {
    used.flip();
  }
  std::vector<vtkIdType> ids;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (used[i])
    {
      ids.push_back(static_cast<vtkIdType>(i));
    }
  }
  return ids;
}

PointBlocks GetPoints(vtkPointSet* data)
{
  if (!data->GetPoints())
  {
    return PointBlocks(std::vector<Bounds>());
  }
  vtkDataArray* const points = data->GetPoints()->GetData();
  const auto ids = std::make_shared<const std::vector<vtkIdType>>(FindUsed(data));
  const auto visit = [points, ids](std::size_t block, const PointBlocks::Use& use)
  {
    const std::size_t end = std::min((block + 1) * PointsPerBlock, ids->size());
    for (std::size_t i = block * PointsPerBlock; i < end; ++i)
    {
      Point point{};
      points->GetTuple((*ids)[i], point.data());
      if (IsFinite(point))
      {
        use(point);
      }
    }
    return true;
  };
  std::vector<Bounds> boxes((ids->size() + PointsPerBlock - 1) / PointsPerBlock);
  for (std::size_t block = 0; block < boxes.size(); ++block)
  {
    visit(block, [&](const Point& point) { boxes[block].Include(point); });
  }
  return PointBlocks(std::move(boxes), visit);
}

/** The points of chunks that were decoded. */
class DecodedChunks
{
public:
  DecodedChunks(SharedFile& file, std::size_t step)
    : Parts(file.MakeView(file.GetFile(), false))
    , Step(step)
  {
  }

  bool Visit(std::size_t chunk, const PointBlocks::Use& use)
  {
    auto found = this->Points.find(chunk);
    if (found == this->Points.end())
    {
      if (this->Count >= MostPoints)
      {
        return false;
      }
      found = this->Points.emplace(chunk, this->Decode(chunk)).first;
      this->Count += found->second.size();
    }
    for (const Point& point : found->second)
    {
      use(point);
    }
    return true;
  }

private:
  std::vector<Point> Decode(std::size_t chunk) const
  {
    PieceDecoder decoder(this->Parts);
    PieceRequest request;
    request.Chunks = { static_cast<std::uint32_t>(chunk) };
    request.Step = this->Step;
    request.RestoreOrder = false;
    decoder.SetRequest(request);
    const bool isFloat = this->Parts->GetFile()->GetCoordinateType() == ScalarType::Float32;
    std::vector<float> floats(isFloat ? 3 * decoder.GetNumberOfPoints() : 0);
    std::vector<double> doubles(isFloat ? 0 : 3 * decoder.GetNumberOfPoints());
    PieceTarget target;
    target.Points = isFloat ? static_cast<void*>(floats.data()) : doubles.data();
    decoder.Fill(target);
    doubles.insert(doubles.end(), floats.begin(), floats.end());
    std::vector<Point> points;
    for (std::size_t i = 0; i < doubles.size(); i += 3)
    {
      const Point point{ doubles[i], doubles[i + 1], doubles[i + 2] };
      if (IsFinite(point))
      {
        points.push_back(point);
      }
    }
    return points;
  }

  std::shared_ptr<ChunkCache> Parts;
  std::size_t Step;
  std::map<std::size_t, std::vector<Point>> Points;
  std::size_t Count = 0;
};

/** The corners of a box of index coordinates, one voxel wider on all sides. */
template <typename ToWorld>
PointBlocks GetCorners(
  const std::array<double, 3>& first, const std::array<double, 3>& last, ToWorld&& toWorld)
{
  std::array<Point, 8> corners{};
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    Point index{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      index[axis] = ((corner >> axis) & 1u) ? last[axis] + 1 : first[axis] - 1;
    }
    corners[corner] = toWorld(index);
  }
  return PointBlocks(std::span<const Point>(corners));
}
}

//------------------------------------------------------------------------------
PointBlocks GetObjectPoints(vtkDataObject* data)
{
  if (auto* const points = vtkPointSet::SafeDownCast(data))
  {
    return GetPoints(points);
  }
  auto* const image = vtkImageData::SafeDownCast(data);
  if (!image)
  {
    ThrowInvalid("there is no grid, surface or image");
  }
  int extent[6];
  image->GetExtent(extent);
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    return PointBlocks(std::vector<Bounds>());
  }
  return GetCorners({ static_cast<double>(extent[0]), static_cast<double>(extent[2]),
                      static_cast<double>(extent[4]) },
    { static_cast<double>(extent[1]), static_cast<double>(extent[3]),
      static_cast<double>(extent[5]) },
    [image](const Point& index)
    {
      Point world{};
      image->TransformContinuousIndexToPhysicalPoint(index.data(), world.data());
      return world;
    });
}

//------------------------------------------------------------------------------
PointBlocks GetObjectPoints(SharedFile& file, std::size_t step)
{
  const FileReader& reader = *file.GetFile();
  std::vector<Bounds> boxes(reader.GetChunks().size());
  for (std::size_t chunk = 0; chunk < boxes.size(); ++chunk)
  {
    boxes[chunk] = reader.GetChunkBounds(chunk, 0, step);
  }
  const auto chunks = std::make_shared<DecodedChunks>(file, step);
  return PointBlocks(std::move(boxes),
    [chunks](std::size_t chunk, const PointBlocks::Use& use) { return chunks->Visit(chunk, use); });
}

//------------------------------------------------------------------------------
PointBlocks GetObjectPoints(const VolumeInput& volume)
{
  const VolumePlace place(volume);
  return GetCorners({ 0, 0, 0 },
    { volume.Size[0] - 1.0, volume.Size[1] - 1.0, volume.Size[2] - 1.0 },
    [&](const Point& index) { return place.ToWorld(index); });
}
}
