// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunHartleyReader.h"

#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunFileInput.h"
#include "gatunHartleyFile.h"
#include "gatunReport.h"
#include "gatunStatistics.h"
#include "gatunVolumeBridge.h"
#include "vtkGatunCompat.h"
#include "vtkGatunErrorCode.h"
#include "vtkGatunHartleyCoefficients.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <array>
#include <new>
#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunHartleyReader);

//------------------------------------------------------------------------------
class vtkGatunHartleyReader::vtkInternals
{
public:
  gatun::CurrentFileOf<gatun::HartleyFile> File;

  // Published. A new object for each file that is opened.
  vtkSmartPointer<vtkGatunHartleyCoefficients> Coefficients;

  // Modified when the file changed on disk and when the last output is not valid.
  vtkTimeStamp FileTime;
  bool ReadAgain = false;

  const gatun::HartleyFile* Get() const { return this->File.GetLast().get(); }

  /** Opens the file if that is necessary. */
  const gatun::HartleyFile& Open(const char* path)
  {
    const std::shared_ptr<const gatun::HartleyFile>& file = this->File.Get(path);
    if (!this->Coefficients || this->Coefficients->GetSource() != file)
    {
      this->Coefficients = vtkSmartPointer<vtkGatunHartleyCoefficients>::New();
      this->Coefficients->SetSource(file, file->GetVolume());
    }
    return *file;
  }

  void Close()
  {
    this->File.Close();
    this->Coefficients = nullptr;
  }

  gatun::Statistics Statistics;

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
vtkGatunHartleyReader::vtkGatunHartleyReader()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkGatunHartleyReader::~vtkGatunHartleyReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunHartleyReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "BlockSize: " << this->GetBlockSize() << "\n";
  os << indent << "RateControl: " << this->GetRateControl() << "\n";
  os << indent << "RateControlValue: " << this->GetRateControlValue() << "\n";
  os << indent << "Lossless: " << (this->GetLossless() ? "true" : "false") << "\n";
  os << indent << "MeasuredRMSError: " << this->GetMeasuredRMSError() << "\n";
  os << indent << "MaximumError: " << this->GetMaximumError() << "\n";
  os << indent << "NumberOfBlocks: " << this->GetNumberOfBlocks() << "\n";
  os << indent << "NumberOfChunks: " << this->GetNumberOfChunks() << "\n";
  os << indent << "FileBytes: " << this->GetFileBytes() << "\n";
  os << indent << "BitsPerVoxel: " << this->GetBitsPerVoxel() << "\n";
}

//------------------------------------------------------------------------------
int vtkGatunHartleyReader::CanReadFile(const char* name)
{
  try
  {
    return name && gatun::HartleyFile::CanRead(name) ? 1 : 0;
  }
  catch (const std::bad_alloc&)
  {
    return 0; // no memory for the name
  }
}

//------------------------------------------------------------------------------
int vtkGatunHartleyReader::GetBlockSize()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file && !file->GetLayout().IsWhole() ? static_cast<int>(file->GetLayout().Block[0]) : 0;
}

//------------------------------------------------------------------------------
int vtkGatunHartleyReader::GetRateControl()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? static_cast<int>(file->GetRateControl().Mode) : 0;
}

//------------------------------------------------------------------------------
double vtkGatunHartleyReader::GetRateControlValue()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? file->GetRateControl().Value : 0;
}

//------------------------------------------------------------------------------
double vtkGatunHartleyReader::GetMeasuredRMSError()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? file->GetRMSError() : 0;
}

//------------------------------------------------------------------------------
double vtkGatunHartleyReader::GetMaximumError()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? file->GetMaximumError() : 0;
}

//------------------------------------------------------------------------------
bool vtkGatunHartleyReader::GetLossless()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file && file->IsLossless();
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunHartleyReader::GetNumberOfBlocks()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? static_cast<vtkIdType>(file->GetLayout().GetNumberOfBlocks()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunHartleyReader::GetNumberOfChunks()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? static_cast<vtkIdType>(file->GetLayout().GetNumberOfChunks()) : 0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkGatunHartleyReader::GetFileBytes()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  return file ? file->GetFileBytes() : 0;
}

//------------------------------------------------------------------------------
double vtkGatunHartleyReader::GetBitsPerVoxel()
{
  const double voxels = this->Internals->CountVoxels();
  return voxels > 0 ? 8 * static_cast<double>(this->GetFileBytes()) / voxels : 0;
}

//------------------------------------------------------------------------------
void vtkGatunHartleyReader::GetRange(double range[2])
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  range[0] = file ? file->GetRange().Min : 0;
  range[1] = file ? file->GetRange().Max : 0;
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunHartleyReader::GetStatistics()
{
  const gatun::HartleyFile* const file = this->Internals->Get();
  gatun::Statistics& table = this->Internals->Statistics;
  table.Clear();
  table.Add("BytesRead", file ? file->GetBytesRead() : 0);
  return table.Get();
}

//------------------------------------------------------------------------------
int vtkGatunHartleyReader::ComputePipelineMTime(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inInfoVec), vtkInformationVector* vtkNotUsed(outInfoVec),
  int vtkNotUsed(requestFromOutputPort), vtkMTimeType* mtime)
{
  // Not in GetMTime, which must not change during a request.
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
// Within a catch block: reports the exception and empties the output.
void vtkGatunHartleyReader::Fail(vtkInformationVector* outputVector) noexcept
{
  const gatun::VTKFailure failure =
    gatun::DescribeFailure(this->FileName ? this->FileName : "(no file)");
  this->SetErrorCode(failure.Code);
  gatun::ReportFailure(
    this, failure, vtkDataObject::GetData(outputVector->GetInformationObject(0)));
}

//------------------------------------------------------------------------------
int vtkGatunHartleyReader::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInternals& self = *this->Internals;
  vtkInformation* const outInfo = outputVector->GetInformationObject(0);
  outInfo->Remove(vtkGatunHartleyCoefficients::COEFFICIENTS());
  if (!this->FileName || !*this->FileName)
  {
    if (auto* output = vtkDataObject::GetData(outInfo))
    {
      output->Initialize();
    }
    self.Close();
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("No FileName was set.");
    return 0;
  }
  try
  {
    const gatun::VolumeInput& volume = self.Open(this->FileName).GetVolume();
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
    outInfo->Set(vtkGatunHartleyCoefficients::COEFFICIENTS(), self.Coefficients);
  }
  catch (...)
  {
    self.Close();
    this->Fail(outputVector);
    return 0;
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunHartleyReader::RequestData(vtkInformation* vtkNotUsed(request),
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
    const gatun::HartleyFile& file = self.Open(this->FileName);
    outInfo->Set(vtkGatunHartleyCoefficients::COEFFICIENTS(), self.Coefficients);
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
    // The next update has to read again, also after an abort.
    self.ReadAgain = true;
    return this->GetErrorCode() == vtkGatunErrorCode::AbortedError ? 1 : 0;
  }
  return 1;
}
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
