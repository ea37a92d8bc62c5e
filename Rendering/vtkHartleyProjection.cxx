// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHartleyProjection.h"

#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunFileInput.h"
#include "gatunHartleyCamera.h"
#include "gatunHartleyFile.h"
#include "gatunHartleyPicture.h"
#include "gatunImagePipeline.h"
#include "gatunVolumeBridge.h"
#include "vtkGatunCompat.h"
#include "vtkHartleyVolumeReader.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"
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

vtkStandardNewMacro(vtkHartleyProjection);

namespace
{
using Report = std::function<bool(double)>;

constexpr int MostPixels = 32000;

//------------------------------------------------------------------------------
// The reader whose file is drawn instead of its output; null for other algorithms.
vtkHartleyVolumeReader* GetReader(vtkAlgorithm* producer)
{
  auto* const reader = vtkHartleyVolumeReader::SafeDownCast(producer);
  return reader && reader->GetFileName() ? reader : nullptr;
}

//------------------------------------------------------------------------------
// Where an input will have its voxels; none while that is not known.
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
// What an image was compressed from, and how.
struct ImageKey
{
  vtkSmartPointer<vtkDataArray> Array;
  vtkMTimeType Time = 0;
  int BlockSize = 0;
  gatun::HartleyGoal Goal;

  bool IsSame(const ImageKey& other) const
  {
    return this->Array == other.Array && this->Time == other.Time &&
      this->BlockSize == other.BlockSize && this->Goal == other.Goal;
  }
};
} // anonymous namespace

//------------------------------------------------------------------------------
class vtkHartleyProjection::vtkPipeline : public gatun::ImagePipeline
{
public:
  static vtkPipeline* New();
  vtkTypeMacro(vtkPipeline, gatun::ImagePipeline);

protected:
  void NoteFailure() override
  {
    auto* const self = vtkHartleyProjection::SafeDownCast(this->GetAlgorithm());
    if (self && self->GetErrorCode() == vtkErrorCode::NoError)
    {
      self->SetErrorCode(vtkErrorCode::UnknownError);
    }
  }
};

vtkStandardNewMacro(vtkHartleyProjection::vtkPipeline);

//------------------------------------------------------------------------------
class vtkHartleyProjection::vtkInternals
{
public:
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkVolumeProperty> Property;

  // What is drawn: a file, or what an image was compressed to.
  gatun::CurrentFileOf<gatun::HartleyFile> File;
  ImageKey Key;
  std::shared_ptr<const gatun::HartleySource> Source;
  gatun::VolumeInput Volume;

  std::unique_ptr<gatun::HartleyProjector> Projector;
  gatun::HartleyOptions Options;
  gatun::HartleyPicture Picture; ///< the last one, without its pixels

  void Forget()
  {
    this->Projector.reset();
    this->Source.reset();
    this->File.Close();
    this->Key = {};
    this->Picture = {};
  }

  bool OpenFile(const std::string& path);
  bool Compress(vtkHartleyProjection* self, vtkImageData* image, const Report& progress);
  void MakeProjector(const vtkHartleyProjection* self);
  vtkSmartPointer<vtkCamera> MakeCamera(
    const vtkHartleyProjection* self, const gatun::VolumePlace& place) const;
  gatun::HartleyFrame MakeFrame(
    const vtkHartleyProjection* self, const gatun::VolumePlace& place) const;
  gatun::HartleyShading MakeShading(
    vtkHartleyProjection* self, const gatun::VolumePlace& place) const;
  vtkSmartPointer<vtkVolumeProperty> MakeProperty(
    vtkHartleyProjection* self, const gatun::VolumePlace& place) const;
  static std::array<int, 6> GetPart(const vtkHartleyProjection* self, vtkInformation* outInfo);
};

//------------------------------------------------------------------------------
// Returns whether it is another one than before.
bool vtkHartleyProjection::vtkInternals::OpenFile(const std::string& path)
{
  if (this->Source && !this->File.IsNew(path))
  {
    return false;
  }
  this->Forget();
  this->Source = this->File.Get(path);
  this->Volume = this->File.GetLast()->GetVolume();
  return true;
}

//------------------------------------------------------------------------------
// Returns whether there was anything to do.
bool vtkHartleyProjection::vtkInternals::Compress(
  vtkHartleyProjection* self, vtkImageData* image, const Report& progress)
{
  if (self->BlockSize < 0)
  {
    gatun::ThrowInvalid("a block size of " + std::to_string(self->BlockSize) +
      " is not possible; it is 2 to 64, or 0 for the whole volume");
  }
  gatun::BridgedVolume bridged = gatun::BridgeVolume(image, self->GetInputArrayInformation(0));
  ImageKey key;
  key.Array = gatun::FindVolumeArray(image, self->GetInputArrayInformation(0));
  key.Time = std::max(image->GetMTime(), key.Array->GetMTime());
  key.BlockSize = self->BlockSize;
  key.Goal = { self->Goal, self->Quality, self->MaximumError, self->PSNR, self->Rate,
    self->FrequencyWeight };
  if (this->Source && this->Key.IsSame(key))
  {
    return false;
  }
  this->Forget();
  this->Source = gatun::HartleyVolume::Make(bridged.Volume,
    static_cast<std::uint32_t>(self->BlockSize), gatun::MakeHartleyQuality(key.Goal), progress);
  this->Key = key;
  this->Volume = bridged.Volume;
  this->Volume.Values = nullptr;
  return true;
}

//------------------------------------------------------------------------------
void vtkHartleyProjection::vtkInternals::MakeProjector(const vtkHartleyProjection* self)
{
  gatun::HartleyOptions options;
  options.Method = static_cast<gatun::HartleyMethod>(self->Method);
  options.Kernel = static_cast<gatun::HartleyKernel>(self->Kernel);
  options.Padding = self->Padding;
  options.CacheBytes = static_cast<std::uint64_t>(self->MemoryBudget) << 20;
  const gatun::HartleyOptions& old = this->Options;
  if (!this->Projector || options.Method != old.Method || options.Kernel != old.Kernel ||
    options.Padding != old.Padding || options.CacheBytes != old.CacheBytes)
  {
    this->Projector.reset();
    this->Projector = std::make_unique<gatun::HartleyProjector>(this->Source, options);
    this->Options = options;
  }
}

//------------------------------------------------------------------------------
// The one that was set, or one that sees all.
vtkSmartPointer<vtkCamera> vtkHartleyProjection::vtkInternals::MakeCamera(
  const vtkHartleyProjection* self, const gatun::VolumePlace& place) const
{
  if (this->Camera)
  {
    return this->Camera;
  }
  std::array<double, 3> direction{};
  std::array<double, 3> up{};
  std::array<double, 3> across{};
  std::copy_n(self->ViewDirection, 3, direction.begin());
  std::copy_n(self->ViewUp, 3, up.begin());
  const double length = vtkMath::Normalize(direction.data());
  const double lengthUp = vtkMath::Normalize(up.data());
  vtkMath::Cross(direction.data(), up.data(), across.data());
  if (!(length > 0 && lengthUp > 0) || !std::isfinite(length + lengthUp) ||
    !(vtkMath::Norm(across.data()) > 1e-6))
  {
    gatun::ThrowInvalid("ViewDirection and ViewUp do not make a view: they are zero, not finite, "
                        "or along one line");
  }
  if (!(self->Zoom > 0) || !std::isfinite(self->Zoom))
  {
    gatun::ThrowInvalid("a zoom of " + std::to_string(self->Zoom) + " is not possible");
  }
  vtkNew<vtkCamera> camera;
  camera->SetFocalPoint(direction.data());
  camera->SetPosition(0, 0, 0);
  camera->SetViewUp(up.data());
  gatun::ShowVolume(camera, place, static_cast<double>(self->Size[0]) / self->Size[1]);
  camera->SetParallelScale(camera->GetParallelScale() / self->Zoom);
  return camera;
}

//------------------------------------------------------------------------------
gatun::HartleyFrame vtkHartleyProjection::vtkInternals::MakeFrame(
  const vtkHartleyProjection* self, const gatun::VolumePlace& place) const
{
  for (const int pixels : self->Size)
  {
    if (pixels < 1 || pixels > MostPixels)
    {
      gatun::ThrowInvalid("a picture of " + std::to_string(self->Size[0]) + " x " +
        std::to_string(self->Size[1]) + " pixels is not possible; 1 to " +
        std::to_string(MostPixels) + " each are");
    }
  }
  if (!(self->SampleDistance >= 0) || !std::isfinite(self->SampleDistance))
  {
    gatun::ThrowInvalid(
      "a sample distance of " + std::to_string(self->SampleDistance) + " is not possible");
  }
  return gatun::MakeHartleyFrame(this->MakeCamera(self, place), { self->Size[0], self->Size[1] },
    place, self->SampleDistance > 0 ? self->SampleDistance : place.GetVoxelEdge());
}

//------------------------------------------------------------------------------
// The one that was set, or the default.
vtkSmartPointer<vtkVolumeProperty> vtkHartleyProjection::vtkInternals::MakeProperty(
  vtkHartleyProjection* self, const gatun::VolumePlace& place) const
{
  if (this->Property)
  {
    return this->Property;
  }
  const double range[2] = { this->Source->GetRange().Min, this->Source->GetRange().Max };
  vtkNew<vtkVolumeProperty> property;
  self->FillDefaultProperty(property, range, std::max(2 * place.GetRadius(), place.GetVoxelEdge()));
  return property;
}

//------------------------------------------------------------------------------
gatun::HartleyShading vtkHartleyProjection::vtkInternals::MakeShading(
  vtkHartleyProjection* self, const gatun::VolumePlace& place) const
{
  const gatun::Range range = this->Source->GetRange();
  const double distance = self->SampleDistance > 0 ? self->SampleDistance : place.GetVoxelEdge();
  gatun::HartleyShading shading;
  shading.Law = static_cast<gatun::HartleyLaw>(self->Law);
  shading.Zero = self->UseZero ? self->Zero : range.Min;
  double extinction = self->Extinction;
  if (!(extinction > 0))
  {
    const double densest = range.Max - shading.Zero;
    extinction =
      densest > 0 ? 10 / (std::max(2 * place.GetRadius(), place.GetVoxelEdge()) * densest) : 0;
  }
  shading.Extinction = extinction * distance;
  shading.Black = self->Window[0];
  shading.White = self->Window[1];
  if (!std::isfinite(shading.Zero + shading.Extinction + shading.Black + shading.White))
  {
    gatun::ThrowInvalid("extinction, zero or window are not finite");
  }
  gatun::FillHartleyTable(this->MakeProperty(self, place), range, distance, shading);
  return shading;
}

//------------------------------------------------------------------------------
vtkHartleyProjection::vtkHartleyProjection()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkHartleyProjection::~vtkHartleyProjection() = default;

//------------------------------------------------------------------------------
void vtkHartleyProjection::SetCamera(vtkCamera* camera)
{
  if (camera != this->Internals->Camera)
  {
    this->Internals->Camera = camera;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCamera* vtkHartleyProjection::GetCamera()
{
  return this->Internals->Camera;
}

//------------------------------------------------------------------------------
void vtkHartleyProjection::ResetCamera()
{
  if (!this->Internals->Camera || this->GetNumberOfInputConnections(0) < 1)
  {
    return;
  }
  try
  {
    this->UpdateInformation();
    const auto volume = DescribeInput(this->GetInputInformation(0, 0));
    if (volume)
    {
      const double aspect =
        static_cast<double>(std::max(1, this->Size[0])) / std::max(1, this->Size[1]);
      gatun::ShowVolume(this->Internals->Camera, gatun::VolumePlace(*volume), aspect);
    }
  }
  catch (...)
  {
    const gatun::VTKFailure failure = gatun::DescribeFailure("The camera stays where it is");
    vtkErrorMacro(<< failure.Message);
  }
}

//------------------------------------------------------------------------------
void vtkHartleyProjection::SetProperty(vtkVolumeProperty* property)
{
  if (property != this->Internals->Property)
  {
    this->Internals->Property = property;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkVolumeProperty* vtkHartleyProjection::GetProperty()
{
  return this->Internals->Property;
}

//------------------------------------------------------------------------------
vtkIdType vtkHartleyProjection::GetNumberOfBlocksDrawn()
{
  return static_cast<vtkIdType>(this->Internals->Picture.Blocks);
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkHartleyProjection::GetNumberOfTerms()
{
  return this->Internals->Picture.Terms;
}

//------------------------------------------------------------------------------
int vtkHartleyProjection::GetMethodUsed()
{
  return static_cast<int>(this->Internals->Picture.Method);
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkHartleyProjection::GetBytesRead()
{
  const auto& file = this->Internals->File.GetLast();
  return file ? file->GetBytesRead() : 0;
}

//------------------------------------------------------------------------------
void vtkHartleyProjection::GetRange(double range[2])
{
  const auto& source = this->Internals->Source;
  range[0] = source ? source->GetRange().Min : 0;
  range[1] = source ? source->GetRange().Max : 0;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHartleyProjection::GetMTime()
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
vtkAlgorithm* vtkHartleyProjection::FindProducer()
{
  return this->GetInputAlgorithm();
}

//------------------------------------------------------------------------------
void vtkHartleyProjection::FillDefaultProperty(
  vtkVolumeProperty* property, const double range[2], double diagonal)
{
  vtkNew<vtkColorTransferFunction> colours;
  vtkNew<vtkPiecewiseFunction> opacity;
  const double high = range[0] < range[1] ? range[1] : range[0] + 1;
  colours->AddRGBPoint(range[0], 0, 0, 0);
  colours->AddRGBPoint(high, 1, 1, 1);
  opacity->AddPoint(range[0], 0);
  opacity->AddPoint(high, 1);
  property->SetColor(colours);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(diagonal / 30);
}

//------------------------------------------------------------------------------
vtkExecutive* vtkHartleyProjection::CreateDefaultExecutive()
{
  return vtkPipeline::New();
}

//------------------------------------------------------------------------------
int vtkHartleyProjection::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHartleyProjection::RequestInformation(
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
      const auto frame = this->Internals->MakeFrame(this, gatun::VolumePlace(*volume));
      std::copy_n(frame.Spacing.begin(), 2, spacing);
      std::copy_n(frame.First.begin(), 2, origin);
    }
  }
  catch (...)
  {
    // RequestData tells what is wrong.
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
int vtkHartleyProjection::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const info = inputs[0]->GetInformationObject(0);
  if (GetReader(this->FindProducer()))
  {
    // Even then what the reader has made already stays.
    const int nothing[6] = { 0, -1, 0, -1, 0, -1 };
    info->Set(Pipeline::UPDATE_EXTENT(), nothing, 6);
  }
  else if (info->Has(Pipeline::WHOLE_EXTENT()))
  {
    // Some filters in between pass on pieces only.
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  return 1;
}

//------------------------------------------------------------------------------
// What is asked for of the picture. After a failure, that may be more than there is.
std::array<int, 6> vtkHartleyProjection::vtkInternals::GetPart(
  const vtkHartleyProjection* self, vtkInformation* outInfo)
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
int vtkHartleyProjection::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* const outInfo = outputs->GetInformationObject(0);
  vtkImageData* const output = vtkImageData::GetData(outInfo);
  this->SetErrorCode(vtkErrorCode::NoError);
  auto& self = *this->Internals;
  vtkHartleyVolumeReader* const reader = GetReader(this->FindProducer());
  try
  {
    output->Initialize();
    // Compressing takes longer than drawing.
    const auto progressFrom = [this](double first, double last)
    {
      return [this, first, last](double fraction)
      {
        this->UpdateProgress(first + (last - first) * fraction);
        return !gatun::IsAborted(this);
      };
    };
    double first = 0;
    const bool isNew = reader
      ? self.OpenFile(reader->GetFileName())
      : self.Compress(this, vtkImageData::GetData(inputs[0], 0), progressFrom(0, 0.7));
    if (isNew)
    {
      ++this->NumberOfVolumes;
      first = reader ? 0 : 0.7;
    }
    const gatun::VolumePlace place(self.Volume);
    const gatun::HartleyFrame frame = self.MakeFrame(this, place);
    const gatun::HartleyShading shading = self.MakeShading(this, place);
    self.MakeProjector(this);
    self.Picture = self.Projector->Draw(frame.View, shading, progressFrom(first, 1));
    gatun::PictureOutput options;
    options.Floats = this->OutputFloats;
    if (this->UseBackground)
    {
      options.Background = { this->Background[0], this->Background[1], this->Background[2] };
    }
    gatun::FillImage(self.Picture, options, vtkInternals::GetPart(this, outInfo), output);
    output->SetOrigin(frame.First[0], frame.First[1], 0);
    output->SetSpacing(frame.Spacing[0], frame.Spacing[1], 1);
    self.Picture.Colours = {};
    self.Picture.Sums = {};
    self.Picture.Samples = {};
    this->UpdateProgress(1);
    return 1;
  }
  catch (...)
  {
    output->Initialize();
    const gatun::VTKFailure failure =
      gatun::DescribeFailure(reader ? reader->GetFileName() : "The volume cannot be drawn");
    this->SetErrorCode(failure.Code);
    if (!failure.Aborted)
    {
      vtkErrorMacro(<< failure.Message);
      self.Forget();
    }
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkHartleyProjection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const laws[] = { "XRay", "Exponential", "TransferFunction" };
  const char* const goals[] = { "Quality", "Error", "PSNR", "Rate" };
  const char* const methods[] = { "Automatic", "Basis", "Slice" };
  const char* const kernels[] = { "KaiserBessel", "Trilinear" };
  const auto tell = [](bool value) { return value ? "On" : "Off"; };
  const auto triple = [](const double* value)
  {
    return std::to_string(value[0]) + " " + std::to_string(value[1]) + " " +
      std::to_string(value[2]);
  };
  os << indent << "Camera: " << this->Internals->Camera.Get() << "\n";
  os << indent << "ViewDirection: " << triple(this->ViewDirection) << "\n";
  os << indent << "ViewUp: " << triple(this->ViewUp) << "\n";
  os << indent << "Zoom: " << this->Zoom << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "Law: " << laws[this->Law] << "\n";
  os << indent << "Property: " << this->Internals->Property.Get() << "\n";
  os << indent << "Extinction: " << this->Extinction << "\n";
  os << indent << "UseZero: " << tell(this->UseZero) << "\n";
  os << indent << "Zero: " << this->Zero << "\n";
  os << indent << "Window: " << this->Window[0] << " " << this->Window[1] << "\n";
  os << indent << "UseBackground: " << tell(this->UseBackground) << "\n";
  os << indent << "Background: " << triple(this->Background) << "\n";
  os << indent << "OutputFloats: " << tell(this->OutputFloats) << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "BlockSize: " << this->BlockSize << "\n";
  os << indent << "Goal: " << goals[this->Goal] << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "PSNR: " << this->PSNR << "\n";
  os << indent << "Rate: " << this->Rate << "\n";
  os << indent << "FrequencyWeight: " << this->FrequencyWeight << "\n";
  os << indent << "Method: " << methods[this->Method] << "\n";
  os << indent << "Kernel: " << kernels[this->Kernel] << "\n";
  os << indent << "Padding: " << this->Padding << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
  os << indent << "NumberOfVolumes: " << this->NumberOfVolumes << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
