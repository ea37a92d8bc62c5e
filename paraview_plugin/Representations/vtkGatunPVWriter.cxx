// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunPVWriter.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunPVWriter);

//------------------------------------------------------------------------------
vtkGatunPVWriter::vtkGatunPVWriter()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkGatunPVWriter::~vtkGatunPVWriter() = default;

//------------------------------------------------------------------------------
int vtkGatunPVWriter::Write()
{
  const bool isSeries = this->WriteTimeSteps && !this->WriteAllTimeSteps && this->FileName &&
    *this->FileName && this->GetNumberOfInputConnections(0) > 0;
  if (!isSeries)
  {
    return this->Superclass::Write();
  }
  const std::string name = this->FileName;
  const int written = this->WriteSeries(name);
  this->SetFileName(name.c_str());
  return written;
}

//------------------------------------------------------------------------------
int vtkGatunPVWriter::WriteSeries(const std::string& name)
{
  this->UpdateInformation();
  vtkInformation* const info = this->GetInputInformation(0, 0);
  auto* const key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  if (!info->Has(key))
  {
    return this->Superclass::Write();
  }
  const std::vector<double> times(info->Get(key), info->Get(key) + info->Length(key));
  const auto count = static_cast<int>(times.size());
  const int last =
    this->MaxTimeStep < this->MinTimeStep ? count - 1 : std::min(this->MaxTimeStep, count - 1);
  const std::filesystem::path path(name);
  for (std::int64_t step = this->MinTimeStep; step <= last; step += this->TimeStepStride)
  {
    auto file = path;
    file.replace_filename(
      path.stem().string() + "_" + std::to_string(step) + path.extension().string());
    this->SetFileName(file.string().c_str());
    info->Set(
      vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), times[static_cast<std::size_t>(step)]);
    if (!this->Superclass::Write())
    {
      return 0; // in all processes
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkGatunPVWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WriteTimeSteps: " << (this->WriteTimeSteps ? "On" : "Off") << "\n";
  os << indent << "MinTimeStep: " << this->MinTimeStep << "\n";
  os << indent << "MaxTimeStep: " << this->MaxTimeStep << "\n";
  os << indent << "TimeStepStride: " << this->TimeStepStride << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
