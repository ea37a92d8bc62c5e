// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkPlaces_h
#define gatunChunkPlaces_h

// The vertices of a chunk on its lattice.

#include "gatunGeometry.h"
#include "gatunMeasure.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
inline LatticePoint MapKeys(const Lattice& lattice, const PointDomain& domains,
  const PointKeys& keys, std::uint32_t users = 0)
{
  return lattice.Map(
    domains[0].ToValue(keys[0]), domains[1].ToValue(keys[1]), domains[2].ToValue(keys[2]), users);
}

/** users: as LatticePoint::Users. */
inline std::vector<LatticePoint> MapShared(const Lattice& lattice, const PointDomain& domains,
  std::span<const PointKeys> keys, std::span<const std::uint32_t> users)
{
  std::vector<LatticePoint> shared(keys.size());
  for (std::size_t i = 0; i < shared.size(); ++i)
  {
    shared[i] = MapKeys(lattice, domains, keys[i], users[i]);
  }
  return shared;
}
}

#endif
