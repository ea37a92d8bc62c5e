// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeRange_h
#define gatunMergeRange_h

#include <cmath>
#include <limits>
#include <vector>

namespace gatun
{
/** Returns factors for the values of fields: values are relative to the range, and the squares of
 * the factors to the weight. They are 0 for a field without a range. */
template <typename Fields>
std::vector<double> FindFieldScales(const Fields& fields)
{
  double weights = 0;
  for (const auto& field : fields)
  {
    weights += field.Weight;
  }
  std::vector<double> scales;
  for (const auto& field : fields)
  {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    for (const double value : field.Values)
    {
      low = value < low ? value : low;
      high = value > high ? value : high;
    }
    const double range = high - low;
    scales.push_back(range > 0 && weights > 0 ? std::sqrt(field.Weight / weights) / range : 0);
  }
  return scales;
}
}

#endif
