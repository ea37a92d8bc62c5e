// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunHartleyCamera_h
#define gatunHartleyCamera_h

#include "gatunHartleyFrame.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkCamera;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The view of a camera, or of its left or right eye if it is in stereo, in an image of a given
 * size. The clipping range has no influence. Throws InvalidInput unless the projection is parallel,
 * and if the camera is sheared, scales the image unevenly, or if its directions do not define a
 * view. */
HartleyEye MakeHartleyEye(vtkCamera* camera, int width, int height);
}

#endif
