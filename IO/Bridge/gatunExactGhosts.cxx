// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunExactGhosts.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace
{

//------------------------------------------------------------------------------
class ExactGhostLevelsKey : public vtkInformationIntegerKey
{
public:
  vtkTypeMacro(ExactGhostLevelsKey, vtkInformationIntegerKey);

  using vtkInformationIntegerKey::vtkInformationIntegerKey;

  bool NeedToExecute(vtkInformation* pipelineInfo, vtkInformation* dataInfo) override
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    // A single piece has no ghosts, whatever the request.
    return Pipeline::GetUpdateNumberOfPieces(pipelineInfo) > 1 &&
      std::max(0, Pipeline::GetUpdateGhostLevel(pipelineInfo)) !=
      dataInfo->Get(vtkDataObject::DATA_NUMBER_OF_GHOST_LEVELS());
  }
};

} // anonymous namespace

namespace gatun
{

//------------------------------------------------------------------------------
vtkInformationIntegerKey* ExactGhostLevels()
{
  // VTK deletes its keys at exit.
  static auto* key = new ExactGhostLevelsKey("EXACT_GHOST_LEVELS", "vtkGatunReader");
  return key;
}

}
