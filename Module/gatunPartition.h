// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunPartition_h
#define gatunPartition_h

// Cuts a mesh into chunks and finds the points that they share.

#include "gatunFileWriter.h"
#include "gatunLayers.h"
#include "gatunTables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace gatun
{
/** Reads coordinates and connectivity of a MeshInput whatever their types. */
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

  /** Unsigned, so that a negative id is far too large. */
  std::uint64_t GetId(std::uint64_t tet, unsigned corner) const
  {
    return this->Mesh.WideIds
      ? static_cast<const std::uint64_t*>(this->Mesh.Connectivity)[4 * tet + corner]
      : static_cast<std::uint64_t>(static_cast<std::int64_t>(
          static_cast<const std::int32_t*>(this->Mesh.Connectivity)[4 * tet + corner]));
  }

  /** Makes a box hold the finite coordinates of a point. */
  void Extend(Bounds& box, std::uint64_t point) const
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const double x = this->GetCoordinate(point, axis);
      if (std::isfinite(x))
      {
        box[axis].Min = std::min(box[axis].Min, x);
        box[axis].Max = std::max(box[axis].Max, x);
      }
    }
  }

  const MeshInput& GetMesh() const { return this->Mesh; }

private:
  const MeshInput Mesh;
};

/** A mesh cut into chunks. Indices are those of the input; they fit 32 bits. */
struct Partition
{
  static constexpr std::uint32_t Unused = 0xffffffffu;

  std::vector<std::uint32_t> Tets; // all, chunk by chunk, ascending within a chunk
  std::vector<std::size_t> ChunkStart;

  // The points used by several chunks, in the order of the file: blocks, groups, Morton order.
  std::vector<std::uint32_t> SharedPoints;
  std::vector<BlockEntry> Blocks; // groups and counts only

  std::vector<std::uint32_t> UnusedPoints;

  // Of each point: its place in SharedPoints, or OwnPoint, or UnusedPoint.
  static constexpr std::uint32_t OwnPoint = 0xfffffffeu;
  std::vector<std::uint32_t> SharedIndex;

  std::size_t GetChunkCount() const { return this->ChunkStart.size() - 1; }
};

/** By which values a mesh is cut, and what comes out of that. */
struct LayerPartition
{
  ArrayDescription Array;
  LayerRequest Request;
  Layers Result;
};

/**
 * Halves the tetrahedra along the longest axis of their centroids until no part has more than
 * chunkTets; with layers, those of each bucket of layers by themselves. The same result for any
 * number of threads. Throws InvalidInput if a tetrahedron names a point that is not there.
 */
Partition MakePartition(const MeshAccess& mesh, std::uint32_t chunkTets,
  const std::function<bool(double)>& progress, LayerPartition* layers = nullptr);
}

#endif
