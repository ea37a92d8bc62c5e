// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHartleyVolumeWriter.h"

#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunHartleyFile.h"
#include "gatunVolumeBridge.h"
#include "vtkGatunCompat.h"
#include "vtkGatunErrorCode.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <stdexcept>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkHartleyVolumeWriter);

//------------------------------------------------------------------------------
vtkHartleyVolumeWriter::vtkHartleyVolumeWriter()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
vtkHartleyVolumeWriter::~vtkHartleyVolumeWriter()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkHartleyVolumeWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const goals[] = { "Quality", "Error", "PSNR", "Rate" };
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "BlockSize: " << this->BlockSize << "\n";
  os << indent << "Goal: " << goals[this->Goal] << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "PSNR: " << this->PSNR << "\n";
  os << indent << "Rate: " << this->Rate << "\n";
  os << indent << "FrequencyWeight: " << this->FrequencyWeight << "\n";
  os << indent << "ReplaceReadOnly: " << (this->ReplaceReadOnly ? "On" : "Off") << "\n";
  os << indent << "FileBytes: " << this->FileBytes << "\n";
  os << indent << "RootMeanSquareError: " << this->RootMeanSquareError << "\n";
  os << indent << "LargestError: " << this->LargestError << "\n";
}

//------------------------------------------------------------------------------
int vtkHartleyVolumeWriter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHartleyVolumeWriter::Write()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (this->GetNumberOfInputConnections(0) < 1)
  {
    this->SetErrorCode(vtkGatunErrorCode::InvalidInputError);
    vtkErrorMacro("No input was set.");
    return 0;
  }
  try
  {
    const vtkMTimeType before = this->WriteTime.GetMTime();
    this->Modified();
    this->UpdateWholeExtent();
    if (this->WriteTime.GetMTime() == before && this->GetErrorCode() == vtkErrorCode::NoError)
    {
      throw std::runtime_error("not written, as the input could not be updated");
    }
  }
  catch (...)
  {
    // What VTK and the algorithms before this one throw, too.
    this->HandleFailure();
  }
  return this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkHartleyVolumeWriter::Update()
{
  this->Write();
}

//------------------------------------------------------------------------------
void vtkHartleyVolumeWriter::Update(int vtkNotUsed(port))
{
  this->Write();
}

//------------------------------------------------------------------------------
vtkTypeBool vtkHartleyVolumeWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    return 1;
  }
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* const info = inputVector[0]->GetInformationObject(0);
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    if (info->Has(Pipeline::WHOLE_EXTENT()))
    {
      info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkHartleyVolumeWriter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("No FileName was set.");
    return 0;
  }
  try
  {
    this->WriteVolume(vtkImageData::GetData(inputVector[0]));
  }
  catch (...)
  {
    this->HandleFailure();
    return this->GetErrorCode() == vtkGatunErrorCode::AbortedError ? 1 : 0;
  }
  this->WriteTime.Modified();
  this->UpdateProgress(1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHartleyVolumeWriter::WriteVolume(vtkImageData* image)
{
  if (!image)
  {
    gatun::ThrowInvalid("the input is not a vtkImageData");
  }
  if (this->BlockSize < 0)
  {
    gatun::ThrowInvalid("a block size of " + std::to_string(this->BlockSize) +
      " is not possible; it is 2 to 64, or 0 for the whole volume");
  }
  const gatun::BridgedVolume bridged =
    gatun::BridgeVolume(image, this->GetInputArrayInformation(0));
  gatun::HartleyWriterOptions options;
  options.BlockSize = static_cast<std::uint32_t>(this->BlockSize);
  options.Quality = gatun::MakeHartleyQuality({ this->Goal, this->Quality, this->MaximumError,
    this->PSNR, this->Rate, this->FrequencyWeight });
  options.ReplaceReadOnly = this->ReplaceReadOnly;
  const gatun::HartleyWritten written =
    gatun::WriteHartleyFile(this->FileName, bridged.Volume, options,
      [this](double fraction)
      {
        this->UpdateProgress(fraction);
        return !gatun::IsAborted(this);
      });
  this->FileBytes = written.FileBytes;
  this->RootMeanSquareError = written.RootMeanSquareError;
  this->LargestError = written.LargestError;
}

//------------------------------------------------------------------------------
// Within a catch block: reports.
void vtkHartleyVolumeWriter::HandleFailure() noexcept
{
  this->SetErrorCode(vtkErrorCode::UnknownError);
  try
  {
    const gatun::VTKFailure failure =
      gatun::DescribeFailure(this->FileName ? this->FileName : "(no file)");
    this->SetErrorCode(failure.Code);
    if (!failure.Aborted)
    {
      vtkErrorMacro(<< failure.Message);
    }
  }
  catch (...)
  {
    // Not even memory for the message; the code tells it.
  }
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
