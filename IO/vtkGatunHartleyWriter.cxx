// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunHartleyWriter.h"

#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunHartleyFile.h"
#include "gatunHartleyParameters.h"
#include "gatunOwned.h"
#include "gatunReport.h"
#include "gatunStatistics.h"
#include "gatunVolumeBridge.h"
#include "vtkGatunCompat.h"
#include "vtkGatunErrorCode.h"
#include "vtkGatunHartleyEncoding.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <stdexcept>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunHartleyWriter);

//------------------------------------------------------------------------------
class vtkGatunHartleyWriter::vtkInternals
{
public:
  gatun::Owned<vtkGatunHartleyEncoding> Encoding;
  gatun::HartleyWritten Written;
  gatun::Statistics Statistics;
};

//------------------------------------------------------------------------------
vtkGatunHartleyWriter::vtkGatunHartleyWriter()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
vtkGatunHartleyWriter::~vtkGatunHartleyWriter()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunHartleyWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Encoding:\n";
  this->GetEncoding()->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
void vtkGatunHartleyWriter::SetEncoding(vtkGatunHartleyEncoding* encoding)
{
  if (this->Internals->Encoding.Set(encoding))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkGatunHartleyEncoding* vtkGatunHartleyWriter::GetEncoding()
{
  return this->Internals->Encoding.Get();
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunHartleyWriter::GetStatistics()
{
  const gatun::HartleyWritten& written = this->Internals->Written;
  gatun::Statistics& table = this->Internals->Statistics;
  table.Clear();
  table.Add("FileBytes", written.FileBytes);
  table.Add("RMSError", written.RMSError);
  table.Add("MaximumError", written.MaximumError);
  return table.Get();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGatunHartleyWriter::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->GetEncoding()->GetMTime());
}

//------------------------------------------------------------------------------
int vtkGatunHartleyWriter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunHartleyWriter::Write()
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
    // Including exceptions of VTK and of upstream algorithms.
    this->HandleFailure();
  }
  return this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
}

//------------------------------------------------------------------------------
VTK_GATUN_UPDATE_RESULT vtkGatunHartleyWriter::Update()
{
  return static_cast<VTK_GATUN_UPDATE_RESULT>(this->Write());
}

//------------------------------------------------------------------------------
VTK_GATUN_UPDATE_RESULT vtkGatunHartleyWriter::Update(int vtkNotUsed(port))
{
  return static_cast<VTK_GATUN_UPDATE_RESULT>(this->Write());
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGatunHartleyWriter::ProcessRequest(
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
int vtkGatunHartleyWriter::RequestData(vtkInformation* vtkNotUsed(request),
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
void vtkGatunHartleyWriter::WriteVolume(vtkImageData* image)
{
  if (!image)
  {
    gatun::ThrowInvalid("the input is not a vtkImageData");
  }
  const gatun::BridgedVolume bridged =
    gatun::BridgeVolume(image, this->GetInputArrayInformation(0));
  gatun::HartleyWriterOptions options;
  const gatun::HartleyParameters parameters = gatun::GetParameters(this->GetEncoding());
  options.BlockSize = parameters.BlockSize;
  options.RateControl = parameters.RateControl;
  this->Internals->Written = gatun::WriteHartleyFile(this->FileName, bridged.Volume, options,
    [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return !gatun::IsAborted(this);
    });
}

//------------------------------------------------------------------------------
// Within a catch block: reports the exception.
void vtkGatunHartleyWriter::HandleFailure() noexcept
{
  const gatun::VTKFailure failure =
    gatun::DescribeFailure(this->FileName ? this->FileName : "(no file)");
  this->SetErrorCode(failure.Code);
  gatun::ReportFailure(this, failure, nullptr);
}
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
