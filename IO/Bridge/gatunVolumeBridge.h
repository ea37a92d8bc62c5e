// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Conversion between VTK's images and the volumes of the core.

#ifndef gatunVolumeBridge_h
#define gatunVolumeBridge_h

#include "gatunArrayBridge.h"
#include "gatunHartleyVolume.h"

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"

#include <array>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkDataArray;
class vtkImageData;
class vtkInformation;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** A volume and the array that owns its values. */
struct BridgedVolume
{
  VolumeInput Volume;
  vtkSmartPointer<vtkDataArray> Owner;
};

/**
 * Describes a point array of an image as a volume. Wanted: the array selection of
 * vtkAlgorithm::GetInputArrayInformation. Contiguous values are not copied. Throws gatun::Error
 * (InvalidInput) if there is no such array or if it does not have one numeric component.
 */
VTKGATUNIO_EXPORT BridgedVolume BridgeVolume(vtkImageData* image, vtkInformation* wanted);

/** The point array that BridgeVolume uses. Throws the same errors. */
VTKGATUNIO_EXPORT vtkDataArray* FindVolumeArray(vtkImageData* image, vtkInformation* wanted);

/** The description by which a reader creates the array of a volume. */
VTKGATUNIO_EXPORT ArrayDescription DescribeVolumeArray(const VolumeInput& volume);

/** The extent of a volume. Throws gatun::Error (Corrupt) if it exceeds VTK's range. */
VTKGATUNIO_EXPORT std::array<int, 6> ExtentOf(const VolumeInput& volume);
}

#endif
