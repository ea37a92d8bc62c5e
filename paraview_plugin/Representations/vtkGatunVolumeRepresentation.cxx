// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunVolumeRepresentation.h"

#include "gatunFilePiece.h"
#include "gatunMeshPiece.h"
#include "gatunPieceSource.h"
#include "gatunVolumeProp.h"
#include "vtkGatunDetailPolicy.h"
#include "vtkGatunFileHandle.h"
#include "vtkGatunReader.h"
#include "vtkGatunVolumeMapper.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOrderedCompositingHelper.h"
#include "vtkOutlineSource.h"
#include "vtkPVGeometryFilter.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumeRepresentationPreprocessor.h"

#include <algorithm>
#include <cmath>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunVolumeRepresentation);

namespace
{
//------------------------------------------------------------------------------
vtkDataObject* GetData(vtkAlgorithmOutput* producer)
{
  return producer ? producer->GetProducer()->GetOutputDataObject(producer->GetIndex()) : nullptr;
}

//------------------------------------------------------------------------------
/** Whether the piece of any process has a volume to draw. Collective. */
bool AnyHasVolume(vtkUnstructuredGrid* piece, const gatun::DrawnFile& file)
{
  const int own = piece && (!file.Path.empty() || gatun::HasVolume(piece)) ? 1 : 0;
  int any = own;
  if (auto* const controller = vtkMultiProcessController::GetGlobalController())
  {
    controller->AllReduce(&own, &any, 1, vtkCommunicator::MAX_OP);
  }
  return any != 0;
}

//------------------------------------------------------------------------------
/** Marks a piece that stands for a file with the number of cells that do so in all processes.
 * Collective. */
void MarkCells(vtkUnstructuredGrid* piece, gatun::DrawnFile file, vtkIdType own)
{
  vtkIdType all = own;
  if (auto* const controller = vtkMultiProcessController::GetGlobalController())
  {
    controller->AllReduce(&own, &all, 1, vtkCommunicator::SUM_OP);
  }
  if (!file.Path.empty())
  {
    file.Cells = all;
    gatun::MarkPiece(piece, file);
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
vtkGatunVolumeRepresentation::vtkGatunVolumeRepresentation()
  : DetailPolicy(vtkSmartPointer<vtkGatunDetailPolicy>::New())
  , File(std::make_unique<gatun::PieceSource>(vtkSmartPointer<vtkGatunReader>::New()))
  , Piece(vtkSmartPointer<vtkUnstructuredGrid>::New())
{
  this->Actor = gatun::MakeVolumeProp();
  this->Actor->SetProperty(this->Property);
  this->Actor->SetLODMapper(this->LODMapper);
  this->Superclass::AddVolumeMapper("Gatun", this->VolumeMapper);
  this->Superclass::SetActiveVolumeMapper("Gatun");
}

vtkGatunVolumeRepresentation::~vtkGatunVolumeRepresentation() = default;

//------------------------------------------------------------------------------
void vtkGatunVolumeRepresentation::SetBlendMode(int mode)
{
  this->VolumeMapper->SetBlendMode(mode);
}

//------------------------------------------------------------------------------
int vtkGatunVolumeRepresentation::GetBlendMode()
{
  return this->VolumeMapper->GetBlendMode();
}

//------------------------------------------------------------------------------
void vtkGatunVolumeRepresentation::SetMemoryBudget(int mebibytes)
{
  this->VolumeMapper->SetMemoryBudget(mebibytes);
  this->File->GetReader()->SetMemoryBudget(mebibytes);
}

//------------------------------------------------------------------------------
int vtkGatunVolumeRepresentation::GetMemoryBudget()
{
  return this->VolumeMapper->GetMemoryBudget();
}

//------------------------------------------------------------------------------
void vtkGatunVolumeRepresentation::SetAutoAdjustSampleDistances(bool on)
{
  this->VolumeMapper->SetAutoAdjustSampleDistances(on);
  if (!on)
  {
    // The one last chosen may be that of an interaction.
    this->VolumeMapper->SetImageSampleDistance(1);
  }
}

//------------------------------------------------------------------------------
bool vtkGatunVolumeRepresentation::GetAutoAdjustSampleDistances()
{
  return this->VolumeMapper->GetAutoAdjustSampleDistances();
}

//------------------------------------------------------------------------------
void vtkGatunVolumeRepresentation::SetDetailPolicy(vtkGatunDetailPolicy* policy)
{
  this->DetailPolicy = policy;
  if (!policy)
  {
    this->DetailPolicy = vtkSmartPointer<vtkGatunDetailPolicy>::New();
  }
}

//------------------------------------------------------------------------------
vtkGatunDetailPolicy* vtkGatunVolumeRepresentation::GetDetailPolicy()
{
  return this->DetailPolicy;
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunVolumeRepresentation::GetStatistic(const char* name)
{
  return this->VolumeMapper->GetStatistics()->GetValueByName(0, name).ToTypeInt64();
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunVolumeRepresentation::GetDrawnPoints()
{
  return this->GetStatistic("DrawnPoints");
}

//------------------------------------------------------------------------------
void vtkGatunVolumeRepresentation::SetScalarOpacityUnitDistance(double distance)
{
  this->UnitDistance = distance;
}

//------------------------------------------------------------------------------
void vtkGatunVolumeRepresentation::SetActiveVolumeMapper(const char*) {}

//------------------------------------------------------------------------------
vtkIdType vtkGatunVolumeRepresentation::GetBytesRead()
{
  return this->Drawn ? this->GetStatistic("BytesRead") : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunVolumeRepresentation::GetBytesSent()
{
  return this->GetStatistic("BytesSent");
}

//------------------------------------------------------------------------------
int vtkGatunVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->MakePiece(inputVector[0]->GetNumberOfInformationObjects() == 1
      ? vtkDataObject::GetData(inputVector[0], 0)
      : nullptr);
  // Not that of the superclass, which would copy the mesh.
  return this->vtkVolumeRepresentation::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeRepresentation::MakePiece(vtkDataObject* input)
{
  vtkMath::UninitializeBounds(this->DataBounds);
  this->Piece = vtkSmartPointer<vtkUnstructuredGrid>::New();
  this->OwnCells = 0;
  if (!input)
  {
    return; // a process without data
  }
  if (vtkGatunFileHandle* const handle = this->File->FindFile(this))
  {
    this->Piece->ShallowCopy(input);
    const gatun::DrawnFile file = gatun::DescribeFile(handle, input);
    gatun::MarkPiece(this->Piece, file);
    this->OwnCells = file.Cells;
    // All processes need to know the bounds, and only the first one has the outline.
    handle->GetBounds(this->DataBounds);
    return;
  }
  if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(input))
  {
    this->Piece = gatun::MakeMeshPiece(grid);
  }
  else
  {
    // Blocks are joined, and other kinds of grids made into one.
    this->Preprocessor->SetInputConnection(this->GetInternalOutputPort());
    this->Preprocessor->Modified();
    this->Preprocessor->Update();
    if (auto* const made =
          vtkUnstructuredGrid::SafeDownCast(this->Preprocessor->GetOutputDataObject(0)))
    {
      this->Piece = gatun::MakeMeshPiece(made);
    }
  }
  gatun::UnmarkPiece(this->Piece);
  this->Piece->GetBounds(this->DataBounds);
}

//------------------------------------------------------------------------------
int vtkGatunVolumeRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  // Not that of the superclass, which would deliver what its preprocessor made.
  if (!this->vtkVolumeRepresentation::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->DeliverPiece(inInfo, outInfo);
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    this->DeliverOutline(inInfo);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->PrepareToDraw(inInfo);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkGatunVolumeRepresentation::DeliverPiece(vtkInformation* inInfo, vtkInformation* outInfo)
{
  // All processes draw each image together, also those that have nothing in view. Cells stay where
  // they are, so that no order of processes is needed. Surfaces in place of volumes need it, as
  // they are drawn translucent.
  const gatun::DrawnFile file = this->File->GetMark(this->Piece);
  const bool hasVolume = AnyHasVolume(this->Piece, file);
  MarkCells(this->Piece, file, this->OwnCells);
  outInfo->Set(hasVolume ? vtkPVRenderView::RENDER_EMPTY_IMAGES()
                         : vtkPVRenderView::NEED_ORDERED_COMPOSITING(),
    1);
  const int redistributes =
    vtkPVRenderView::DATA_IS_REDISTRIBUTABLE | vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING;
  vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
  vtkPVRenderView::SetPiece(inInfo, this, this->Piece);
  vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this, hasVolume ? 0 : redistributes);
  vtkPVRenderView::SetRedistributionModeToUniquelyAssignBoundaryCells(inInfo, this);
  vtkNew<vtkMatrix4x4> matrix;
  this->Actor->GetMatrix(matrix);
  vtkPVRenderView::SetGeometryBounds(inInfo, this, this->DataBounds, matrix);
  // The view asks the actor for bounds, too, which would be those of what was drawn before.
  this->Actor->SetMapper(nullptr);
}

//------------------------------------------------------------------------------
/** For processes that have nothing else while somebody interacts. */
void vtkGatunVolumeRepresentation::DeliverOutline(vtkInformation* inInfo)
{
  this->OutlineSource->SetBounds(this->DataBounds);
  this->OutlineSource->Update();
  vtkPVRenderView::SetPieceLOD(inInfo, this, this->OutlineSource->GetOutputDataObject(0));
  vtkPVRenderView::SetRequiresDistributedRenderingLOD(inInfo, this, true);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeRepresentation::PrepareToDraw(vtkInformation* inInfo)
{
  vtkAlgorithmOutput* const producer = vtkPVRenderView::GetPieceProducer(inInfo, this);
  auto* const piece = vtkUnstructuredGrid::SafeDownCast(GetData(producer));
  this->Drawn = nullptr;
  this->Shown = piece;
  this->Actor->SetEnableLOD(0);
  if (auto* const view = vtkPVRenderView::SafeDownCast(this->GetView()))
  {
    // An image cannot be peeled. Processes with and without translucent geometry would draw it a
    // different number of times.
    view->GetRenderer()->UseDepthPeelingForVolumesOff();
  }
  this->VolumeMapper->SetController(this->FindController(inInfo, piece));
  const bool isParallel = this->VolumeMapper->GetController() != nullptr;
  this->VolumeMapper->SetImageProcess(isParallel ? this->FindImageProcess() : -1);
  this->VolumeMapper->GetDetailPolicy()->DeepCopy(this->DetailPolicy);
  if (!piece && isParallel)
  {
    vtkNew<vtkUnstructuredGrid> none;
    this->VolumeMapper->SetInputData(none);
  }
  else if (!piece)
  {
    this->Actor->SetMapper(nullptr);
    vtkAlgorithmOutput* const outline = vtkPVRenderView::GetPieceProducerLOD(inInfo, this);
    if (inInfo->Has(vtkPVRenderView::USE_LOD()) && GetData(outline))
    {
      this->LODMapper->SetScalarVisibility(0);
      this->LODMapper->SetInputConnection(outline);
      this->Actor->SetEnableLOD(1);
    }
    return;
  }
  else if (const gatun::DrawnFile file = this->File->GetMark(piece); !file.Path.empty())
  {
    this->CellsInPlace = file.Cells;
    if (!this->ConnectFile(piece, file))
    {
      this->Drawn = nullptr;
      if (!isParallel)
      {
        this->Actor->SetMapper(nullptr);
        return;
      }
      // The others wait for this process, whose mapper tells them the error.
      this->File->GetReader()->SetFileName(file.Path.c_str());
      this->VolumeMapper->SetInputConnection(this->File->GetReader()->GetOutputPort());
    }
  }
  else
  {
    this->VolumeMapper->SetInputConnection(producer);
    if (!isParallel && piece->GetNumberOfCells() > 0 && !gatun::HasVolume(piece))
    {
      this->LODGeometryFilter->SetUseOutline(0);
      this->LODGeometryFilter->SetInputConnection(producer);
      this->LODMapper->SetInputConnection(this->LODGeometryFilter->GetOutputPort());
      this->Actor->SetEnableLOD(1);
    }
  }
  // The mapper would warn of a file without a hierarchy, and by default, nobody has asked for one.
  if (this->Drawn && !this->Drawn->GetHasHierarchy())
  {
    this->VolumeMapper->GetDetailPolicy()->JustInTimeOff();
  }
  this->UpdateMapperParameters();
  this->VolumeMapper->ReduceBounds();
}

//------------------------------------------------------------------------------
/** The controller of the processes that draw the next image together, if there is more than one and
 * any of them has a volume. */
vtkMultiProcessController* vtkGatunVolumeRepresentation::FindController(
  vtkInformation* inInfo, vtkUnstructuredGrid* piece)
{
  auto* const controller = vtkMultiProcessController::GetGlobalController();
  auto* const view = vtkPVRenderView::SafeDownCast(this->GetView());
  if (!controller || controller->GetNumberOfProcesses() == 1 || !view)
  {
    return nullptr;
  }
  const bool isDistributed = inInfo->Has(vtkPVRenderView::USE_LOD())
    ? view->GetUseDistributedRenderingForLODRender()
    : view->GetUseDistributedRenderingForRender();
  if (!isDistributed)
  {
    return nullptr; // the first process draws alone
  }
  return AnyHasVolume(piece, this->File->GetMark(piece)) ? controller : nullptr;
}

//------------------------------------------------------------------------------
/** The process that draws the image of all: the frontmost one, if their images are blended. */
int vtkGatunVolumeRepresentation::FindImageProcess()
{
  auto* const view = vtkPVRenderView::SafeDownCast(this->GetView());
  auto* const delivery =
    vtkPVRenderViewDataDeliveryManager::SafeDownCast(view->GetDeliveryManager());
  if (!view->GetUseOrderedCompositing() || !delivery || delivery->GetCuts().empty())
  {
    return -1;
  }
  vtkNew<vtkOrderedCompositingHelper> order;
  order->SetBoundingBoxes(delivery->GetCuts());
  return order->ComputeSortOrder(view->GetActiveCamera()).front();
}

//------------------------------------------------------------------------------
/** Connects the mapper to a file, by its handle if this process has read the piece. */
bool vtkGatunVolumeRepresentation::ConnectFile(
  vtkUnstructuredGrid* piece, const gatun::DrawnFile& file)
{
  vtkAlgorithm* const source = this->File->Connect(this, piece, file);
  if (!source)
  {
    return false;
  }
  this->Drawn = gatun::GetHandle(source);
  this->Shown = vtkDataSet::SafeDownCast(source->GetOutputDataObject(0));
  this->VolumeMapper->SetInputConnection(source->GetOutputPort());
  return this->Drawn != nullptr;
}

//------------------------------------------------------------------------------
double vtkGatunVolumeRepresentation::ChooseUnitDistance()
{
  if (!this->Drawn)
  {
    return this->UnitDistance;
  }
  // As ParaView does, by default: the diagonal by the cells along an edge of a cube.
  double bounds[6];
  this->Drawn->GetBounds(bounds);
  const double diagonal = vtkBoundingBox(bounds).GetDiagonalLength();
  const double inPlace = diagonal / std::cbrt(static_cast<double>(this->CellsInPlace));
  if (!(std::abs(this->UnitDistance - inPlace) <= 1e-6 * inPlace))
  {
    return this->UnitDistance; // chosen by the user
  }
  const vtkIdType tets = this->Drawn->GetNumberOfTetrahedra();
  return tets > 0 ? diagonal / std::cbrt(static_cast<double>(tets)) : this->UnitDistance;
}

//------------------------------------------------------------------------------
void vtkGatunVolumeRepresentation::UpdateMapperParameters()
{
  const char* name = nullptr;
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkInformation* const info = this->GetInputArrayInformation(0);
  if (info && info->Has(vtkDataObject::FIELD_ASSOCIATION()) &&
    info->Has(vtkDataObject::FIELD_NAME()))
  {
    name = info->Get(vtkDataObject::FIELD_NAME());
    association = info->Get(vtkDataObject::FIELD_ASSOCIATION());
  }
  const bool ofCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  const int mode =
    ofCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA;
  this->VolumeMapper->SelectScalarArray(name);
  this->VolumeMapper->SetScalarMode(mode);
  this->LODMapper->SetScalarVisibility(name && *name);
  this->LODMapper->SelectColorArray(name);
  this->LODMapper->SetScalarMode(mode);

  vtkDataArray* const array = name && this->Shown
    ? this->Shown->GetAttributes(ofCells ? vtkDataObject::CELL : vtkDataObject::POINT)
        ->GetArray(name)
    : nullptr;
  vtkColorTransferFunction* const colors = this->Property->GetRGBTransferFunction(0);
  int component = 0;
  if (array && array->GetNumberOfComponents() > 1)
  {
    component = colors->GetVectorMode() == vtkScalarsToColors::COMPONENT
      ? std::clamp(colors->GetVectorComponent(), 0, array->GetNumberOfComponents() - 1)
      : -1;
  }
  this->VolumeMapper->SetArrayComponent(component);
  this->LODMapper->SetLookupTable(colors);
  this->Property->SetIndependentComponents(1);
  this->Property->SetScalarOpacityUnitDistance(this->ChooseUnitDistance());
  this->Actor->SetMapper(this->VolumeMapper);
  // Without an array there is nothing to draw, which is no error.
  this->Actor->SetVisibility(this->GetVisibility() && name && *name);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UnitDistance: " << this->UnitDistance << "\n";
  os << indent << "DrawsFile: " << (this->Drawn ? "true" : "false") << "\n";
  os << indent << "VolumeMapper:\n";
  this->VolumeMapper->PrintSelf(os, indent.GetNextIndent());
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
