// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunObjectPoints_h
#define gatunObjectPoints_h

// The points of what is drawn, for cameras that show all of it.

#include "gatunFraming.h"
#include "gatunHartleyInput.h"

#include "vtkType.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <cstddef>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkDataObject;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
class SharedFile;

/** The points that the cells of a grid or a surface use, or the corners of an image. The data must
 * stay as it is. Throws Error(InvalidInput) for other data. */
PointBlocks GetObjectPoints(vtkDataObject* data);

/** The points of the chunks of a file at a step. Chunks that reach farthest are decoded, up to a
 * few; the boxes of others stand for them. The file must stay. */
PointBlocks GetObjectPoints(SharedFile& file, std::size_t step);

/** The corners of a volume, where it has fallen to zero. */
PointBlocks GetObjectPoints(const VolumeInput& volume);
}

#endif
