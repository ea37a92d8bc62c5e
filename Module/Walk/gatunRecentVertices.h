// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunRecentVertices_h
#define gatunRecentVertices_h

#include "gatunFront.h"

#include <algorithm>
#include <array>

namespace gatun
{
/** The vertices that were used last, the latest first. */
class RecentVertices
{
public:
  static constexpr unsigned Bits = 8;
  static constexpr unsigned Most = 1u << Bits;

  RecentVertices() { this->List.fill(NoVertex); }

  /** The place of a vertex, or Most. */
  unsigned Find(Vertex v) const
  {
    return static_cast<unsigned>(
      std::find(this->List.begin(), this->List.end(), v) - this->List.begin());
  }

  /** NoVertex if there are fewer. */
  Vertex Get(unsigned place) const { return this->List[place]; }

  /** Moves a vertex to the front. place: its place, or Most if it was not listed. */
  void Use(Vertex v, unsigned place)
  {
    const auto end = this->List.begin() + std::min(place, Most - 1);
    std::copy_backward(this->List.begin(), end, end + 1);
    this->List[0] = v;
  }

private:
  std::array<Vertex, Most> List;
};
}

#endif
