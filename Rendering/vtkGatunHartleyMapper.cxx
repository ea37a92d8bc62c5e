// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunHartleyMapper.h"

#include "gatunFrameClock.h"
#include "gatunRayImage.h"
#include "vtkGatunHartleyCoefficients.h"
#include "vtkGatunHartleyProjection.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCamera.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTimerLog.h"
#include "vtkTransform.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunHartleyMapper);

namespace
{
constexpr double LargestDistance = 8;

//------------------------------------------------------------------------------
// The camera in the coordinates of the volume's data. Returns false if the matrix of the volume
// scales unevenly.
bool MoveToData(vtkVolume* volume, vtkCamera* camera)
{
  vtkMatrix4x4* const matrix = volume->GetMatrix();
  if (matrix->IsIdentity())
  {
    return true;
  }
  double lengths[3];
  for (int column = 0; column < 3; ++column)
  {
    lengths[column] = std::hypot(
      matrix->GetElement(0, column), matrix->GetElement(1, column), matrix->GetElement(2, column));
  }
  constexpr double tolerance = 1e-6;
  if (!(lengths[0] > 0) || std::abs(lengths[1] - lengths[0]) > tolerance * lengths[0] ||
    std::abs(lengths[2] - lengths[0]) > tolerance * lengths[0])
  {
    return false;
  }
  vtkNew<vtkTransform> toData;
  toData->SetMatrix(matrix);
  toData->Inverse();
  camera->ApplyTransform(toData);
  camera->SetParallelScale(camera->GetParallelScale() / lengths[0]);
  return true;
}
}

//------------------------------------------------------------------------------
vtkGatunHartleyMapper::vtkGatunHartleyMapper()
  : Image(std::make_unique<gatun::RayImage>())
{
  this->SetProjection(vtkNew<vtkGatunHartleyProjection>());
}

vtkGatunHartleyMapper::~vtkGatunHartleyMapper() = default;

//------------------------------------------------------------------------------
void vtkGatunHartleyMapper::SetProjection(vtkGatunHartleyProjection* projection)
{
  if (projection && projection != this->Projection)
  {
    this->Projection = projection;
    this->Projection->OutputFloatsOn();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkGatunHartleyProjection* vtkGatunHartleyMapper::GetProjection()
{
  return this->Projection;
}

//------------------------------------------------------------------------------
// Whether the input comes with its coefficients, so that its voxels are not needed.
bool vtkGatunHartleyMapper::HasCoefficients()
{
  vtkAlgorithm* const input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputAlgorithm(0, 0) : nullptr;
  if (!input)
  {
    return false;
  }
  input->UpdateInformation();
  return this->GetInputInformation(0, 0)->Has(vtkGatunHartleyCoefficients::COEFFICIENTS());
}

//------------------------------------------------------------------------------
VTK_GATUN_UPDATE_RESULT vtkGatunHartleyMapper::Update()
{
  return static_cast<VTK_GATUN_UPDATE_RESULT>(this->Update(0, nullptr));
}

//------------------------------------------------------------------------------
VTK_GATUN_UPDATE_RESULT vtkGatunHartleyMapper::Update(int)
{
  return static_cast<VTK_GATUN_UPDATE_RESULT>(this->Update(0, nullptr));
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGatunHartleyMapper::Update(vtkInformation*)
{
  return this->Update(0, nullptr);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGatunHartleyMapper::Update(int, vtkInformationVector*)
{
  if (!this->HasCoefficients())
  {
    // Without a port, as a mapper has no output; Update() would come back here.
    this->Superclass::Update(-1);
    return 1;
  }
  // vtkVolume draws nothing where there is no object, even if it is empty.
  this->GetInputAlgorithm(0, 0)->UpdateDataObject();
  return 1;
}

//------------------------------------------------------------------------------
double* vtkGatunHartleyMapper::GetBounds()
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const info = this->HasCoefficients() ? this->GetInputInformation(0, 0) : nullptr;
  if (!info || !info->Has(Pipeline::WHOLE_EXTENT()))
  {
    return this->Superclass::GetBounds();
  }
  vtkNew<vtkImageData> shape;
  shape->SetExtent(info->Get(Pipeline::WHOLE_EXTENT()));
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
  shape->GetBounds(this->Bounds);
  return this->Bounds;
}

//------------------------------------------------------------------------------
double vtkGatunHartleyMapper::ChooseDistance(vtkVolume* volume, double pixels) const
{
  const double allocated = volume->GetAllocatedRenderTime();
  if (!this->AutoAdjustSampleDistances || !(allocated > 0 && allocated < gatun::LeastTimeAtRest))
  {
    return 1;
  }
  return std::clamp(std::sqrt(this->SecondsPerPixel * pixels / allocated), 1.0, LargestDistance);
}

//------------------------------------------------------------------------------
// ToBorders: the outermost of so many rows of rays are on the borders of the image, instead of in
// the middle of its outermost pixels.
bool vtkGatunHartleyMapper::SetCamera(
  vtkRenderer* renderer, vtkVolume* volume, int rows, bool toBorders)
{
  vtkCamera* const active = renderer->GetActiveCamera();
  if (!active->GetParallelProjection())
  {
    if (!this->HasReportedPerspective)
    {
      vtkErrorMacro("A volume cannot be drawn from its Hartley coefficients in a perspective "
                    "projection. Turn on the parallel projection of the camera.");
      this->HasReportedPerspective = true;
    }
    return false;
  }
  this->HasReportedPerspective = false;
  const vtkMTimeType matrixTime = volume->GetMatrix()->GetMTime();
  const int borderRows = toBorders ? rows : 0;
  if (this->Projection->GetCamera() && active->GetMTime() == this->CameraTime &&
    matrixTime == this->MatrixTime && borderRows == this->BorderRows)
  {
    return true;
  }
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(active);
  if (!MoveToData(volume, camera))
  {
    vtkErrorMacro(
      "A volume that is scaled unevenly cannot be drawn from its Hartley coefficients.");
    return false;
  }
  if (toBorders)
  {
    // The center of the window is in units of the image.
    const double factor = rows / (rows - 1.0);
    const double* const center = camera->GetWindowCenter();
    camera->SetWindowCenter(center[0] / factor, center[1] / factor);
    camera->SetParallelScale(camera->GetParallelScale() * factor);
  }
  this->Projection->SetCamera(camera);
  this->CameraTime = active->GetMTime();
  this->MatrixTime = matrixTime;
  this->BorderRows = borderRows;
  return true;
}

//------------------------------------------------------------------------------
void vtkGatunHartleyMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkAlgorithmOutput* const input = this->GetInputConnection(0, 0);
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  if (!input || size[0] < 1 || size[1] < 1)
  {
    return;
  }
  const double pixels = static_cast<double>(size[0]) * size[1];
  this->ImageSampleDistance = this->ChooseDistance(volume, pixels);
  const bool toBorders = this->ImageSampleDistance > 1;
  int rays[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    rays[axis] = toBorders
      ? std::max(2, static_cast<int>(std::ceil(size[axis] / this->ImageSampleDistance)))
      : size[axis];
  }
  this->Projection->SetInputConnection(input);
  this->Projection->SetSize(rays);
  this->Projection->SetProperty(volume->GetProperty());
  if (!this->SetCamera(renderer, volume, rays[1], toBorders))
  {
    return;
  }
  const double start = vtkTimerLog::GetUniversalTime();
  this->Projection->Update();
  auto* const colors = this->Projection->GetErrorCode() == vtkErrorCode::NoError
    ? vtkFloatArray::SafeDownCast(this->Projection->GetOutput()->GetPointData()->GetArray("RGBA"))
    : nullptr;
  if (!colors)
  {
    return;
  }
  try
  {
    const float* const first = colors->GetPointer(0);
    this->Image->Take(
      std::vector<float>(first, first + colors->GetNumberOfValues()), rays[0], rays[1], toBorders);
    this->Image->Show(renderer, volume, false);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
  this->TimeToDraw = vtkTimerLog::GetUniversalTime() - start;
  this->SecondsPerPixel =
    this->TimeToDraw / (static_cast<double>(rays[0]) * static_cast<double>(rays[1]));
}

//------------------------------------------------------------------------------
void vtkGatunHartleyMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Image->Release(window);
}

//------------------------------------------------------------------------------
void vtkGatunHartleyMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AutoAdjustSampleDistances: " << (this->AutoAdjustSampleDistances ? "On" : "Off")
     << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "Projection:\n";
  this->Projection->PrintSelf(os, indent.GetNextIndent());
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
