// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPlainKeys_h
#define gatunPlainKeys_h

#include "gatunInline.h"
#include "gatunTypes.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace gatun
{
using Key = std::uint64_t;

/** Keys of all values of a type, in the order of the values. */
class PlainKeys
{
public:
  /** The key of the value at an address. */
  static Key ReadPlain(ScalarType type, const void* value)
  {
    Key raw = 0;
    std::memcpy(&raw, value, SizeOf(type));
    return FromRaw(type, raw);
  }

  /** The key of a value given by its bits. */
  static Key FromRaw(ScalarType type, Key raw)
  {
    const unsigned bits = static_cast<unsigned>(8 * SizeOf(type));
    const Key sign = Key{ 1 } << (bits - 1);
    switch (type)
    {
      case ScalarType::Int8:
      case ScalarType::Int16:
      case ScalarType::Int32:
      case ScalarType::Int64:
        return raw ^ sign;
      case ScalarType::Float32:
        return (raw & sign) ? ~raw & 0xffffffffu : raw | sign;
      case ScalarType::Float64:
        return (raw & sign) ? ~raw : raw | sign;
      default:
        return raw;
    }
  }

  /** The inverse of ReadPlain. */
  GATUN_INLINE static void WritePlain(ScalarType type, Key key, void* value)
  {
    const unsigned bits = static_cast<unsigned>(8 * SizeOf(type));
    const Key sign = Key{ 1 } << (bits - 1);
    switch (type)
    {
      case ScalarType::Int8:
      case ScalarType::Int16:
      case ScalarType::Int32:
      case ScalarType::Int64:
        key ^= sign;
        break;
      case ScalarType::Float32:
      case ScalarType::Float64:
        // The sign of positive numbers, else all bits. A condition would be an unpredictable
        // branch.
        key ^= sign | ((key >> (bits - 1) & 1) - 1);
        break;
      default:
        break;
    }
    std::memcpy(value, &key, SizeOf(type));
  }

  static double PlainToNumber(ScalarType type, Key key)
  {
    switch (type)
    {
      case ScalarType::Float32:
      {
        float value;
        WritePlain(type, key, &value);
        return value;
      }
      case ScalarType::Float64:
      {
        double value;
        WritePlain(type, key, &value);
        return value;
      }
      case ScalarType::Int8:
      case ScalarType::Int16:
      case ScalarType::Int32:
      case ScalarType::Int64:
        return static_cast<double>(
          static_cast<std::int64_t>(key - (Key{ 1 } << (8 * SizeOf(type) - 1))));
      default:
        return static_cast<double>(key);
    }
  }

  /** The key of a number that is rounded to a floating type. */
  static Key RoundToFloating(ScalarType type, double number)
  {
    return type == ScalarType::Float32
      ? FromRaw(type, std::bit_cast<std::uint32_t>(static_cast<float>(number)))
      : FromRaw(type, std::bit_cast<std::uint64_t>(number));
  }

  /** The key closest to a finite number. */
  static Key FromNumber(ScalarType type, double number)
  {
    const unsigned bits = static_cast<unsigned>(8 * SizeOf(type));
    const Key last = bits == 64 ? ~Key{ 0 } : (Key{ 1 } << bits) - 1;
    switch (type)
    {
      case ScalarType::Float32:
      {
        constexpr double largest = std::numeric_limits<float>::max();
        const float value = static_cast<float>(number > largest ? largest
            : number < -largest                                 ? -largest
                                                                : number);
        return FromRaw(ScalarType::Float32, std::bit_cast<std::uint32_t>(value));
      }
      case ScalarType::Float64:
        return FromRaw(ScalarType::Float64, std::bit_cast<std::uint64_t>(number));
      case ScalarType::Int8:
      case ScalarType::Int16:
      case ScalarType::Int32:
      case ScalarType::Int64:
      {
        const double half = std::ldexp(1.0, static_cast<int>(bits) - 1);
        const double whole = std::floor(number + 0.5);
        return whole <= -half ? 0
          : whole >= half
          ? last
          : static_cast<Key>(static_cast<std::int64_t>(whole)) + (Key{ 1 } << (bits - 1));
      }
      default:
      {
        const double end = std::ldexp(1.0, static_cast<int>(bits));
        const double whole = std::floor(number + 0.5);
        return whole <= 0 ? 0 : whole >= end ? last : static_cast<Key>(whole);
      }
    }
  }
};
}

#endif
