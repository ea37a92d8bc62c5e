// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunDependencyCodec_h
#define gatunDependencyCodec_h

#include "gatunBytes.h"
#include "gatunMergeDependencies.h"
#include "gatunMergeTree.h"

#include <cstdint>
#include <functional>
#include <span>

namespace gatun
{
/** The dependencies of all merges from a first one on, on merges from that one to another one, but
 * for most that follow from others. Merges are numbered from the first one. */
MergeDependencies SelectDependencies(
  const MergeDependencies& all, std::uint32_t first, std::uint32_t end);

/** Puts dependencies on the first merges, as many as given, and those between the others together,
 * which are numbered by themselves. */
MergeDependencies JoinDependencies(
  const MergeDependencies& onFirst, std::uint32_t merges, const MergeDependencies& rest);

/** Encodes the dependencies of the merges of a tree, without most dependencies that follow from
 * others. Empty if there is no stream for them, as they and the merges between them are more than
 * 64 a merge on average. Progress: see MergeDependencies. */
Bytes EncodeDependencies(const MergeTree& tree, const MergeDependencies& dependencies,
  const std::function<bool(double)>& progress = {});

/** Decodes a stream of EncodeDependencies. Throws Error(Corrupt) if it is damaged. Safe on hostile
 * input: memory and time are in proportion to the merges and points. */
MergeDependencies DecodeDependencies(std::span<const std::uint8_t> stream, const MergeTree& tree);
}

#endif
