// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunVolumeProp_h
#define gatunVolumeProp_h

#include "vtkSmartPointer.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkPVLODVolume;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** A volume that calls a vtkGatunVolumeMapper with a controller for each image, even if its input
 * lacks the array to draw. ParaView's does not, and other processes would wait for it. */
vtkSmartPointer<vtkPVLODVolume> MakeVolumeProp();
}

#endif
