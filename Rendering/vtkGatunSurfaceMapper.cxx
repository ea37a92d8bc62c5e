// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunSurfaceMapper.h"

#include "gatunErrorCodes.h"
#include "vtkGatunSurfaceMapperInternals.h"

#include "vtkErrorCode.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"

#include <algorithm>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunSurfaceMapper);

//------------------------------------------------------------------------------
vtkGatunSurfaceMapper::vtkGatunSurfaceMapper()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkGatunSurfaceMapper::~vtkGatunSurfaceMapper() = default;

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::SetMemoryBudget(int mebibytes)
{
  this->MemoryBudget = std::max(0, mebibytes);
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::SetJustInTime(bool on)
{
  this->JustInTime = on;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::SetTimeBudget(double seconds)
{
  // Not a number becomes 0.
  this->TimeBudget = seconds > 0 ? std::min(seconds, 1e6) : 0;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::SetSimplificationRatio(double ratio)
{
  this->SimplificationRatio = ratio > 0 ? std::min(ratio, 1.0) : 0;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::SetViewDependent(bool on)
{
  this->ViewDependent = on;
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::SetPixelError(double pixels)
{
  if (pixels >= 0)
  {
    this->PixelError = pixels;
  }
  else
  {
    vtkErrorMacro(<< "PixelError must be 0 or more; " << pixels << " is ignored");
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunSurfaceMapper::GetNumberOfDrawnPoints()
{
  return this->Internals->GetDrawnPoints();
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::WaitForPreparation()
{
  this->Internals->Wait();
}

//------------------------------------------------------------------------------
bool vtkGatunSurfaceMapper::GetIsDrawingFile()
{
  return this->Internals->IsDrawingFile();
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkGatunSurfaceMapper::GetBufferBytes()
{
  return this->Internals->GetBytes();
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunSurfaceMapper::GetNumberOfDrawnChunks()
{
  return this->Internals->Drawn;
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunSurfaceMapper::GetNumberOfCulledChunks()
{
  return this->Internals->Culled;
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunSurfaceMapper::GetNumberOfDecodedChunks()
{
  return this->Internals->Decoded;
}

//------------------------------------------------------------------------------
double* vtkGatunSurfaceMapper::GetBounds()
{
  double* const bounds = this->Superclass::GetBounds();
  if (const gatun::PublishedFile* const file = vtkInternals::FindFile(this))
  {
    vtkInternals::GetBounds(*file, this->GetInputInformation(), bounds);
  }
  return bounds;
}

//------------------------------------------------------------------------------
/** Reports what is being thrown. */
void vtkGatunSurfaceMapper::Fail() noexcept
{
  try
  {
    const gatun::VTKFailure failure = gatun::DescribeFailure("The surface cannot be drawn");
    this->SetErrorCode(failure.Code);
    if (!failure.Aborted && this->Internals->Reported.insert(failure.Message).second)
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
void vtkGatunSurfaceMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  auto& self = *this->Internals;
  this->SetErrorCode(vtkErrorCode::NoError);
  bool isFile = false;
  try
  {
    isFile = self.Open(this, actor);
    if (isFile)
    {
      self.Draw(this, renderer, actor);
      if (self.Failure)
      {
        std::rethrow_exception(self.Failure);
      }
      self.Reported.clear();
    }
  }
  catch (...)
  {
    isFile = true;
    this->Fail();
  }
  if (!isFile)
  {
    this->Superclass::RenderPiece(renderer, actor);
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::ProposeLevels(vtkRenderer* renderer, vtkActor* actor, int levels[2])
{
  levels[0] = levels[1] = -1;
  try
  {
    if (renderer && actor && this->Internals->Open(this, actor))
    {
      const auto proposal = this->Internals->Propose(this, renderer, actor);
      levels[0] = proposal.Wanted;
      levels[1] = proposal.Shown;
    }
  }
  catch (...)
  {
    // RenderPiece fails, too, and tells the error.
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::SetLevels(const int levels[2])
{
  this->Internals->Shared = vtkInternals::LevelChoice{ levels[0], levels[1] };
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::ResetLevels()
{
  this->Internals->Shared.reset();
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& pixels, vtkProp* prop)
{
  if (!this->Internals->IsDrawingFile())
  {
    this->Superclass::ProcessSelectorPixelBuffers(selector, pixels, prop);
    return;
  }
  try
  {
    this->Internals->ProcessSelection(selector, pixels, prop);
  }
  catch (...)
  {
    this->Fail();
  }
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkGatunSurfaceMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
  os << indent << "JustInTime: " << (this->JustInTime ? "on" : "off") << "\n";
  os << indent << "TimeBudget: " << this->TimeBudget << "\n";
  os << indent << "SimplificationRatio: " << this->SimplificationRatio << "\n";
  os << indent << "ViewDependent: " << (this->ViewDependent ? "on" : "off") << "\n";
  os << indent << "PixelError: " << this->PixelError << "\n";
  os << indent << "IsDrawingFile: " << (this->GetIsDrawingFile() ? "true" : "false") << "\n";
  os << indent << "BufferBytes: " << this->GetBufferBytes() << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
