// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunVerifyFile_h
#define gatunVerifyFile_h

#include "gatunFileReader.h"
#include "vtkGatunCoreModule.h"

#include <functional>

namespace gatun
{
/** Reads a whole file and checks every checksum and that every stream decodes. Returns false if
 * progress asked to stop. Throws gatun::Error at the first thing that is wrong. */
VTKGATUNCORE_EXPORT bool VerifyFile(
  const FileReader& file, const std::function<bool(double)>& progress = {});
}

#endif
