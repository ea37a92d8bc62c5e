// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunVolumeMapper.h"

#include "gatunErrorCodes.h"
#include "gatunProcessExchange.h"
#include "vtkGatunVolumeMapperInternals.h"

#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunVolumeMapper);

using gatun::InputKind;

namespace
{
// One numbering for all classes that draw.
static_assert(int{ vtkGatunVolumeMapper::COMPOSITE_BLEND } == gatun::CompositeBlend);
static_assert(int{ vtkGatunVolumeMapper::MAXIMUM_INTENSITY_BLEND } == gatun::MaximumIntensityBlend);
static_assert(int{ vtkGatunVolumeMapper::XRAY_BLEND } == gatun::XRayBlend);

//------------------------------------------------------------------------------
void ToArray(const gatun::Bounds& box, double* bounds)
{
  vtkMath::UninitializeBounds(bounds);
  if (box[0].Min <= box[0].Max)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = box[axis].Min;
      bounds[2 * axis + 1] = box[axis].Max;
    }
  }
}
}

//------------------------------------------------------------------------------
vtkGatunVolumeMapper::vtkGatunVolumeMapper()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkGatunVolumeMapper::~vtkGatunVolumeMapper()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->Controller)
  {
    vtkSetObjectBodyMacro(Controller, vtkMultiProcessController, controller);
    this->Internals->WholeBounds.reset();
  }
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::ReduceBounds()
{
  this->Internals->WholeBounds.reset();
  if (!vtkInternals::IsParallel(this))
  {
    return;
  }
  try
  {
    std::array<double, 6> own{};
    std::copy_n(this->GetBounds(), own.size(), own.begin());
    gatun::ProcessExchange exchange(this->Controller);
    this->Internals->WholeBounds = gatun::JoinBounds(exchange.Gather(own));
  }
  catch (...)
  {
    this->Fail();
  }
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunVolumeMapper::GetStatistics()
{
  auto& self = *this->Internals;
  self.Statistics.Clear();
  self.Statistics.Add("BytesRead", self.Input.GetScene().GetBytesRead());
  self.Statistics.Add("BytesSent", self.BytesSent);
  self.Statistics.Add("DrawnPoints", self.Points);
  self.Statistics.Add("RedrawnFraction", self.Image.GetRedrawnFraction());
  return self.Statistics.Get();
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::SetDetailPolicy(vtkGatunDetailPolicy* policy)
{
  if (this->Internals->Policy.Set(policy))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkGatunDetailPolicy* vtkGatunVolumeMapper::GetDetailPolicy()
{
  return this->Internals->Policy.Get();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGatunVolumeMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->GetDetailPolicy()->GetMTime());
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::SetBlendMode(int mode)
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
bool vtkGatunVolumeMapper::PrepareSimplification()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    const auto progress = [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return this->GetAbortExecute() == 0;
    };
    auto& self = *this->Internals;
    gatun::LevelOfDetailCache* const levels = self.Simplifies(this) && self.SetScene(this, progress)
      ? self.Input.GetScene().GetLevels()
      : nullptr;
    if (!levels)
    {
      return false;
    }
    levels->WaitForLevels(progress);
    levels->Wait();
    this->UpdateProgress(1);
    return true;
  }
  catch (...)
  {
    this->Fail();
    return false;
  }
}

//------------------------------------------------------------------------------
/** Reports what is being thrown. */
void vtkGatunVolumeMapper::Fail() noexcept
{
  try
  {
    const gatun::VTKFailure failure = gatun::DescribeFailure("The mesh cannot be drawn");
    this->SetErrorCode(failure.Code);
    if (failure.Aborted)
    {
      return;
    }
    auto& self = *this->Internals;
    self.Input.GetScene().Clear();
    const auto input = vtkInternals::GetConnection(this);
    if (self.Reported.insert(self.Input.GetCause(input, failure)).second)
    {
      vtkErrorMacro(<< failure.Message);
    }
  }
  catch (...)
  {
    // No memory for a message, or an observer of errors that throws.
    this->SetErrorCode(vtkErrorCode::UnknownError);
  }
}

//------------------------------------------------------------------------------
double* vtkGatunVolumeMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  auto& self = *this->Internals;
  if (self.WholeBounds)
  {
    std::copy(self.WholeBounds->begin(), self.WholeBounds->end(), this->Bounds);
    return this->Bounds;
  }
  try
  {
    const gatun::MapperConnection input = vtkInternals::GetConnection(this);
    switch (self.Input.GetKind(input))
    {
      case InputKind::None:
        break;
      case InputKind::Grid:
        return this->Superclass::GetBounds();
      case InputKind::File:
        ToArray(self.Input.GetFileBounds(input), this->Bounds);
        break;
      case InputKind::Pieces:
        self.SetScene(this, {});
        ToArray(self.Input.GetScene().GetPieceBounds(), this->Bounds);
        break;
    }
  }
  catch (...)
  {
    this->Fail();
  }
  return this->Bounds;
}

//------------------------------------------------------------------------------
vtkDataSet* vtkGatunVolumeMapper::GetDataSetInput()
{
  const auto input = vtkInternals::GetConnection(this);
  return this->Internals->Input.GetKind(input) == InputKind::Grid
    ? this->Superclass::GetDataSetInput()
    : nullptr;
}

//------------------------------------------------------------------------------
VTK_GATUN_UPDATE_RESULT vtkGatunVolumeMapper::Update()
{
  return static_cast<VTK_GATUN_UPDATE_RESULT>(this->Update(0));
}

//------------------------------------------------------------------------------
VTK_GATUN_UPDATE_RESULT vtkGatunVolumeMapper::Update(int port)
{
  return static_cast<VTK_GATUN_UPDATE_RESULT>(this->Update(port, nullptr));
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGatunVolumeMapper::Update(int, vtkInformationVector*)
{
  try
  {
    this->Internals->Input.Pull(vtkInternals::GetConnection(this));
    return 1;
  }
  catch (...)
  {
    this->Fail();
    return 0;
  }
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGatunVolumeMapper::Update(vtkInformation*)
{
  return this->Update(0, nullptr);
}

//------------------------------------------------------------------------------
VTK_GATUN_UPDATE_RESULT vtkGatunVolumeMapper::UpdateWholeExtent()
{
  return static_cast<VTK_GATUN_UPDATE_RESULT>(this->Update(0));
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  this->TimeToDraw = 0;
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    this->Internals->Draw(this, renderer, volume);
    this->Internals->Reported.clear();
  }
  catch (...)
  {
    this->Fail();
  }
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Image.Release(window);
}

//------------------------------------------------------------------------------
void vtkGatunVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto tell = [](auto value) { return value ? "On" : "Off"; };
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "AutoAdjustSampleDistances: " << tell(this->AutoAdjustSampleDistances) << "\n";
  os << indent << "MinimumImageSampleDistance: " << this->MinimumImageSampleDistance << "\n";
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << "\n";
  os << indent << "IntermixIntersectingGeometry: " << tell(this->IntermixIntersectingGeometry)
     << "\n";
  os << indent << "ArrayComponent: " << this->ArrayComponent << "\n";
  os << indent << "OpacityLimit: " << this->OpacityLimit << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
  os << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
  os << indent << "DetailPolicy:\n";
  this->GetDetailPolicy()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "ImageProcess: " << this->ImageProcess << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
