// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunArrayCodec_h
#define gatunArrayCodec_h

// Encoding of array values, and of coordinates outside a walk, by prediction from earlier values.

#include "gatunBytes.h"
#include "gatunCellRules.h"
#include "gatunDomain.h"
#include "gatunGeometry.h"
#include "gatunTopology.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Prediction of the values of a stream within their time step. */
enum class SpatialMode : std::uint8_t
{
  Previous = 0, ///< the previous value of the stream
  Gate = 1,     ///< points: the rule that predicted the coordinates; cells: the parent tetrahedron
  Fit = 2       ///< points: a linear function fitted to the known neighbors
};

/** Use of the values of the previous time step. */
enum class TemporalMode : std::uint8_t
{
  None = 0,
  Repeat = 1, ///< the value of the previous step
  Change = 2  ///< the value of the previous step plus a spatial prediction of the change
};

/** The neighbors of each own vertex of a chunk that are known before it, and their weights. */
class NeighborFit
{
public:
  struct Neighbor
  {
    Vertex Id;
    double Weight;
  };

  /** places: coordinates of all vertices of the topology in the order of the walk. */
  NeighborFit(const Topology& topology, std::span<const std::array<double, 3>> places);

  std::span<const Neighbor> Of(std::size_t ownVertex) const
  {
    return { this->List.data() + this->Start[ownVertex],
      this->Start[ownVertex + 1] - this->Start[ownVertex] };
  }

  /** The memory of the lists. */
  std::size_t GetBytes() const
  {
    return this->Start.capacity() * sizeof(std::uint32_t) +
      this->List.capacity() * sizeof(Neighbor);
  }

private:
  std::vector<std::uint32_t> Start;
  std::vector<Neighbor> List;
};

/** The data from which all point arrays of a chunk are predicted. */
struct PointContext
{
  const Topology* Mesh = nullptr;
  std::vector<Vertex> OwnIds;                       // the number of each own vertex in the walk
  const PredictionRules* Rules = nullptr;           // of the geometry of a chunk of tetrahedra
  const std::vector<CellRule>* CellRules = nullptr; // and of another chunk, otherwise null
  std::span<const std::uint8_t> UsedRules;          // the rule of each own vertex
  const NeighborFit* Fit = nullptr;                 // may be null if no stream uses it
};

/**
 * The values of one component. For points of a chunk there is a key for every vertex of the walk,
 * and those of shared vertices are known. Otherwise keys are in the order of coding.
 */
struct ComponentKeys
{
  std::vector<Key> Now;
  std::vector<Key> Before; // of the previous time step, or empty
};

/** The modes of a stream. Throws if they are unknown. */
struct ArrayModes
{
  SpatialMode Spatial = SpatialMode::Previous;
  TemporalMode Temporal = TemporalMode::None;

  static ArrayModes Read(std::span<const std::uint8_t> stream);
};

/** Encodes own points with all modes and returns the shortest stream. Components of domains with a
 * quantizer get the keys that readers will have. Where these are on a lattice, the keys must be
 * those of its places, if there are such (Quantizer::ToLattice). */
Bytes EncodePointValues(const PointContext& context, std::span<const Domain> domains,
  std::span<ComponentKeys> components);
void DecodePointValues(std::span<const std::uint8_t> stream, const PointContext& context,
  std::span<const Domain> domains, std::span<ComponentKeys> components);

/** Encodes values of the tetrahedra of a chunk. Without parents, these are values on a block, and
 * those of domains with a quantizer are on its lattice. */
Bytes EncodeCellValues(std::span<const std::uint32_t> parents, std::span<const Domain> domains,
  std::span<ComponentKeys> components);
void DecodeCellValues(std::span<const std::uint8_t> stream, std::span<const std::uint32_t> parents,
  std::span<const Domain> domains, std::span<ComponentKeys> components);
}

#endif
