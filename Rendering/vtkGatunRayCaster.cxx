// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunRayCaster.h"

#include "gatunDetailSettings.h"
#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunFileConsumer.h"
#include "gatunFileReader.h"
#include "gatunImagePipeline.h"
#include "gatunJustInTime.h"
#include "gatunNewArray.h"
#include "gatunOwned.h"
#include "gatunRayCaster.h"
#include "gatunRayRendering.h"
#include "gatunRayScene.h"
#include "gatunReport.h"
#include "gatunStatistics.h"
#include "vtkGatunCompat.h"

#include "vtkCamera.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <chrono>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunRayCaster);

// One numbering for all classes that draw.
static_assert(int{ vtkGatunRayCaster::COMPOSITE_BLEND } == gatun::CompositeBlend);
static_assert(int{ vtkGatunRayCaster::MAXIMUM_INTENSITY_BLEND } == gatun::MaximumIntensityBlend);
static_assert(int{ vtkGatunRayCaster::XRAY_BLEND } == gatun::XRayBlend);

//------------------------------------------------------------------------------
class vtkGatunRayCaster::vtkPipeline : public gatun::ImagePipeline
{
public:
  static vtkPipeline* New();
  vtkTypeMacro(vtkPipeline, gatun::ImagePipeline);

protected:
  void NoteFailure() override
  {
    auto* const caster = vtkGatunRayCaster::SafeDownCast(this->GetAlgorithm());
    if (caster && caster->GetErrorCode() == vtkErrorCode::NoError)
    {
      caster->SetErrorCode(vtkErrorCode::UnknownError);
    }
  }
};

vtkStandardNewMacro(vtkGatunRayCaster::vtkPipeline);

//------------------------------------------------------------------------------
class vtkGatunRayCaster::vtkInternals
{
public:
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkVolumeProperty> Property;
  vtkSmartPointer<vtkMatrix4x4> VolumeMatrix;
  vtkSmartPointer<vtkPlaneCollection> ClippingPlanes;
  gatun::RayScene Scene;
  gatun::JustInTime Frames;
  gatun::Owned<vtkGatunDetailPolicy> Policy;
  gatun::RayStatistics Counts; // of the last image
  std::uint64_t Points = 0;    // of the last image
  gatun::Statistics Statistics;

  void Draw(gatun::FrameRequest request, gatun::RayCaster& caster, const gatun::RayView& view,
    const gatun::RaySource::Progress& progress);
};

//------------------------------------------------------------------------------
vtkGatunRayCaster::vtkGatunRayCaster()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetNumberOfInputPorts(1);
}

//------------------------------------------------------------------------------
vtkGatunRayCaster::~vtkGatunRayCaster()
{
  this->SetArrayName(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunRayCaster::SetBlendMode(int mode)
{
  if (!gatun::RayModeOf(mode))
  {
    vtkErrorMacro("Blend mode " << mode << " is not supported.");
  }
  else if (mode != this->BlendMode)
  {
    this->BlendMode = mode;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGatunRayCaster::SetSize(int width, int height)
{
  constexpr int most = 32000;
  width = std::clamp(width, 1, most);
  height = std::clamp(height, 1, most);
  if (width != this->Size[0] || height != this->Size[1])
  {
    this->Size[0] = width;
    this->Size[1] = height;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGatunRayCaster::SetCamera(vtkCamera* camera)
{
  if (camera != this->Internals->Camera)
  {
    this->Internals->Camera = camera;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCamera* vtkGatunRayCaster::GetCamera()
{
  return this->Internals->Camera;
}

//------------------------------------------------------------------------------
void vtkGatunRayCaster::SetProperty(vtkVolumeProperty* property)
{
  if (property != this->Internals->Property)
  {
    this->Internals->Property = property;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkVolumeProperty* vtkGatunRayCaster::GetProperty()
{
  return this->Internals->Property;
}

//------------------------------------------------------------------------------
void vtkGatunRayCaster::SetVolumeMatrix(vtkMatrix4x4* matrix)
{
  if (matrix != this->Internals->VolumeMatrix)
  {
    this->Internals->VolumeMatrix = matrix;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkGatunRayCaster::GetVolumeMatrix()
{
  return this->Internals->VolumeMatrix;
}

//------------------------------------------------------------------------------
void vtkGatunRayCaster::SetClippingPlanes(vtkPlaneCollection* planes)
{
  if (planes != this->Internals->ClippingPlanes)
  {
    this->Internals->ClippingPlanes = planes;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPlaneCollection* vtkGatunRayCaster::GetClippingPlanes()
{
  return this->Internals->ClippingPlanes;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGatunRayCaster::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  const auto include = [&](vtkObject* object)
  {
    if (object)
    {
      time = std::max(time, object->GetMTime());
    }
  };
  include(this->Internals->Camera);
  include(this->Internals->Property);
  include(this->Internals->VolumeMatrix);
  include(this->Internals->ClippingPlanes);
  include(this->Internals->Policy.Get());
  return time;
}

//------------------------------------------------------------------------------
void vtkGatunRayCaster::SetDetailPolicy(vtkGatunDetailPolicy* policy)
{
  if (this->Internals->Policy.Set(policy))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkGatunDetailPolicy* vtkGatunRayCaster::GetDetailPolicy()
{
  return this->Internals->Policy.Get();
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunRayCaster::GetStatistics()
{
  const gatun::RayStatistics& s = this->Internals->Counts;
  gatun::Statistics& table = this->Internals->Statistics;
  table.Clear();
  table.Add("FetchSeconds", s.FetchTime);
  table.Add("SimplifySeconds", s.SimplifyTime);
  table.Add("OrderSeconds", s.OrderTime);
  table.Add("SetUpSeconds", s.SetUpTime);
  table.Add("DrawSeconds", s.DrawTime);
  table.Add("FinishSeconds", s.FinishTime);
  table.Add("DrawnChunks", s.Blocks);
  table.Add("SkippedChunks", s.SkippedBlocks);
  table.Add("DrawnTetrahedra", s.Tets);
  table.Add("SeenTetrahedra", s.SeenTets);
  table.Add("DrawnPoints", this->Internals->Points);
  table.Add("MostWaitingTetrahedra", s.MostWaiting);
  table.Add("MostFragments", s.MostFragments);
  table.Add("MostBytes", s.MostBytes);
  return table.Get();
}

//------------------------------------------------------------------------------
vtkExecutive* vtkGatunRayCaster::CreateDefaultExecutive()
{
  return vtkPipeline::New();
}

//------------------------------------------------------------------------------
int vtkGatunRayCaster::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunRayCaster::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* const info = outputs->GetInformationObject(0);
  const int extent[6] = { 0, this->Size[0] - 1, 0, this->Size[1] - 1, 0, 0 };
  const double spacing[3] = { 1, 1, 1 };
  const double origin[3] = { 0, 0, 0 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 4);
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunRayCaster::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const info = inputs[0]->GetInformationObject(0);
  if (gatun::GetUsableFile(info))
  {
    gatun::RequestNothing(info);
    return 1;
  }
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  return 1;
}

//------------------------------------------------------------------------------
/** Draws the mesh, or a coarser one. */
void vtkGatunRayCaster::vtkInternals::Draw(gatun::FrameRequest request, gatun::RayCaster& caster,
  const gatun::RayView& view, const gatun::RaySource::Progress& progress)
{
  gatun::LevelOfDetailCache* const levels = this->Scene.GetLevels();
  if (!levels)
  {
    this->Scene.Draw(caster, view, progress);
    return;
  }
  levels->WaitForLevels(progress);
  const gatun::Frame frame = this->Frames.Begin(*levels, request, progress);
  const auto start = std::chrono::steady_clock::now();
  this->Scene.Draw(caster, view, progress, frame.Source.get());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  this->Frames.End(
    *levels, frame, request.Pixels, caster.GetStatistics(), { seconds.count(), seconds.count() });
  this->Points = frame.Points;
}

//------------------------------------------------------------------------------
int vtkGatunRayCaster::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* const image = vtkImageData::GetData(outputs, 0);
  vtkInformation* const inInfo = inputs[0]->GetInformationObject(0);
  image->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  auto& self = *this->Internals;
  self.Counts = {};
  self.Points = 0;
  const gatun::PublishedFile* const file = gatun::GetUsableFile(inInfo);
  try
  {
    if (!self.Camera || !self.Property)
    {
      throw gatun::Error(gatun::ErrorCode::InvalidInput,
        self.Camera ? "no property with colors is set" : "no camera is set");
    }
    gatun::RequireNumber("OpacityLimit", this->OpacityLimit);
    const gatun::DetailSettings detail(self.Policy.Get());
    gatun::FrameRequest request;
    request.Budget = detail.JustInTime ? detail.TimeBudget : 0;
    request.Ratio = detail.Ratio;
    request.Pixels = static_cast<double>(this->Size[0]) * this->Size[1];
    request.Waits = true;
    const gatun::RayMode mode = *gatun::RayModeOf(this->BlendMode);
    const auto view = gatun::MakeRayView(
      self.Camera, gatun::RayGrid{ this->Size[0], this->Size[1] }, self.VolumeMatrix, false);
    const gatun::RayArray array{ this->ArrayName ? this->ArrayName : "", this->ArrayAssociation,
      this->ArrayComponent, {} };
    request.Merges = file ? file->Merges : 0;
    const bool simplifies =
      detail.Ratio > 0 || request.Merges > 0 || request.Budget > 0 || detail.PixelError > 0;
    if (file)
    {
      const auto step = gatun::GetRequestedStep(*file->File->GetFile(), inInfo);
      self.Scene.SetFile(*file, step, array, simplifies);
    }
    else
    {
      const auto budget = static_cast<std::uint64_t>(this->MemoryBudget) << 20;
      self.Scene.SetGrid(vtkUnstructuredGrid::GetData(inInfo), array, budget, simplifies);
    }
    if (!self.Scene.GetReason().empty())
    {
      gatun::ThrowInvalid(self.Scene.GetReason());
    }
    const auto progress = [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return !gatun::IsAborted(this);
    };

    gatun::RaySettings settings;
    settings.Opaque = static_cast<float>(this->OpacityLimit);
    settings.Shading =
      gatun::MakeRayShading(self.Property, self.Camera, nullptr, self.VolumeMatrix);
    const auto table =
      gatun::MakeRayTable(self.Property, mode, self.Scene.GetRange(), view.SampleDistance);
    gatun::RayCaster caster(
      view, table, gatun::MakeRayLimits(view, self.ClippingPlanes, self.VolumeMatrix), settings);
    if ((request.Budget > 0 && detail.ViewDependent) || detail.PixelError > 0)
    {
      request.View = gatun::MakeDetailView(detail.PixelError, view, table);
    }
    self.Draw(std::move(request), caster, view, progress);

    image->SetDimensions(this->Size[0], this->Size[1], 1);
    vtkNew<vtkFloatArray> colors;
    colors->SetName("RGBA");
    colors->SetNumberOfComponents(4);
    gatun::SizeArray(colors, image->GetNumberOfPoints());
    vtkNew<vtkFloatArray> depths;
    depths->SetName("Depth");
    gatun::SizeArray(depths, image->GetNumberOfPoints());
    caster.Finish(colors->GetPointer(0), depths->GetPointer(0));
    image->GetPointData()->SetScalars(colors);
    image->GetPointData()->AddArray(depths);
    self.Counts = caster.GetStatistics();
    return 1;
  }
  catch (...)
  {
    image->Initialize();
    const gatun::VTKFailure failure = gatun::DescribeFailure("The mesh cannot be drawn");
    this->SetErrorCode(failure.Code);
    gatun::ReportFailure(this, failure, nullptr);
    self.Scene.Clear();
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkGatunRayCaster::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BlendMode: " << this->BlendMode << "\n";
  os << indent << "Camera: " << this->Internals->Camera.Get() << "\n";
  os << indent << "Property: " << this->Internals->Property.Get() << "\n";
  os << indent << "VolumeMatrix: " << this->Internals->VolumeMatrix.Get() << "\n";
  os << indent << "ClippingPlanes: " << this->Internals->ClippingPlanes.Get() << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "ArrayName: " << (this->ArrayName ? this->ArrayName : "(none)") << "\n";
  os << indent << "ArrayAssociation: " << this->ArrayAssociation << "\n";
  os << indent << "ArrayComponent: " << this->ArrayComponent << "\n";
  os << indent << "OpacityLimit: " << this->OpacityLimit << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
  os << indent << "DetailPolicy:\n";
  this->GetDetailPolicy()->PrintSelf(os, indent.GetNextIndent());
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
