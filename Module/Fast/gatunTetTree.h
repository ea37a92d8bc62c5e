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

/** The four vertices with the last two exchanged. */
constexpr PackedTet ExchangeLast(PackedTet tet)
{
  return (tet & 0xffffffffu) | tet >> 48 << 32 | (tet >> 32 & 0xffff) << 48;
}

/** Tetrahedra, with some of 0 before and behind them that coders may read. */
class PaddedTets
{
public:
  static constexpr std::size_t Padding = 16;

  PaddedTets() = default;
  explicit PaddedTets(std::size_t tets)
    : Padded(Padding + tets + Padding, 0)
  {
  }

  PackedTet* data() { return this->Padded.data() + Padding; }
  const PackedTet* data() const { return this->Padded.data() + Padding; }
  std::size_t size() const { return this->Padded.empty() ? 0 : this->Padded.size() - 2 * Padding; }
  PackedTet& operator[](std::size_t tet) { return this->data()[tet]; }
  const PackedTet& operator[](std::size_t tet) const { return this->data()[tet]; }
  const PackedTet* begin() const { return this->data(); }
  const PackedTet* end() const { return this->data() + this->size(); }
  std::size_t capacity() const { return this->Padded.capacity(); }

  bool operator==(const PaddedTets&) const = default;

private:
  std::vector<PackedTet> Padded;
};

/** The tetrahedra of a chunk. Vertices are numbered in the order of their first use. */
struct TetTree
{
  static constexpr std::uint32_t MaxVertices = 0xffff;
  static constexpr std::uint32_t NoTet = 0xffffffffu;

  PaddedTets Tets;
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
};

/** Whether a vertex is an own one, by its source. */
constexpr bool IsOwn(std::uint32_t source)
{
  return (source & TetTree::SharedFlag) == 0;
}

/** The own vertices. */
inline std::vector<std::uint32_t> FindOwn(std::span<const std::uint32_t> sources)
{
  std::vector<std::uint32_t> own(sources.size());
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < own.size(); ++v)
  {
    own[count] = v; // the next one replaces a shared one
    count += IsOwn(sources[v]) ? 1 : 0;
  }
  own.resize(count);
  return own;
}

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
