// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnSpooledMesh.h"

#include "gtnFailure.h"
#include "gtnSpoolCursor.h"

#include "gatunKeepMemory.h"
#include "gatunMeshCheck.h"
#include "gatunParallel.h"

#include "vtkAbstractArray.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace gtn
{
namespace
{

constexpr std::uint64_t MiB = std::uint64_t{ 1 } << 20;

// What ranges of a mesh take while they are read, and the sample of its points.
constexpr std::uint64_t ReadingBytes = 40 * MiB;

// Of an array that is read at once.
constexpr std::size_t MostBlockBytes = std::size_t{ 4 } << 20;

// For the buffers of all streams.
constexpr std::uint64_t MostStreamBytes = 64 * MiB;

void ToPoints(
  const std::vector<std::uint8_t>& bytes, int type, std::vector<PointTree::Point>& points)
{
  const auto convert = [&](const auto* values)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        points[i][axis] = static_cast<double>(values[3 * i + axis]);
      }
    }
  };
  switch (type)
  {
    vtkTemplateMacro(convert(reinterpret_cast<const VTK_TT*>(bytes.data())));
    default:
      throw Failure("has points of a type that is not known");
  }
}

// Sorts numbers and removes those that are there several times, which most are.
void SortUnique(std::vector<std::uint32_t>& numbers)
{
  constexpr std::size_t share = 1 << 19;
  std::vector<std::size_t> kept((numbers.size() + share - 1) / share);
  const auto sort = [](auto begin, auto end)
  {
    std::sort(begin, end);
    return std::unique(begin, end);
  };
  gatun::ParallelFor(kept.size(),
    [&](std::size_t part)
    {
      const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(part * share);
      const auto end =
        numbers.begin() + static_cast<std::ptrdiff_t>(std::min(numbers.size(), (part + 1) * share));
      kept[part] = static_cast<std::size_t>(sort(begin, end) - begin);
    });
  auto to = numbers.begin();
  for (std::size_t part = 0; part < kept.size(); ++part)
  {
    const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(part * share);
    to = std::copy(begin, begin + static_cast<std::ptrdiff_t>(kept[part]), to);
  }
  numbers.erase(sort(numbers.begin(), to), numbers.end());
}

} // anonymous namespace

//------------------------------------------------------------------------------
// Progress in points and cells that are read.
class SpooledMesh::Work
{
public:
  Work(const std::function<bool(double)>& progress, double total)
    : Progress(progress)
    , Total(std::max(total, 1.))
  {
  }

  void Add(std::size_t count)
  {
    this->Done += static_cast<double>(count);
    if (this->Progress && !this->Progress(std::min(1., this->Done / this->Total)))
    {
      throw Interrupted();
    }
  }

private:
  const std::function<bool(double)>& Progress;
  const double Total;
  double Done = 0;
};

//------------------------------------------------------------------------------
SpooledMesh::SpooledMesh(std::shared_ptr<RangedMesh> mesh, const SpoolSettings& settings,
  const std::function<bool(double)>& progress)
  : Mesh(std::move(mesh))
  , Settings(settings)
  , Times(this->Mesh->GetTimes())
  , Steps(std::max<std::size_t>(1, this->Times.size()))
  , File(settings.Folder)
{
  this->MeasureTuples();
  this->CheckMemory();
  const auto points = static_cast<double>(this->Mesh->GetNumberOfPoints());
  const auto cells = static_cast<double>(this->Mesh->GetNumberOfCells());
  vtkUnstructuredGrid* grid = this->Mesh->GetTemplate(0);
  const auto count = [&](int association)
  {
    return static_cast<double>(this->Steps) *
      grid->GetAttributesAsFieldData(association)->GetNumberOfArrays();
  };
  Work work(progress,
    points * (3 + count(vtkDataObject::POINT)) + cells * (2 + count(vtkDataObject::CELL)));
  {
    const PointTree tree = this->MakeTree(work);
    PieceRouter router(
      static_cast<std::size_t>(this->Mesh->GetNumberOfPoints()), tree.CountLeaves());
    this->FindLeaves(router, tree, work);
    this->WeighCells(router, work);
    this->SpoolCells(router, work);
    this->SpoolUnused(router);
  }
  this->SpoolArrays(vtkDataObject::CELL, work);
  if (this->HasCellNumbers)
  {
    this->SpoolCellNumbers(work);
  }
  this->MakeLocal();
  this->MarkShared();
  this->SpoolArrays(vtkDataObject::POINT, work);
  this->Mesh->CheckUnchanged();
  gatun::ReturnFreedMemory();
}

//------------------------------------------------------------------------------
SpooledMesh::~SpooledMesh() = default;

//------------------------------------------------------------------------------
void SpooledMesh::MeasureTuples()
{
  vtkUnstructuredGrid* grid = this->Mesh->GetTemplate(0);
  const int type = grid->GetPoints() ? grid->GetPoints()->GetDataType() : VTK_FLOAT;
  this->CoordinateBytes = 3 * static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(type));
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkFieldData* data = grid->GetAttributesAsFieldData(association);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      this->TupleBytes[association] +=
        static_cast<std::size_t>(array->GetNumberOfComponents() * array->GetDataTypeSize());
    }
  }
  constexpr std::size_t numberBytes = 16; // in the join array, and as they go to the writer
  this->PointBytes = this->CoordinateBytes + this->TupleBytes[vtkDataObject::POINT] + numberBytes;
}

//------------------------------------------------------------------------------
void SpooledMesh::CheckMemory()
{
  const std::uint64_t least = ReadingBytes + 2 * this->Mesh->GetNumberOfPoints();
  if (least > this->Settings.Memory)
  {
    this->FailForMemory(least);
  }
  this->StreamBytes = static_cast<std::size_t>(
    std::min<std::uint64_t>(MostStreamBytes, (this->Settings.Memory - least) / 2));
}

//------------------------------------------------------------------------------
// Each stream that is written has a buffer.
void SpooledMesh::CheckStreams(std::size_t streams) const
{
  const std::uint64_t least = static_cast<std::uint64_t>(streams) * Spool::LeastBuffer;
  if (least > this->StreamBytes)
  {
    this->FailForMemory(ReadingBytes + 2 * this->Mesh->GetNumberOfPoints() + 2 * least);
  }
}

//------------------------------------------------------------------------------
void SpooledMesh::FailForMemory(std::uint64_t needed) const
{
  throw Failure(this->Settings.Name,
    "dividing the mesh into pieces takes about " +
      std::to_string((needed + this->Settings.Reserved) / MiB + 1) +
      " MiB of memory, and --memory allows " +
      std::to_string((this->Settings.Memory + this->Settings.Reserved) / MiB));
}

//------------------------------------------------------------------------------
PointTree SpooledMesh::MakeTree(Work& work)
{
  constexpr std::size_t mostSamples = std::size_t{ 1 } << 18;
  constexpr std::size_t samplesOfLeaf = 8;
  const auto count = static_cast<std::size_t>(this->Mesh->GetNumberOfPoints());
  const std::size_t stride = count / mostSamples + 1;
  vtkPoints* points = this->Mesh->GetTemplate(0)->GetPoints();
  std::vector<PointTree::Point> sample;
  std::vector<PointTree::Point> block;
  std::vector<std::uint8_t> bytes(BlockSize * this->CoordinateBytes);
  for (std::size_t begin = 0; begin < count; begin += BlockSize)
  {
    block.resize(std::min(BlockSize, count - begin));
    this->Mesh->ReadPoints(begin, block.size(), bytes.data());
    ToPoints(bytes, points->GetDataType(), block);
    for (std::size_t i = (stride - begin % stride) % stride; i < block.size(); i += stride)
    {
      const PointTree::Point& point = block[i];
      if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]))
      {
        sample.push_back(point);
      }
    }
    work.Add(block.size());
  }
  const unsigned levels = std::min(PieceRouter::MostLevels,
    static_cast<unsigned>(std::bit_width(sample.size() / samplesOfLeaf + 1)) - 1);
  return { std::move(sample), levels };
}

//------------------------------------------------------------------------------
void SpooledMesh::FindLeaves(PieceRouter& router, const PointTree& tree, Work& work)
{
  const auto count = static_cast<std::size_t>(this->Mesh->GetNumberOfPoints());
  vtkPoints* points = this->Mesh->GetTemplate(0)->GetPoints();
  std::vector<PointTree::Point> block;
  std::vector<std::uint8_t> bytes(BlockSize * this->CoordinateBytes);
  for (std::size_t begin = 0; begin < count; begin += BlockSize)
  {
    block.resize(std::min(BlockSize, count - begin));
    this->Mesh->ReadPoints(begin, block.size(), bytes.data());
    ToPoints(bytes, points->GetDataType(), block);
    constexpr std::size_t share = 4096;
    gatun::ParallelFor((block.size() + share - 1) / share,
      [&](std::size_t part)
      {
        const std::size_t end = std::min(block.size(), (part + 1) * share);
        for (std::size_t i = part * share; i < end; ++i)
        {
          router.SetLeaf(begin + i, tree.Find(block[i]));
        }
      });
    work.Add(block.size());
  }
}

//------------------------------------------------------------------------------
void SpooledMesh::WeighCells(PieceRouter& router, Work& work)
{
  RangedCells cells;
  for (std::uint64_t begin = 0; begin < this->Mesh->GetNumberOfCells(); begin += cells.Types.size())
  {
    this->Mesh->ReadCells(begin, BlockSize, cells);
    const std::span<const std::uint32_t> points(cells.Points);
    std::size_t at = 0;
    for (std::size_t i = 0; i < cells.Types.size(); ++i)
    {
      gatun::CheckCellSize(begin + i, cells.Types[i], cells.Sizes[i]);
      router.Weigh(
        points.subspan(at, cells.Sizes[i]), cells.FaceSizes.empty() ? 0 : cells.FaceSizes[i]);
      at += cells.Sizes[i];
    }
    this->HasCellNumbers = this->HasCellNumbers ||
      (this->Settings.Split &&
        std::any_of(cells.Types.begin(), cells.Types.end(),
          [](std::uint8_t type) { return type != VTK_TETRA; }));
    work.Add(cells.Types.size());
  }
  const double id = this->Mesh->HasWideIds() ? 8 : 4;
  const bool hasFaces = this->Mesh->HasPolyhedra();
  const ElementBytes bytes{ static_cast<double>(this->PointBytes),
    1 + id + (hasFaces ? sizeof(vtkIdType) : 0) +
      static_cast<double>(this->TupleBytes[vtkDataObject::CELL]),
    id, sizeof(vtkIdType) };
  this->Pieces.resize(router.Divide(bytes, this->Settings.PieceBytes, this->Settings.Pieces));
}

//------------------------------------------------------------------------------
// Writes the cells of each piece, with points of the whole mesh.
void SpooledMesh::SpoolCells(PieceRouter& router, Work& work)
{
  const std::size_t pieces = this->Pieces.size();
  const bool hasFaces = this->Mesh->HasPolyhedra();
  const std::size_t kinds = hasFaces ? 5 : 3;
  this->CheckStreams(kinds * pieces + 1);
  const std::size_t first = this->File.Open(kinds * pieces + 1, this->StreamBytes);
  this->Routes = first;
  this->Types = first + 1;
  this->Sizes = this->Types + pieces;
  this->Corners = this->Sizes + pieces;
  this->FaceSizes = this->Corners + pieces;
  this->Faces = this->FaceSizes + pieces;
  RangedCells cells;
  std::vector<std::uint32_t> routes;
  const auto append = [&](std::size_t stream, const auto& values, std::size_t at, std::size_t n)
  {
    this->File.Append(
      stream, { reinterpret_cast<const std::uint8_t*>(values.data() + at), n * sizeof(values[0]) });
  };
  for (std::uint64_t begin = 0; begin < this->Mesh->GetNumberOfCells(); begin += cells.Types.size())
  {
    this->Mesh->ReadCells(begin, BlockSize, cells);
    const std::span<const std::uint32_t> points(cells.Points);
    routes.clear();
    std::size_t at = 0;
    std::size_t faceAt = 0;
    for (std::size_t i = 0; i < cells.Types.size(); ++i)
    {
      const std::size_t piece = router.Route(points.subspan(at, cells.Sizes[i]));
      routes.push_back(static_cast<std::uint32_t>(piece));
      ++this->Pieces[piece].Cells;
      append(this->Types + piece, cells.Types, i, 1);
      append(this->Sizes + piece, cells.Sizes, i, 1);
      append(this->Corners + piece, cells.Points, at, cells.Sizes[i]);
      at += cells.Sizes[i];
      if (hasFaces)
      {
        append(this->FaceSizes + piece, cells.FaceSizes, i, 1);
        append(this->Faces + piece, cells.Faces, faceAt, cells.FaceSizes[i]);
        faceAt += cells.FaceSizes[i];
      }
    }
    this->File.Append(this->Routes, routes);
    work.Add(cells.Types.size());
  }
  this->File.Close();
}

//------------------------------------------------------------------------------
// Makes pieces of points that no cell uses, after those with cells.
void SpooledMesh::SpoolUnused(const PieceRouter& router)
{
  const auto points = static_cast<std::size_t>(this->Mesh->GetNumberOfPoints());
  const auto most = static_cast<std::size_t>(
    std::clamp<std::uint64_t>(this->Settings.PieceBytes / this->PointBytes, 1, points + 1));
  std::size_t unused = 0;
  for (std::size_t p = 0; p < points; ++p)
  {
    unused += router.IsUnused(p);
  }
  this->FirstUnused = this->Pieces.size();
  this->UnusedNumbers = this->File.Open((unused + most - 1) / most, this->StreamBytes);
  std::size_t found = 0;
  for (std::size_t p = 0; p < points && found < unused; ++p)
  {
    if (router.IsUnused(p))
    {
      const auto number = static_cast<std::uint32_t>(p);
      this->File.Append(this->UnusedNumbers + found++ / most, std::vector{ number });
    }
  }
  this->File.Close();
  for (std::size_t begin = 0; begin < unused; begin += most)
  {
    Piece piece;
    piece.Points = std::min(most, unused - begin);
    piece.Bytes = static_cast<std::uint64_t>(piece.Points) * this->PointBytes;
    this->UnusedBytes += piece.Bytes;
    this->Pieces.push_back(piece);
  }
}

//------------------------------------------------------------------------------
// Lists the points of each piece with cells, and gives the cells their numbers in this list.
void SpooledMesh::MakeLocal()
{
  this->Numbers = this->File.Open(this->FirstUnused, this->StreamBytes);
  for (std::size_t p = 0; p < this->FirstUnused; ++p)
  {
    this->MakePieceLocal(p);
  }
  this->File.Close();
}

//------------------------------------------------------------------------------
void SpooledMesh::MakePieceLocal(std::size_t number)
{
  Piece& piece = this->Pieces[number];
  auto corners = this->File.ReadAll<std::uint32_t>(this->Corners + number);
  std::vector<std::uint32_t> faces;
  std::vector<std::uint32_t> points = corners;
  const auto forEachOfFaces = [&](auto&& use)
  {
    for (std::size_t at = 0; at < faces.size();)
    {
      for (std::uint32_t left = faces[at++]; left > 0; --left)
      {
        for (std::uint32_t n = faces[at++]; n > 0; --n)
        {
          use(faces[at++]);
        }
      }
    }
  };
  if (this->Mesh->HasPolyhedra())
  {
    faces = this->File.ReadAll<std::uint32_t>(this->Faces + number);
    forEachOfFaces([&](std::uint32_t point) { points.push_back(point); });
  }
  SortUnique(points);
  const auto find = [&](std::uint32_t& point)
  {
    point = static_cast<std::uint32_t>(
      std::lower_bound(points.begin(), points.end(), point) - points.begin());
  };
  constexpr std::size_t share = 1 << 16;
  gatun::ParallelFor((corners.size() + share - 1) / share,
    [&](std::size_t part)
    {
      const std::size_t end = std::min(corners.size(), (part + 1) * share);
      for (std::size_t i = part * share; i < end; ++i)
      {
        find(corners[i]);
      }
    });
  this->File.Replace(this->Corners + number, corners);
  if (!faces.empty())
  {
    forEachOfFaces(find);
    this->File.Replace(this->Faces + number, faces);
  }
  this->File.Append(this->Numbers + number, points);
  piece.Points = points.size();
  const std::size_t id = this->Mesh->HasWideIds() ? 8 : 4;
  const std::size_t cellBytes = 1 + id + this->TupleBytes[vtkDataObject::CELL] +
    (this->Mesh->HasPolyhedra() ? sizeof(vtkIdType) : 0);
  piece.Bytes = static_cast<std::uint64_t>(points.size()) * this->PointBytes +
    static_cast<std::uint64_t>(piece.Cells) * cellBytes +
    static_cast<std::uint64_t>(corners.size()) * id +
    static_cast<std::uint64_t>(faces.size()) * sizeof(vtkIdType);
}

//------------------------------------------------------------------------------
void SpooledMesh::MarkShared()
{
  const std::uint64_t count = this->Mesh->GetNumberOfPoints();
  std::vector<SpoolCursor> cursors = this->MakeCursors();
  this->Shared = this->File.Open(this->FirstUnused, this->StreamBytes / 2);
  std::vector<std::vector<std::uint32_t>> points(this->FirstUnused);
  std::vector<std::uint32_t> uses(BlockSize);
  std::vector<std::uint8_t> marks;
  for (std::uint64_t begin = 0; begin < count; begin += BlockSize)
  {
    std::fill(uses.begin(), uses.end(), 0);
    for (std::size_t p = 0; p < this->FirstUnused; ++p)
    {
      points[p].clear();
      cursors[p].TakeBelow(begin + BlockSize,
        [&](std::uint32_t point)
        {
          points[p].push_back(static_cast<std::uint32_t>(point - begin));
          ++uses[points[p].back()];
        });
    }
    for (std::size_t p = 0; p < this->FirstUnused; ++p)
    {
      marks.resize(points[p].size());
      std::transform(points[p].begin(), points[p].end(), marks.begin(),
        [&](std::uint32_t point) { return static_cast<std::uint8_t>(uses[point] > 1); });
      this->File.Append(this->Shared + p, marks);
    }
  }
  this->File.Close();
}

//------------------------------------------------------------------------------
// Cursors of the numbers of the points of all pieces.
std::vector<SpoolCursor> SpooledMesh::MakeCursors() const
{
  std::vector<SpoolCursor> cursors;
  for (std::size_t p = 0; p < this->Pieces.size(); ++p)
  {
    cursors.emplace_back(this->File, this->GetNumbers(p),
      this->StreamBytes / 2 / sizeof(std::uint32_t) / this->Pieces.size() + 1);
  }
  return cursors;
}

//------------------------------------------------------------------------------
template <typename Read>
SpooledMesh::SpooledArray SpooledMesh::Distribute(
  int association, std::size_t tupleBytes, Work& work, Read&& read)
{
  const bool isPoints = association == vtkDataObject::POINT;
  const std::size_t pieces = this->Pieces.size();
  const std::uint64_t count =
    isPoints ? this->Mesh->GetNumberOfPoints() : this->Mesh->GetNumberOfCells();
  const SpooledArray array{ this->File.Open(pieces, this->StreamBytes / 2), tupleBytes };
  std::vector<SpoolCursor> points = isPoints ? this->MakeCursors() : std::vector<SpoolCursor>();
  SpoolCursor routes(this->File, this->Routes, BlockSize);
  const auto block = std::clamp<std::size_t>(MostBlockBytes / tupleBytes, 1, BlockSize);
  std::vector<std::uint8_t> values(block * tupleBytes);
  for (std::uint64_t begin = 0; begin < count; begin += block)
  {
    const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(block, count - begin));
    read(begin, size, values.data());
    const auto append = [&](std::size_t piece, std::size_t tuple)
    {
      this->File.Append(
        array.FirstStream + piece, { values.data() + tuple * tupleBytes, tupleBytes });
    };
    if (isPoints)
    {
      for (std::size_t p = 0; p < pieces; ++p)
      {
        points[p].TakeBelow(begin + size,
          [&](std::uint32_t point) { append(p, static_cast<std::size_t>(point - begin)); });
      }
    }
    else
    {
      std::size_t tuple = 0;
      routes.Take(size, [&](std::uint32_t piece) { append(piece, tuple++); });
    }
    work.Add(size);
  }
  this->File.Close();
  return array;
}

//------------------------------------------------------------------------------
void SpooledMesh::SpoolArrays(int association, Work& work)
{
  if (association == vtkDataObject::POINT)
  {
    this->Coordinates = this->Distribute(association, this->CoordinateBytes, work,
      [&](std::uint64_t begin, std::size_t count, void* values)
      { this->Mesh->ReadPoints(begin, count, values); });
  }
  vtkFieldData* data = this->Mesh->GetTemplate(0)->GetAttributesAsFieldData(association);
  for (std::size_t step = 0; step < this->Steps; ++step)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      this->Arrays[association].push_back(this->Distribute(association,
        static_cast<std::size_t>(array->GetNumberOfComponents() * array->GetDataTypeSize()), work,
        [&](std::uint64_t begin, std::size_t count, void* values)
        { this->Mesh->ReadArray(association, i, step, begin, count, values); }));
    }
  }
}

//------------------------------------------------------------------------------
void SpooledMesh::SpoolCellNumbers(Work& work)
{
  this->CellNumbers = this->Distribute(vtkDataObject::CELL, sizeof(vtkIdType), work,
    [](std::uint64_t begin, std::size_t count, void* values)
    {
      auto* numbers = static_cast<vtkIdType*>(values);
      std::iota(numbers, numbers + count, static_cast<vtkIdType>(begin));
    });
}
}
