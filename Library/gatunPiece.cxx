// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPiece.h"

#include "gatunBytePlan.h"
#include "gatunCellShapes.h"
#include "gatunChunkCache.h"
#include "gatunExactPiece.h"
#include "gatunPieceDecoder.h"

#include <algorithm>
#include <utility>

namespace gatun
{
namespace
{
Region TakeRegion(const gatun_request& from)
{
  Region region;
  if (from.flags & GATUN_IN_BOX)
  {
    auto& box = region.Box.emplace();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box[axis] = { from.box[2 * axis], from.box[2 * axis + 1] };
    }
  }
  if (from.flags & GATUN_IN_RANGE)
  {
    region.Interval = { from.range_array, from.range_component, { from.range[0], from.range[1] } };
  }
  if (from.flags & GATUN_ON_PLANE)
  {
    Region::Plane plane;
    std::copy_n(from.origin, 3, plane.Origin.begin());
    std::copy_n(from.normal, 3, plane.Normal.begin());
    region.Section = plane;
  }
  return region;
}

/** Cells of a file, from whole chunks or exactly those of a region. */
template <typename Decoder>
class CellPiece final : public gatun_piece
{
public:
  CellPiece(std::unique_ptr<Decoder> decoder, const FoundRequest& found)
    : Cells(std::move(decoder))
    , CoordinateType(found.File->GetCoordinateType())
    , Arrays(found.Arrays)
  {
  }

  gatun_sizes GetSizes() const override
  {
    gatun_sizes sizes{};
    sizes.points = this->Cells->GetNumberOfPoints();
    sizes.cells = this->Cells->GetNumberOfCells();
    sizes.connectivity = this->Cells->GetConnectivitySize();
    sizes.faces = this->Cells->GetFacesSize();
    sizes.cell_type = this->Cells->IsTetrahedral() ? TetraType : 0;
    sizes.coordinate_type = static_cast<gatun_type>(this->CoordinateType);
    return sizes;
  }

  void Read(const gatun_buffers& from, const Progress& progress) override
  {
    const auto points = this->Cells->GetNumberOfPoints();
    const auto cells = this->Cells->GetNumberOfCells();
    PieceTarget target;
    target.Points =
      TakeBuffer(from.points, Product(points, 3 * SizeOf(this->CoordinateType)), "the points");
    this->TakeCells(from, target);
    constexpr auto id = sizeof(std::int64_t);
    target.GlobalPointIds =
      TakeBuffer<std::int64_t>(from.point_ids, Product(points, id), "the ids of the points");
    target.GlobalCellIds =
      TakeBuffer<std::int64_t>(from.cell_ids, Product(cells, id), "the ids of the cells");
    target.PointGhosts =
      TakeBuffer<unsigned char>(from.point_ghosts, points, "the ghosts of the points");
    target.CellGhosts =
      TakeBuffer<unsigned char>(from.cell_ghosts, cells, "the ghosts of the cells");
    target.Arrays = TakeArrays(from, this->Arrays, points, cells);
    this->Cells->Fill(target, progress);
  }

private:
  void TakeCells(const gatun_buffers& from, PieceTarget& target) const
  {
    const std::uint64_t id = from.wide_ids ? sizeof(std::int64_t) : sizeof(std::int32_t);
    const auto cells = this->Cells->GetNumberOfCells();
    target.WideIds = from.wide_ids != 0;
    Need(target.WideIds ||
        std::max(this->Cells->GetNumberOfPoints(), this->Cells->GetConnectivitySize()) <=
          0x7fffffff,
      "ids of 32 bits are too small for this piece");
    target.Connectivity = TakeBuffer(
      from.connectivity, Product(this->Cells->GetConnectivitySize(), id), "the connectivity");
    if (this->Cells->IsTetrahedral())
    {
      return;
    }
    target.Offsets = TakeBuffer(from.offsets, Product(cells + 1, id), "the offsets");
    target.Types = TakeBuffer<std::uint8_t>(from.types, cells, "the types of the cells");
    target.FaceLocations = TakeBuffer<std::int64_t>(
      from.face_locations, Product(cells, sizeof(std::int64_t)), "the locations of faces");
    target.Faces = TakeBuffer<std::int64_t>(
      from.faces, Product(this->Cells->GetFacesSize(), sizeof(std::int64_t)), "the faces");
    Need(!target.Connectivity == !target.Offsets && !target.Connectivity == !target.Types,
      "connectivity, offsets and types are wanted together");
    Need(!target.Connectivity || this->Cells->GetFacesSize() == 0 ||
        (target.FaceLocations && target.Faces),
      "the faces of polyhedra are wanted with their cells");
  }

  const std::unique_ptr<Decoder> Cells;
  const ScalarType CoordinateType;
  const std::vector<ArrayDescription> Arrays;
};

template <typename Decoder>
std::unique_ptr<gatun_piece> MakePiece(std::unique_ptr<Decoder> decoder, const FoundRequest& found)
{
  return std::make_unique<CellPiece<Decoder>>(std::move(decoder), found);
}
}

//------------------------------------------------------------------------------
FoundRequest::FoundRequest(gatun_file& file, const gatun_request& from)
  : Region(TakeRegion(from))
  , IsExact((from.flags & GATUN_EXACT) != 0 && (this->Region.Box || this->Region.Interval))
{
  const auto place = file.Find(from.step);
  this->Mesh = from.flags & GATUN_BOUNDARY ? place.Mesh->GetBoundary() : place.Mesh;
  const auto source = gatun_file::Simplify(*this->Mesh, from.level, from.ratio);
  this->File = source.File;
  this->Request.Merges = source.Merges;
  this->Request.Tree = source.Merges > 0 ? source.Tree : nullptr;
  this->Request.Step = place.Step;
  const auto pieces = std::max(from.pieces, 1u);
  Need(from.piece < pieces, "there is no such piece");
  const auto chunks = FindChunks(*this->File, this->Region, place.Step, source.Merges);
  this->Request.Chunks = GetPiece(chunks, from.piece, pieces);
  if (from.ghost_levels > 0 && chunks.size() != this->File->GetChunks().size())
  {
    this->Request.Universe = chunks;
  }
  this->Request.GhostLevels = from.ghost_levels;
  this->Request.WithUnusedPoints = (from.flags & GATUN_UNUSED_POINTS) != 0 && from.piece == 0;
  this->Request.Form = from.flags & GATUN_TETRAHEDRA ? PieceForm::Tetrahedra : PieceForm::Original;
  this->Request.RestoreOrder = (from.flags & GATUN_RESTORE_ORDER) != 0;
  Need(from.array_count == 0 || from.arrays, "the numbers of the arrays are missing");
  Need(
    from.array_count == 0 || place.Step < this->File->GetNumberOfSteps(), "the file has no values");
  for (std::size_t i = 0; i < from.array_count; ++i)
  {
    const auto number = from.arrays[i];
    Need(number < this->File->GetArrays().size() && (i == 0 || number > from.arrays[i - 1]),
      "the numbers of the arrays do not ascend, or one does not exist");
    this->Request.Arrays.push_back(number);
    this->Arrays.push_back(this->File->GetArrays()[number]);
  }
}
}

using namespace gatun;

//------------------------------------------------------------------------------
std::vector<void*> gatun_piece::TakeArrays(const gatun_buffers& from,
  const std::vector<ArrayDescription>& arrays, std::uint64_t points, std::uint64_t cells)
{
  std::vector<void*> list;
  if (!from.arrays)
  {
    return list;
  }
  Need(from.array_count == arrays.size(), "there are not as many buffers of arrays as requested");
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    const auto& array = arrays[i];
    const auto tuples = array.Where == Association::Point ? points : cells;
    list.push_back(
      TakeBuffer(from.arrays[i], Product(tuples, Product(array.Components, SizeOf(array.Type))),
        "array '" + array.Name + "'"));
  }
  return list;
}

//------------------------------------------------------------------------------
gatun_status gatun_plan(gatun_file* file, const gatun_request* request, uint64_t gap,
  gatun_range* ranges, size_t capacity, size_t* count)
{
  return Guard(
    [&]
    {
      NeedPointers(file, request, count);
      BytePlan plan;
      plan.Try(
        [&]
        {
          const FoundRequest found(*file, Take(request));
          PlanPiece(*found.File, found.Request, plan);
        });
      GiveRanges(std::move(plan.Ranges), plan.Missing, gap, ranges, capacity, count);
    });
}

gatun_status gatun_prepare(gatun_file* file, const gatun_request* request, gatun_sizes* sizes,
  gatun_progress progress, void* user, gatun_piece** piece)
{
  return Guard(
    [&]
    {
      NeedPointers(file, request, sizes, piece);
      const FoundRequest found(*file, Take(request));
      const auto report = WrapProgress(progress, user);
      std::unique_ptr<gatun_piece> made;
      if (found.IsExact)
      {
        made = MakePiece(
          std::make_unique<ExactPiece>(found.MakeCache(), found.Request, found.Region, report),
          found);
      }
      else
      {
        auto decoder = std::make_unique<PieceDecoder>(found.MakeCache());
        decoder->SetRequest(found.Request, report);
        made = MakePiece(std::move(decoder), found);
      }
      Give(made->GetSizes(), sizes);
      *piece = made.release();
    });
}

gatun_status gatun_read(
  gatun_piece* piece, const gatun_buffers* buffers, gatun_progress progress, void* user)
{
  return Guard(
    [&]
    {
      NeedPointers(piece, buffers);
      piece->Read(Take(buffers), WrapProgress(progress, user));
    });
}

void gatun_end(gatun_piece* piece)
{
  delete piece;
}
