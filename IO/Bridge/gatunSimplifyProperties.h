// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSimplifyProperties_h
#define gatunSimplifyProperties_h

#include "gatunSimplifyTarget.h"
#include "vtkGatunIOModule.h" // For export macro

#include "vtkIOStream.h"
#include "vtkIndent.h"
#include "vtkType.h"

namespace gatun
{
/** The simplification properties of vtkGatunReader and vtkGatunSimplify. The target is the error
 * unless that is 0, then the number of points unless that is 0, then the ratio. */
struct VTKGATUNIO_EXPORT SimplifyProperties
{
  double Ratio;
  vtkIdType NumberOfPoints;
  double RMSError;

  SimplifyTarget GetTarget() const;

  /** For PrintSelf. */
  void Print(ostream& os, vtkIndent indent) const;
};
}

#endif
