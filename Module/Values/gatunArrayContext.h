// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunArrayContext_h
#define gatunArrayContext_h

// The data from which the arrays of a chunk are predicted, made from its mesh.

#include "gatunChunkCodec.h"
#include "gatunNeighborFit.h"
#include "gatunPointContext.h"
#include "gatunQuadraticFit.h"

#include <cstdint>
#include <optional>

namespace gatun
{
/** The weights of neighbors that a context has. */
enum class ContextFits : std::uint8_t
{
  None,
  Linear,
  All ///< also those of quadratic functions
};

/** The context of point arrays without weights of neighbors. The mesh must outlive it. */
PointContext MakePointContext(const ChunkMesh& mesh);

/** The weights of the cells around each cell. The calling thread must have a FloatEnvironment. */
QuadraticFit FitCells(const ChunkMesh& mesh);

/** The context of point arrays and its weights of neighbors. The mesh must outlive it. */
class ArrayContext
{
public:
  ArrayContext(const ChunkMesh& mesh, ContextFits fits);

  // The context points to the weights.
  ArrayContext(const ArrayContext&) = delete;
  ArrayContext& operator=(const ArrayContext&) = delete;

  const PointContext& GetPoints() const { return this->Points; }

private:
  std::optional<NeighborFit> Fit;
  std::optional<QuadraticFit> Quadratic;
  PointContext Points;
};
}

#endif
