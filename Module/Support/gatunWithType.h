// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunWithType_h
#define gatunWithType_h

// From values whose type is known at run time to code that is made for each type.

#include "gatunTypes.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace gatun
{
/** Calls use(pointer of the type that values have). */
template <typename Use>
void WithType(ScalarType type, const void* values, Use&& use)
{
  switch (type)
  {
    case ScalarType::Int8:
      return use(static_cast<const std::int8_t*>(values));
    case ScalarType::UInt8:
      return use(static_cast<const std::uint8_t*>(values));
    case ScalarType::Int16:
      return use(static_cast<const std::int16_t*>(values));
    case ScalarType::UInt16:
      return use(static_cast<const std::uint16_t*>(values));
    case ScalarType::Int32:
      return use(static_cast<const std::int32_t*>(values));
    case ScalarType::UInt32:
      return use(static_cast<const std::uint32_t*>(values));
    case ScalarType::Int64:
      return use(static_cast<const std::int64_t*>(values));
    case ScalarType::UInt64:
      return use(static_cast<const std::uint64_t*>(values));
    case ScalarType::Float32:
      return use(static_cast<const float*>(values));
    case ScalarType::Float64:
      return use(static_cast<const double*>(values));
  }
}

/** Calls use(getValue), where getValue(i) is a component of tuple i, or its length if component is
 * -1, as a double. */
template <typename Use>
void WithComponent(
  ScalarType type, const void* values, std::size_t components, int component, Use&& use)
{
  WithType(type, values,
    [&](const auto* typed)
    {
      if (component >= 0)
      {
        const auto* const first = typed + component;
        use([=](std::size_t i) { return static_cast<double>(first[components * i]); });
        return;
      }
      use(
        [=](std::size_t i)
        {
          double sum = 0;
          for (std::size_t c = 0; c < components; ++c)
          {
            const auto value = static_cast<double>(typed[components * i + c]);
            sum += value * value;
          }
          return std::sqrt(sum);
        });
    });
}
}

#endif
