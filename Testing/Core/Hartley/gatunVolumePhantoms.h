// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunVolumePhantoms_h
#define gatunVolumePhantoms_h

// Made volumes, of any size: a head with vessels, a smooth field, a constant.

#include "gatunHartleyVolume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace gatun::test
{
/** A volume with its voxels. */
template <typename Value>
struct Phantom
{
  std::array<std::uint32_t, 3> Size{};
  std::vector<Value> Values;

  VolumeInput GetInput() const
  {
    VolumeInput input;
    input.Size = this->Size;
    input.Type = GetType();
    input.Values = this->Values.data();
    input.Name = "phantom";
    return input;
  }

  static constexpr ScalarType GetType()
  {
    if constexpr (std::is_same_v<Value, std::uint8_t>)
    {
      return ScalarType::UInt8;
    }
    else
    {
      return ScalarType::Float32;
    }
  }
};

/** What function says at each voxel; x, y and z go from -1 to 1 along the longest axis. */
template <typename Value, typename Function>
Phantom<Value> MakePhantom(const std::array<std::uint32_t, 3>& size, const Function& function)
{
  Phantom<Value> phantom;
  phantom.Size = size;
  phantom.Values.reserve(std::size_t{ size[0] } * size[1] * size[2]);
  const double half = std::max({ size[0], size[1], size[2] }) / 2.0;
  for (std::uint32_t k = 0; k < size[2]; ++k)
  {
    for (std::uint32_t j = 0; j < size[1]; ++j)
    {
      for (std::uint32_t i = 0; i < size[0]; ++i)
      {
        phantom.Values.push_back(function((i + 0.5 - size[0] / 2.0) / half,
          (j + 0.5 - size[1] / 2.0) / half, (k + 0.5 - size[2] / 2.0) / half));
      }
    }
  }
  return phantom;
}

/** From 0 to 1 over about two voxels around the surface of an ellipsoid. */
inline double GetInside(const std::array<double, 3>& point, const std::array<double, 3>& center,
  const std::array<double, 3>& radii, double voxel)
{
  double squares = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double part = (point[axis] - center[axis]) / radii[axis];
    squares += part * part;
  }
  const double depth = (1 - std::sqrt(squares)) * std::min({ radii[0], radii[1], radii[2] });
  return std::clamp(0.5 + depth / (2 * voxel), 0.0, 1.0);
}

/** How much of a vessel is at a point: a tube of the radius that winds about an axis. */
inline double GetVessel(
  double along, double across, double up, double winding, double radius, double voxel)
{
  const double dx = across - 0.28 * std::sin(winding * along + 1) - 0.08 * std::sin(9 * along);
  const double dy = up - 0.28 * std::cos(0.8 * winding * along) - 0.06 * std::sin(11 * along + 2);
  // A tube that winds is cut at a slant; the distance is a little too large, the vessel thinner.
  return std::clamp(0.5 + (radius - std::sqrt(dx * dx + dy * dy)) / (2 * voxel), 0.0, 1.0);
}

/** Bone, tissue, cavities, fine bright vessels and the noise of a scanner, in ellipsoids as those
 * of Shepp's and Logan's head. Outside is 0. */
inline Phantom<std::uint8_t> MakeHead(const std::array<std::uint32_t, 3>& size)
{
  const double voxel = 2.0 / std::max({ size[0], size[1], size[2] });
  std::uint32_t state = 12345;
  return MakePhantom<std::uint8_t>(size,
    [&](double x, double y, double z) -> std::uint8_t
    {
      const std::array<double, 3> point{ x, y, z };
      const double skull = GetInside(point, { 0, 0, 0 }, { 0.69, 0.85, 0.88 }, voxel);
      const double brain = GetInside(point, { 0, -0.015, 0 }, { 0.63, 0.78, 0.82 }, voxel);
      double value = 175 * skull * (1 - brain) + 62 * brain;
      value -= 34 * GetInside(point, { 0.22, 0, 0 }, { 0.11, 0.31, 0.25 }, voxel);
      value -= 34 * GetInside(point, { -0.22, 0, 0 }, { 0.16, 0.41, 0.3 }, voxel);
      value += 22 * GetInside(point, { 0, 0.35, -0.15 }, { 0.21, 0.25, 0.41 }, voxel);
      value += 30 * GetInside(point, { 0, 0.1, 0.25 }, { 0.046, 0.046, 0.05 }, voxel);
      value += 45 * GetInside(point, { -0.08, -0.605, 0 }, { 0.046, 0.046, 0.07 }, voxel);
      const double thick = std::max(0.02, 1.2 * voxel);
      const double thin = std::max(0.009, 0.7 * voxel);
      const double vessels = std::max({ GetVessel(z, x, y, 4, thick, voxel),
        GetVessel(y, x, z, 5, thin, voxel), GetVessel(x, y, z, 6, thin, voxel) });
      value += (210 - value) * vessels * brain;
      // Noise of a linear congruential generator, the same everywhere.
      state = state * 1664525u + 1013904223u;
      const double noise = static_cast<double>(state >> 8) / 16777216.0 - 0.5;
      return static_cast<std::uint8_t>(std::clamp(value + 6 * noise * skull + 0.5, 0.0, 255.0));
    });
}

/** Waves under a bell: smooth, positive, and almost 0 at the border. */
inline Phantom<float> MakeSmooth(const std::array<std::uint32_t, 3>& size)
{
  return MakePhantom<float>(size,
    [](double x, double y, double z)
    {
      const double bell = std::exp(-5 * (x * x + 1.4 * y * y + 1.2 * z * z));
      return static_cast<float>(
        1000 * bell * (1 + 0.4 * std::sin(7 * x + 1) * std::cos(6 * y) + 0.3 * std::sin(8 * z)));
    });
}

inline Phantom<float> MakeConstant(const std::array<std::uint32_t, 3>& size, float value)
{
  return MakePhantom<float>(size, [value](double, double, double) { return value; });
}
}

#endif
