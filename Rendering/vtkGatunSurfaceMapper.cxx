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
void vtkGatunSurfaceMapper::SetDetailPolicy(vtkGatunDetailPolicy* policy)
{
  this->Internals->Policy.Set(policy);
}

//------------------------------------------------------------------------------
vtkGatunDetailPolicy* vtkGatunSurfaceMapper::GetDetailPolicy()
{
  return this->Internals->Policy.Get();
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunSurfaceMapper::GetStatistics()
{
  auto& self = *this->Internals;
  self.Statistics.Clear();
  self.Statistics.Add("DrawnPoints", self.GetDrawnPoints());
  self.Statistics.Add("DrawnChunks", self.Drawn);
  self.Statistics.Add("CulledChunks", self.Culled);
  self.Statistics.Add("DecodedChunks", self.Decoded);
  self.Statistics.Add("BufferBytes", self.GetBytes());
  return self.Statistics.Get();
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
  os << indent << "DetailPolicy:\n";
  this->GetDetailPolicy()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "IsDrawingFile: " << (this->GetIsDrawingFile() ? "true" : "false") << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
