// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPiece.h"

#include "gatunCellShapes.h"
#include "gatunFileSlice.h"
#include "gatunFileSurface.h"

#include <cmath>
#include <optional>
#include <utility>

namespace gatun
{
namespace
{
/** Triangles that were made of a mesh, with its arrays. */
class TrianglePiece final : public gatun_piece
{
public:
  TrianglePiece(Surface surface, ScalarType coordinateType, bool hasNormals,
    std::vector<ArrayDescription> arrays)
    : Triangles(std::move(surface))
    , CoordinateType(coordinateType)
    , HasNormals(hasNormals)
    , Arrays(std::move(arrays))
  {
  }

  gatun_sizes GetSizes() const override
  {
    gatun_sizes sizes{};
    sizes.points = this->Triangles.GetNumberOfPoints();
    sizes.cells = this->Triangles.GetNumberOfTriangles();
    sizes.connectivity = 3 * sizes.cells;
    sizes.cell_type = TriangleType;
    sizes.coordinate_type = static_cast<gatun_type>(this->CoordinateType);
    return sizes;
  }

  void Read(const gatun_buffers& from, const Progress&) override
  {
    const auto sizes = this->GetSizes();
    const std::uint64_t id = from.wide_ids ? sizeof(std::int64_t) : sizeof(std::int32_t);
    Need(
      from.wide_ids || sizes.points <= 0x7fffffff, "ids of 32 bits are too small for this surface");
    if (void* to = TakeBuffer(
          from.points, Product(sizes.points, 3 * SizeOf(this->CoordinateType)), "the points"))
    {
      this->Triangles.FillPoints(to);
    }
    if (void* to =
          TakeBuffer(from.connectivity, Product(sizes.connectivity, id), "the connectivity"))
    {
      this->Triangles.FillTriangles(to, from.wide_ids != 0);
    }
    if (auto* to =
          TakeBuffer<float>(from.normals, Product(sizes.points, 3 * sizeof(float)), "the normals"))
    {
      Need(this->HasNormals, "normals were not asked for");
      this->Triangles.FillNormals(to);
    }
    const auto targets = TakeArrays(from, this->Arrays, sizes.points, sizes.cells);
    std::size_t pointArrays = 0;
    std::size_t cellArrays = 0;
    for (std::size_t i = 0; i < targets.size(); ++i)
    {
      const auto& array = this->Arrays[i];
      const auto bytes = array.Components * SizeOf(array.Type);
      if (array.Where == Association::Point)
      {
        this->FillIf(targets[i], pointArrays++, bytes, &Surface::FillPointArray);
      }
      else
      {
        this->FillIf(targets[i], cellArrays++, bytes, &Surface::FillCellArray);
      }
    }
  }

private:
  void FillIf(void* to, std::size_t array, std::size_t bytes,
    void (Surface::*fill)(std::size_t, std::size_t, void*) const) const
  {
    if (to)
    {
      (this->Triangles.*fill)(array, bytes, to);
    }
  }

  const Surface Triangles;
  const ScalarType CoordinateType;
  const bool HasNormals;
  const std::vector<ArrayDescription> Arrays;
};
}
}

using namespace gatun;

//------------------------------------------------------------------------------
gatun_status gatun_prepare_contour(gatun_file* file, const gatun_request* request,
  const gatun_contour* contour, gatun_sizes* sizes, gatun_progress progress, void* user,
  gatun_piece** piece)
{
  return Guard(
    [&]
    {
      NeedPointers(file, request, contour, sizes, piece);
      const auto from = Take(contour);
      const auto wish = Take(request);
      const FoundRequest found(*file, wish);
      Need(!found.File->IsSurface(), "a surface has no isosurfaces");
      Need(from.values || from.value_count == 0, "the isovalues are missing");
      FileSurface maker(found.MakeCache(), found.Request.Tree, found.Request.Merges);
      FileSurfaceRequest own;
      own.Options.Values.assign(from.values, from.values + from.value_count);
      own.Options.CoordinateType = found.File->GetCoordinateType();
      own.Options.Normals = from.normals != 0;
      own.Array = from.array;
      own.Component = from.component;
      own.Step = found.Request.Step;
      own.Arrays = found.Request.Arrays;
      own.Piece = wish.piece;
      own.Pieces = std::max(wish.pieces, 1u);
      auto made = std::make_unique<TrianglePiece>(maker.Extract(own, WrapProgress(progress, user)),
        own.Options.CoordinateType, own.Options.Normals, found.Arrays);
      Give(made->GetSizes(), sizes);
      *piece = made.release();
    });
}

//------------------------------------------------------------------------------
gatun_status gatun_prepare_slice(gatun_file* file, const gatun_request* request, gatun_sizes* sizes,
  gatun_progress progress, void* user, gatun_piece** piece)
{
  return Guard(
    [&]
    {
      NeedPointers(file, request, sizes, piece);
      auto wish = Take(request);
      wish.flags |= GATUN_ON_PLANE;
      const FoundRequest found(*file, wish);
      const auto& plane = *found.Region.Section;
      double length = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        Need(std::isfinite(plane.Origin[axis]) && std::isfinite(plane.Normal[axis]),
          "the plane is not finite");
        length = std::max(length, std::abs(plane.Normal[axis]));
      }
      Need(length > 0, "the normal of the plane is 0");
      const auto type = found.File->GetCoordinateType();
      auto made = std::make_unique<TrianglePiece>(
        ExtractSlice(found.MakeCache(), found.Request, plane, type, WrapProgress(progress, user)),
        type, false, found.Arrays);
      Give(made->GetSizes(), sizes);
      *piece = made.release();
    });
}
