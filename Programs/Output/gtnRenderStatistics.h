// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnRenderStatistics_h
#define gtnRenderStatistics_h

// What a picture took.

#include <array>
#include <vector>

class vtkGatunRayCaster;

namespace gtn
{
class Json;

struct Statistic
{
  enum KindType
  {
    Seconds,
    Count,
    Bytes
  };

  const char* Name; ///< as in JSON
  const char* Title;
  KindType Kind;
};

/** What Measure tells, in that order. */
extern const std::array<Statistic, 14> Statistics;
using Measurement = std::array<double, 14>; ///< NaN: not known

/** What the caster knows of its last picture, with the seconds that went by and the bytes that the
 * program read meanwhile. */
Measurement Measure(vtkGatunRayCaster* caster, double seconds, double bytesRead);

/** Of each statistic by itself. */
Measurement MedianOf(const std::vector<Measurement>& all);

/** Bytes that the program has read from files so far; NaN where that is not known. */
double CountBytesRead();

/** The most memory that the program had so far; NaN where that is not known. */
double GetPeakMemory();

void PrintTable(const Measurement& measurement, double peakMemory);
void AddMeasurement(Json& json, const Measurement& measurement);
}

#endif
