// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGateValues_h
#define gatunGateValues_h

// Values of a component as differences to those around them. See Documentation/format.md, 10.12.

#include "gatunBytes.h"
#include "gatunDomain.h"
#include "gatunGateRule.h"

#include <cstdint>
#include <span>

namespace gatun
{
/** The rule for the keys of all vertices that takes the fewest bits. */
VertexRule ChooseVertexRule(
  const Domain& domain, const GateVertices& vertices, const GateKeys& keys);

/** Codes the keys of own vertices; those of shared ones are known. Decoding is safe on hostile
 * input: throws Error(Corrupt). */
void PutVertexValues(
  ByteWriter& out, const Domain& domain, const GateVertices& vertices, const GateKeys& keys);
void GetVertexValues(
  ByteReader& in, const Domain& domain, const GateVertices& vertices, const GateKeys& keys);

/** The same for items that have a parent among the earlier ones, or TetTree::NoTet: then the item
 * before takes its place. Without parents, that is so for all. */
void PutItemValues(ByteWriter& out, const Domain& domain, std::span<const std::uint32_t> parents,
  const GateKeys& keys);
void GetItemValues(ByteReader& in, const Domain& domain, std::span<const std::uint32_t> parents,
  const GateKeys& keys);
}

#endif
