// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSimplifyProperties.h"

namespace gatun
{
//------------------------------------------------------------------------------
SimplifyTarget SimplifyProperties::GetTarget() const
{
  if (this->RMSError != 0) // NaN is an error
  {
    return { SimplifyTarget::RMSError, this->RMSError };
  }
  if (this->NumberOfPoints != 0)
  {
    return { SimplifyTarget::NumberOfPoints, static_cast<double>(this->NumberOfPoints) };
  }
  return { SimplifyTarget::Ratio, this->Ratio };
}

//------------------------------------------------------------------------------
void SimplifyProperties::Print(ostream& os, vtkIndent indent) const
{
  os << indent << "SimplificationRatio: " << this->Ratio << "\n";
  os << indent << "SimplificationNumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "SimplificationRMSError: " << this->RMSError << "\n";
}
}
