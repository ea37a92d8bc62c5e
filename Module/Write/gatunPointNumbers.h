// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPointNumbers_h
#define gatunPointNumbers_h

#include "gatunBoundaryMerge.h"
#include "gatunWriterPart.h"

#include <cstdint>
#include <vector>

namespace gatun
{
/** The original numbers of the points of parts. A point of several parts has the number of the
 * first one. */
class PointNumbers
{
public:
  explicit PointNumbers(const BoundaryMerge& boundaries)
    : Boundaries(boundaries)
  {
  }

  /** The numbers of the points of a part. The parts must come in their order. */
  std::vector<std::uint64_t> Find(
    const PartPlace& place, std::uint64_t points, const PartJoins& joins);

  /** The numbers of each group of points of several parts, as far as they are known. */
  std::vector<std::vector<std::uint64_t>>& GetJoined() { return this->Joined; }

private:
  const BoundaryMerge& Boundaries;
  std::vector<std::vector<std::uint64_t>> Joined;
};
}

#endif
