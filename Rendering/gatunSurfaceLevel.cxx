// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceLevel.h"

#include "gatunCoarseLayout.h"
#include "gatunFileReader.h"
#include "gatunSurfaceGrid.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
SurfaceLevel::SurfaceLevel(PublishedFile source, std::size_t merges, SurfaceContents what)
  : Source(std::move(source))
  , Merges(merges)
  , What(std::move(what))
  , Place(PieceReader::FindPlace(this->Source, merges))
{
  const FileReader& file = *this->Place.File;
  const auto points = static_cast<double>(file.GetNumberOfPoints());
  // Cells and points decrease in proportion.
  const double left = points > 0 ? 1 - static_cast<double>(this->Place.Merges) / points : 1;
  for (std::size_t chunk = 0; chunk < file.GetChunks().size(); ++chunk)
  {
    this->Boxes.push_back(file.GetChunkBounds(chunk, this->Place.Merges, this->What.Step));
    this->Cells.push_back(
      static_cast<std::uint64_t>(left * static_cast<double>(file.GetChunks()[chunk].Cells)));
  }
}

SurfaceLevel::SurfaceLevel(
  PublishedFile source, std::size_t level, MergeCut cut, SurfaceContents what)
  : Source(std::move(source))
  , Merges(this->Source.File->GetMergesOfLevel(level) + cut.GetNumberOfMerges())
  , What(std::move(what))
  , Place(this->Source.File->GetLevel(level))
{
  this->Source.RestoreOrder = false; // which base meshes do not have
  this->Place.Merges = cut.GetLast();
  this->Layout =
    std::make_shared<const CoarseLayout>(this->Place.File, *this->Place.Tree, std::move(cut));
  const auto& chunks = this->Place.File->GetChunks();
  for (std::uint32_t chunk = 0; chunk < chunks.size(); ++chunk)
  {
    this->Boxes.push_back(this->Layout->GetBounds(chunk, this->What.Step));
    const double cells =
      this->Layout->GetShareLeft(chunk) * static_cast<double>(chunks[chunk].Cells);
    this->Cells.push_back(static_cast<std::uint64_t>(std::ceil(cells)));
  }
}

SurfaceLevel::~SurfaceLevel() = default;

//------------------------------------------------------------------------------
SurfaceLevel::LayoutPointer SurfaceLevel::GetLayout(const MergeTree& tree) const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (!this->Layout)
  {
    this->Layout = std::make_shared<const CoarseLayout>(
      this->Place.File, tree, MergeCut(tree, this->Place.Merges));
  }
  return this->Layout;
}

//------------------------------------------------------------------------------
std::unique_ptr<PieceReader> SurfaceLevel::TakeReader() const
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (!this->Readers.empty())
    {
      auto reader = std::move(this->Readers.back());
      this->Readers.pop_back();
      return reader;
    }
  }
  auto reader = std::make_unique<PieceReader>();
  const bool isMerged = this->Place.Merges > 0;
  // Buffers take the place of decoded chunks. After merges, a chunk needs points of others.
  reader->Choose(
    this->Source, this->Place, isMerged ? this->GetLayout(*this->Place.Tree) : nullptr, isMerged);
  return reader;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SurfaceLevel::Read(
  PieceReader& reader, std::uint32_t chunk, bool withIds, const Progress& progress) const
{
  vtkNew<vtkInformation> whole; // asks for the only piece
  PortRequest port(*this->Source.File->GetFile(), whole);
  port.Step = this->What.Step;
  PieceRequest request = reader.MakeRequest(this->Source, port, { chunk });
  request.Arrays = this->What.Arrays;
  request.Form = PieceForm::Original;
  request.WithUnusedPoints = false;
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  reader.Read(this->Source, request, false, grid, progress);
  if (withIds)
  {
    // Apart from the arrays, as one of them may be global ids that the user made.
    request.Arrays.clear();
    vtkNew<vtkUnstructuredGrid> ids;
    reader.Read(this->Source, request, true, ids, progress);
    grid->GetPointData()->AddArray(ids->GetPointData()->GetGlobalIds());
    grid->GetCellData()->AddArray(ids->GetCellData()->GetGlobalIds());
  }
  reader.ForgetMesh();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  MakeSurface(grid, FindSurfaceCells(grid), mesh);
  return mesh;
}

//------------------------------------------------------------------------------
SurfacePart SurfaceLevel::Decode(std::uint32_t chunk, bool withIds, const Progress& progress) const
{
  SurfacePart part;
  try
  {
    auto reader = this->TakeReader();
    part.Mesh = this->Read(*reader, chunk, withIds, progress);
    part.Cone = FindNormalCone(part.Mesh);
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Readers.push_back(std::move(reader));
  }
  catch (...)
  {
    part.Failure = std::current_exception();
  }
  return part;
}

//------------------------------------------------------------------------------
std::optional<std::vector<std::uint32_t>> SurfaceLevel::FindChanges(const SurfaceLevel& other) const
{
  if (this->Source.File != other.Source.File || this->Place.File != other.Place.File ||
    this->Source.RestoreOrder != other.Source.RestoreOrder || this->What != other.What)
  {
    return std::nullopt;
  }
  const auto& tree = this->Place.Tree ? this->Place.Tree : other.Place.Tree;
  return tree ? this->GetLayout(*tree)->FindChanges(*other.GetLayout(*tree))
              : std::vector<std::uint32_t>();
}
}
