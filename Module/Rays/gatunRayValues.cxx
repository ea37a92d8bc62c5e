// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayValues.h"

#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunWithType.h"

#include <algorithm>
#include <string>

namespace gatun
{
namespace
{
void CheckComponent(const FileReader& file, std::uint32_t index, int component)
{
  const auto& arrays = file.GetArrays();
  if (index >= arrays.size())
  {
    ThrowInvalid("there is no such array", file.GetPath());
  }
  const auto& array = arrays[index];
  if (component < -1 || component >= static_cast<int>(array.Components))
  {
    ThrowInvalid(
      "array '" + array.Name + "' has no component " + std::to_string(component), file.GetPath());
  }
}
}

//------------------------------------------------------------------------------
void TakeHues(const RayHuesInput& input, std::span<const std::uint32_t> tuples, RayHues& hues)
{
  const RayValuesInput& values = input.Values;
  hues.Channels = input.Channels;
  hues.OfCells = values.Where == Association::Cell;
  hues.Values.resize(tuples.size() * input.Channels);
  // Colors of integers are from 0 to 255.
  const bool isFloating = values.Type == ScalarType::Float32 || values.Type == ScalarType::Float64;
  const double scale = input.Channels == 3 && !isFloating ? 1.0 / 255 : 1;
  for (unsigned channel = 0; channel < input.Channels; ++channel)
  {
    const int component = input.Channels == 1 ? values.Component : static_cast<int>(channel);
    WithComponent(values.Type, values.Values, values.Components, component,
      [&](auto&& getValue)
      {
        for (std::size_t i = 0; i < tuples.size(); ++i)
        {
          hues.Values[i * input.Channels + channel] = scale * getValue(tuples[i]);
        }
      });
  }
}

//------------------------------------------------------------------------------
void CheckRayValues(const FileReader& file, const RayValues& values)
{
  CheckComponent(file, values.Array, values.Component);
  if (values.Hues.Channels > 0)
  {
    CheckComponent(file, values.Hues.Array, values.Hues.Channels == 3 ? 2 : values.Hues.Component);
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
