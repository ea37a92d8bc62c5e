// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeRange_h
#define gatunMergeRange_h

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace gatun
{
/** The range of a field, and its weight relative to those of other fields. */
struct FieldRange
{
  double Weight = 1;
  double Low = std::numeric_limits<double>::max();
  double High = std::numeric_limits<double>::lowest();

  void Include(std::span<const double> values)
  {
    for (const double value : values)
    {
      this->Low = value < this->Low ? value : this->Low;
      this->High = value > this->High ? value : this->High;
    }
  }
};

/** Returns factors for the values of fields: values are relative to the range, and the squares of
 * the factors to the weight. They are 0 for a field without a range. */
inline std::vector<double> FindFieldScales(std::span<const FieldRange> fields)
{
  double weights = 0;
  for (const FieldRange& field : fields)
  {
    weights += field.Weight;
  }
  std::vector<double> scales;
  for (const FieldRange& field : fields)
  {
    const double range = field.High - field.Low;
    scales.push_back(range > 0 && weights > 0 ? std::sqrt(field.Weight / weights) / range : 0);
  }
  return scales;
}

/** The same for the fields of a BasicMergeInput. */
template <typename Field>
std::vector<double> FindFieldScales(const std::vector<Field>& fields)
{
  std::vector<FieldRange> ranges;
  for (const Field& field : fields)
  {
    ranges.push_back({ field.Weight });
    ranges.back().Include(field.Values);
  }
  return FindFieldScales(std::span<const FieldRange>(ranges));
}
}

#endif
