// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnSpoolSource.h"

#include "gtnFailure.h"
#include "gtnPrepare.h"
#include "gtnTimes.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <exception>
#include <utility>

namespace gtn
{
vtkStandardNewMacro(SpoolSource);

//------------------------------------------------------------------------------
SpoolSource::SpoolSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
void SpoolSource::SetMesh(std::shared_ptr<const SpooledMesh> mesh, const InputOptions& options)
{
  this->Mesh = std::move(mesh);
  this->Options = options;
  this->Options.Skip.clear(); // these have not been read
  this->Options.Arrays.emplace_back(JoinArrayName);
  this->Modified();
}

//------------------------------------------------------------------------------
int SpoolSource::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  PublishTimes(info, this->Mesh->GetTimes());
  return 1;
}

//------------------------------------------------------------------------------
int SpoolSource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  const std::vector<double>& times = this->Mesh->GetTimes();
  const std::size_t step = FindStep(info, times);
  try
  {
    const int piece = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
    const auto pieces = static_cast<std::size_t>(info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
    if (pieces != this->Mesh->GetNumberOfPieces())
    {
      throw Failure("has other pieces");
    }
    Preparer::Prepare(
      this->Mesh->MakePiece(static_cast<std::size_t>(piece), step), this->Options, output);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< ReasonOf(error));
    return 0;
  }
  if (!times.empty())
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), times[step]);
  }
  return 1;
}
}
