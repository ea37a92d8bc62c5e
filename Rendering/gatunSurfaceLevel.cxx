// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceLevel.h"

#include "gatunChangedChunks.h"
#include "gatunFileReader.h"
#include "gatunSurfaceGrid.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
SurfaceLevel::SurfaceLevel(PublishedFile source, std::size_t merges, SurfaceContents what)
  : Source(std::move(source))
  , Merges(merges)
  , What(std::move(what))
  , Place{ this->Source.File->GetFile(), nullptr, 0 }
{
  // The same mesh as a reader chooses.
  PieceReader reader;
  reader.Choose(this->Source, merges, false);
  if (merges > 0)
  {
    const bool hasBaseMeshes = &reader.GetMesh() != this->Source.File->GetFile().get();
    this->Place = this->Source.File->Find(merges, hasBaseMeshes);
    const auto points = static_cast<double>(this->Place.File->GetNumberOfPoints());
    this->Left = points > 0 ? 1 - static_cast<double>(this->Place.Merges) / points : 1;
  }
  const auto chunks = this->GetNumberOfChunks();
  this->Boxes.reserve(chunks);
  for (std::size_t chunk = 0; chunk < chunks; ++chunk)
  {
    this->Boxes.push_back(
      this->Place.File->GetChunkBounds(chunk, this->Place.Merges, this->What.Step));
  }
}

SurfaceLevel::~SurfaceLevel() = default;

//------------------------------------------------------------------------------
std::size_t SurfaceLevel::GetNumberOfChunks() const
{
  return this->Place.File->GetChunks().size();
}

//------------------------------------------------------------------------------
std::uint64_t SurfaceLevel::GetNumberOfCells(std::size_t chunk) const
{
  // Cells and points decrease in proportion.
  return static_cast<std::uint64_t>(
    this->Left * static_cast<double>(this->Place.File->GetChunks()[chunk].Cells));
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
  // Buffers take the place of decoded chunks. After merges, a chunk needs points of others.
  reader->Choose(this->Source, this->Merges, this->Place.Merges > 0);
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
  if (!tree)
  {
    return std::vector<std::uint32_t>();
  }
  this->Changes = other.Changes;
  if (!this->Changes || this->Changes->GetTree() != tree)
  {
    this->Changes = std::make_shared<const MergeChanges>(tree);
  }
  return FindChangedChunks(
    *this->Place.File, *this->Changes, other.Place.Merges, this->Place.Merges);
}
}
