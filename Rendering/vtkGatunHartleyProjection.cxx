// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunHartleyProjection.h"

#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunHartleyCamera.h"
#include "gatunHartleyFrame.h"
#include "gatunHartleyOutput.h"
#include "gatunHartleyProjector.h"
#include "gatunHartleyTransfer.h"
#include "gatunImageEncoder.h"
#include "gatunImagePipeline.h"
#include "gatunReport.h"
#include "gatunStatistics.h"
#include "vtkGatunCompat.h"
#include "vtkGatunHartleyCoefficients.h"

#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunHartleyProjection);

namespace
{
using Report = std::function<bool(double)>;

constexpr int MostPixels = 32000;

// The encoder's share of the progress.
constexpr double PartOfEncoder = 0.7;

// The default unit distance of opacities and the reciprocal of the default of Extinction, in parts
// of the diagonal.
constexpr double RampsPerDiagonal = 30;
constexpr double DepthsPerDiagonal = 10;

//------------------------------------------------------------------------------
// The volume that a pipeline's information describes.
std::optional<gatun::VolumeInput> DescribeInput(vtkInformation* info)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (!info->Has(Pipeline::WHOLE_EXTENT()))
  {
    return {};
  }
  gatun::VolumeInput volume;
  std::array<int, 6> extent{};
  info->Get(Pipeline::WHOLE_EXTENT(), extent.data());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (extent[2 * axis] > extent[2 * axis + 1])
    {
      return {};
    }
    volume.FirstIndex[axis] = extent[2 * axis];
    volume.Size[axis] = static_cast<std::uint32_t>(extent[2 * axis + 1] - extent[2 * axis]) + 1;
  }
  if (info->Has(vtkDataObject::ORIGIN()))
  {
    info->Get(vtkDataObject::ORIGIN(), volume.Origin.data());
  }
  if (info->Has(vtkDataObject::SPACING()))
  {
    info->Get(vtkDataObject::SPACING(), volume.Spacing.data());
  }
  if (info->Has(vtkDataObject::DIRECTION()))
  {
    info->Get(vtkDataObject::DIRECTION(), volume.Direction.data());
  }
  return volume;
}

//------------------------------------------------------------------------------
std::array<double, 3> ToArray(const double* values)
{
  return { values[0], values[1], values[2] };
}
} // anonymous namespace

//------------------------------------------------------------------------------
class vtkGatunHartleyProjection::vtkPipeline : public gatun::ImagePipeline
{
public:
  static vtkPipeline* New();
  vtkTypeMacro(vtkPipeline, gatun::ImagePipeline);

protected:
  void NoteFailure() override
  {
    auto* const self = vtkGatunHartleyProjection::SafeDownCast(this->GetAlgorithm());
    if (self && self->GetErrorCode() == vtkErrorCode::NoError)
    {
      self->SetErrorCode(vtkErrorCode::UnknownError);
    }
  }
};

vtkStandardNewMacro(vtkGatunHartleyProjection::vtkPipeline);

//------------------------------------------------------------------------------
class vtkGatunHartleyProjection::vtkInternals
{
public:
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkVolumeProperty> Property;

  // The volume that is drawn, and the encoder of inputs that come without coefficients.
  std::shared_ptr<const gatun::HartleySource> Source;
  gatun::VolumeInput Volume;
  gatun::ImageEncoder Encoder;

  std::unique_ptr<gatun::HartleyProjector> Projector;
  gatun::HartleyOptions Options;
  gatun::HartleyImage Image; ///< the last one, without its pixels
  std::uint64_t Volumes = 0; ///< that were drawn
  gatun::Statistics Statistics;

  void Forget()
  {
    this->Projector.reset();
    this->Source.reset();
    this->Encoder.Clear();
    this->Image = {};
  }

  /** Draws a volume from now on. */
  void Use(
    const std::shared_ptr<const gatun::HartleySource>& source, const gatun::VolumeInput& volume)
  {
    if (source != this->Source)
    {
      this->Projector.reset();
      this->Source = source;
      this->Volume = volume;
      ++this->Volumes;
    }
  }

  static vtkGatunHartleyCoefficients* FindCoefficients(vtkGatunHartleyProjection* self);
  void MakeProjector(const vtkGatunHartleyProjection* self);
  static gatun::HartleyFrame MakeFrame(
    vtkGatunHartleyProjection* self, const gatun::VolumePlace& place);
  gatun::HartleyShading MakeShading(
    vtkGatunHartleyProjection* self, const gatun::VolumePlace& place) const;
  static std::array<int, 6> GetPart(const vtkGatunHartleyProjection* self, vtkInformation* outInfo);
};

//------------------------------------------------------------------------------
// The coefficients that come with the input; null if there are none, or none of the selected array.
vtkGatunHartleyCoefficients* vtkGatunHartleyProjection::vtkInternals::FindCoefficients(
  vtkGatunHartleyProjection* self)
{
  vtkInformation* const info = self->GetCoefficientsInformation();
  auto* const found = info ? vtkGatunHartleyCoefficients::SafeDownCast(
                               info->Get(vtkGatunHartleyCoefficients::COEFFICIENTS()))
                           : nullptr;
  if (!found || !found->GetSource())
  {
    return nullptr;
  }
  vtkInformation* const wanted = self->GetInputArrayInformation(0);
  const char* const name =
    wanted->Has(vtkDataObject::FIELD_NAME()) ? wanted->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  return !name || !*name || found->GetVolume().Name == name ? found : nullptr;
}

//------------------------------------------------------------------------------
void vtkGatunHartleyProjection::vtkInternals::MakeProjector(const vtkGatunHartleyProjection* self)
{
  gatun::HartleyOptions options;
  options.Method = static_cast<gatun::HartleyMethod>(self->Method);
  options.CacheBytes = static_cast<std::uint64_t>(self->MemoryBudget) << 20;
  const gatun::HartleyOptions& old = this->Options;
  if (!this->Projector || options.Method != old.Method || options.CacheBytes != old.CacheBytes)
  {
    this->Projector.reset();
    this->Projector = std::make_unique<gatun::HartleyProjector>(this->Source, options);
    this->Options = options;
  }
}

//------------------------------------------------------------------------------
gatun::HartleyFrame vtkGatunHartleyProjection::vtkInternals::MakeFrame(
  vtkGatunHartleyProjection* self, const gatun::VolumePlace& place)
{
  if (!std::isfinite(self->SampleDistance))
  {
    gatun::ThrowInvalid("the sample distance is not a finite number");
  }
  gatun::HartleyEye eye;
  eye.Focus = place.GetCenter();
  eye.ParallelScale =
    gatun::GetFittingScale(place, static_cast<double>(self->Size[0]) / self->Size[1]);
  if (const auto camera = self->MakeCamera(eye.Focus.data(), eye.ParallelScale))
  {
    eye = gatun::MakeHartleyEye(camera, self->Size[0], self->Size[1]);
  }
  return gatun::MakeHartleyFrame(eye, { self->Size[0], self->Size[1] }, place,
    self->SampleDistance > 0 ? self->SampleDistance : place.GetVoxelEdge());
}

//------------------------------------------------------------------------------
gatun::HartleyShading vtkGatunHartleyProjection::vtkInternals::MakeShading(
  vtkGatunHartleyProjection* self, const gatun::VolumePlace& place) const
{
  const gatun::Range range = this->Source->GetRange();
  const double distance = self->SampleDistance > 0 ? self->SampleDistance : place.GetVoxelEdge();
  gatun::HartleyShading shading;
  shading.OpacityModel = static_cast<gatun::HartleyOpacityModel>(self->OpacityModel);
  shading.Zero = std::isnan(self->Zero) ? range.Min : self->Zero;
  double extinction = self->Extinction;
  if (extinction == 0)
  {
    const double densest = range.Max - shading.Zero;
    extinction = densest > 0 ? DepthsPerDiagonal / (place.GetDiagonal() * densest) : 0;
  }
  shading.Extinction = extinction * distance;
  shading.Black = self->Window[0];
  shading.White = self->Window[1];
  if (!std::isfinite(shading.Zero + shading.Extinction + shading.Black + shading.White))
  {
    gatun::ThrowInvalid("Extinction, Zero or Window is not a finite number");
  }
  const double bounds[2] = { range.Min, range.Max };
  const auto property = self->MakeProperty(bounds, place.GetDiagonal());
  gatun::FillHartleyTable(
    property, place.GetDiagonal() / RampsPerDiagonal, range, distance, shading);
  return shading;
}

//------------------------------------------------------------------------------
// The part of the image that is requested. After a failure, VTK may request more than there is.
std::array<int, 6> vtkGatunHartleyProjection::vtkInternals::GetPart(
  const vtkGatunHartleyProjection* self, vtkInformation* outInfo)
{
  std::array<int, 6> extent{ 0, self->Size[0] - 1, 0, self->Size[1] - 1, 0, 0 };
  const std::array<int, 6> whole = extent;
  outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = std::max(extent[2 * axis], whole[2 * axis]);
    extent[2 * axis + 1] = std::min(extent[2 * axis + 1], whole[2 * axis + 1]);
  }
  return extent;
}

//------------------------------------------------------------------------------
vtkGatunHartleyProjection::vtkGatunHartleyProjection()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkGatunHartleyProjection::~vtkGatunHartleyProjection() = default;

//------------------------------------------------------------------------------
void vtkGatunHartleyProjection::SetSize(int width, int height)
{
  const int clamped[2] = { std::clamp(width, 1, MostPixels), std::clamp(height, 1, MostPixels) };
  if (!std::equal(clamped, clamped + 2, this->Size))
  {
    std::copy_n(clamped, 2, this->Size);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGatunHartleyProjection::SetBackground(double red, double green, double blue)
{
  const double clamped[3] = { std::clamp(red, -1., 1.), std::clamp(green, -1., 1.),
    std::clamp(blue, -1., 1.) };
  if (!std::equal(clamped, clamped + 3, this->Background))
  {
    std::copy_n(clamped, 3, this->Background);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGatunHartleyProjection::SetZero(double value)
{
  if (value != this->Zero && !(std::isnan(value) && std::isnan(this->Zero)))
  {
    this->Zero = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGatunHartleyProjection::SetCamera(vtkCamera* camera)
{
  if (camera != this->Internals->Camera)
  {
    this->Internals->Camera = camera;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCamera* vtkGatunHartleyProjection::GetCamera()
{
  return this->Internals->Camera;
}

//------------------------------------------------------------------------------
void vtkGatunHartleyProjection::SetProperty(vtkVolumeProperty* property)
{
  if (property != this->Internals->Property)
  {
    this->Internals->Property = property;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkVolumeProperty* vtkGatunHartleyProjection::GetProperty()
{
  return this->Internals->Property;
}

//------------------------------------------------------------------------------
bool vtkGatunHartleyProjection::ResetCamera(vtkCamera* camera)
{
  if (!camera || this->GetNumberOfInputConnections(0) < 1)
  {
    return false;
  }
  try
  {
    this->GetInputAlgorithm(0, 0)->UpdateInformation();
    const auto volume = DescribeInput(this->GetInputInformation(0, 0));
    if (!volume)
    {
      return false;
    }
    const gatun::VolumePlace place(*volume);
    const double aspect = static_cast<double>(this->Size[0]) / this->Size[1];
    const double scale = gatun::GetFittingScale(place, aspect);
    const auto& center = place.GetCenter();
    const double* const direction = camera->GetDirectionOfProjection();
    const double distance = 2 * scale;
    camera->SetPosition(center[0] - distance * direction[0], center[1] - distance * direction[1],
      center[2] - distance * direction[2]);
    camera->SetFocalPoint(center.data());
    camera->SetParallelScale(scale);
    camera->SetClippingRange(scale, 3 * scale);
    camera->ParallelProjectionOn();
    return true;
  }
  catch (...)
  {
    return false; // an image of such a volume reports the error
  }
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunHartleyProjection::GetStatistics()
{
  const auto& self = *this->Internals;
  gatun::Statistics& table = this->Internals->Statistics;
  table.Clear();
  table.Add("DrawnBlocks", self.Image.Blocks);
  table.Add("Coefficients", self.Image.Terms);
  table.Add("Method", static_cast<std::uint64_t>(self.Image.Method));
  table.Add("Volumes", self.Volumes);
  return table.Get();
}

//------------------------------------------------------------------------------
void vtkGatunHartleyProjection::GetRange(double range[2])
{
  const auto& source = this->Internals->Source;
  range[0] = source ? source->GetRange().Min : 0;
  range[1] = source ? source->GetRange().Max : 0;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGatunHartleyProjection::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->Internals->Camera)
  {
    time = std::max(time, this->Internals->Camera->GetMTime());
  }
  if (this->Internals->Property)
  {
    time = std::max(time, this->Internals->Property->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
vtkInformation* vtkGatunHartleyProjection::GetCoefficientsInformation()
{
  return this->GetInputInformation(0, 0);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCamera> vtkGatunHartleyProjection::MakeCamera(const double*, double)
{
  return this->Internals->Camera;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolumeProperty> vtkGatunHartleyProjection::MakeProperty(const double*, double)
{
  return this->Internals->Property;
}

//------------------------------------------------------------------------------
vtkExecutive* vtkGatunHartleyProjection::CreateDefaultExecutive()
{
  return vtkPipeline::New();
}

//------------------------------------------------------------------------------
int vtkGatunHartleyProjection::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunHartleyProjection::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* const info = outputs->GetInformationObject(0);
  const int extent[6] = { 0, this->Size[0] - 1, 0, this->Size[1] - 1, 0, 0 };
  double spacing[3] = { 1, 1, 1 };
  double origin[3] = { 0, 0, 0 };
  const double direction[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  try
  {
    if (const auto volume = DescribeInput(inputs[0]->GetInformationObject(0)))
    {
      const gatun::VolumePlace place(*volume);
      const auto frame = vtkInternals::MakeFrame(this, place);
      std::fill_n(spacing, 2, frame.Spacing);
      std::copy_n(frame.First.begin(), 2, origin);
    }
  }
  catch (...)
  {
    // RequestData reports the error.
  }
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkDataObject::DIRECTION(), direction, 9);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_UNSIGNED_CHAR, 4);
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunHartleyProjection::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const info = inputs[0]->GetInformationObject(0);
  if (vtkInternals::FindCoefficients(this))
  {
    // An output that exists already contains the empty extent and remains.
    const int nothing[6] = { 0, -1, 0, -1, 0, -1 };
    info->Set(Pipeline::UPDATE_EXTENT(), nothing, 6);
  }
  else if (info->Has(Pipeline::WHOLE_EXTENT()))
  {
    // Some upstream filters pass on pieces only.
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunHartleyProjection::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* const outInfo = outputs->GetInformationObject(0);
  vtkImageData* const output = vtkImageData::GetData(outInfo);
  this->SetErrorCode(vtkErrorCode::NoError);
  auto& self = *this->Internals;
  const auto report = [this](double first, double last) -> Report
  {
    return [this, first, last](double fraction)
    {
      this->UpdateProgress(first + (last - first) * fraction);
      return !gatun::IsAborted(this);
    };
  };
  try
  {
    output->Initialize();
    double first = 0;
    if (vtkGatunHartleyCoefficients* const coefficients = vtkInternals::FindCoefficients(this))
    {
      self.Encoder.Clear();
      self.Use(coefficients->GetSource(), coefficients->GetVolume());
    }
    else
    {
      const bool isNew = self.Encoder.Encode(vtkImageData::GetData(inputs[0], 0),
        this->GetInputArrayInformation(0), {}, report(0, PartOfEncoder));
      first = isNew ? PartOfEncoder : 0;
      self.Use(self.Encoder.GetCoefficients(), self.Encoder.GetVolume());
    }
    const gatun::VolumePlace place(self.Volume);
    const gatun::HartleyFrame frame = vtkInternals::MakeFrame(this, place);
    const gatun::HartleyShading shading = self.MakeShading(this, place);
    self.MakeProjector(this);
    self.Image = self.Projector->Draw(frame.View, shading, report(first, 1));
    gatun::ImageOutput options;
    options.Floats = this->OutputFloats;
    const double* const background = this->Background;
    if (background[0] >= 0 && background[1] >= 0 && background[2] >= 0)
    {
      options.Background = ToArray(this->Background);
    }
    gatun::FillImage(self.Image, options, vtkInternals::GetPart(this, outInfo), output);
    output->SetOrigin(frame.First[0], frame.First[1], 0);
    output->SetSpacing(frame.Spacing, frame.Spacing, 1);
    self.Image.Colors = {};
    self.Image.Sums = {};
    self.Image.Samples = {};
    this->UpdateProgress(1);
    return 1;
  }
  catch (...)
  {
    const gatun::VTKFailure failure = gatun::DescribeFailure("The volume cannot be drawn");
    this->SetErrorCode(failure.Code);
    gatun::ReportFailure(this, failure, output);
    if (!failure.Aborted)
    {
      self.Forget();
    }
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkGatunHartleyProjection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const models[] = { "XRay", "Exponential", "TransferFunction" };
  const char* const methods[] = { "Automatic", "Basis", "Slice", "Voxels" };
  const auto onOff = [](bool value) { return value ? "On" : "Off"; };
  const auto print = [&os, indent](const char* name, const auto& value)
  { os << indent << name << ": " << value << "\n"; };
  const auto printVector = [&os, indent](const char* name, const auto& values)
  {
    os << indent << name << ":";
    for (const auto value : values)
    {
      os << " " << value;
    }
    os << "\n";
  };
  printVector("Size", this->Size);
  print("OpacityModel", models[this->OpacityModel]);
  print("Camera", this->Internals->Camera.Get());
  print("Property", this->Internals->Property.Get());
  print("Extinction", this->Extinction);
  print("Zero", this->Zero);
  printVector("Window", this->Window);
  printVector("Background", this->Background);
  print("OutputFloats", onOff(this->OutputFloats));
  print("SampleDistance", this->SampleDistance);
  print("Method", methods[this->Method]);
  print("MemoryBudget", this->MemoryBudget);
}
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
