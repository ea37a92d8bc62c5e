// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunWriterCheck_h
#define gatunWriterCheck_h

#include "gatunMeshInput.h"
#include "gatunTypes.h"
#include "gatunWriterOptions.h"

#include <vector>

namespace gatun
{
/** Throws Error(InvalidInput) if a mesh, its arrays or the options cannot be written. */
void CheckWriterInput(
  const MeshInput& mesh, const std::vector<ArrayDescription>& arrays, const WriterOptions& options);

/** The same of the arrays alone. */
void CheckArrays(const std::vector<ArrayDescription>& arrays);
}

#endif
