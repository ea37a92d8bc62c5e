// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunCellNodes.h"

namespace gatun
{
namespace
{
// clang-format off
constexpr std::uint8_t Edge[] = { 2, 0, 1 };
constexpr std::uint8_t Triangle[] = { 2, 0, 1,  2, 1, 2,  2, 2, 0,  3, 0, 1, 2 };
constexpr std::uint8_t Quad[] = { 2, 0, 1,  2, 1, 2,  2, 2, 3,  2, 3, 0,  4, 0, 1, 2, 3 };
constexpr std::uint8_t LinearQuad[] = { 2, 0, 1,  2, 2, 3 };
constexpr std::uint8_t Tetra[] = { 2, 0, 1,  2, 1, 2,  2, 2, 0,  2, 0, 3,  2, 1, 3,  2, 2, 3 };
constexpr std::uint8_t Hexahedron[] = { 2, 0, 1,  2, 1, 2,  2, 2, 3,  2, 3, 0,  2, 4, 5,  2, 5, 6,
  2, 6, 7,  2, 7, 4,  2, 0, 4,  2, 1, 5,  2, 2, 6,  2, 3, 7,  4, 0, 4, 7, 3,  4, 1, 2, 6, 5,
  4, 0, 1, 5, 4,  4, 3, 7, 6, 2,  4, 0, 1, 2, 3,  4, 4, 5, 6, 7,  4, 0, 2, 5, 7 };
constexpr std::uint8_t Wedge[] = { 2, 0, 1,  2, 1, 2,  2, 2, 0,  2, 3, 4,  2, 4, 5,  2, 5, 3,
  2, 0, 3,  2, 1, 4,  2, 2, 5,  4, 0, 1, 4, 3,  4, 1, 2, 5, 4,  4, 2, 0, 3, 5 };
constexpr std::uint8_t Pyramid[] = { 2, 0, 1,  2, 1, 2,  2, 2, 3,  2, 3, 0,  2, 0, 4,  2, 1, 4,
  2, 2, 4,  2, 3, 4,  4, 0, 1, 2, 3,  3, 0, 1, 4,  3, 1, 2, 4,  3, 2, 3, 4,  3, 3, 0, 4,
  3, 0, 2, 4 };
// clang-format on

/** The first bytes of a list of hosts. */
constexpr CellNodes Make(
  std::uint8_t corners, std::span<const std::uint8_t> hosts, unsigned edges, unsigned others = 0)
{
  const auto points = static_cast<std::uint8_t>(corners + edges + others);
  std::size_t bytes = std::size_t{ 3 } * edges;
  for (; others > 0; --others)
  {
    bytes += 1u + hosts[bytes];
  }
  return { corners, points, hosts.first(bytes) };
}
}

//------------------------------------------------------------------------------
CellNodes GetCellNodes(int type)
{
  switch (type)
  {
    case 21: // quadratic
      return Make(2, Edge, 1);
    case 22:
      return Make(3, Triangle, 3);
    case 23:
      return Make(4, Quad, 4);
    case 24:
      return Make(4, Tetra, 6);
    case 25:
      return Make(8, Hexahedron, 12);
    case 26:
      return Make(6, Wedge, 9);
    case 27:
      return Make(5, Pyramid, 8);
    case 28: // biquadratic
      return Make(4, Quad, 4, 1);
    case 29: // triquadratic
      return Make(8, Hexahedron, 12, 7);
    case 30: // quadratic linear
      return Make(4, LinearQuad, 2);
    case 31:
      return Make(6, Wedge, 6);
    case 32: // biquadratic quadratic
      return Make(6, Wedge, 9, 3);
    case 33:
      return Make(8, Hexahedron, 12, 4);
    case 34:
      return Make(3, Triangle, 3, 1);
    case 37:
      return Make(5, Pyramid, 8, 6);
    default:
      return {};
  }
}
}
