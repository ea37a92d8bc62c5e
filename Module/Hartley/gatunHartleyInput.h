// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyInput_h
#define gatunHartleyInput_h

#include "gatunHartleyLayout.h"
#include "gatunTypes.h"

#include <array>
#include <cstdint>
#include <string>

namespace gatun
{
/** A regular volume of scalars in the caller's memory. */
struct VolumeInput
{
  HartleyLayout::Triple Size{};
  ScalarType Type = ScalarType::UInt8;
  const void* Values = nullptr; ///< x fastest

  // Readers return these members unchanged. The encoder does not use them.
  std::string Name;
  std::int32_t VTKType = 0; ///< as in ArrayDescription
  std::array<double, 3> Origin{};
  std::array<double, 3> Spacing{ 1, 1, 1 };
  std::array<double, 9> Direction{ 1, 0, 0, 0, 1, 0, 0, 0, 1 }; ///< rows
  std::array<std::int32_t, 3> FirstIndex{};                     ///< first index of the extent
};

/** The quantity that determines the quantizer's step. The numbers are part of the file format. */
enum class HartleyRateMode : std::uint8_t
{
  Quality = 0,     ///< 1 to 100: the step is range * 2^(-Value / 10)
  RMSError = 1,    ///< upper bound of the root mean square error of the voxels; 0: lossless
  PSNR = 2,        ///< lower bound of 20 log10(range / root mean square error), in dB
  BitsPerVoxel = 3 ///< size of the whole file
};

/** Rate control: how accurately a volume is stored. */
struct HartleyRateControl
{
  HartleyRateMode Mode = HartleyRateMode::Quality;
  double Value = 60;

  /** How much coarser the highest frequencies are quantized than the lowest: 0 (not at all) to 4.
   */
  double FrequencyWeight = 0;

  bool operator==(const HartleyRateControl&) const = default;
};
}

#endif
