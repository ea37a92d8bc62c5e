// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellTemplates_h
#define gatunCellTemplates_h

// The dictionary of a CellTree.

#include "gatunBytes.h"
#include "gatunTetTree.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/** How a cell is made of earlier ones. Its first corners, the head, are in places that the template
 * names; each of the rest has a symbol. */
struct CellTemplate
{
  static constexpr unsigned MaxHead = 8;
  static constexpr unsigned MaxSources = 3;

  // Places: the first corners of the sources, then new vertices, vertices that are named by their
  // distance, and a place with vertex 0 for corners that are not there.
  static constexpr unsigned New = MaxSources * MaxHead;
  static constexpr unsigned Far = New + MaxHead;
  static constexpr unsigned Nothing = Far + MaxHead;
  static constexpr unsigned Places = Nothing + 1;

  // Symbols of the rest: a new vertex, a distance follows, or corner c of source s.
  static constexpr std::uint8_t NewSymbol = 0;
  static constexpr std::uint8_t FarSymbol = 1;
  static constexpr std::uint8_t NearSymbol = 2; // + s * NearCorners + c
  static constexpr unsigned NearCorners = 32;
  static constexpr unsigned Symbols = NearSymbol + MaxSources * NearCorners;

  /** Gates of the rest are of this number of corners at most, from the first. */
  static constexpr unsigned MaxRestGates = 24;
  static constexpr std::uint8_t Before = 255; // in such a gate: the vertex that came before

  static constexpr std::uint8_t Escape = 255; // of bytes whose number follows elsewhere

  static constexpr std::uint32_t NoPattern = 0xffffffffu;

  using Gate = std::array<std::uint8_t, 4>;

  std::array<std::uint8_t, MaxHead> From{ Nothing, Nothing, Nothing, Nothing, Nothing, Nothing,
    Nothing, Nothing };              // the place of each corner of the head
  std::array<Gate, MaxHead> Gates{}; // the places of the gate of each new vertex of the head
  std::uint8_t Type = 0;             // of the cell
  std::uint8_t Head = 0;             // corners
  std::uint8_t Sources = 0;          // that are used
  std::uint8_t News = 0;             // of the head
  std::uint8_t Fars = 0;             // of the head
  bool KnowsSources = true;          // each follows the one that the cell before had
  bool IsSized = false;              // the number of corners of the rest follows
  bool IsPlain = false;              // there is only a head
  std::uint8_t RestGateCount = 0;    // gates of the rest
  std::uint32_t Rest = 0;            // corners of the rest
  std::uint32_t Hidden = 0;          // of them, points that only faces have, the last ones
  std::uint32_t Pattern = NoPattern; // of the faces, if it is a polyhedron
  std::uint32_t FirstRestGate = 0;   // in CellTemplates

  /** Counts the new and the far vertices of the head. Returns whether they come in order. */
  bool Count();
};

/** Faces of polyhedra: for each one the number of its corners, then their numbers among the points
 * of the cell. */
struct FacePattern
{
  std::vector<std::uint32_t> Values;
  std::vector<std::uint8_t> IsSize; // of each value
  std::uint32_t Points = 0;         // that it needs

  explicit FacePattern(std::vector<std::uint32_t> values);
  FacePattern() = default;
};

/** What the cells of a chunk have in common. */
struct CellTemplates
{
  std::vector<CellTemplate> Items;
  std::vector<CellTemplate::Gate> RestGates; // of all
  std::vector<FacePattern> Patterns;

  void Write(ByteWriter& out) const;

  /** most: the largest numbers of bytes, and of templates and patterns each. Safe on hostile input:
   * throws Error(Corrupt). */
  static CellTemplates Read(ByteReader& in, std::uint64_t mostBytes, std::uint32_t most);
};
}

#endif
