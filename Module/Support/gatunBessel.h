// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBessel_h
#define gatunBessel_h

#include <limits>

namespace gatun
{
/** The modified Bessel function of the first kind of order 0, for the windows of Kaiser and Bessel.
 * libc++ has no std::cyl_bessel_i. */
inline double GetBessel(double x)
{
  // The sum of (x / 2)^2k / k!^2, whose terms are all positive.
  const double square = x * x / 4;
  double sum = 1;
  double term = 1;
  for (int k = 1; term > sum * (std::numeric_limits<double>::epsilon() / 4); ++k)
  {
    term *= square / (static_cast<double>(k) * k);
    sum += term;
  }
  return sum;
}
}

#endif
