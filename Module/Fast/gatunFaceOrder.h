// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFaceOrder_h
#define gatunFaceOrder_h

// Points and faces of polyhedra in an order that many of them have in common.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
struct OrderedFaces
{
  std::vector<std::uint32_t> Points; ///< those of the cell, then those that only its faces have
  std::uint32_t Hidden = 0;          ///< the number of the latter

  /** For each face, the number of its corners, then their first places in Points. */
  std::vector<std::uint32_t> Pattern;
};

/** Orders a polyhedron. Its points and faces may come in another order if all points are corners of
 * faces. isNew: whether a point was met before the cell; these come first where that is possible.
 */
OrderedFaces OrderFaces(std::span<const std::uint32_t> corners,
  std::span<const std::uint32_t> faces, const std::function<bool(std::uint32_t)>& isNew);
}

#endif
