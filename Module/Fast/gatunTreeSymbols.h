// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTreeSymbols_h
#define gatunTreeSymbols_h

// The symbols of TetTree.

#include "gatunTetTree.h"

#include <array>
#include <cstdint>

namespace gatun::TreeSymbols
{
// The fourth corner of an attached tetrahedron: a new vertex, any other one (a number follows), or
// the fourth corner of a tetrahedron 1 to Reach before this one, behind the parent, or before it.
constexpr std::uint8_t New = 0;
constexpr std::uint8_t Far = 1;
constexpr unsigned Reach = 8;
constexpr std::uint8_t Before = 2;
constexpr std::uint8_t BehindParent = Before + Reach;
constexpr std::uint8_t BeforeParent = BehindParent + Reach;
constexpr unsigned Count = BeforeParent + Reach;

/** Faces 0, 1 and 2 are opposite to these corners p: p1 p2 p3, p2 p0 p3 and p0 p1 p3. Face 3 is
 * that to the parent. */
constexpr unsigned FaceCount = 3;

/** The lowest bit of the first corner of each face, where p0 follows p2. */
constexpr std::array<unsigned, FaceCount> FaceShifts{ 16, 32, 0 };

constexpr PackedTet LowThree = 0xffffffffffffu;

/** The face of a tetrahedron that begins at a shift, as three corners. */
constexpr PackedTet GetFace(PackedTet tet, unsigned shift)
{
  const PackedTet turned = (tet & LowThree) | tet << 48;
  return (turned >> shift & 0xffffffffu) | tet >> 48 << 32;
}

/** The corner opposite to the face that begins at a shift. */
constexpr PackedTet GetOpposite(PackedTet tet, unsigned shift)
{
  // A table, as compilers make unpredictable branches of conditions.
  constexpr std::array<std::uint8_t, FaceCount> shifts{ 32, 0, 16 };
  return tet >> shifts[shift / 16] & 0xffff;
}

constexpr PackedTet Pack(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
  return PackedTet{ a } | PackedTet{ b } << 16 | PackedTet{ c } << 32 | PackedTet{ d } << 48;
}
}

#endif
