// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunTetrahedralize.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGatunTetrahedralize);

//------------------------------------------------------------------------------
vtkGatunTetrahedralize::vtkGatunTetrahedralize() = default;

//------------------------------------------------------------------------------
vtkGatunTetrahedralize::~vtkGatunTetrahedralize() = default;

//------------------------------------------------------------------------------
void vtkGatunTetrahedralize::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
int vtkGatunTetrahedralize::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunTetrahedralize::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* vtkNotUsed(outputVector))
{
  vtkErrorMacro("Tetrahedralization is not written yet.");
  return 0;
}
