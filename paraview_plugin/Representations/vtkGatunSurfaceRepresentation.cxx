// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunSurfaceRepresentation.h"

#include "gatunPieceSource.h"
#include "vtkGatunDetailPolicy.h"
#include "vtkGatunFileHandle.h"
#include "vtkGatunSurfaceMapper.h"
#include "vtkGatunSurfaceReader.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunSurfaceRepresentation);

namespace
{
/** The first surface among the blocks of the data that ParaView delivers. */
vtkPolyData* FindSurface(vtkDataObject* data)
{
  auto* const blocks = vtkCompositeDataSet::SafeDownCast(data);
  if (!blocks)
  {
    return vtkPolyData::SafeDownCast(data);
  }
  const auto each = vtk::TakeSmartPointer(blocks->NewIterator());
  for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
  {
    if (auto* const surface = vtkPolyData::SafeDownCast(each->GetCurrentDataObject()))
    {
      return surface;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
vtkIdType GetStatistic(vtkGatunSurfaceMapper* mapper, const char* name)
{
  return mapper->GetStatistics()->GetValueByName(0, name).ToTypeInt64();
}
} // anonymous namespace

//------------------------------------------------------------------------------
vtkGatunSurfaceRepresentation::vtkGatunSurfaceRepresentation()
  : File(std::make_unique<gatun::PieceSource>(vtkSmartPointer<vtkGatunSurfaceReader>::New()))
{
  vtkMath::UninitializeBounds(this->FileBounds);
  this->SetDetailPolicy(nullptr);
}

vtkGatunSurfaceRepresentation::~vtkGatunSurfaceRepresentation() = default;

//------------------------------------------------------------------------------
void vtkGatunSurfaceRepresentation::SetMemoryBudget(int mebibytes)
{
  this->FrontMapper->SetMemoryBudget(mebibytes);
  this->BackMapper->SetMemoryBudget(mebibytes);
}

//------------------------------------------------------------------------------
int vtkGatunSurfaceRepresentation::GetMemoryBudget()
{
  return this->FrontMapper->GetMemoryBudget();
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceRepresentation::SetDetailPolicy(vtkGatunDetailPolicy* policy)
{
  this->FrontMapper->SetDetailPolicy(policy);
  this->BackMapper->SetDetailPolicy(this->FrontMapper->GetDetailPolicy());
}

//------------------------------------------------------------------------------
vtkGatunDetailPolicy* vtkGatunSurfaceRepresentation::GetDetailPolicy()
{
  return this->FrontMapper->GetDetailPolicy();
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunSurfaceRepresentation::GetDrawnPoints()
{
  return this->DrawsFile ? GetStatistic(this->FrontMapper, "DrawnPoints") : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunSurfaceRepresentation::GetDrawnChunks()
{
  return this->DrawsFile ? GetStatistic(this->FrontMapper, "DrawnChunks") : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunSurfaceRepresentation::GetDecodedChunks()
{
  return GetStatistic(this->FrontMapper, "DecodedChunks") +
    GetStatistic(this->BackMapper, "DecodedChunks");
}

//------------------------------------------------------------------------------
int vtkGatunSurfaceRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  this->ReadsFile = false;
  gatun::UnmarkPiece(this->GetRenderedDataObject(0));
  vtkDataObject* const input = inputVector[0]->GetNumberOfInformationObjects() == 1
    ? vtkDataObject::GetData(inputVector[0], 0)
    : nullptr;
  if (!input)
  {
    return result; // a process without data
  }
  if (vtkGatunFileHandle* const handle = this->File->FindFile(this))
  {
    if (vtkPolyData* const piece = FindSurface(this->GetRenderedDataObject(0)))
    {
      // Only this knows of the arrays that are added to its own copy of the outline.
      gatun::MarkPiece(piece, gatun::DescribeFile(handle, input));
      this->ReadsFile = true;
      // All processes need to know the bounds, and only the first one has the outline.
      handle->GetBounds(this->FileBounds);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
int vtkGatunSurfaceRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    // Each process draws what it has. A process without a reader cannot tell whether that is a
    // file, and all must agree.
    vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
    if (this->ReadsFile)
    {
      // The outline is in one process, and the chunks are in all.
      vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this, 0);
      vtkNew<vtkMatrix4x4> matrix;
      this->Actor->GetMatrix(matrix);
      vtkPVRenderView::SetGeometryBounds(inInfo, this, this->FileBounds, matrix);
    }
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    vtkPVRenderView::SetRequiresDistributedRenderingLOD(inInfo, this, true);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->PrepareToDraw(inInfo);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceRepresentation::UpdateColoringParameters()
{
  this->Representation = this->Style;
  this->Superclass::UpdateColoringParameters();
}

//------------------------------------------------------------------------------
/** Gives the mapper of a file what the superclass has set in its own. */
void vtkGatunSurfaceRepresentation::CopySettings(
  vtkMapper* from, vtkGatunSurfaceMapper* to, vtkTimeStamp& time)
{
  if (time < from->GetMTime())
  {
    // Not that of vtkPolyDataMapper, which would copy the input, too.
    to->vtkMapper::ShallowCopy(from); // NOLINT(bugprone-parent-virtual-call)
    // Static is how ParaView's mapper gets its data; the file must be seen to change.
    to->SetStatic(0);
    time.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceRepresentation::PrepareToDraw(vtkInformation* inInfo)
{
  vtkMultiProcessController* const controller = this->FindController(inInfo);
  this->ConnectMappers(inInfo, controller);
  this->ChooseLevels(controller);
}

//------------------------------------------------------------------------------
/** The controller of the processes that draw the next image together, if there is more than one. */
vtkMultiProcessController* vtkGatunSurfaceRepresentation::FindController(vtkInformation* inInfo)
{
  auto* const controller = vtkMultiProcessController::GetGlobalController();
  auto* const view = vtkPVRenderView::SafeDownCast(this->GetView());
  if (!controller || controller->GetNumberOfProcesses() == 1 || !view)
  {
    return nullptr;
  }
  const bool isShared = inInfo->Has(vtkPVRenderView::USE_LOD())
    ? view->GetUseDistributedRenderingForLODRender()
    : view->GetUseDistributedRenderingForRender();
  return isShared ? controller : nullptr;
}

//------------------------------------------------------------------------------
/** The levels of detail of the next image. Several processes choose them together, also those that
 * have failed to open the file. */
void vtkGatunSurfaceRepresentation::ChooseLevels(vtkMultiProcessController* controller)
{
  if (!controller || !this->GetDetailPolicy()->GetJustInTime())
  {
    this->FrontMapper->ResetLevels();
    this->BackMapper->ResetLevels();
    return;
  }
  int own[2] = { -1, -1 };
  if (this->DrawsFile)
  {
    vtkPVRenderView* const view = vtkPVRenderView::SafeDownCast(this->GetView());
    this->FrontMapper->ProposeLevels(view->GetRenderer(), this->Actor, own);
  }
  int all[2];
  controller->AllReduce(own, all, 2, vtkCommunicator::MAX_OP);
  this->FrontMapper->SetLevels(all);
  this->BackMapper->SetLevels(all);
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceRepresentation::ConnectMappers(
  vtkInformation* inInfo, vtkMultiProcessController* controller)
{
  vtkPolyData* const piece = FindSurface(vtkPVView::GetDeliveredPiece(inInfo, this));
  const gatun::DrawnFile file = this->File->GetMark(piece);
  this->DrawsFile = false;
  if (file.Path.empty())
  {
    this->Actor->SetMapper(this->Mapper);
    this->BackfaceActor->SetMapper(this->BackfaceMapper);
    return;
  }
  // Chunks are their own level of detail.
  this->Actor->SetEnableLOD(0);
  this->BackfaceActor->SetEnableLOD(0);
  vtkAlgorithm* const source = this->File->Connect(this, piece, file);
  if (!source)
  {
    this->Actor->SetMapper(nullptr);
    this->BackfaceActor->SetMapper(nullptr);
    return;
  }
  this->DrawsFile = true;
  for (vtkGatunSurfaceMapper* const mapper : { this->FrontMapper.Get(), this->BackMapper.Get() })
  {
    mapper->SetInputConnection(source->GetOutputPort());
    mapper->SetNumberOfPieces(controller ? controller->GetNumberOfProcesses() : 1);
    mapper->SetPiece(controller ? controller->GetLocalProcessId() : 0);
  }
  this->CopySettings(this->Mapper, this->FrontMapper, this->FrontTime);
  this->CopySettings(this->BackfaceMapper, this->BackMapper, this->BackTime);
  this->Actor->SetMapper(this->FrontMapper);
  this->BackfaceActor->SetMapper(this->BackMapper);
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Style: " << this->Style << "\n";
  os << indent << "DrawsFile: " << (this->DrawsFile ? "true" : "false") << "\n";
  os << indent << "FrontMapper:\n";
  this->FrontMapper->PrintSelf(os, indent.GetNextIndent());
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
