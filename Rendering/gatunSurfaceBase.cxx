// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceBase.h"

#include "gatunFileReader.h"
#include "gatunNewArray.h"
#include "gatunParallel.h"
#include "gatunPieceReader.h"
#include "gatunSurfaceGrid.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace gatun
{
namespace
{
// A block is an image's unit of transfer, and takes some time to draw.
constexpr std::size_t MostBlocks = 64;
constexpr std::size_t CellsOfBlock = 4096;

//------------------------------------------------------------------------------
std::vector<SurfaceDetail::Point> GetPlaces(vtkPoints* points)
{
  std::vector<SurfaceDetail::Point> places(static_cast<std::size_t>(points->GetNumberOfPoints()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    points->GetPoint(static_cast<vtkIdType>(i), places[i].data());
  }
  return places;
}

//------------------------------------------------------------------------------
/** Tuples of arrays, with the roles of the arrays. */
void Gather(vtkDataSetAttributes* from, vtkDataSetAttributes* to, vtkIdList* ids)
{
  vtkNew<vtkIdList> places;
  places->SetNumberOfIds(ids->GetNumberOfIds());
  std::iota(places->begin(), places->end(), vtkIdType{ 0 });
  to->CopyAllOn();
  to->CopyAllocate(from, ids->GetNumberOfIds());
  to->SetNumberOfTuples(ids->GetNumberOfIds());
  to->CopyData(from, ids, places);
}
}

//------------------------------------------------------------------------------
SurfaceBase::SurfaceBase(PublishedFile source, std::size_t merges, SurfaceContents what,
  const SurfaceMesh::Progress& progress)
  : Source(std::move(source))
  , Merges(merges)
  , What(std::move(what))
{
  constexpr double ofReading = 0.3;
  const auto report = [&](double done) { return !progress || progress(done); };
  // The order of the file, in which merges name points.
  this->Source.RestoreOrder = false;
  this->Read([&](double done) { return report(ofReading * done); });

  const auto places = GetPlaces(this->Grid->GetPoints());
  std::vector<MergeTree::Triangle> triangles;
  for (std::size_t cell = 0; cell < this->Types.size(); ++cell)
  {
    const auto corners = this->GetCorners(cell);
    if (this->Types[cell] == VTK_TRIANGLE)
    {
      triangles.push_back({ corners[0], corners[1], corners[2] });
    }
  }
  SharedFile& hierarchy = *this->Source.File;
  const auto file = hierarchy.Find(merges).File;
  auto tree = hierarchy.GetTree(*file);
  const auto progressOfRest = [&](double done)
  { return report(ofReading + (1 - ofReading) * done); };
  // Those in the file, if it has any.
  auto dependencies = hierarchy.GetDependencies(*file, progressOfRest);
  if (!dependencies)
  {
    dependencies = std::make_shared<const MergeDependencies>(*tree, triangles, progressOfRest);
  }
  this->Detail = std::make_unique<const SurfaceDetail>(
    std::move(tree), std::move(dependencies), places, triangles);
  this->Divide(places);
}

SurfaceBase::~SurfaceBase() = default;

//------------------------------------------------------------------------------
std::uint64_t SurfaceBase::EstimateBytes(std::uint64_t points)
{
  // A point, its normal, its merge and dependencies, two triangles, and what choosing takes.
  return 160 * points;
}

//------------------------------------------------------------------------------
void SurfaceBase::Read(const SurfaceMesh::Progress& progress)
{
  PieceReader reader;
  reader.Choose(this->Source, this->Merges, false);
  vtkNew<vtkInformation> whole; // asks for the only piece
  PortRequest port(*this->Source.File->GetFile(), whole);
  port.Step = this->What.Step;
  std::vector<std::uint32_t> chunks(reader.GetMesh().GetChunks().size());
  std::iota(chunks.begin(), chunks.end(), 0u);
  PieceRequest request = reader.MakeRequest(this->Source, port, chunks);
  request.Arrays = this->What.Arrays;
  request.Form = PieceForm::Original;
  this->Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  reader.Read(this->Source, request, false, this->Grid, progress);
  reader.ForgetMesh();

  vtkCellArray* const cells = this->Grid->GetCells();
  this->Corners.reserve(static_cast<std::size_t>(cells->GetNumberOfConnectivityIds()));
  const auto next = vtk::TakeSmartPointer(cells->NewIterator());
  for (next->GoToFirstCell(); !next->IsDoneWithTraversal(); next->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    next->GetCurrentCell(count, corners);
    this->Types.push_back(
      static_cast<std::uint8_t>(this->Grid->GetCellType(next->GetCurrentCellId())));
    this->Begins.push_back(static_cast<std::uint32_t>(this->Corners.size()));
    std::transform(corners, corners + count, std::back_inserter(this->Corners),
      [](vtkIdType corner) { return static_cast<std::uint32_t>(corner); });
  }
  this->Begins.push_back(static_cast<std::uint32_t>(this->Corners.size()));
  // Only points and arrays are needed from now on. Cell arrays keep their length.
  auto kept = vtkSmartPointer<vtkUnstructuredGrid>::New();
  kept->SetPoints(this->Grid->GetPoints());
  kept->GetPointData()->ShallowCopy(this->Grid->GetPointData());
  kept->GetCellData()->ShallowCopy(this->Grid->GetCellData());
  this->Grid = kept;
}

//------------------------------------------------------------------------------
std::span<const std::uint32_t> SurfaceBase::GetCorners(std::size_t cell) const
{
  return std::span(this->Corners)
    .subspan(this->Begins[cell], this->Begins[cell + 1] - this->Begins[cell]);
}

//------------------------------------------------------------------------------
/** Bisects the cells along the longest axis, until there are enough blocks of equal size. */
void SurfaceBase::Divide(std::span<const SurfaceDetail::Point> places)
{
  const std::size_t count = this->Types.size();
  std::vector<std::array<float, 3>> middles(count);
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    const auto corners = this->GetCorners(cell);
    for (std::size_t c = 0; c < 3; ++c)
    {
      double sum = 0;
      for (const std::uint32_t corner : corners)
      {
        sum += places[corner][c] / static_cast<double>(corners.size());
      }
      // What is nowhere is together.
      middles[cell][c] = std::isfinite(sum) ? static_cast<float>(sum) : 0;
    }
  }
  this->Order.resize(count);
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  this->Starts = { 0, count };
  for (std::size_t blocks = 1; blocks < MostBlocks && blocks * CellsOfBlock < count; blocks *= 2)
  {
    std::vector<std::size_t> starts(2 * blocks + 1, count);
    ParallelFor(blocks,
      [&](std::size_t block)
      {
        const auto at = [&](std::size_t i)
        { return this->Order.begin() + static_cast<std::ptrdiff_t>(i); };
        const std::size_t begin = this->Starts[block];
        const std::size_t end = this->Starts[block + 1];
        Bounds box;
        std::for_each(at(begin), at(end),
          [&](std::uint32_t cell)
          {
            const auto& middle = middles[cell];
            box.Include(SurfaceDetail::Point{ middle[0], middle[1], middle[2] });
          });
        std::size_t axis = 0;
        for (std::size_t c = 1; c < 3; ++c)
        {
          axis = box[c].Max - box[c].Min > box[axis].Max - box[axis].Min ? c : axis;
        }
        const std::size_t middle = begin + (end - begin) / 2;
        std::nth_element(at(begin), at(middle), at(end),
          [&](std::uint32_t a, std::uint32_t b)
          { return std::pair(middles[a][axis], a) < std::pair(middles[b][axis], b); });
        starts[2 * block] = begin;
        starts[2 * block + 1] = middle;
      });
    this->Starts = std::move(starts);
  }
  for (std::size_t block = 0; block < this->GetNumberOfBlocks(); ++block)
  {
    // Cells stay in their order, which decides what is drawn of two at one place.
    std::sort(this->Order.begin() + static_cast<std::ptrdiff_t>(this->Starts[block]),
      this->Order.begin() + static_cast<std::ptrdiff_t>(this->Starts[block + 1]));
  }
}

//------------------------------------------------------------------------------
bool SurfaceBase::Touches(std::size_t block, const std::vector<bool>& isMarked) const
{
  for (std::size_t i = this->Starts[block]; i < this->Starts[block + 1]; ++i)
  {
    for (const std::uint32_t corner : this->GetCorners(this->Order[i]))
    {
      if (isMarked[corner])
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
SurfaceBlock SurfaceBase::Simplify(
  std::size_t block, std::span<const std::uint32_t> ancestors) const
{
  SurfaceBlock left;
  for (std::size_t i = this->Starts[block]; i < this->Starts[block + 1]; ++i)
  {
    const std::uint32_t cell = this->Order[i];
    const auto corners = this->GetCorners(cell);
    if (this->Types[cell] == VTK_TRIANGLE)
    {
      MergeTree::Triangle triangle{ corners[0], corners[1], corners[2] };
      if (!gatun::Simplify(triangle, ancestors))
      {
        continue;
      }
      left.Corners.insert(left.Corners.end(), triangle.begin(), triangle.end());
    }
    else
    {
      std::transform(corners.begin(), corners.end(), std::back_inserter(left.Corners),
        [&](std::uint32_t corner) { return ancestors[corner]; });
    }
    left.Cells.push_back(cell);
  }
  for (const std::uint32_t corner : left.Corners)
  {
    std::array<double, 3> place{};
    this->Grid->GetPoints()->GetPoint(corner, place.data());
    left.Box.Include(place);
  }
  return left;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SurfaceBase::MakeMesh(const SurfaceBlock& block) const
{
  std::vector<std::uint32_t> points = block.Corners;
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto copy = [](const std::vector<std::uint32_t>& from)
  {
    auto ids = vtkSmartPointer<vtkIdList>::New();
    ids->SetNumberOfIds(static_cast<vtkIdType>(from.size()));
    std::copy(from.begin(), from.end(), ids->begin());
    return ids;
  };
  const auto pointIds = copy(points);
  const auto cellIds = copy(block.Cells);

  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataType(this->Grid->GetPoints()->GetDataType());
  SizePoints(coordinates, pointIds->GetNumberOfIds());
  this->Grid->GetPoints()->GetData()->GetTuples(pointIds, coordinates->GetData());
  grid->SetPoints(coordinates);
  Gather(this->Grid->GetPointData(), grid->GetPointData(), pointIds);

  vtkNew<vtkUnsignedCharArray> types;
  SizeArray(types, cellIds->GetNumberOfIds());
  unsigned char* type = types->GetPointer(0);
  CellCollector cells;
  cells.Reserve(block.Cells.size(), block.Corners.size());
  auto corner = block.Corners.begin();
  for (const std::uint32_t cell : block.Cells)
  {
    *type++ = this->Types[cell];
    const std::size_t count = this->GetCorners(cell).size();
    for (std::size_t i = 0; i < count; ++i, ++corner)
    {
      cells.AddPoint(static_cast<vtkIdType>(
        std::lower_bound(points.begin(), points.end(), *corner) - points.begin()));
    }
    cells.EndCell();
  }
  grid->SetCells(types, cells.Make());
  Gather(this->Grid->GetCellData(), grid->GetCellData(), cellIds);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  MakeSurface(grid, FindSurfaceCells(grid), mesh);
  return mesh;
}
}
