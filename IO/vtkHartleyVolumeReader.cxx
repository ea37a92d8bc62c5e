// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHartleyVolumeReader.h"

#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunFileInput.h"
#include "gatunHartleyFile.h"
#include "gatunVolumeBridge.h"
#include "vtkGatunCompat.h"
#include "vtkGatunErrorCode.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <array>
#include <new>
#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkHartleyVolumeReader);

//------------------------------------------------------------------------------
class vtkHartleyVolumeReader::vtkInternals
{
public:
  gatun::CurrentFileOf<gatun::HartleyFile> File;

  // Bumped when the file changed on disk, or when what was read last must not be kept.
  vtkTimeStamp FileTime;
  bool ReadAgain = false;

  const gatun::HartleyFile* Get() const { return this->File.GetLast().get(); }

  double CountVoxels() const
  {
    double voxels = 0;
    if (const gatun::HartleyFile* const file = this->Get())
    {
      const auto& size = file->GetLayout().Size;
      voxels = static_cast<double>(size[0]) * size[1] * size[2];
    }
    return voxels;
  }
};

//------------------------------------------------------------------------------
vtkHartleyVolumeReader::vtkHartleyVolumeReader()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHartleyVolumeReader::~vtkHartleyVolumeReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkHartleyVolumeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "BlockSize: " << this->GetBlockSize() << "\n";
  os << indent << "Goal: " << this->GetGoal() << "\n";
  os << indent << "GoalValue: " << this->GetGoalValue() << "\n";
  os << indent << "Lossless: " << (this->GetLossless() ? "true" : "false") << "\n";
  os << indent << "NumberOfBlocks: " << this->GetNumberOfBlocks() << "\n";
  os << indent << "NumberOfChunks: " << this->GetNumberOfChunks() << "\n";
  os << indent << "FileBytes: " << this->GetFileBytes() << "\n";
  os << indent << "BitsPerVoxel: " << this->GetBitsPerVoxel() << "\n";
  os << indent << "BytesRead: " << this->GetBytesRead() << "\n";
}

//------------------------------------------------------------------------------
int vtkHartleyVolumeReader::CanReadFile(const char* name)
{
  try
  {
    return name && gatun::HartleyFile::CanRead(name) ? 1 : 0;
  }
  catch (const std::bad_alloc&)
  {
    return 0; // there is not even memory for the name
  }
}

//------------------------------------------------------------------------------
int vtkHartleyVolumeReader::GetBlockSize()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file && !file->GetLayout().IsWhole() ? static_cast<int>(file->GetLayout().Block[0]) : 0;
}

//------------------------------------------------------------------------------
int vtkHartleyVolumeReader::GetGoal()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? static_cast<int>(file->GetQuality().Kind) : 0;
}

//------------------------------------------------------------------------------
double vtkHartleyVolumeReader::GetGoalValue()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? file->GetQuality().Value : 0;
}

//------------------------------------------------------------------------------
bool vtkHartleyVolumeReader::GetLossless()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file && file->IsLossless();
}

//------------------------------------------------------------------------------
vtkIdType vtkHartleyVolumeReader::GetNumberOfBlocks()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? static_cast<vtkIdType>(file->GetLayout().GetNumberOfBlocks()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkHartleyVolumeReader::GetNumberOfChunks()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? static_cast<vtkIdType>(file->GetLayout().GetNumberOfChunks()) : 0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkHartleyVolumeReader::GetFileBytes()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? file->GetFileBytes() : 0;
}

//------------------------------------------------------------------------------
double vtkHartleyVolumeReader::GetBitsPerVoxel()
{
  const double voxels = this->Internals->CountVoxels();
  return voxels > 0 ? 8 * static_cast<double>(this->GetFileBytes()) / voxels : 0;
}

//------------------------------------------------------------------------------
void vtkHartleyVolumeReader::GetRange(double range[2])
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  range[0] = file ? file->GetRange().Min : 0;
  range[1] = file ? file->GetRange().Max : 0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkHartleyVolumeReader::GetBytesRead()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? file->GetBytesRead() : 0;
}

//------------------------------------------------------------------------------
int vtkHartleyVolumeReader::ComputePipelineMTime(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inInfoVec), vtkInformationVector* vtkNotUsed(outInfoVec),
  int vtkNotUsed(requestFromOutputPort), vtkMTimeType* mtime)
{
  // Here and not in GetMTime: there it would change in the middle of a request.
  vtkInternals& self = *this->Internals;
  if (self.ReadAgain || (this->FileName && self.File.HasChanged(this->FileName)))
  {
    self.FileTime.Modified();
    self.ReadAgain = false;
  }
  *mtime = std::max(this->GetMTime(), self.FileTime.GetMTime());
  return 1;
}

//------------------------------------------------------------------------------
// Within a catch block: reports, and leaves nothing of what was read before. What was thrown ends
// here, and nothing else may be thrown if memory has run out.
void vtkHartleyVolumeReader::Fail(vtkInformationVector* outputVector) noexcept
{
  const gatun::VTKFailure failure =
    gatun::DescribeFailure(this->FileName ? this->FileName : "(no file)");
  this->SetErrorCode(failure.Code);
  try
  {
    if (auto* output = vtkDataObject::GetData(outputVector->GetInformationObject(0)))
    {
      output->Initialize();
    }
    if (!failure.Aborted)
    {
      vtkErrorMacro(<< failure.Message);
    }
  }
  catch (const std::bad_alloc&)
  {
    // The error code tells it.
  }
}

//------------------------------------------------------------------------------
int vtkHartleyVolumeReader::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInternals& self = *this->Internals;
  vtkInformation* const outInfo = outputVector->GetInformationObject(0);
  if (!this->FileName || !*this->FileName)
  {
    if (auto* output = vtkDataObject::GetData(outInfo))
    {
      output->Initialize();
    }
    self.File.Close();
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("No FileName was set.");
    return 0;
  }
  try
  {
    const gatun::VolumeInput& volume = self.File.Get(this->FileName)->GetVolume();
    outInfo->Set(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), gatun::ExtentOf(volume).data(), 6);
    outInfo->Set(vtkDataObject::ORIGIN(), volume.Origin.data(), 3);
    outInfo->Set(vtkDataObject::SPACING(), volume.Spacing.data(), 3);
    outInfo->Set(vtkDataObject::DIRECTION(), volume.Direction.data(), 9);
    outInfo->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    const auto array = vtkSmartPointer<vtkDataArray>(
      gatun::ArrayFiller(gatun::DescribeVolumeArray(volume), 0).Finish());
    vtkDataObject::SetActiveAttributeInfo(outInfo, vtkDataObject::FIELD_ASSOCIATION_POINTS,
      vtkDataSetAttributes::SCALARS, array->GetName(), array->GetDataType(), 1, -1);
  }
  catch (...)
  {
    self.File.Close();
    this->Fail(outputVector);
    return 0;
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHartleyVolumeReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInternals& self = *this->Internals;
  vtkInformation* const outInfo = outputVector->GetInformationObject(0);
  vtkImageData* const output = vtkImageData::GetData(outInfo);
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    output->GetPointData()->Initialize();
    this->UpdateProgress(0);
    const gatun::HartleyFile& file = *self.File.Get(this->FileName);
    const gatun::VolumeInput& volume = file.GetVolume();
    const std::array<int, 6> whole = gatun::ExtentOf(volume);
    std::array<int, 6> extent = whole;
    outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
    output->SetOrigin(volume.Origin.data());
    output->SetSpacing(volume.Spacing.data());
    output->SetDirectionMatrix(volume.Direction.data());
    bool isEmpty = false;
    gatun::HartleyLayout::Triple first{};
    gatun::HartleyLayout::Triple end{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int low = std::max(extent[2 * axis], whole[2 * axis]);
      const int high = std::min(extent[2 * axis + 1], whole[2 * axis + 1]);
      isEmpty = isEmpty || low > high;
      if (!isEmpty)
      {
        extent[2 * axis] = low;
        extent[2 * axis + 1] = high;
        first[axis] = static_cast<std::uint32_t>(std::int64_t{ low } - whole[2 * axis]);
        end[axis] = static_cast<std::uint32_t>(std::int64_t{ high } - whole[2 * axis] + 1);
      }
    }
    if (isEmpty)
    {
      extent = { 0, -1, 0, -1, 0, -1 };
    }
    output->SetExtent(extent.data());
    gatun::ArrayFiller filler(gatun::DescribeVolumeArray(volume), output->GetNumberOfPoints());
    if (!isEmpty)
    {
      file.GetVoxels(first, end, filler.GetBuffer(),
        [this](double fraction)
        {
          this->UpdateProgress(fraction);
          return !gatun::IsAborted(this);
        });
    }
    output->GetPointData()->SetScalars(filler.Finish());
    this->UpdateProgress(1);
  }
  catch (...)
  {
    this->Fail(outputVector);
    // An aborted update is none; the next one starts anew.
    self.ReadAgain = true;
    return this->GetErrorCode() == vtkGatunErrorCode::AbortedError ? 1 : 0;
  }
  return 1;
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
