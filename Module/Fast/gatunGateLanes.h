// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGateLanes_h
#define gatunGateLanes_h

// Several components of plain float32 at once, by the lanes of vectors.

#include "gatunGateValues.h"

#include <cstddef>
#include <span>

namespace gatun
{
/** The keys of a component: that of vertex v is First[v * Stride], and before Before[v], if values
 * before are used. */
struct KeyColumn
{
  Key* First;
  std::size_t Stride;
  const Key* Before = nullptr;
};

constexpr std::size_t MostGateLanes = 4;

/** Decodes up to MostGateLanes components, as GetVertexValues does one after the other, without
 * values before or, if all columns have them, with BeforeUse::Change. Each is of a domain for which
 * Float32Domain::Matches. Throws Error(Corrupt). */
void GetVertexLanes(
  ByteReader& in, const GateVertices& vertices, std::span<const KeyColumn> columns);
}

#endif
