// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileInput.h"

#include "gatunFileReader.h"
#include "vtkGatunReader.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
vtkGatunReader* GetFileReader(vtkAlgorithm* input)
{
  auto* const reader = vtkGatunReader::SafeDownCast(input);
  return reader && reader->GetFileName() && !reader->GetUseBox() && !reader->GetUseValueRange() &&
      reader->GetSimplification() >= 0
    ? reader
    : nullptr;
}

//------------------------------------------------------------------------------
void RequestNothing(vtkGatunReader* reader, vtkInformation* info)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  // Of so many pieces the first is empty.
  constexpr int many = 1 << 30;
  int piece = 0;
  int pieces = many;
  int ghosts = 0;
  vtkDataObject* const output = reader->GetOutputDataObject(0);
  if (output && output->GetUpdateTime() > reader->GetMTime())
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
}
