// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshAccess_h
#define gatunMeshAccess_h

#include "gatunMeshInput.h"
#include "gatunTypes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gatun
{
/** Reads coordinates and connectivity of a MeshInput of any type. */
class MeshAccess
{
public:
  explicit MeshAccess(const MeshInput& mesh)
    : Mesh(mesh)
  {
  }

  double GetCoordinate(std::uint64_t point, unsigned axis) const
  {
    return this->Mesh.CoordinateType == ScalarType::Float32
      ? static_cast<double>(static_cast<const float*>(this->Mesh.Coordinates)[3 * point + axis])
      : static_cast<const double*>(this->Mesh.Coordinates)[3 * point + axis];
  }

  /** The id is unsigned, so that negative ids are out of range. */
  std::uint64_t GetId(std::uint64_t tet, unsigned corner) const
  {
    return this->Mesh.WideIds
      ? static_cast<const std::uint64_t*>(this->Mesh.Connectivity)[4 * tet + corner]
      : static_cast<std::uint64_t>(static_cast<std::int64_t>(
          static_cast<const std::int32_t*>(this->Mesh.Connectivity)[4 * tet + corner]));
  }

  /** Adds the finite coordinates of a point to a box. */
  void Include(Bounds& box, std::uint64_t point) const
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const double x = this->GetCoordinate(point, axis);
      if (std::isfinite(x))
      {
        box[axis].Include(x);
      }
    }
  }

  const MeshInput& GetMesh() const { return this->Mesh; }

private:
  const MeshInput Mesh;
};
}

#endif
