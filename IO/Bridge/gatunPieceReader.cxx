// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPieceReader.h"

#include "gatunArrayBridge.h"
#include "gatunFileConsumer.h"
#include "gatunFileReader.h"
#include "gatunNewArray.h"
#include "gatunParallel.h"
#include "gatunRegion.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace gatun
{
namespace
{
//------------------------------------------------------------------------------
/** Sets the size of a new array. */
template <typename ArrayT>
auto* MakeRoom(ArrayT* array, vtkIdType values)
{
  SizeArray(array, values);
  return array->GetPointer(0);
}

//------------------------------------------------------------------------------
// Offsets 0, 4, 8, ... of tetrahedra.
template <typename ArrayT>
vtkSmartPointer<ArrayT> MakeOffsets(vtkIdType tets)
{
  using ValueT = typename ArrayT::ValueType;
  auto offsets = vtkSmartPointer<ArrayT>::New();
  ValueT* const values = MakeRoom(offsets.Get(), tets + 1);
  constexpr vtkIdType block = 1 << 20;
  ParallelFor(static_cast<std::size_t>(tets / block + 1),
    [values, tets](std::size_t part)
    {
      const auto begin = static_cast<vtkIdType>(part) * block;
      const vtkIdType end = std::min(begin + block, tets + 1);
      for (vtkIdType i = begin; i < end; ++i)
      {
        values[i] = static_cast<ValueT>(4 * i);
      }
    });
  return offsets;
}

//------------------------------------------------------------------------------
// Makes room for the cells of a piece. The offsets of tetrahedra are known.
template <typename ArrayT>
vtkSmartPointer<vtkCellArray> MakeCells(const PieceDecoder& decoder, PieceTarget& target)
{
  const auto count = static_cast<vtkIdType>(decoder.GetNumberOfCells());
  vtkNew<ArrayT> connectivity;
  target.Connectivity =
    MakeRoom(connectivity.Get(), static_cast<vtkIdType>(decoder.GetConnectivitySize()));
  vtkSmartPointer<ArrayT> offsets;
  if (decoder.IsTetrahedral())
  {
    offsets = MakeOffsets<ArrayT>(count);
  }
  else
  {
    offsets = vtkSmartPointer<ArrayT>::New();
    target.Offsets = MakeRoom(offsets.Get(), count + 1);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkIdTypeArray> MakeIds(const char* name, vtkIdType values)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name);
  SizeArray(ids, values);
  return ids;
}

//------------------------------------------------------------------------------
/** Ids that nobody asked for stay out of the lists of arrays in ParaView. */
void AddIds(vtkDataSetAttributes* attributes, vtkIdTypeArray* ids, bool isAskedFor)
{
  vtkInformation* const info = ids->GetInformation();
  if (isAskedFor)
  {
    info->Remove(vtkAbstractArray::GUI_HIDE());
  }
  else
  {
    info->Set(vtkAbstractArray::GUI_HIDE(), 1);
  }
  attributes->SetGlobalIds(ids);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnsignedCharArray> MakeGhostArray(vtkIdType values)
{
  auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  SizeArray(ghosts, values);
  return ghosts;
}

//------------------------------------------------------------------------------
std::int64_t* PointerTo(vtkIdTypeArray* ids)
{
  return reinterpret_cast<std::int64_t*>(ids->GetPointer(0));
}

//------------------------------------------------------------------------------
// Makes room for the types and faces of original cells.
PieceReader::OriginalCells MakeOriginalCells(const PieceDecoder& decoder, PieceTarget& target)
{
  const auto count = static_cast<vtkIdType>(decoder.GetNumberOfCells());
  PieceReader::OriginalCells cells;
  cells.Types = vtkSmartPointer<vtkUnsignedCharArray>::New();
  SizeArray(cells.Types, count);
  target.Types = cells.Types->GetPointer(0);
  if (decoder.GetFacesSize() > 0)
  {
    cells.Faces.Locations = vtkSmartPointer<vtkIdTypeArray>::New();
    SizeArray(cells.Faces.Locations, count);
    target.FaceLocations = PointerTo(cells.Faces.Locations);
    cells.Faces.Values = vtkSmartPointer<vtkIdTypeArray>::New();
    SizeArray(cells.Faces.Values, static_cast<vtkIdType>(decoder.GetFacesSize()));
    target.Faces = PointerTo(cells.Faces.Values);
  }
  return cells;
}

//------------------------------------------------------------------------------
// Adds ghost flags; those that the file holds (of hidden points, say) stay.
void AddGhosts(vtkDataSetAttributes* attributes, vtkUnsignedCharArray* ghosts)
{
  if (!ghosts)
  {
    return;
  }
  auto* stored = vtkArrayDownCast<vtkUnsignedCharArray>(attributes->GetArray(ghosts->GetName()));
  if (!stored || stored->GetNumberOfValues() != ghosts->GetNumberOfValues())
  {
    attributes->AddArray(ghosts);
    return;
  }
  for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
  {
    stored->SetValue(i, static_cast<unsigned char>(stored->GetValue(i) | ghosts->GetValue(i)));
  }
}

//------------------------------------------------------------------------------
vtkDataSetAttributes* AttributesOf(vtkUnstructuredGrid* grid, Association where)
{
  if (where == Association::Point)
  {
    return grid->GetPointData();
  }
  return grid->GetCellData();
}

//------------------------------------------------------------------------------
// Whether a request is for all chunks of a file, without merges.
bool IsWhole(const FileReader& file, const PieceRequest& request)
{
  return request.Chunks.size() == file.GetChunks().size() && request.Merges == 0;
}

//------------------------------------------------------------------------------
// Whether an array of the request is, or is named like, global ids.
bool HasGlobalIds(const FileReader& file, const PieceRequest& request, Association where)
{
  const char* name = where == Association::Point ? "GlobalPointIds" : "GlobalCellIds";
  return std::any_of(request.Arrays.begin(), request.Arrays.end(),
    [&](std::uint32_t index)
    {
      const ArrayDescription& array = file.GetArrays()[index];
      return array.Where == where &&
        (array.Name == name || (array.AttributeRoles >> vtkDataSetAttributes::GLOBALIDS & 1u) != 0);
    });
}
}

//------------------------------------------------------------------------------
PortRequest::PortRequest(const FileReader& file, vtkInformation* outInfo)
  : Piece(vtkStreamingDemandDrivenPipeline::GetUpdatePiece(outInfo))
  , Pieces(std::max(1, vtkStreamingDemandDrivenPipeline::GetUpdateNumberOfPieces(outInfo)))
  , Step(GetRequestedStep(file, outInfo))
{
  if (this->Pieces > 1)
  {
    this->GhostLevels = static_cast<unsigned>(
      std::max(0, vtkStreamingDemandDrivenPipeline::GetUpdateGhostLevel(outInfo)));
  }
}

//------------------------------------------------------------------------------
void AddStepFieldData(const FileReader& file, std::size_t step, vtkUnstructuredGrid* output)
{
  if (step < file.GetNumberOfSteps())
  {
    AddFieldData(output->GetFieldData(), file.GetFieldData(step));
  }
}

//------------------------------------------------------------------------------
void SetStepTime(const FileReader& file, std::size_t step, vtkDataObject* output)
{
  if (file.HasTime() && step < file.GetTimes().size())
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), file.GetTimes()[step]);
  }
}

//------------------------------------------------------------------------------
PieceReader::PieceReader() = default;
PieceReader::~PieceReader() = default;

//------------------------------------------------------------------------------
SharedFile::Place PieceReader::FindPlace(const PublishedFile& handle, std::size_t merges)
{
  const auto& file = handle.File->GetFile();
  // Base meshes have no original order.
  const bool keepsOrder = handle.RestoreOrder && file->GetKeptOrder() != KeepNone;
  return handle.File->Find(merges, !keepsOrder);
}

//------------------------------------------------------------------------------
void PieceReader::Choose(const PublishedFile& handle, const SharedFile::Place& place,
  std::shared_ptr<const CoarseLayout> layout, bool keepsChunks)
{
  this->SetMesh(handle, place.File, keepsChunks);
  this->Tree = place.Tree;
  this->Merges = place.Merges;
  this->Layout = std::move(layout);
}

//------------------------------------------------------------------------------
void PieceReader::ChooseBoundary(const PublishedFile& handle, std::size_t merges)
{
  this->Choose(handle, handle.File->GetBoundary()->Find(merges), nullptr, true);
}

//------------------------------------------------------------------------------
void PieceReader::SetMesh(
  const PublishedFile& handle, const std::shared_ptr<const FileReader>& mesh, bool keepsChunks)
{
  if (!this->Parts || mesh != this->Parts->GetFile())
  {
    this->DecodedBefore = this->GetDecodedChunks();
    this->ForgetMesh();
    this->Decoder.reset();
    this->Parts = handle.File->MakeView(mesh, keepsChunks);
  }
  this->KeepsChunks = keepsChunks;
}

//------------------------------------------------------------------------------
PieceRequest PieceReader::MakeRequest(const PublishedFile& handle, const PortRequest& port,
  const std::vector<std::uint32_t>& chunks) const
{
  const FileReader& file = *handle.File->GetFile();
  PieceRequest request;
  request.Step = port.Step;
  request.Merges = this->Merges;
  request.Tree = this->Tree;
  request.Cut = this->Layout;
  request.RestoreOrder = handle.RestoreOrder;
  request.Form = handle.SplitCells ? PieceForm::Tetrahedra : PieceForm::Original;
  const bool exists = port.Piece >= 0 && port.Piece < port.Pieces;
  if (exists)
  {
    request.Chunks =
      GetPiece(chunks, static_cast<std::size_t>(port.Piece), static_cast<std::size_t>(port.Pieces));
  }
  // Without steps, arrays have no values.
  for (std::uint32_t i = 0; i < file.GetArrays().size() && file.GetNumberOfSteps() > 0; ++i)
  {
    if (handle.Selected[i])
    {
      request.Arrays.push_back(i);
    }
  }
  request.GhostLevels = port.GhostLevels;
  const bool isWhole = chunks.size() == this->GetMesh().GetChunks().size();
  if (request.GhostLevels > 0 && !isWhole)
  {
    request.Universe = chunks;
  }
  request.WithUnusedPoints = exists && port.Piece == 0;
  return request;
}

//------------------------------------------------------------------------------
PieceRequest PieceReader::MakeBoundaryRequest(
  const PublishedFile& handle, const PortRequest& port) const
{
  std::vector<std::uint32_t> chunks(this->GetMesh().GetChunks().size());
  std::iota(chunks.begin(), chunks.end(), 0u);
  PieceRequest request = this->MakeRequest(handle, port, chunks);
  request.Form = PieceForm::Original;
  return request;
}

//------------------------------------------------------------------------------
void PieceReader::ForgetMesh()
{
  if (this->Decoder)
  {
    this->Decoder->Forget();
  }
  this->Mesh = nullptr;
  this->PointStep.reset();
  this->Cells = nullptr;
  this->Original = {};
  this->PointIds = nullptr;
  this->CellIds = nullptr;
  this->PointGhosts = nullptr;
  this->CellGhosts = nullptr;
}

//------------------------------------------------------------------------------
void PieceReader::ClearCache()
{
  if (this->Parts)
  {
    this->Parts->Clear();
  }
}

//------------------------------------------------------------------------------
void PieceReader::Close()
{
  this->ForgetMesh();
  this->Decoder.reset();
  this->Parts.reset();
  this->Tree.reset();
  this->Layout.reset();
  this->Merges = 0;
  this->DecodedBefore = 0;
}

//------------------------------------------------------------------------------
std::uint64_t PieceReader::GetDecodedChunks() const
{
  return this->DecodedBefore + (this->Parts ? this->Parts->GetStatistics().MeshesDecoded : 0);
}

//------------------------------------------------------------------------------
bool PieceReader::HasMeshOf(const PieceRequest& request) const
{
  PieceRequest mesh = request;
  mesh.Arrays = this->MeshRequest.Arrays;
  mesh.Step = this->MeshRequest.Step;
  return this->Mesh && mesh == this->MeshRequest;
}

//------------------------------------------------------------------------------
/** Makes room for the points of the request that the decoder has. */
vtkSmartPointer<vtkPoints> PieceReader::MakePoints(
  const FileReader& file, PieceTarget& target) const
{
  const auto points = static_cast<vtkIdType>(this->Decoder->GetNumberOfPoints());
  auto coordinates = vtkSmartPointer<vtkPoints>::New();
  coordinates->SetDataType(
    file.GetCoordinateType() == ScalarType::Float64 ? VTK_DOUBLE : VTK_FLOAT);
  SizePoints(coordinates, points);
  SetDescription(coordinates->GetData(), file.GetPointArray());
  target.Points = coordinates->GetData()->GetVoidPointer(0);
  return coordinates;
}

//------------------------------------------------------------------------------
/** Makes a mesh with room for the cells of the request that the decoder has. */
void PieceReader::MakeMesh(const FileReader& file, PieceTarget& target)
{
  const auto points = static_cast<vtkIdType>(this->Decoder->GetNumberOfPoints());
  const auto ids = static_cast<vtkIdType>(this->Decoder->GetConnectivitySize());
  target.WideIds =
    file.HasWideIds() || std::max(ids, points) >= std::numeric_limits<vtkTypeInt32>::max();
  this->Cells = target.WideIds ? MakeCells<vtkTypeInt64Array>(*this->Decoder, target)
                               : MakeCells<vtkTypeInt32Array>(*this->Decoder, target);
  this->Original = {};
  if (!this->Decoder->IsTetrahedral())
  {
    this->Original = MakeOriginalCells(*this->Decoder, target);
  }
  this->Mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
}

//------------------------------------------------------------------------------
/** Gives the mesh its cells. They are complete now, as the grid may read them. */
void PieceReader::FinishMesh()
{
  if (this->Original.Types)
  {
    SetCells(this->Mesh, this->Original.Types, this->Cells, this->Original.Faces);
  }
  else
  {
    this->Mesh->SetCells(VTK_TETRA, this->Cells);
  }
  this->Cells = nullptr;
  this->Original = {};
}

//------------------------------------------------------------------------------
void PieceReader::MakeGhosts(PieceTarget& target)
{
  this->PointGhosts = MakeGhostArray(static_cast<vtkIdType>(this->Decoder->GetNumberOfPoints()));
  this->CellGhosts = MakeGhostArray(static_cast<vtkIdType>(this->Decoder->GetNumberOfCells()));
  target.PointGhosts = this->PointGhosts->GetPointer(0);
  target.CellGhosts = this->CellGhosts->GetPointer(0);
}

//------------------------------------------------------------------------------
void PieceReader::Read(const PublishedFile& handle, const PieceRequest& request, bool globalIds,
  vtkUnstructuredGrid* output, const Progress& progress)
{
  const FileReader& file = *handle.File->GetFile();
  const bool meshIsThere = this->HasMeshOf(request);
  if (!meshIsThere)
  {
    this->ForgetMesh();
  }
  if (!this->Decoder)
  {
    this->Decoder = std::make_unique<PieceDecoder>(this->Parts);
  }
  // The cache would only take memory if the mesh is read once. With steps, or after a change of
  // arrays, it is likely to be needed again.
  this->Parts->SetKeepsChunks(this->KeepsChunks &&
    (meshIsThere || !IsWhole(this->GetMesh(), request) || file.GetNumberOfSteps() > 1));
  const double share = request.GhostLevels > 0 && !meshIsThere ? 0.5 : 0.0;
  this->Decoder->SetRequest(
    request, [&progress, share](double fraction) { return progress(share * fraction); });
  const auto points = static_cast<vtkIdType>(this->Decoder->GetNumberOfPoints());
  const auto cells = static_cast<vtkIdType>(this->Decoder->GetNumberOfCells());

  PieceTarget target;
  if (!meshIsThere)
  {
    this->MakeMesh(file, target);
    this->MeshRequest = request;
    if (request.GhostLevels > 0)
    {
      this->MakeGhosts(target);
    }
  }
  // Outputs of other steps keep their points and share the cells.
  const std::size_t pointStep = this->GetMesh().GetPointStep(request.Step);
  vtkSmartPointer<vtkPoints> coordinates;
  if (this->PointStep != pointStep)
  {
    coordinates = this->MakePoints(file, target);
  }
  const bool pointIds = globalIds && !HasGlobalIds(file, request, Association::Point);
  const bool cellIds = globalIds && !HasGlobalIds(file, request, Association::Cell);
  if (pointIds && !this->PointIds)
  {
    this->PointIds = MakeIds("GlobalPointIds", points);
    target.GlobalPointIds = PointerTo(this->PointIds);
  }
  if (cellIds && !this->CellIds)
  {
    this->CellIds = MakeIds("GlobalCellIds", cells);
    target.GlobalCellIds = PointerTo(this->CellIds);
  }
  std::vector<ArrayFiller> fillers;
  for (const std::uint32_t array : request.Arrays)
  {
    const ArrayDescription& description = file.GetArrays()[array];
    fillers.emplace_back(description, description.Where == Association::Point ? points : cells);
    target.Arrays.push_back(fillers.back().GetBuffer());
  }
  this->Decoder->Fill(target,
    [&progress, share](double fraction) { return progress(share + (1 - share) * fraction); });
  if (!meshIsThere)
  {
    this->FinishMesh();
  }
  if (coordinates)
  {
    this->Mesh->SetPoints(coordinates);
    this->PointStep = pointStep;
  }

  output->CopyStructure(this->Mesh);
  for (std::size_t i = 0; i < fillers.size(); ++i)
  {
    const ArrayDescription& description = file.GetArrays()[request.Arrays[i]];
    AddWithRoles(
      AttributesOf(output, description.Where), fillers[i].Finish(), description.AttributeRoles);
  }
  if (pointIds)
  {
    AddIds(output->GetPointData(), this->PointIds, handle.GenerateGlobalIds);
  }
  if (cellIds)
  {
    AddIds(output->GetCellData(), this->CellIds, handle.GenerateGlobalIds);
  }
  AddGhosts(output->GetPointData(), this->PointGhosts);
  AddGhosts(output->GetCellData(), this->CellGhosts);
  AddStepFieldData(file, request.Step, output);
}
}
