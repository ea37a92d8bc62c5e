// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchZfp_h
#define benchZfp_h

// zfp, next to which sizes and errors are measured, where it is installed.

#include <array>
#include <cstdint>
#include <vector>

namespace bench
{
bool HasZfp();

/** How zfp is told what to keep. */
enum class ZfpMode
{
  Accuracy,  ///< of floats: no error larger than the value
  Precision, ///< of floats: so many bit planes
  Reversible ///< of integers: lossless
};

struct ZfpResult
{
  std::uint64_t Bytes = 0;
  std::vector<float> Voxels;
};

/** There and back again. Throws Failure. */
ZfpResult RunZfp(const std::vector<float>& voxels, const std::array<std::uint32_t, 3>& size,
  ZfpMode mode, double value);
}

#endif
