// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyTent_h
#define gatunHartleyTent_h

#include <cmath>
#include <numbers>

namespace gatun
{
/** The spectrum of the tent function: sin(pi f)^2 / (pi f)^2. Frequency: in cycles per voxel. */
inline double GetTentSpectrum(double frequency)
{
  const double angle = std::numbers::pi * frequency;
  const double sinc = std::abs(angle) < 1e-6 ? 1 : std::sin(angle) / angle;
  return sinc * sinc;
}
}

#endif
