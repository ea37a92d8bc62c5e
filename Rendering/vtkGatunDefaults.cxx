// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunDefaults.h"

#include "gatunDefaultOpacity.h"
#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunFileConsumer.h"
#include "gatunFileReader.h"
#include "gatunFraming.h"
#include "gatunHartleyFile.h"
#include "gatunObjectPoints.h"
#include "gatunRayScene.h"
#include "gatunReport.h"
#include "gatunValueSurvey.h"
#include "gatunVolumeBridge.h"
#include "gatunVolumeSurvey.h"
#include "vtkGatunFileHandle.h"
#include "vtkGatunHartleyCoefficients.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <optional>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunDefaults);

namespace
{
//------------------------------------------------------------------------------
gatun::FramingView MakeView(vtkCamera* camera, double aspect)
{
  vtkMatrix4x4* const toEye = camera->GetViewTransformMatrix();
  gatun::FramingView view;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int column = static_cast<int>(axis);
    view.Right[axis] = toEye->GetElement(0, column);
    view.Up[axis] = toEye->GetElement(1, column);
    view.Back[axis] = toEye->GetElement(2, column);
  }
  view.IsParallel = camera->GetParallelProjection() != 0;
  view.TangentOfHalfAngle = std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2);
  if (camera->GetUseHorizontalViewAngle())
  {
    view.TangentOfHalfAngle /= aspect;
  }
  view.Aspect = aspect;
  return view;
}

//------------------------------------------------------------------------------
void Place(vtkCamera* camera, const gatun::FramingView& view, const gatun::Framing& framing)
{
  std::array<double, 3> eye = framing.FocalPoint;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    eye[axis] += framing.Distance * view.Back[axis];
  }
  camera->SetFocalPoint(framing.FocalPoint.data());
  camera->SetPosition(eye.data());
  camera->SetParallelScale(framing.ParallelScale);
}
}

//------------------------------------------------------------------------------
class vtkGatunDefaults::vtkInternals
{
public:
  vtkSmartPointer<vtkAlgorithm> Producer;
  int Port = 0;
  vtkSmartPointer<vtkDataObject> Data;

  double Unit = 1; // of the functions that were made last

  /** What there is to look at; one of them is not null. */
  struct Object
  {
    const gatun::PublishedFile* File = nullptr;
    std::size_t Step = 0;
    std::shared_ptr<const gatun::HartleySource> Volume;
    gatun::VolumeInput Place; // of the volume
    vtkDataObject* Data = nullptr;
  };

  Object Find(const vtkGatunDefaults& self);
  gatun::PointBlocks GetPoints(const vtkGatunDefaults& self);
  gatun::ValueSurvey Survey(const vtkGatunDefaults& self, const std::optional<gatun::Range>& range);

  template <typename Frame>
  bool Fit(vtkGatunDefaults* self, vtkCamera* camera, double aspect, Frame&& frame);

private:
  gatun::ValueSurvey SurveyImage(
    const vtkGatunDefaults& self, vtkImageData* image, const std::optional<gatun::Range>& range);
};

//------------------------------------------------------------------------------
vtkGatunDefaults::vtkInternals::Object vtkGatunDefaults::vtkInternals::Find(
  const vtkGatunDefaults& self)
{
  Object object;
  if (this->Data)
  {
    object.Data = this->Data;
    return object;
  }
  if (!this->Producer)
  {
    gatun::ThrowInvalid("there is no input");
  }
  this->Producer->UpdateInformation();
  vtkInformation* const info = this->Producer->GetOutputInformation(this->Port);
  auto* const handle =
    vtkGatunFileHandle::SafeDownCast(info->Get(vtkGatunFileHandle::FILE_HANDLE()));
  if (handle)
  {
    const gatun::PublishedFile* const file =
      self.UseTime ? &handle->GetContents(self.Time) : gatun::GetPublishedFile(info);
    if (file->Failure)
    {
      std::rethrow_exception(file->Failure);
    }
    if (file->CanReplaceOutput())
    {
      const gatun::FileReader& reader = *file->File->GetFile();
      object.File = file;
      object.Step =
        self.UseTime ? gatun::FindStep(reader, self.Time) : gatun::GetRequestedStep(reader, info);
      return object;
    }
  }
  auto* const coefficients = vtkGatunHartleyCoefficients::SafeDownCast(
    info->Get(vtkGatunHartleyCoefficients::COEFFICIENTS()));
  if (coefficients &&
    std::dynamic_pointer_cast<const gatun::HartleyFile>(coefficients->GetSource()))
  {
    object.Volume = coefficients->GetSource();
    object.Place = coefficients->GetVolume();
    return object;
  }
  this->Producer->Update(this->Port);
  object.Data = this->Producer->GetOutputDataObject(this->Port);
  return object;
}

//------------------------------------------------------------------------------
gatun::PointBlocks vtkGatunDefaults::vtkInternals::GetPoints(const vtkGatunDefaults& self)
{
  const Object object = this->Find(self);
  if (object.File)
  {
    return gatun::GetObjectPoints(*object.File->File, object.Step);
  }
  return object.Volume ? gatun::GetObjectPoints(object.Place) : gatun::GetObjectPoints(object.Data);
}

//------------------------------------------------------------------------------
gatun::ValueSurvey vtkGatunDefaults::vtkInternals::SurveyImage(
  const vtkGatunDefaults& self, vtkImageData* image, const std::optional<gatun::Range>& range)
{
  vtkNew<vtkInformation> wanted;
  wanted->Set(vtkDataObject::FIELD_ASSOCIATION(), vtkDataObject::FIELD_ASSOCIATION_POINTS);
  if (self.ArrayName && *self.ArrayName)
  {
    wanted->Set(vtkDataObject::FIELD_NAME(), self.ArrayName);
  }
  else
  {
    wanted->Set(vtkDataObject::FIELD_ATTRIBUTE_TYPE(), vtkDataSetAttributes::SCALARS);
  }
  const gatun::BridgedVolume bridged = gatun::BridgeVolume(image, wanted);
  return gatun::SurveyVolume(bridged.Volume, range);
}

//------------------------------------------------------------------------------
gatun::ValueSurvey vtkGatunDefaults::vtkInternals::Survey(
  const vtkGatunDefaults& self, const std::optional<gatun::Range>& range)
{
  const Object object = this->Find(self);
  if (object.Volume)
  {
    return gatun::SurveyVolume(dynamic_cast<const gatun::HartleyFile&>(*object.Volume), range);
  }
  if (auto* const image = vtkImageData::SafeDownCast(object.Data))
  {
    return this->SurveyImage(self, image, range);
  }
  const gatun::RayArray array{ self.ArrayName ? self.ArrayName : "", self.ArrayAssociation,
    self.ArrayComponent, {} };
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(object.Data);
  gatun::RayScene scene;
  if (object.File && !object.File->File->GetFile()->IsSurface())
  {
    scene.SetFile(*object.File, object.Step, array);
  }
  else if (grid)
  {
    // Blocks are looked at once.
    scene.SetGrid(grid, array, 0);
  }
  else
  {
    gatun::ThrowInvalid("there is neither a grid nor a volume whose values could be looked at");
  }
  return gatun::SurveyValues(*scene.GetSource(), range);
}

//------------------------------------------------------------------------------
template <typename Frame>
bool vtkGatunDefaults::vtkInternals::Fit(
  vtkGatunDefaults* self, vtkCamera* camera, double aspect, Frame&& frame)
{
  try
  {
    if (!camera || !(aspect > 0) || !std::isfinite(aspect))
    {
      gatun::ThrowInvalid("there is no camera, or the aspect is not a positive number");
    }
    const gatun::PointBlocks points = this->GetPoints(*self);
    if (points.IsEmpty())
    {
      gatun::ThrowInvalid("there are no cells with finite coordinates");
    }
    Place(camera, MakeView(camera, aspect), frame(points));
    return true;
  }
  catch (...)
  {
    const gatun::VTKFailure failure = gatun::DescribeFailure("The camera cannot be placed");
    gatun::ReportFailure(self, failure, nullptr);
    return false;
  }
}

//------------------------------------------------------------------------------
vtkGatunDefaults::vtkGatunDefaults()
  : Internals(std::make_unique<vtkInternals>())
{
}

//------------------------------------------------------------------------------
vtkGatunDefaults::~vtkGatunDefaults()
{
  this->SetArrayName(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunDefaults::SetInputConnection(vtkAlgorithmOutput* output)
{
  this->Internals->Producer = output ? output->GetProducer() : nullptr;
  this->Internals->Port = output ? output->GetIndex() : 0;
  this->Internals->Data = nullptr;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGatunDefaults::SetInputData(vtkDataObject* data)
{
  this->Internals->Data = data;
  this->Internals->Producer = nullptr;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkGatunDefaults::MakeProperty(vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;
  const double unit = this->UnitDistance;
  if (!property)
  {
    vtkErrorMacro("There is no default transfer function: there is no property");
    return false;
  }
  if (!this->MakeFunctions(colors, opacities))
  {
    return false;
  }
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
  property->SetScalarOpacityUnitDistance(unit > 0 ? unit : this->Internals->Unit);
  return true;
}

//------------------------------------------------------------------------------
bool vtkGatunDefaults::MakeFunctions(
  vtkColorTransferFunction* colors, vtkPiecewiseFunction* opacities)
{
  try
  {
    std::optional<gatun::Range> range;
    if (this->Range[0] < this->Range[1])
    {
      range = gatun::Range{ this->Range[0], this->Range[1] };
    }
    const gatun::ValueSurvey survey = this->Internals->Survey(*this, range);
    const double unit =
      this->UnitDistance > 0 ? this->UnitDistance : gatun::GetDefaultUnitDistance(survey.Box);
    this->Internals->Unit = unit;
    const gatun::DefaultTransfer made = gatun::MakeDefaultTransfer(survey, unit, range);
    if (colors)
    {
      MakeColors(made.Colors.Min, made.Colors.Max, colors);
    }
    if (opacities)
    {
      opacities->RemoveAllPoints();
      for (const gatun::OpacityNode& node : made.Opacities)
      {
        opacities->AddPoint(node.Value, node.Opacity);
      }
    }
    return true;
  }
  catch (...)
  {
    const gatun::VTKFailure failure =
      gatun::DescribeFailure("There is no default transfer function");
    gatun::ReportFailure(this, failure, nullptr);
    return false;
  }
}

//------------------------------------------------------------------------------
void vtkGatunDefaults::MakeColors(double least, double most, vtkColorTransferFunction* colors)
{
  if (!colors)
  {
    return;
  }
  colors->RemoveAllPoints();
  colors->SetColorSpaceToRGB();
  for (const gatun::DefaultColor& color : gatun::GetDefaultColors())
  {
    colors->AddRGBPoint(
      least * (1 - color.Value) + most * color.Value, color.RGB[0], color.RGB[1], color.RGB[2]);
  }
}

//------------------------------------------------------------------------------
void vtkGatunDefaults::MakeRamp(double least, double most, vtkPiecewiseFunction* opacities)
{
  if (!opacities)
  {
    return;
  }
  opacities->RemoveAllPoints();
  for (const gatun::OpacityNode& node : gatun::GetDefaultRamp())
  {
    opacities->AddPoint(least * (1 - node.Value) + most * node.Value, node.Opacity);
  }
}

//------------------------------------------------------------------------------
bool vtkGatunDefaults::FitCamera(vtkCamera* camera, double aspect)
{
  return this->Internals->Fit(this, camera, aspect,
    [&](const gatun::PointBlocks& points)
    { return gatun::FrameObject(points, MakeView(camera, aspect)); });
}

//------------------------------------------------------------------------------
bool vtkGatunDefaults::FitCameraAt(vtkCamera* camera, double aspect, double x, double y, double z)
{
  return this->Internals->Fit(this, camera, aspect,
    [&](const gatun::PointBlocks& points) {
      return gatun::FrameAround(points, { x, y, z }, MakeView(camera, aspect));
    });
}

//------------------------------------------------------------------------------
void vtkGatunDefaults::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << (this->ArrayName ? this->ArrayName : "(none)") << "\n";
  os << indent << "ArrayAssociation: " << this->ArrayAssociation << "\n";
  os << indent << "ArrayComponent: " << this->ArrayComponent << "\n";
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "UseTime: " << (this->UseTime ? "On" : "Off") << "\n";
  os << indent << "Range: " << this->Range[0] << " " << this->Range[1] << "\n";
  os << indent << "UnitDistance: " << this->UnitDistance << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
