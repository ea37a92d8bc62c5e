// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFrameClock_h
#define gatunFrameClock_h

#include <chrono>

namespace gatun
{
/** An image with this many seconds allocated or more is at rest: interaction allocates a second or
 * less, a still image minutes. */
constexpr double LeastTimeAtRest = 10;

using FrameClock = std::chrono::steady_clock;

/** Returns the seconds since a time. */
inline double SecondsSince(FrameClock::time_point begin)
{
  return std::chrono::duration<double>(FrameClock::now() - begin).count();
}
}

#endif
