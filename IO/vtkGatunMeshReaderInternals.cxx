// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunMeshReaderInternals.h"

#include "gatunChunkTable.h"
#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunFileConsumer.h"
#include "gatunFileReader.h"
#include "gatunOutline.h"
#include "gatunRegion.h"
#include "vtkGatunFileHandle.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{

using gatun::Association;

//------------------------------------------------------------------------------
/** The names of the arrays of a file on its points or cells, each once. */
std::vector<std::string> NamesOf(const gatun::FileReader& file, Association where)
{
  std::vector<std::string> names;
  for (const gatun::ArrayDescription& array : file.GetArrays())
  {
    if (array.Where == where && !array.Name.empty() &&
      std::find(names.begin(), names.end(), array.Name) == names.end())
    {
      names.push_back(array.Name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
/** The number of a point array, or else a cell array. */
std::uint32_t FindArray(const gatun::FileReader& file, const char* name)
{
  const auto& arrays = file.GetArrays();
  for (const Association where : { Association::Point, Association::Cell })
  {
    const auto found = std::find_if(arrays.begin(), arrays.end(),
      [&](const gatun::ArrayDescription& array)
      { return array.Where == where && array.Name == name; });
    if (found != arrays.end())
    {
      return static_cast<std::uint32_t>(found - arrays.begin());
    }
  }
  gatun::ThrowInvalid(
    "there is no array '" + std::string(name) + "' for the value range", file.GetPath());
}

/** Numbers that are none make a box that nothing touches. */
bool HasBox(const double (&box)[6])
{
  return !(box[0] > box[1] || box[2] > box[3] || box[4] > box[5]);
}

//------------------------------------------------------------------------------
/** Throws unless a file is one for the reader. */
void CheckKind(const gatun::FileReader& file, bool readsSurfaces)
{
  if (file.IsSurface() != readsSurfaces)
  {
    gatun::ThrowInvalid(file.IsSurface()
        ? "holds a surface (vtkPolyData), which vtkGatunSurfaceReader reads, not vtkGatunReader"
        : "holds a grid (vtkUnstructuredGrid), which vtkGatunReader reads, not "
          "vtkGatunSurfaceReader",
      file.GetPath());
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
/** The memory budget in bytes. */
std::uint64_t vtkGatunMeshReader::vtkInternals::GetBudget(const vtkGatunMeshReader& reader)
{
  return static_cast<std::uint64_t>(reader.MemoryBudget) << 20;
}

//------------------------------------------------------------------------------
/** Opens the file unless it is open and unchanged; a file opened anew has new caches. */
void vtkGatunMeshReader::vtkInternals::Open(const vtkGatunMeshReader& reader)
{
  const std::string path = reader.FileName;
  const gatun::FileSignature signature = gatun::SignatureOf(path);
  if (this->IsOpen(path) && signature == this->Signature)
  {
    return;
  }
  this->Close();
  this->Path = path;
  this->Signature = signature;
  auto file = std::make_shared<gatun::SharedFile>(path, GetBudget(reader));
  CheckKind(*file->GetFile(), reader.ReadsSurfaces());
  this->Series = std::move(file);
  this->File = this->Series;
  this->PointArrays.SetArrays(NamesOf(this->GetFile(), Association::Point));
  this->CellArrays.SetArrays(NamesOf(this->GetFile(), Association::Cell));
}

//------------------------------------------------------------------------------
void vtkGatunMeshReader::vtkInternals::UseMesh(vtkInformation* outInfo)
{
  const std::size_t mesh = gatun::FindRequestedMesh(*this->Series->GetFile(), outInfo);
  auto file = mesh == 0 ? this->Series : this->Series->GetMesh(mesh);
  if (file != this->File)
  {
    this->File = std::move(file);
    this->Table = nullptr;
  }
}

//------------------------------------------------------------------------------
void vtkGatunMeshReader::vtkInternals::TryMesh(vtkInformation* outInfo)
{
  try
  {
    this->UseMesh(outInfo);
  }
  catch (const gatun::Error&)
  {
    this->File = this->Series;
    this->Table = nullptr;
  }
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunMeshReader::vtkInternals::GetTable()
{
  if (!this->Table && this->File)
  {
    this->Table = gatun::MakeChunkTable(this->GetFile());
  }
  return this->Table;
}

//------------------------------------------------------------------------------
void vtkGatunMeshReader::vtkInternals::PublishTable(vtkInformation* outInfo)
{
  // A larger table is made only when it is asked for: it takes time and memory to open a file that
  // then shows a few chunks.
  constexpr std::size_t maxRows = 65536;
  outInfo->Set(vtkGatunMeshReader::CHUNK_TABLE(),
    this->GetFile().GetChunks().size() <= maxRows ? this->GetTable() : nullptr);
}

//------------------------------------------------------------------------------
gatun::SimplifyProperties vtkGatunMeshReader::vtkInternals::GetProperties(
  const vtkGatunMeshReader& reader)
{
  return { reader.SimplificationRatio, reader.SimplificationNumberOfPoints,
    reader.SimplificationRMSError };
}

//------------------------------------------------------------------------------
bool vtkGatunMeshReader::vtkInternals::HasValueRange(const vtkGatunMeshReader& reader)
{
  return reader.ValueRangeArray && *reader.ValueRangeArray;
}

//------------------------------------------------------------------------------
bool vtkGatunMeshReader::vtkInternals::HasRegion(const vtkGatunMeshReader& reader)
{
  return HasBox(reader.Box) || HasValueRange(reader);
}

//------------------------------------------------------------------------------
gatun::FileSettings vtkGatunMeshReader::vtkInternals::GetSettings(
  const vtkGatunMeshReader& reader) const
{
  gatun::FileSettings settings;
  settings.Path = this->Path;
  settings.Simplification = GetProperties(reader);
  settings.RestoreOrder = reader.RestoreOrder;
  settings.SplitCells = reader.GetSplitsCells();
  settings.GenerateGlobalIds = reader.GenerateGlobalIds;
  settings.HasRegion = HasRegion(reader);
  if (reader.LargeMesh >= 0)
  {
    settings.LargeMesh = static_cast<std::uint64_t>(reader.LargeMesh);
  }
  for (const gatun::ArrayDescription& array : this->GetFile().GetArrays())
  {
    const auto& choice = array.Where == Association::Point ? this->PointArrays : this->CellArrays;
    settings.Selected.push_back(choice.Wants(array.Name));
  }
  return settings;
}

//------------------------------------------------------------------------------
/** Publishes the file that is open with the settings of the reader. */
void vtkGatunMeshReader::vtkInternals::Publish(
  const vtkGatunMeshReader& reader, vtkInformation* outInfo) const
{
  vtkNew<vtkGatunFileHandle> handle;
  handle->SetContents(this->Series, this->GetSettings(reader));
  outInfo->Set(vtkGatunFileHandle::FILE_HANDLE(), handle);
}

//------------------------------------------------------------------------------
/** The chunks of the chosen mesh that the region of interest leaves. */
std::vector<std::uint32_t> vtkGatunMeshReader::vtkInternals::ChunksOf(
  const vtkGatunMeshReader& reader, std::size_t step) const
{
  gatun::Region region;
  if (HasBox(reader.Box))
  {
    auto& box = region.Box.emplace();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box[axis] = { reader.Box[2 * axis], reader.Box[2 * axis + 1] };
    }
  }
  if (HasValueRange(reader))
  {
    region.Interval = { FindArray(this->GetFile(), reader.ValueRangeArray), -1,
      { reader.ValueRange[0], reader.ValueRange[1] } };
  }
  return gatun::FindChunks(this->Pieces.GetMesh(), region, step, this->Pieces.GetMerges());
}

//------------------------------------------------------------------------------
/** Makes the outline; without points and cells unless it is asked for the first piece. */
void vtkGatunMeshReader::vtkInternals::MakeOutline(
  const gatun::PublishedFile& handle, const gatun::PortRequest& port, vtkUnstructuredGrid* output)
{
  this->Pieces.Choose(handle, 0);
  if (this->Pieces.HasMesh())
  {
    this->Cells = {};
    this->Pieces.ForgetMesh();
    this->Pieces.ClearCache();
  }
  const gatun::PieceRequest request = this->Pieces.MakeRequest(handle, port, {});
  gatun::MakeOutline(this->GetFile(), request.Arrays, request.Step, port.Piece != 0, output);
  gatun::AddStepFieldData(this->GetFile(), request.Step, output);
}

//------------------------------------------------------------------------------
/** The number of merges with which the boundary is shown: those of the mesh or, if the memory
 * budget is not enough for that, as many as it takes. Nothing if the boundary cannot be shown. */
std::optional<std::size_t> vtkGatunMeshReader::vtkInternals::FindBoundaryMerges(
  const gatun::PublishedFile& handle) const
{
  if (!this->GetFile().HasBoundary())
  {
    return {};
  }
  const auto& boundary = handle.File->GetBoundary()->GetFile();
  const auto points = static_cast<double>(boundary->GetNumberOfPoints());
  const auto cells = static_cast<double>(boundary->GetNumberOfCells());
  constexpr std::uint64_t bytesOfFace = 5 * sizeof(vtkIdType) + 1;
  std::uint64_t ofPoint = 3 * sizeof(double);
  std::uint64_t ofCell = bytesOfFace;
  for (std::size_t i = 0; i < boundary->GetArrays().size(); ++i)
  {
    const gatun::ArrayDescription& array = boundary->GetArrays()[i];
    auto& sum = array.Where == gatun::Association::Point ? ofPoint : ofCell;
    sum += handle.Selected[i] ? array.Components * SizeOf(array.Type) : 0;
  }
  const double bytes = points * static_cast<double>(ofPoint) + cells * static_cast<double>(ofCell);
  const auto room = static_cast<double>(this->File->GetBudget()->GetBytes());
  std::size_t merges = 0;
  if (handle.Merges > 0 && boundary->HasMergeTree())
  {
    const double error = handle.File->GetTree().GetLargestError(handle.Merges);
    merges = handle.File->GetBoundary()->GetTree().CountMergesForError(error);
  }
  if (bytes > room)
  {
    // Cells become fewer in proportion to points.
    const auto most = static_cast<std::size_t>(std::ceil(points * (1 - room / bytes)));
    merges = std::max(merges, most);
  }
  if (merges > boundary->GetNumberOfMerges())
  {
    return {};
  }
  return merges;
}

//------------------------------------------------------------------------------
void vtkGatunMeshReader::vtkInternals::ReadBoundary(const gatun::PublishedFile& handle,
  std::size_t merges, const gatun::PortRequest& port, vtkUnstructuredGrid* output,
  const gatun::PieceReader::Progress& progress)
{
  this->Pieces.ChooseBoundary(handle, merges);
  const gatun::PieceRequest request = this->Pieces.MakeBoundaryRequest(handle, port);
  this->Pieces.Read(handle, request, false, output, progress);
  gatun::AddOutlinePoints(this->GetFile(), request.Arrays, request.Step, output);
}

//------------------------------------------------------------------------------
/** Makes a surface of what was read. Time steps share its cells. */
void vtkGatunMeshReader::vtkInternals::MakeSurface(vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  if (!this->Cells.Source || this->Cells.Source != grid->GetCells())
  {
    this->Cells = gatun::FindSurfaceCells(grid);
  }
  gatun::MakeSurface(grid, this->Cells, output);
}
