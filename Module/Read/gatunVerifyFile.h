// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunVerifyFile_h
#define gatunVerifyFile_h

#include "gatunExport.h"
#include "gatunFileReader.h"

#include <functional>

namespace gatun
{
/** Checks all checksums of a file and decodes all streams. Returns false if progress asked to stop.
 * Throws Error for the first defect. */
GATUN_EXPORT bool VerifyFile(
  const FileReader& file, const std::function<bool(double)>& progress = {});
}

#endif
