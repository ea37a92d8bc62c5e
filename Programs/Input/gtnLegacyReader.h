// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnLegacyReader_h
#define gtnLegacyReader_h

#include "vtkGenericDataObjectReader.h"

namespace gtn
{
/** Reads .vtk files, which have no time steps, though VTK's reader says that there is one at 0. */
class LegacyReader : public vtkGenericDataObjectReader
{
public:
  static LegacyReader* New();
  vtkTypeMacro(LegacyReader, vtkGenericDataObjectReader);

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
};
}

#endif
