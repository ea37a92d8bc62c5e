// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunReport.h"

#include "vtkDataObject.h"
#include "vtkObject.h"
#include "vtkSetGet.h"

namespace gatun
{
//------------------------------------------------------------------------------
void ReportFailure(vtkObject* self, const VTKFailure& failure, vtkDataObject* output) noexcept
{
  try
  {
    if (output)
    {
      output->Initialize();
    }
    if (!failure.Aborted)
    {
      vtkErrorWithObjectMacro(self, << failure.Message);
    }
  }
  catch (...)
  {
    // There is no memory for the message.
  }
}
}
