// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunHexForm_h
#define gatunHexForm_h

#include "gatunFixedList.h"

#include <array>
#include <cstdint>

namespace gatun
{
/** The sides of a hexahedron's form, the corners of its faces with the edges that begin there. */
struct HexSides
{
  static constexpr unsigned Corners = 8;
  static constexpr unsigned Sides = 24;

  template <typename T>
  using OfCorners = std::array<T, Corners>;
  template <typename T>
  using OfSides = std::array<T, Sides>;

  static constexpr OfSides<std::uint8_t> Corner{ 0, 1, 2, 3, 0, 1, 4, 5, 1, 2, 6, 4, 2, 3, 7, 6, 3,
    0, 5, 7, 5, 4, 6, 7 };
  static constexpr OfSides<std::uint8_t> Face{ 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4,
    4, 4, 5, 5, 5, 5 };

  /** The corner where a side ends. */
  static constexpr unsigned GetEnd(unsigned side) { return Corner[side / 4 * 4 + (side + 1) % 4]; }

  static constexpr bool IsInFace(unsigned corner, unsigned face)
  {
    return Corner[4 * face] == corner || Corner[4 * face + 1] == corner ||
      Corner[4 * face + 2] == corner || Corner[4 * face + 3] == corner;
  }

  static constexpr bool IsEdge(unsigned a, unsigned b)
  {
    bool is = false;
    for (unsigned side = 0; side < Sides; ++side)
    {
      is = is || (Corner[side] == a && GetEnd(side) == b);
      is = is || (Corner[side] == b && GetEnd(side) == a);
    }
    return is;
  }
};

/**
 * The form of a hexahedron, which is the same from all its faces. Has the results of CellForm,
 * known to the compiler.
 */
struct HexForm : HexSides
{
  static constexpr std::uint8_t None = 255;
  static constexpr unsigned Family = 3;
  static constexpr unsigned MostCorners = 4; // of a face

  using Faces = FixedList<std::uint8_t, 6>;

  static constexpr unsigned GetNumberOfFaces() { return 6; }
  static constexpr unsigned GetFirstSide(unsigned face) { return 4 * face; }
  static constexpr unsigned GetDegree(unsigned) { return 4; }

  static constexpr auto Twin = []
  {
    OfSides<std::uint8_t> twins{};
    for (unsigned a = 0; a < Sides; ++a)
    {
      for (unsigned b = 0; b < Sides; ++b)
      {
        const bool along = Corner[a] == Corner[b] && GetEnd(a) == GetEnd(b);
        const bool against = Corner[a] == GetEnd(b) && GetEnd(a) == Corner[b];
        twins[a] = a != b && (along || against) ? static_cast<std::uint8_t>(b) : twins[a];
      }
    }
    return twins;
  }();

  static constexpr auto Edges = []
  {
    std::array<std::array<std::uint8_t, 2>, Sides / 2> edges{};
    unsigned count = 0;
    for (std::uint8_t side = 0; side < Sides; ++side)
    {
      if (side < Twin[side])
      {
        edges[count++] = { side, Twin[side] };
      }
    }
    return edges;
  }();

  /** The other ends of a corner's edges, ascending. */
  static constexpr auto Neighbors = []
  {
    OfCorners<std::array<std::uint8_t, 3>> neighbors{};
    for (unsigned corner = 0; corner < Corners; ++corner)
    {
      unsigned count = 0;
      for (std::uint8_t other = 0; other < Corners; ++other)
      {
        if (IsEdge(corner, other))
        {
          neighbors[corner][count++] = other;
        }
      }
    }
    return neighbors;
  }();

  static constexpr const auto& GetNeighbors(unsigned corner) { return Neighbors[corner]; }

  /** The corner beyond a side's face that has an edge to the side's corner. */
  static constexpr auto Below = []
  {
    OfSides<std::uint8_t> below{};
    for (unsigned side = 0; side < Sides; ++side)
    {
      for (const auto near : Neighbors[Corner[side]])
      {
        below[side] = IsInFace(near, side / 4) ? below[side] : near;
      }
    }
    return below;
  }();

  /** The surroundings of a corner. */
  struct Surroundings
  {
    /** Opposite to the corner between neighbors 0 and 1, 0 and 2, 1 and 2. */
    std::array<std::uint8_t, 3> Diagonals;
    std::uint8_t Opposite;

    /** For each neighbor, the side that begins there of the face without the corner. */
    std::array<std::uint8_t, 3> SidesBelow;
  };

  static constexpr auto Around = []
  {
    OfCorners<Surroundings> around{};
    for (unsigned corner = 0; corner < Corners; ++corner)
    {
      const auto& near = Neighbors[corner];
      auto& result = around[corner];
      for (std::uint8_t other = 0; other < Corners; ++other)
      {
        const bool is0 = IsEdge(near[0], other);
        const bool is1 = IsEdge(near[1], other);
        const bool is2 = IsEdge(near[2], other);
        result.Diagonals[0] = other != corner && is0 && is1 ? other : result.Diagonals[0];
        result.Diagonals[1] = other != corner && is0 && is2 ? other : result.Diagonals[1];
        result.Diagonals[2] = other != corner && is1 && is2 ? other : result.Diagonals[2];
        const bool isFar = other != corner && !is0 && !is1 && !is2 && other != near[0] &&
          other != near[1] && other != near[2];
        result.Opposite = isFar ? other : result.Opposite;
      }
      for (unsigned k = 0; k < 3; ++k)
      {
        for (std::uint8_t side = 0; side < Sides; ++side)
        {
          const bool is = Corner[side] == near[k] && !IsInFace(corner, side / 4);
          result.SidesBelow[k] = is ? side : result.SidesBelow[k];
        }
      }
    }
    return around;
  }();

  unsigned Shape = 0; // of the table of shapes
};
}

#endif
