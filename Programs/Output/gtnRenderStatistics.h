// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnRenderStatistics_h
#define gtnRenderStatistics_h

// Statistics of rendering an image.

#include "gtnJson.h"

#include <vector>

namespace gtn
{
struct Statistic
{
  enum KindType
  {
    Seconds,
    Count,
    Bytes
  };

  const char* Name; ///< in JSON
  const char* Title;
  KindType Kind;
  double Value; ///< NaN: unknown
};

using Statistics = std::vector<Statistic>;

/** Returns the bytes that the program has read from files so far, or NaN if unknown. */
double CountBytesRead();

/** Returns the peak memory of the program so far, or NaN if unknown. */
double GetPeakMemory();

void PrintTable(const Statistics& statistics);
Json::Value JsonOf(const Statistics& statistics);
}

#endif
