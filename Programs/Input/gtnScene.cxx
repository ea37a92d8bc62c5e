// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnScene.h"

#include "gtnFailure.h"

#include "gatunSurfaceGrid.h"
#include "vtkGatunMergeBlocks.h"

#include "vtkCompositeDataSet.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <exception>

namespace gtn
{
vtkStandardNewMacro(SceneMerger);

//------------------------------------------------------------------------------
int SceneMerger::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int SceneMerger::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkNew<vtkGatunMergeBlocks> merge;
  merge->SetInputDataObject(vtkCompositeDataSet::GetData(inputVector[0]));
  merge->Update();
  if (merge->GetErrorCode() != vtkErrorCode::NoError)
  {
    return 0; // which has been reported
  }
  vtkUnstructuredGrid* const grid = merge->GetOutput();
  auto* const names =
    vtkArrayDownCast<vtkStringArray>(grid->GetFieldData()->GetAbstractArray("BlockNames"));
  try
  {
    gatun::MakeSurface(grid, gatun::FindSurfaceCells(grid), vtkPolyData::GetData(outputVector));
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< ReasonOf(error));
    return 0;
  }
  vtkWarningMacro(<< (names ? names->GetNumberOfValues() : 0)
                  << " blocks were merged into one surface");
  return 1;
}
}
