// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMeshInput_h
#define gatunMeshInput_h

#include "gatunTypes.h"

#include <cstdint>

namespace gatun
{
/** A tetrahedral mesh in the caller's memory, which must stay there until Finish has returned. */
struct MeshInput
{
  std::uint64_t Points = 0;
  ScalarType CoordinateType = ScalarType::Float32; ///< Float32 or Float64
  const void* Coordinates = nullptr;               ///< x, y, z of each point
  std::uint64_t Tets = 0;
  const void* Connectivity = nullptr; ///< four point ids a tetrahedron
  bool WideIds = true;                ///< ids are std::int64_t, else std::int32_t; kept in the file
};
}

#endif
