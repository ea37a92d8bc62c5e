// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCornerRotation_h
#define gatunCornerRotation_h

#include <array>
#include <cstdint>

namespace gatun
{
/** Applies one of the 12 even permutations of four corners; 0 is the identity. */
template <typename T>
std::array<T, 4> RotateCorners(const std::array<T, 4>& corners, unsigned rotation)
{
  static constexpr std::uint8_t orders[12][4] = { { 0, 1, 2, 3 }, { 0, 2, 3, 1 }, { 0, 3, 1, 2 },
    { 1, 0, 3, 2 }, { 1, 3, 2, 0 }, { 1, 2, 0, 3 }, { 2, 3, 0, 1 }, { 2, 0, 1, 3 }, { 2, 1, 3, 0 },
    { 3, 2, 1, 0 }, { 3, 1, 0, 2 }, { 3, 0, 2, 1 } };
  const auto* order = orders[rotation];
  return { corners[order[0]], corners[order[1]], corners[order[2]], corners[order[3]] };
}

inline unsigned FindCorner(const std::array<std::uint32_t, 4>& tet, std::uint32_t vertex)
{
  return tet[1] == vertex ? 1 : tet[2] == vertex ? 2 : tet[3] == vertex ? 3 : 0;
}

/** Compares inline, where std::array calls a function. */
inline bool IsSame(const std::array<std::uint32_t, 4>& a, const std::array<std::uint32_t, 4>& b)
{
  return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2]) | (a[3] ^ b[3])) == 0;
}

/** The rotation that converts walked corners to those of the input. flip: whether they are
 * mirrored. */
inline std::uint8_t FindRotation(const std::array<std::uint32_t, 4>& walked,
  const std::array<std::uint32_t, 4>& wanted, bool& flip)
{
  // Indexed by the positions of the first two wanted corners among the walked ones. Each pair has
  // one even permutation; mirrored corners use the same with 2 and 3 exchanged.
  static const auto rotations = []
  {
    std::array<std::uint8_t, 16> table{};
    for (std::uint8_t r = 0; r < 12; ++r)
    {
      const auto order = RotateCorners(std::array<unsigned, 4>{ 0, 1, 2, 3 }, r);
      table[4 * order[0] + order[1]] = r;
    }
    return table;
  }();
  flip = false;
  if (IsSame(walked, wanted))
  {
    return 0;
  }
  const auto first = FindCorner(walked, wanted[0]);
  const auto second = FindCorner(walked, wanted[1]);
  const auto rotation = rotations[4 * first + second];
  flip = !IsSame(RotateCorners(walked, rotation), wanted);
  if (!flip)
  {
    return rotation;
  }
  const auto mirror = [](unsigned place) { return place < 2 ? place : 5 - place; };
  return rotations[4 * mirror(first) + mirror(second)];
}
}

#endif
