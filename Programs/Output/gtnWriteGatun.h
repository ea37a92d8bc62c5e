// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnWriteGatun_h
#define gtnWriteGatun_h

#include <string>

class vtkDataObject;

namespace gtn
{
class Progress;

/** Lets a vtkGatunWriter or vtkGatunHartleyWriter write whose input and file name are set. Throws
 * Failure for inputName or for the file, whichever is to blame, and Interrupted. */
template <typename Writer>
void RunWriter(Writer* writer, const std::string& inputName, Progress& progress);

/** Writes a grid or a surface with the writer's defaults. Throws likewise. */
void WriteGatun(vtkDataObject* mesh, const std::string& file, Progress& progress);
}

#endif
