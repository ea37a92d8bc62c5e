// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayValues.h"

#include "gatunError.h"
#include "gatunFileReader.h"

#include <algorithm>
#include <string>

namespace gatun
{
//------------------------------------------------------------------------------
void CheckRayValues(const FileReader& file, const RayValues& values)
{
  const auto& arrays = file.GetArrays();
  if (values.Array >= arrays.size())
  {
    ThrowInvalid("there is no such array", file.GetPath());
  }
  const auto& array = arrays[values.Array];
  if (values.Component < -1 || values.Component >= static_cast<int>(array.Components))
  {
    ThrowInvalid("array '" + array.Name + "' has no component " + std::to_string(values.Component),
      file.GetPath());
  }
  if (values.Step >= file.GetNumberOfSteps())
  {
    ThrowInvalid("there is no such time step", file.GetPath());
  }
}

//------------------------------------------------------------------------------
Range GetDrawnRange(const ArrayRanges& ranges, int component)
{
  if (component >= 0)
  {
    return ranges[static_cast<std::size_t>(component)];
  }
  const Range& last = ranges.back();
  if (ranges.size() > 1 || last.Min >= 0 || !(last.Min <= last.Max))
  {
    return last;
  }
  return { std::max(0.0, -last.Max), std::max(-last.Min, last.Max) };
}
}
