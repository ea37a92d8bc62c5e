// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleySample_h
#define gatunHartleySample_h

// Volumes for tests, made by rules that need no random numbers of the library.

#include "gatunHartleyFile.h"
#include "gatunHartleyVolume.h"
#include "gatunWithType.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace gatun::test
{
/** A volume with the memory that it needs. */
struct SampleVolume
{
  VolumeInput Input;
  std::vector<unsigned char> Data;

  std::size_t GetCount() const
  {
    return std::size_t{ this->Input.Size[0] } * this->Input.Size[1] * this->Input.Size[2];
  }
};

/** Fills a volume of a type with value(x, y, z), a double. */
template <typename Value>
SampleVolume MakeVolume(const HartleyLayout::Triple& size, ScalarType type, Value&& value)
{
  SampleVolume volume;
  volume.Input.Size = size;
  volume.Input.Type = type;
  volume.Input.Name = "sample";
  volume.Data.resize(volume.GetCount() * SizeOf(type));
  volume.Input.Values = volume.Data.data();
  WithType(type, volume.Data.data(),
    [&](const auto* typed)
    {
      using T = std::remove_cv_t<std::remove_pointer_t<decltype(typed)>>;
      unsigned char* out = volume.Data.data();
      for (std::uint32_t z = 0; z < size[2]; ++z)
      {
        for (std::uint32_t y = 0; y < size[1]; ++y)
        {
          for (std::uint32_t x = 0; x < size[0]; ++x)
          {
            const T one = static_cast<T>(value(x, y, z));
            std::memcpy(out, &one, sizeof(T));
            out += sizeof(T);
          }
        }
      }
    });
  return volume;
}

/** Numbers from 0 up to, not including, 1 that look random. */
inline double GetNoise(std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
  std::uint64_t state = x + 4099ull * y + 16777259ull * z + 1;
  state *= 0x9e3779b97f4a7c15ull;
  state ^= state >> 29;
  state *= 0xbf58476d1ce4e5b9ull;
  state ^= state >> 32;
  return static_cast<double>(state >> 11) / 9007199254740992.0;
}

/** A smooth hill with a hard edge and some noise, from 0 to 1. */
inline double GetPhantom(
  const HartleyLayout::Triple& size, std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
  const auto place = [](std::uint32_t i, std::uint32_t n) { return (i + 0.5) / n - 0.5; };
  const double u = place(x, size[0]);
  const double v = place(y, size[1]);
  const double w = place(z, size[2]);
  const double distance = u * u + 1.5 * v * v + w * w;
  if (distance > 0.2)
  {
    return 0;
  }
  return 0.95 * std::exp(-8 * distance) * (0.8 + 0.2 * std::cos(20 * u + 9 * w)) +
    0.05 * GetNoise(x, y, z);
}

/** The phantom in the middle of what a type can have, or in a part of that. */
inline SampleVolume MakePhantom(const HartleyLayout::Triple& size, ScalarType type)
{
  double first = 0;
  double length = 1;
  switch (type)
  {
    case ScalarType::Int8:
      first = -128;
      length = 255;
      break;
    case ScalarType::UInt8:
      length = 255;
      break;
    case ScalarType::Int16:
      first = -1024;
      length = 4000;
      break;
    case ScalarType::UInt16:
      length = 65535;
      break;
    case ScalarType::Int32:
      first = -2147483648.0;
      length = 4294967295.0;
      break;
    case ScalarType::UInt32:
      first = 3000000000.0;
      length = 100000;
      break;
    case ScalarType::Int64:
      first = -9007199254740000.0;
      length = 1e9;
      break;
    case ScalarType::UInt64:
      first = 9007199254000000.0;
      length = 5000;
      break;
    case ScalarType::Float32:
      first = -3;
      length = 12.5;
      break;
    case ScalarType::Float64:
      first = 1e5;
      length = 1e-3;
      break;
  }
  return MakeVolume(size, type,
    [&](std::uint32_t x, std::uint32_t y, std::uint32_t z)
    { return first + length * GetPhantom(size, x, y, z); });
}

/** All voxels of a file, in its type. */
inline std::vector<unsigned char> ReadVoxels(const HartleyFile& file)
{
  const auto& volume = file.GetVolume();
  std::vector<unsigned char> voxels(
    std::size_t{ volume.Size[0] } * volume.Size[1] * volume.Size[2] * SizeOf(volume.Type));
  file.GetVoxels({ 0, 0, 0 }, volume.Size, voxels.data());
  return voxels;
}

/** How far voxels are from those of a volume. */
struct VoxelDifference
{
  double RootMeanSquare = 0;
  double Largest = 0;
};

inline VoxelDifference Compare(const SampleVolume& volume, const std::vector<unsigned char>& voxels)
{
  VoxelDifference difference;
  WithComponent(volume.Input.Type, volume.Data.data(), 1, 0,
    [&](auto&& expected)
    {
      WithComponent(volume.Input.Type, voxels.data(), 1, 0,
        [&](auto&& found)
        {
          for (std::size_t i = 0; i < volume.GetCount(); ++i)
          {
            const double error = found(i) - expected(i);
            difference.RootMeanSquare += error * error;
            difference.Largest = std::max(difference.Largest, std::abs(error));
          }
        });
    });
  difference.RootMeanSquare =
    std::sqrt(difference.RootMeanSquare / static_cast<double>(volume.GetCount()));
  return difference;
}
}

#endif
