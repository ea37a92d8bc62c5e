// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFastSteps_h
#define gatunFastSteps_h

// Components with bounds of errors in the mode SpatialMode::Fast. See Documentation/format.md,
// 10.12.

#include "gatunBytes.h"
#include "gatunDomain.h"
#include "gatunGateValues.h"

#include <cstdint>
#include <span>

namespace gatun
{
/** Codes the keys of own vertices, as PutVertexValues and GetVertexValues. Keys become those that
 * readers will have. */
void PutVertexSteps(
  ByteWriter& out, const Domain& domain, const GateVertices& vertices, const GateKeys& keys);
void GetVertexSteps(
  ByteReader& in, const Domain& domain, const GateVertices& vertices, const GateKeys& keys);

/** The same for items, as PutItemValues and GetItemValues. onLattice: whether values are places of
 * the lattice already, and are to be coded as they are. */
void PutItemSteps(ByteWriter& out, const Domain& domain, std::span<const std::uint32_t> parents,
  bool onLattice, const GateKeys& keys);
void GetItemSteps(ByteReader& in, const Domain& domain, std::span<const std::uint32_t> parents,
  bool onLattice, const GateKeys& keys);
}

#endif
