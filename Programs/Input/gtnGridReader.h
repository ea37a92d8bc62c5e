// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnGridReader_h
#define gtnGridReader_h

// Readers of .vtu and .pvtu files.

#include "vtkSmartPointer.h"

#include <string>

class vtkXMLReader;

namespace gtn
{
/** VTK's readers. They read polyhedra of version 2.3, too, which VTK 9.3 and earlier leave without
 * faces. Errors are told as VTK's are. */
vtkSmartPointer<vtkXMLReader> MakeGridReader(const std::string& file);
vtkSmartPointer<vtkXMLReader> MakeParallelGridReader(const std::string& file);
}

#endif
