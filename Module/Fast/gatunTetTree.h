// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTetTree_h
#define gatunTetTree_h

// Tetrahedra in breadth-first order: each is attached to a face of an earlier one, and its fourth
// corner is named by one symbol. See Documentation/format.md, 8.14.

#include "gatunBytes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Four vertices of a chunk of at most 65,535 vertices, 16 bits each, the first one lowest. */
using PackedTet = std::uint64_t;

constexpr std::uint32_t GetCorner(PackedTet tet, unsigned corner)
{
  return static_cast<std::uint32_t>(tet >> (16 * corner)) & 0xffff;
}

/** The tetrahedra of a chunk. Vertices are numbered in the order of their first use. */
struct TetTree
{
  static constexpr std::uint32_t MaxVertices = 0xffff;
  static constexpr std::uint32_t NoTet = 0xffffffffu;

  static constexpr std::size_t Padding = 16; ///< tetrahedra of 0 before and behind them

  std::vector<PackedTet> Made;        ///< with padding
  std::vector<std::uint32_t> Parents; ///< the tetrahedron that each is attached to, or NoTet

  /** For each vertex, those from which it is predicted: the face to which the tetrahedron that
   * brought it is attached, and the corner behind. A vertex of a root has the one before, four
   * times. Vertex 0 has itself. */
  std::vector<PackedTet> Gates;

  /** The index of each vertex among the shared or the own ones. */
  std::vector<std::uint32_t> Sources;
  static constexpr std::uint32_t SharedFlag = 0x80000000u;

  /** Bit i of byte i / 8 is set if the last two corners of tetrahedron i have to be exchanged; none
   * if that is so for no tetrahedron. */
  std::vector<std::uint8_t> Flips;

  std::span<const PackedTet> GetTets() const
  {
    return std::span(this->Made).subspan(Padding, this->Made.size() - 2 * Padding);
  }
};

/** Whether a chunk can have this coder. */
constexpr bool FitsTree(std::size_t vertices)
{
  return vertices <= TetTree::MaxVertices;
}

/** Decodes a stream of EncodeTree. Safe on hostile input: throws Error(Corrupt). */
TetTree DecodeTree(std::span<const std::uint8_t> stream, std::uint32_t tets, std::uint32_t shared,
  std::uint32_t vertices);
}

#endif
