// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunArrayCodec_h
#define gatunArrayCodec_h

// Values of arrays, and coordinates outside a walk, predicted from values decoded before.

#include "gatunBytes.h"
#include "gatunDomain.h"
#include "gatunGeometry.h"
#include "gatunTopology.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** How the values of a stream are predicted within their time step. */
enum class SpatialMode : std::uint8_t
{
  Previous = 0, ///< the value coded before
  Gate = 1,     ///< points: the rule that predicted the coordinates; cells: the tetrahedron behind
  Fit = 2       ///< points: a linear function fitted to the known neighbours
};

/** How the values of the step before are used. */
enum class TemporalMode : std::uint8_t
{
  None = 0,
  Repeat = 1, ///< the value of the step before, and nothing else
  Change = 2  ///< the value of the step before plus the spatial prediction of the change
};

/** For each own vertex of a chunk the neighbours known before it and their weights. */
class NeighbourFit
{
public:
  struct Neighbour
  {
    Vertex Id;
    double Weight;
  };

  /** Places are the coordinates of all vertices of the topology, in the order of the walk. */
  NeighbourFit(const Topology& topology, std::span<const std::array<double, 3>> places);

  std::span<const Neighbour> Of(std::size_t ownVertex) const
  {
    return { this->List.data() + this->Start[ownVertex],
      this->Start[ownVertex + 1] - this->Start[ownVertex] };
  }

  /** Memory that the lists take. */
  std::size_t GetBytes() const
  {
    return this->Start.capacity() * sizeof(std::uint32_t) +
      this->List.capacity() * sizeof(Neighbour);
  }

private:
  void Weigh(const std::array<double, 3>& centre, std::span<Neighbour> neighbours,
    std::span<const std::array<double, 3>> places) const;

  std::vector<std::uint32_t> Start;
  std::vector<Neighbour> List;
};

/** All that point arrays of a chunk are predicted from; made once for all of them. */
struct PointContext
{
  const Topology* Mesh = nullptr;
  std::vector<Vertex> OwnIds;              // of each own vertex its number in the walk
  const PredictionRules* Rules = nullptr;  // of the chunk's geometry
  std::span<const std::uint8_t> UsedRules; // of each own vertex
  const NeighbourFit* Fit = nullptr;       // may be null if no stream uses it
};

/**
 * The values of one component. For points of a chunk there is a key for every vertex of the walk,
 * and the shared ones are known beforehand; else keys are in the order of coding.
 */
struct ComponentKeys
{
  std::vector<Key> Now;
  std::vector<Key> Before; // of the time step before, or empty
};

/** The modes that a stream says it uses; throws on unknown ones. */
struct ArrayModes
{
  SpatialMode Spatial = SpatialMode::Previous;
  TemporalMode Temporal = TemporalMode::None;

  static ArrayModes Read(std::span<const std::uint8_t> stream);
};

/** Encodes own points; tries all modes and keeps the shortest stream. */
Bytes EncodePointValues(const PointContext& context, std::span<const Domain> domains,
  std::span<ComponentKeys> components);
void DecodePointValues(std::span<const std::uint8_t> stream, const PointContext& context,
  std::span<const Domain> domains, std::span<ComponentKeys> components);

/** The same for the tetrahedra of a chunk; parents may be empty. */
Bytes EncodeCellValues(std::span<const std::uint32_t> parents, std::span<const Domain> domains,
  std::span<ComponentKeys> components);
void DecodeCellValues(std::span<const std::uint8_t> stream, std::span<const std::uint32_t> parents,
  std::span<const Domain> domains, std::span<ComponentKeys> components);
}

#endif
