// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Conversion between VTK's images and the volumes of the core.

#ifndef gatunVolumeBridge_h
#define gatunVolumeBridge_h

#include "gatunArrayBridge.h"
#include "gatunHartleyVolume.h"

#include "vtkGatunIOModule.h" // For export macro
#include "vtkIndent.h"
#include "vtkSmartPointer.h"

#include <array>
#include <iosfwd>

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

/** The compression parameters of VTK's classes, with their defaults. */
struct HartleyParameters
{
  int BlockSize = 8;
  int RateControl = 0; ///< number of a HartleyRateMode
  double Quality = 60;
  double RMSError = 0;
  double PSNR = 50;
  double BitsPerVoxel = 1;
  double FrequencyWeight = 0;

  bool operator==(const HartleyParameters&) const = default;
};

/** The nearest block size that is possible: 0 (or less) for the whole volume, or 2 to 64. */
VTKGATUNIO_EXPORT int ClampBlockSize(int blockSize);

/** The mode and the value that belongs to it. */
VTKGATUNIO_EXPORT HartleyRateControl MakeRateControl(const HartleyParameters& parameters);

/** Prints the parameters for PrintSelf. */
VTKGATUNIO_EXPORT void PrintParameters(
  std::ostream& os, vtkIndent indent, const HartleyParameters& parameters);
}

#endif
