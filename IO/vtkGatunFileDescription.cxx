// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunFileDescription.h"

#include "gatunErrorCodes.h"
#include "gatunFileReader.h"
#include "gatunHartleyFile.h"
#include "gatunMeshDescription.h"
#include "gatunReport.h"
#include "gatunVolumeDescription.h"

#include "vtkErrorCode.h"
#include "vtkObjectFactory.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunFileDescription);

//------------------------------------------------------------------------------
vtkGatunFileDescription::vtkGatunFileDescription() = default;

//------------------------------------------------------------------------------
vtkGatunFileDescription::~vtkGatunFileDescription()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
std::string vtkGatunFileDescription::ReadJSON()
{
  this->ErrorCode = vtkErrorCode::NoError;
  try
  {
    const std::string path = this->FileName ? this->FileName : "";
    const gatun::Description description = gatun::HartleyFile::CanRead(path)
      ? gatun::DescribeVolume(gatun::HartleyFile(path), false, false)
      : gatun::DescribeMesh(gatun::FileReader(path), false);
    return gatun::WriteJson(description.GetJson());
  }
  catch (...)
  {
    const gatun::VTKFailure failure =
      gatun::DescribeFailure(this->FileName ? this->FileName : "(no file)");
    this->ErrorCode = failure.Code;
    gatun::ReportFailure(this, failure, nullptr);
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkGatunFileDescription::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "ErrorCode: " << this->ErrorCode << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
