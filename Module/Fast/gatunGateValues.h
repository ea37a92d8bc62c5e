// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGateValues_h
#define gatunGateValues_h

// Values of a component as differences to those around them. See Documentation/format.md, 10.12.

#include "gatunBytes.h"
#include "gatunDomain.h"
#include "gatunTetTree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The vertices of a chunk with a TetTree. */
struct GateVertices
{
  std::span<const PackedTet> Gates;
  std::span<const std::uint32_t> Sources; ///< as in TetTree
};

/** How values before help. */
enum class BeforeUse : std::uint8_t
{
  None,
  Repeat, ///< the value before is the prediction
  Change  ///< the change since then is predicted
};

/** The keys of a component now, and before if they are used. */
struct GateKeys
{
  std::span<Key> Now;
  std::span<const Key> Before{};
  BeforeUse Use = BeforeUse::None;
};

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
