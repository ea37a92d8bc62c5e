// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef fuzzMeshes_h
#define fuzzMeshes_h

// Meshes and values out of a fuzzer's bytes.

#include "fuzzInput.h"
#include "gatunArrayContext.h"
#include "gatunQuadraticFit.h"

#include <array>
#include <optional>
#include <vector>

namespace gatun::fuzz
{
using Tet = std::array<std::uint32_t, 4>;

/** A value's key, often an extreme one. */
Key TakeKey(Input& in, const Domain& domain);

/** Plain, with a scale, or with a small palette. */
Domain TakeDomain(Input& in, ScalarType type);

/** The same or, for values of arrays, with a bound of errors. With values of a time step before,
 * plain or with such a bound. */
Domain TakeValueDomain(Input& in, ScalarType type, bool hasBefore);

/** Aborts unless a key may stand for another one, exactly. */
void CheckBound(const Domain& domain, Key original, Key found);

/** Weights of neighbors for up to MostTuples values on cells or blocks. */
constexpr std::uint32_t MostTuples = 200;
const QuadraticFit& GetTupleFit();

/** Counts, box, domains and shared points of a chunk; anything that tables let through and more. */
ChunkFrame TakeFrame(Input& in, std::uint32_t mostTets);

/**
 * Tetrahedra that are mostly glued to the ones before, with the mistakes that meshes have; names
 * points 0 to points - 1, each at least once.
 */
std::vector<Tet> TakeTets(Input& in, std::uint32_t mostTets, std::uint32_t& points);

/** Cells of any type, most of which continue those before; names points as TakeTets does. */
CellList TakeCells(Input& in, std::uint32_t mostCells, std::uint32_t& points);

/** The description of an array whose stream is decoded. */
struct ArrayFrame
{
  std::vector<std::uint32_t> Parents; // of cells; may be empty
  std::vector<Domain> Domains;
  std::vector<ComponentKeys> Keys;
};

class SmallChunk;
ArrayFrame TakePointArray(Input& in, const SmallChunk& chunk);
ArrayFrame TakeCellArray(Input& in);

/** Aborts unless all keys are such as the domains have. */
void CheckKeys(const ArrayFrame& array);

/** Aborts unless the ids, parents and records of a decoded chunk are in range. */
void CheckChunk(const ChunkFrame& frame, const ChunkMesh& mesh);

/** The same for cells of any type. */
void CheckCells(const ChunkFrame& frame, const ChunkMesh& mesh);

/** Splits the cells of a mesh with a context. */
void CheckTets(const ChunkMesh& mesh);

/** The weights of neighbors that the mesh of a chunk can have. */
ContextFits GetFits(const ChunkMesh& mesh);

/** A chunk of some tetrahedra, decoded and ready to have arrays decoded on it. */
class SmallChunk
{
public:
  explicit SmallChunk(Profile profile);

  const PointContext& GetContext() const { return this->Context->GetPoints(); }

  ChunkMesh Mesh;
  std::vector<Vertex> SharedIds; // vertices whose values are known beforehand

private:
  std::optional<ArrayContext> Context;
};
}

#endif
