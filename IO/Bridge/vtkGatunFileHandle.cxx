// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunFileHandle.h"

#include "gatunFileReader.h"
#include "gatunFileSettings.h"
#include "gatunPublishedFile.h"
#include "gatunReport.h"

#include "vtkInformationObjectBaseKey.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <exception>
#include <map>
#include <mutex>
#include <utility>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunFileHandle);

// NeedToExecute, StoreMetaData and CopyDefaultInformation of the key are those of its superclass,
// which do nothing. A handle is no request: it makes nobody execute, it is not kept with data, and
// no filter gets it that does not copy it.
vtkInformationKeyRestrictedMacro(vtkGatunFileHandle, FILE_HANDLE, ObjectBase, "vtkGatunFileHandle");

//------------------------------------------------------------------------------
class vtkGatunFileHandle::vtkInternals
{
public:
  gatun::PublishedFile First;
  gatun::FileSettings Settings;
  std::mutex Guard; // of the other meshes, by their numbers
  std::map<std::size_t, gatun::PublishedFile> Others;
};

//------------------------------------------------------------------------------
vtkGatunFileHandle::vtkGatunFileHandle()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkGatunFileHandle::~vtkGatunFileHandle() = default;

//------------------------------------------------------------------------------
const char* vtkGatunFileHandle::GetFileName()
{
  return this->Internals->First.Path.c_str();
}

//------------------------------------------------------------------------------
bool vtkGatunFileHandle::GetIsOpen()
{
  return this->Internals->First.File != nullptr;
}

//------------------------------------------------------------------------------
const char* vtkGatunFileHandle::GetReason()
{
  return this->Internals->First.Reason.c_str();
}

//------------------------------------------------------------------------------
bool vtkGatunFileHandle::GetCanReplaceOutput()
{
  return this->Internals->First.CanReplaceOutput();
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunFileHandle::GetNumberOfPoints()
{
  const auto& file = this->Internals->First.File;
  return file ? static_cast<vtkIdType>(file->GetFile()->GetNumberOfPoints()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunFileHandle::GetNumberOfTetrahedra()
{
  const auto& file = this->Internals->First.File;
  return file ? static_cast<vtkIdType>(file->GetFile()->GetNumberOfTets()) : 0;
}

//------------------------------------------------------------------------------
void vtkGatunFileHandle::GetBounds(double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  if (const auto& file = this->Internals->First.File)
  {
    const gatun::Bounds& box = file->GetFile()->GetBounds();
    for (std::size_t axis = 0; axis < 3 && box[0].Min <= box[0].Max; ++axis)
    {
      bounds[2 * axis] = box[axis].Min;
      bounds[2 * axis + 1] = box[axis].Max;
    }
  }
}

//------------------------------------------------------------------------------
bool vtkGatunFileHandle::GetHasHierarchy()
{
  const auto& file = this->Internals->First.File;
  return file && file->GetFile()->HasMergeTree();
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunFileHandle::GetNumberOfMerges()
{
  return static_cast<vtkIdType>(this->Internals->First.Merges);
}

//------------------------------------------------------------------------------
bool vtkGatunFileHandle::GetIsOnDemand()
{
  return this->Internals->First.OnDemand;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkGatunFileHandle::GetMemory()
{
  const auto& file = this->Internals->First.File;
  return file ? file->GetBudget()->GetStatistics().Bytes : 0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkGatunFileHandle::GetMemoryBudget()
{
  const auto& file = this->Internals->First.File;
  return file ? file->GetBudget()->GetBytes() : 0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkGatunFileHandle::GetBytesRead()
{
  const auto& file = this->Internals->First.File;
  return file ? file->GetBytesRead() : 0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkGatunFileHandle::GetDecodedChunks()
{
  const auto& file = this->Internals->First.File;
  return file ? file->GetStatistics().MeshesDecoded : 0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkGatunFileHandle::GetFoundChunks()
{
  const auto& file = this->Internals->First.File;
  return file ? file->GetStatistics().MeshesFound : 0;
}

//------------------------------------------------------------------------------
const gatun::PublishedFile& vtkGatunFileHandle::GetContents() const
{
  return this->Internals->First;
}

//------------------------------------------------------------------------------
const gatun::PublishedFile& vtkGatunFileHandle::GetContents(double time) const
{
  vtkInternals& self = *this->Internals;
  const std::size_t mesh = self.First.File ? gatun::FindMesh(*self.First.File->GetFile(), time) : 0;
  if (mesh == 0)
  {
    return self.First;
  }
  const std::lock_guard<std::mutex> lock(self.Guard);
  const auto [place, isNew] = self.Others.try_emplace(mesh);
  if (isNew)
  {
    try
    {
      place->second = self.Settings.Describe(self.First.File->GetMesh(mesh));
    }
    catch (...)
    {
      place->second.Path = self.First.Path;
      place->second.Failure = std::current_exception();
      place->second.Reason = gatun::DescribeFailure(self.First.Path.c_str()).Message;
    }
  }
  return place->second;
}

//------------------------------------------------------------------------------
void vtkGatunFileHandle::SetContents(gatun::PublishedFile&& failure)
{
  this->Internals->First = std::move(failure);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGatunFileHandle::SetContents(
  const std::shared_ptr<gatun::SharedFile>& file, const gatun::FileSettings& settings)
{
  this->Internals->First = settings.Describe(file);
  this->Internals->Settings = settings;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGatunFileHandle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->GetFileName() << "\n";
  os << indent << "IsOpen: " << (this->GetIsOpen() ? "true" : "false") << "\n";
  os << indent << "Reason: " << this->GetReason() << "\n";
  os << indent << "NumberOfPoints: " << this->GetNumberOfPoints() << "\n";
  os << indent << "NumberOfTetrahedra: " << this->GetNumberOfTetrahedra() << "\n";
  os << indent << "NumberOfMerges: " << this->GetNumberOfMerges() << "\n";
  os << indent << "IsOnDemand: " << (this->GetIsOnDemand() ? "true" : "false") << "\n";
  os << indent << "Memory: " << this->GetMemory() << "\n";
  os << indent << "MemoryBudget: " << this->GetMemoryBudget() << "\n";
  os << indent << "BytesRead: " << this->GetBytesRead() << "\n";
  os << indent << "DecodedChunks: " << this->GetDecodedChunks() << "\n";
  os << indent << "FoundChunks: " << this->GetFoundChunks() << "\n";
}
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
