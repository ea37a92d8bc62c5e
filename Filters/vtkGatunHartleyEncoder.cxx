// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunHartleyEncoder.h"

#include "gatunErrorCodes.h"
#include "gatunHartleyParameters.h"
#include "gatunImageEncoder.h"
#include "gatunOwned.h"
#include "gatunReport.h"
#include "gatunStatistics.h"
#include "gatunVolumeBridge.h"
#include "vtkGatunCompat.h"
#include "vtkGatunHartleyCoefficients.h"
#include "vtkGatunHartleyEncoding.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunHartleyEncoder);

namespace
{
//------------------------------------------------------------------------------
// The part of the input that is requested. VTK may request more than there is.
std::array<int, 6> GetRequestedExtent(vtkImageData* input, vtkInformation* outInfo)
{
  const int* const whole = input->GetExtent();
  std::array<int, 6> extent{};
  std::copy_n(whole, 6, extent.begin());
  outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = std::max(extent[2 * axis], whole[2 * axis]);
    extent[2 * axis + 1] = std::min(extent[2 * axis + 1], whole[2 * axis + 1]);
  }
  return extent;
}

//------------------------------------------------------------------------------
void PassPart(vtkImageData* input, const std::array<int, 6>& extent, vtkImageData* output)
{
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    output->Initialize();
    output->SetOrigin(input->GetOrigin());
    output->SetSpacing(input->GetSpacing());
    output->SetDirectionMatrix(input->GetDirectionMatrix());
    return;
  }
  output->ShallowCopy(input);
  if (!std::equal(extent.begin(), extent.end(), input->GetExtent()))
  {
    output->Crop(extent.data());
  }
}
}

//------------------------------------------------------------------------------
class vtkGatunHartleyEncoder::vtkInternals
{
public:
  gatun::Owned<vtkGatunHartleyEncoding> Encoding;
  gatun::ImageEncoder Encoder;
  std::uint64_t Encodings = 0;
  gatun::Statistics Statistics;
};

//------------------------------------------------------------------------------
vtkGatunHartleyEncoder::vtkGatunHartleyEncoder()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkGatunHartleyEncoder::~vtkGatunHartleyEncoder() = default;

//------------------------------------------------------------------------------
void vtkGatunHartleyEncoder::SetEncoding(vtkGatunHartleyEncoding* encoding)
{
  if (this->Internals->Encoding.Set(encoding))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkGatunHartleyEncoding* vtkGatunHartleyEncoder::GetEncoding()
{
  return this->Internals->Encoding.Get();
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunHartleyEncoder::GetStatistics()
{
  const auto& coefficients = this->Internals->Encoder.GetCoefficients();
  gatun::Statistics& table = this->Internals->Statistics;
  table.Clear();
  table.Add("Blocks", coefficients ? coefficients->GetLayout().GetNumberOfBlocks() : 0);
  table.Add("Coefficients", coefficients ? coefficients->GetNumberOfTerms() : 0);
  table.Add("Encodings", this->Internals->Encodings);
  return table.Get();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGatunHartleyEncoder::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->GetEncoding()->GetMTime());
}

//------------------------------------------------------------------------------
void vtkGatunHartleyEncoder::GetRange(double range[2])
{
  const auto& coefficients = this->Internals->Encoder.GetCoefficients();
  range[0] = coefficients ? coefficients->GetRange().Min : 0;
  range[1] = coefficients ? coefficients->GetRange().Max : 0;
}

//------------------------------------------------------------------------------
int vtkGatunHartleyEncoder::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunHartleyEncoder::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* const outInfo = outputs->GetInformationObject(0);
  // The input or a property has changed.
  outInfo->Remove(vtkGatunHartleyCoefficients::COEFFICIENTS());
  outInfo->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunHartleyEncoder::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const info = inputs[0]->GetInformationObject(0);
  if (info->Has(Pipeline::WHOLE_EXTENT()))
  {
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunHartleyEncoder::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* const outInfo = outputs->GetInformationObject(0);
  vtkImageData* const input = vtkImageData::GetData(inputs[0], 0);
  vtkImageData* const output = vtkImageData::GetData(outInfo);
  this->SetErrorCode(vtkErrorCode::NoError);
  outInfo->Remove(vtkGatunHartleyCoefficients::COEFFICIENTS());
  gatun::ImageEncoder& encoder = this->Internals->Encoder;
  try
  {
    this->UpdateProgress(0);
    const bool isNew = encoder.Encode(input, this->GetInputArrayInformation(0),
      gatun::GetParameters(this->GetEncoding()),
      [this](double fraction)
      {
        this->UpdateProgress(fraction);
        return !gatun::IsAborted(this);
      });
    this->Internals->Encodings += isNew;
    PassPart(input, GetRequestedExtent(input, outInfo), output);
    vtkNew<vtkGatunHartleyCoefficients> coefficients;
    coefficients->SetSource(encoder.GetCoefficients(), encoder.GetVolume());
    outInfo->Set(vtkGatunHartleyCoefficients::COEFFICIENTS(), coefficients);
    this->UpdateProgress(1);
    return 1;
  }
  catch (...)
  {
    const gatun::VTKFailure failure = gatun::DescribeFailure("The volume cannot be encoded");
    encoder.Clear();
    this->SetErrorCode(failure.Code);
    gatun::ReportFailure(this, failure, output);
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkGatunHartleyEncoder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding:\n";
  this->GetEncoding()->PrintSelf(os, indent.GetNextIndent());
}
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
