// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnGridReader_h
#define gtnGridReader_h

// The reader of .vtu files.

#include "vtkSmartPointer.h"

#include <string>

class vtkXMLReader;

namespace gtn
{
/** VTK's reader, which reads empty pieces, too, and polyhedra of version 2.3, which VTK 9.3 and
 * earlier leave without faces. Errors are told as VTK's are. */
vtkSmartPointer<vtkXMLReader> MakeGridReader(const std::string& file);
}

#endif
