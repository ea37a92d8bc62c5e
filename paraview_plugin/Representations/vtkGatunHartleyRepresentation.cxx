// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunHartleyRepresentation.h"

#include "gatunFilePiece.h"
#include "gatunVolumeProp.h"
#include "vtkGatunHartleyCoefficients.h"
#include "vtkGatunHartleyMapper.h"
#include "vtkGatunHartleyProjection.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOutlineSource.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolumeProperty.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

//------------------------------------------------------------------------------
/** Finds the coefficients at the source of the representation's input. */
class vtkGatunHartleyRepresentation::vtkProjection : public vtkGatunHartleyProjection
{
public:
  static vtkProjection* New();
  vtkTypeMacro(vtkProjection, vtkGatunHartleyProjection);

  void SetSourceInformation(vtkInformation* info)
  {
    if (info != this->SourceInformation)
    {
      this->SourceInformation = info;
      this->Modified();
    }
  }

  bool HasCoefficients() const
  {
    return this->SourceInformation &&
      this->SourceInformation->Has(vtkGatunHartleyCoefficients::COEFFICIENTS());
  }

protected:
  vtkInformation* GetCoefficientsInformation() override
  {
    return this->HasCoefficients() ? this->SourceInformation.Get()
                                   : this->Superclass::GetCoefficientsInformation();
  }

private:
  vtkSmartPointer<vtkInformation> SourceInformation;
};

vtkStandardNewMacro(vtkGatunHartleyRepresentation::vtkProjection);
vtkStandardNewMacro(vtkGatunHartleyRepresentation);

namespace
{
//------------------------------------------------------------------------------
/** The place of the whole volume that some information describes, without voxels. */
vtkSmartPointer<vtkImageData> MakeShape(vtkInformation* info)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  auto shape = vtkSmartPointer<vtkImageData>::New();
  if (info->Has(Pipeline::WHOLE_EXTENT()))
  {
    shape->SetExtent(info->Get(Pipeline::WHOLE_EXTENT()));
  }
  if (info->Has(vtkDataObject::ORIGIN()))
  {
    shape->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
  }
  if (info->Has(vtkDataObject::SPACING()))
  {
    shape->SetSpacing(info->Get(vtkDataObject::SPACING()));
  }
  if (info->Has(vtkDataObject::DIRECTION()))
  {
    shape->SetDirectionMatrix(info->Get(vtkDataObject::DIRECTION()));
  }
  return shape;
}

//------------------------------------------------------------------------------
bool IsParallel()
{
  auto* const controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1;
}
}

//------------------------------------------------------------------------------
vtkGatunHartleyRepresentation::vtkGatunHartleyRepresentation()
  : Projection(vtkSmartPointer<vtkProjection>::New())
{
  this->VolumeMapper->SetProjection(this->Projection);
  // That of ParaView draws nothing without voxels.
  this->Actor = gatun::MakeVolumeProp();
  this->Actor->SetProperty(this->Property);
  this->Actor->SetLODMapper(this->OutlineMapper);
}

vtkGatunHartleyRepresentation::~vtkGatunHartleyRepresentation() = default;

//------------------------------------------------------------------------------
void vtkGatunHartleyRepresentation::SetOpacityModel(int model)
{
  this->Projection->SetOpacityModel(model);
}

//------------------------------------------------------------------------------
int vtkGatunHartleyRepresentation::GetOpacityModel()
{
  return this->Projection->GetOpacityModel();
}

//------------------------------------------------------------------------------
void vtkGatunHartleyRepresentation::SetExtinction(double extinction)
{
  this->Projection->SetExtinction(extinction);
}

//------------------------------------------------------------------------------
double vtkGatunHartleyRepresentation::GetExtinction()
{
  return this->Projection->GetExtinction();
}

//------------------------------------------------------------------------------
void vtkGatunHartleyRepresentation::SetWindow(double black, double white)
{
  this->Projection->SetWindow(black, white);
}

//------------------------------------------------------------------------------
double* vtkGatunHartleyRepresentation::GetWindow()
{
  return this->Projection->GetWindow();
}

//------------------------------------------------------------------------------
void vtkGatunHartleyRepresentation::SetMemoryBudget(int mebibytes)
{
  this->Projection->SetMemoryBudget(mebibytes);
}

//------------------------------------------------------------------------------
int vtkGatunHartleyRepresentation::GetMemoryBudget()
{
  return this->Projection->GetMemoryBudget();
}

//------------------------------------------------------------------------------
void vtkGatunHartleyRepresentation::SetAutoAdjustSampleDistances(bool on)
{
  this->VolumeMapper->SetAutoAdjustSampleDistances(on);
}

//------------------------------------------------------------------------------
bool vtkGatunHartleyRepresentation::GetAutoAdjustSampleDistances()
{
  return this->VolumeMapper->GetAutoAdjustSampleDistances();
}

//------------------------------------------------------------------------------
int vtkGatunHartleyRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunHartleyRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkMath::UninitializeBounds(this->DataBounds);
  this->Volume = nullptr;
  this->Projection->SetSourceInformation(nullptr);
  vtkImageData* const input = inputVector[0]->GetNumberOfInformationObjects() == 1
    ? vtkImageData::GetData(inputVector[0], 0)
    : nullptr;
  if (input)
  {
    this->Projection->SetSourceInformation(gatun::FindSource(this));
    if (this->Projection->HasCoefficients())
    {
      this->Volume = MakeShape(gatun::FindSource(this));
    }
    else
    {
      this->Volume = vtkSmartPointer<vtkImageData>::New();
      this->Volume->ShallowCopy(input);
    }
    this->Volume->GetBounds(this->DataBounds);
    this->OutlineSource->SetBounds(this->DataBounds);
    this->OutlineSource->Update();
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkGatunHartleyRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->Deliver(inInfo);
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    vtkPVRenderView::SetPieceLOD(inInfo, this, this->OutlineSource->GetOutputDataObject(0));
    vtkPVRenderView::SetRequiresDistributedRenderingLOD(inInfo, this, true);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->PrepareToDraw();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkGatunHartleyRepresentation::Deliver(vtkInformation* inInfo)
{
  // Coefficients stay where they are; the outline stands for them.
  vtkPVRenderView::SetPiece(inInfo, this, this->OutlineSource->GetOutputDataObject(0), 0);
  vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
  vtkNew<vtkMatrix4x4> matrix;
  this->Actor->GetMatrix(matrix);
  vtkPVRenderView::SetGeometryBounds(inInfo, this, this->DataBounds, matrix);
  // The view asks the actor for bounds, too, which would be those of what was drawn before.
  this->Actor->SetMapper(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunHartleyRepresentation::PrepareToDraw()
{
  this->Actor->SetMapper(nullptr);
  this->Actor->SetEnableLOD(0);
  vtkInformation* const info = this->GetInputArrayInformation(0);
  const char* const name = info && info->Has(vtkDataObject::FIELD_NAME())
    ? info->Get(vtkDataObject::FIELD_NAME())
    : nullptr;
  this->Actor->SetVisibility(
    this->GetVisibility() && this->Volume && name && *name && !IsParallel());
  if (this->Volume && IsParallel() && !this->HasReportedParallel)
  {
    vtkErrorMacro(
      "Gatun Hartley draws in one process only. Gatun Hartley Projection makes images with "
      "several.");
    this->HasReportedParallel = true;
  }
  if (!this->Actor->GetVisibility())
  {
    return;
  }
  if (auto* const view = vtkPVRenderView::SafeDownCast(this->GetView()))
  {
    // An image cannot be peeled.
    view->GetRenderer()->UseDepthPeelingForVolumesOff();
  }
  this->Projection->SetInputArrayToProcess(
    0, 0, 0, info->Get(vtkDataObject::FIELD_ASSOCIATION()), name);
  this->VolumeMapper->SetInputDataObject(0, this->Volume);
  this->Property->SetIndependentComponents(1);
  this->Actor->SetMapper(this->VolumeMapper);
}

//------------------------------------------------------------------------------
bool vtkGatunHartleyRepresentation::AddToView(vtkView* view)
{
  auto* const renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->AddActor(this->Actor);
  return this->Superclass::AddToView(view);
}

//------------------------------------------------------------------------------
bool vtkGatunHartleyRepresentation::RemoveFromView(vtkView* view)
{
  auto* const renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->RemoveActor(this->Actor);
  return this->Superclass::RemoveFromView(view);
}

//------------------------------------------------------------------------------
void vtkGatunHartleyRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HasCoefficients: " << (this->Projection->HasCoefficients() ? "true" : "false")
     << "\n";
  os << indent << "VolumeMapper:\n";
  this->VolumeMapper->PrintSelf(os, indent.GetNextIndent());
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
