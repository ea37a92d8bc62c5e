// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileConsumer.h"

#include "gatunFileReader.h"
#include "gatunFileSettings.h"
#include "vtkGatunFileHandle.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace gatun
{
namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

/** Whether an output holds what its algorithm would make now. */
bool IsUpToDate(vtkDataObject* output, vtkInformation* info)
{
  vtkExecutive* const producer = vtkExecutive::PRODUCER()->GetExecutive(info);
  return output && producer && output->GetUpdateTime() > producer->GetAlgorithm()->GetMTime();
}
}

//------------------------------------------------------------------------------
const PublishedFile* GetPublishedFile(vtkInformation* info)
{
  auto* const object =
    info ? vtkGatunFileHandle::SafeDownCast(info->Get(vtkGatunFileHandle::FILE_HANDLE())) : nullptr;
  if (!object)
  {
    return nullptr;
  }
  return info->Has(Pipeline::UPDATE_TIME_STEP())
    ? &object->GetContents(info->Get(Pipeline::UPDATE_TIME_STEP()))
    : &object->GetContents();
}

//------------------------------------------------------------------------------
const PublishedFile* GetUsableFile(vtkInformation* info)
{
  const PublishedFile* const handle = GetPublishedFile(info);
  return handle && handle->CanReplaceOutput() ? handle : nullptr;
}

//------------------------------------------------------------------------------
void RequestNothing(vtkInformation* info)
{
  // Of so many pieces the first is empty.
  constexpr int many = 1 << 30;
  int piece = 0;
  int pieces = many;
  int ghosts = 0;
  vtkDataObject* const output = vtkDataObject::GetData(info);
  if (IsUpToDate(output, info))
  {
    vtkInformation* const held = output->GetInformation();
    if (held->Has(vtkDataObject::DATA_NUMBER_OF_PIECES()))
    {
      piece = held->Get(vtkDataObject::DATA_PIECE_NUMBER());
      pieces = held->Get(vtkDataObject::DATA_NUMBER_OF_PIECES());
      ghosts = held->Get(vtkDataObject::DATA_NUMBER_OF_GHOST_LEVELS());
    }
  }
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), ghosts);
}

//------------------------------------------------------------------------------
std::size_t FindStep(const FileReader& file, double time)
{
  const auto& times = file.GetTimes();
  return file.HasTime() ? static_cast<std::size_t>(std::max<std::ptrdiff_t>(0,
                            std::upper_bound(times.begin(), times.end(), time) - times.begin() - 1))
                        : 0;
}

//------------------------------------------------------------------------------
std::size_t FindRequestedMesh(const FileReader& file, vtkInformation* info)
{
  return info->Has(Pipeline::UPDATE_TIME_STEP())
    ? FindMesh(file, info->Get(Pipeline::UPDATE_TIME_STEP()))
    : 0;
}

//------------------------------------------------------------------------------
std::size_t GetRequestedStep(const FileReader& file, vtkInformation* info)
{
  return info->Has(Pipeline::UPDATE_TIME_STEP())
    ? FindStep(file, info->Get(Pipeline::UPDATE_TIME_STEP()))
    : 0;
}
}
