// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkMesh.h"

namespace gatun
{
//------------------------------------------------------------------------------
std::vector<std::array<double, 3>> GetPlaces(
  std::span<const PointKeys> keys, const PointDomain& domains)
{
  std::vector<std::array<double, 3>> places(keys.size());
  for (unsigned i = 0; i < 3; ++i)
  {
    const bool isFloat32 = Float32Domain::Matches(domains[i]);
    for (std::size_t v = 0; v < places.size(); ++v)
    {
      const Key key = keys[v][i];
      places[v][i] = isFloat32 ? Float32Domain::ToNumber(key) : domains[i].ToValue(key);
    }
  }
  return places;
}

std::vector<std::array<double, 3>> ChunkMesh::GetPlaces() const
{
  return gatun::GetPlaces(this->Keys, this->Domains);
}
}
