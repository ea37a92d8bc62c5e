// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// VTK's images and the volumes that the core knows, in both directions.

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
/** A volume, and what keeps its values alive. */
struct BridgedVolume
{
  VolumeInput Volume;
  vtkSmartPointer<vtkDataArray> Owner;
};

/**
 * Describes an image as a volume, with one of its point arrays: wanted is what
 * vtkAlgorithm::GetInputArrayInformation tells. Values that lie in memory one after the other are
 * not copied. Throws gatun::Error (InvalidInput) where there is no such array, or it is none of
 * single numbers.
 */
VTKGATUNIO_EXPORT BridgedVolume BridgeVolume(vtkImageData* image, vtkInformation* wanted);

/** The point array that BridgeVolume takes. Throws what that does. */
VTKGATUNIO_EXPORT vtkDataArray* FindVolumeArray(vtkImageData* image, vtkInformation* wanted);

/** How a reader makes a volume's array. */
VTKGATUNIO_EXPORT ArrayDescription DescribeVolumeArray(const VolumeInput& volume);

/** The extent of a volume. Throws gatun::Error (Corrupt) where it does not fit into VTK's. */
VTKGATUNIO_EXPORT std::array<int, 6> ExtentOf(const VolumeInput& volume);

/** How well to keep a volume, as VTK's classes are told. */
struct HartleyGoal
{
  int Goal = 0; ///< number of a HartleyQuality::Goal
  double Quality = 60;
  double Error = 0;
  double PSNR = 50;
  double Rate = 1;
  double FrequencyWeight = 0;

  bool operator==(const HartleyGoal&) const = default;
};

VTKGATUNIO_EXPORT HartleyQuality MakeHartleyQuality(const HartleyGoal& goal);
}

#endif
