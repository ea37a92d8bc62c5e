// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshInput_h
#define gatunMeshInput_h

#include "gatunTypes.h"

#include <cstdint>

namespace gatun
{
/** A tetrahedral mesh in the caller's memory. It must exist until FileWriter::Finish has returned.
 */
struct MeshInput
{
  std::uint64_t Points = 0;
  ScalarType CoordinateType = ScalarType::Float32; ///< Float32 or Float64
  const void* Coordinates = nullptr;               ///< x, y, z of each point
  std::uint64_t Tets = 0;
  const void* Connectivity = nullptr; ///< four point ids for each tetrahedron
  bool WideIds = true; ///< whether ids are std::int64_t or std::int32_t; recorded in the file
};
}

#endif
