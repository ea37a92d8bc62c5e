// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTetGeometry_h
#define gatunTetGeometry_h

// The geometry streams of chunks of tetrahedra.

#include "gatunBytes.h"
#include "gatunGateFrame.h"
#include "gatunGeometry.h"
#include "gatunTopology.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The vertices of a chunk after its walk. */
struct TetVertices
{
  const Topology& Walk;
  std::span<const PointKeys> Keys; ///< of all vertices
  const PointDomain& Domains;
};

struct EncodedGeometry
{
  Bytes Stream;
  PredictionRules Rules;
  std::vector<std::uint8_t> UsedRules; ///< one for each own vertex
};

/** Encodes the own vertices with the rules that make the shortest stream. ids: the number of each
 * own vertex in the walk. */
EncodedGeometry EncodeTetGeometry(const TetVertices& vertices, std::span<const Vertex> ids);

/** Reads the rules at the beginning of a stream. */
GateRules ReadGateRules(ByteReader& in);
}

#endif
