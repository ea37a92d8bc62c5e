// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunWithType_h
#define gatunWithType_h

// Dispatch from types that are known at run time to code for each type.

#include "gatunTypes.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace gatun
{
/** Calls use(typed), where typed is the pointer values with the type of its values. */
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

/** The Euclidean length of a tuple. */
template <typename Value>
double GetTupleLength(const Value* tuple, std::size_t components)
{
  double sum = 0;
  for (std::size_t c = 0; c < components; ++c)
  {
    const auto value = static_cast<double>(tuple[c]);
    sum += value * value;
  }
  return std::sqrt(sum);
}

/** Calls use(getValue), where getValue(i) is the given component of tuple i as a double, or the
 * length of the tuple if component is -1. */
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
      use([=](std::size_t i) { return GetTupleLength(typed + components * i, components); });
    });
}

/** Reads single components of tuples, or lengths if component is -1, as doubles. Prefer
 * WithComponent for loops over many tuples of one component. */
class ComponentReader
{
public:
  ComponentReader(ScalarType type, const void* values, std::size_t components)
    : Values(values)
    , Components(components)
  {
    WithType(type, values,
      [this](const auto* typed)
      {
        using Value = std::remove_cvref_t<decltype(*typed)>;
        this->ReadComponent = [](const void* first, std::size_t i)
        { return static_cast<double>(static_cast<const Value*>(first)[i]); };
        this->ReadLength = [](const void* first, std::size_t i, std::size_t count)
        { return GetTupleLength(static_cast<const Value*>(first) + i, count); };
      });
  }

  double Get(std::size_t tuple, int component) const
  {
    const std::size_t first = tuple * this->Components;
    return component >= 0
      ? this->ReadComponent(this->Values, first + static_cast<std::size_t>(component))
      : this->ReadLength(this->Values, first, this->Components);
  }

private:
  const void* Values;
  std::size_t Components;
  double (*ReadComponent)(const void*, std::size_t) = nullptr;
  double (*ReadLength)(const void*, std::size_t, std::size_t) = nullptr;
};
}

#endif
