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

  // What readers get back, and nothing here depends on.
  std::string Name;
  std::int32_t VTKType = 0; ///< as in ArrayDescription
  std::array<double, 3> Origin{};
  std::array<double, 3> Spacing{ 1, 1, 1 };
  std::array<double, 9> Direction{ 1, 0, 0, 0, 1, 0, 0, 0, 1 }; ///< rows
  std::array<std::int32_t, 3> FirstIndex{};                     ///< where the extent begins
};

/** How well a volume is kept. Exactly one of Quality, Error and PSNR says it. */
struct HartleyQuality
{
  enum class Goal : std::uint8_t
  {
    Quality =
      0,       ///< Value from 1 to 100: the step of the quantiser is range * 2^(-Value / 10) (say)
    Error = 1, ///< Value: root mean square error of the voxels, in their unit; 0: lossless
    PSNR = 2,  ///< Value: 20 log10(range / root mean square error), in dB
    Rate = 3   ///< Value: bits a voxel of the whole file
  };
  Goal Kind = Goal::Quality;
  double Value = 60;

  /** How much coarser the highest frequencies are quantised than the lowest, 0 (not at all) to 4.
   */
  double FrequencyWeight = 0;
};
}

#endif
