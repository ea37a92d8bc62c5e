// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunReader.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGatunReader);

//------------------------------------------------------------------------------
vtkGatunReader::vtkGatunReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkGatunReader::~vtkGatunReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

//------------------------------------------------------------------------------
int vtkGatunReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* vtkNotUsed(outputVector))
{
  vtkErrorMacro("Reading .gtn files is not written yet.");
  return 0;
}
