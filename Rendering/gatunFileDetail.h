// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileDetail_h
#define gatunFileDetail_h

// Files that hold how their mesh can be simplified.

#include "gatunLevelsOfDetail.h"
#include "gatunRaySource.h"
#include "gatunRayValues.h"

#include <memory>

namespace gatun
{
class FileReader;

/** Whether a file can be drawn with fewer points. Decodes nothing. */
bool HasDetail(const FileReader& file);

/** A file that can, with any number of its points. May be called in the background. */
std::shared_ptr<LevelsOfDetail> MakeFileDetail(std::shared_ptr<const FileReader> file,
  const RayValues& values, const RaySource::Progress& progress);
}

#endif
