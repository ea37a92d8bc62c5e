// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayInstructions_h
#define gatunRayInstructions_h

#include <cstdint>

namespace gatun
{
/** The instruction sets for which the inner loops are compiled. */
enum class RayInstructions : std::uint8_t
{
  Portable, ///< those of all processors
  AVX2,     ///< AVX2 and FMA
  AVX512,   ///< AVX-512 F, VL, DQ and BW
  Best = AVX512
};
}

#endif
