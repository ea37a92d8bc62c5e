// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunArrayCodec_h
#define gatunArrayCodec_h

// Encoding of array values, and of coordinates outside a walk, by prediction from earlier values.

#include "gatunBytes.h"
#include "gatunDomain.h"
#include "gatunPointContext.h"
#include "gatunTopology.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The modes of a stream. Throws if they are unknown. */
struct ArrayModes
{
  SpatialMode Spatial = SpatialMode::Previous;
  TemporalMode Temporal = TemporalMode::None;

  static ArrayModes Read(std::span<const std::uint8_t> stream);
};

/** Throws unless points of this mesh of a chunk can have values of a mode. */
void CheckPointMode(SpatialMode mode, const Topology& mesh);

/** How much smaller a stream must be to be worth a slower mode. */
struct ModeChoice
{
  std::size_t Part = 64;   ///< by its size divided by this,
  double BitsOfValue = 0;  ///< and by this number of bits a value
  bool HasWeights = false; ///< whether readers have the weights of quadratic functions by then
};

/** Encodes own points with all modes and returns the best stream. Components of domains with a
 * quantizer get the keys that readers will have. Where these are on a lattice, the keys must be
 * keys of its places, if there are such (Quantizer::ToLattice). */
Bytes EncodePointValues(const PointContext& context, std::span<const Domain> domains,
  std::span<ComponentKeys> components, const ModeChoice& choice = {});
void DecodePointValues(std::span<const std::uint8_t> stream, const PointContext& context,
  std::span<const Domain> domains, std::span<ComponentKeys> components);

/** Encodes values of the cells of a chunk, or on the points of a block. With a quantizer, values
 * are on its lattice. */
Bytes EncodeCellValues(const CellContext& context, std::span<const Domain> domains,
  std::span<ComponentKeys> components, const ModeChoice& choice = {});
void DecodeCellValues(std::span<const std::uint8_t> stream, const CellContext& context,
  std::span<const Domain> domains, std::span<ComponentKeys> components);
}

#endif
