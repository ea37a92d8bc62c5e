// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunWriter.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGatunWriter);

//------------------------------------------------------------------------------
vtkGatunWriter::vtkGatunWriter() = default;

//------------------------------------------------------------------------------
vtkGatunWriter::~vtkGatunWriter()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

//------------------------------------------------------------------------------
int vtkGatunWriter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
void vtkGatunWriter::WriteData()
{
  vtkErrorMacro("Writing .gtn files is not written yet.");
}
