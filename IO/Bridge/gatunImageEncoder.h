// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunImageEncoder_h
#define gatunImageEncoder_h

#include "gatunVolumeBridge.h"

#include "vtkWeakPointer.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace gatun
{
/** How a volume is encoded. */
struct HartleyParameters
{
  std::uint32_t BlockSize = 8;
  HartleyRateControl RateControl;

  bool operator==(const HartleyParameters&) const = default;
};

/** Encodes an image as Hartley coefficients, and again when it or a parameter has changed. */
class VTKGATUNIO_EXPORT ImageEncoder
{
public:
  /** Returns whether coefficients were computed; otherwise those of the previous call are valid.
   * Throws what BridgeVolume and HartleyVolume::Make throw, and then has no coefficients. */
  bool Encode(vtkImageData* image, vtkInformation* wanted, const HartleyParameters& parameters,
    const std::function<bool(double)>& progress);

  /** Null if there are none. */
  const std::shared_ptr<const HartleyVolume>& GetCoefficients() const { return this->Coefficients; }

  /** The description of the encoded volume, without its values. */
  const VolumeInput& GetVolume() const { return this->Volume; }

  void Clear();

private:
  std::shared_ptr<const HartleyVolume> Coefficients;
  VolumeInput Volume;

  // The source of the coefficients.
  vtkWeakPointer<vtkDataArray> Array;
  vtkMTimeType Time = 0;
  HartleyParameters Parameters;
};
}

#endif
