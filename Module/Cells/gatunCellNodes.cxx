// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunCellNodes.h"

#include "gatunLatticeNodes.h"

#include <mutex>
#include <optional>
#include <span>

namespace gatun
{
namespace
{
// For each node the number of the corners that it lies between, then these corners. The center of a
// cell lies between four corners whose mean it is.
// clang-format off
constexpr std::uint8_t Edge[] = { 2, 0, 1 };
constexpr std::uint8_t TriangleParts[] = { 2, 0, 1,  2, 1, 2,  2, 2, 0,  3, 0, 1, 2 };
constexpr std::uint8_t QuadParts[] = { 2, 0, 1,  2, 1, 2,  2, 2, 3,  2, 3, 0,  4, 0, 1, 2, 3 };
constexpr std::uint8_t LinearQuad[] = { 2, 0, 1,  2, 2, 3 };
constexpr std::uint8_t TetraParts[] = { 2, 0, 1,  2, 1, 2,  2, 2, 0,  2, 0, 3,  2, 1, 3,  2, 2, 3 };
constexpr std::uint8_t HexahedronParts[] = { 2, 0, 1,  2, 1, 2,  2, 2, 3,  2, 3, 0,  2, 4, 5,  2, 5, 6,
  2, 6, 7,  2, 7, 4,  2, 0, 4,  2, 1, 5,  2, 2, 6,  2, 3, 7,  4, 0, 4, 7, 3,  4, 1, 2, 6, 5,
  4, 0, 1, 5, 4,  4, 3, 7, 6, 2,  4, 0, 1, 2, 3,  4, 4, 5, 6, 7,  4, 0, 2, 5, 7 };
constexpr std::uint8_t WedgeParts[] = { 2, 0, 1,  2, 1, 2,  2, 2, 0,  2, 3, 4,  2, 4, 5,  2, 5, 3,
  2, 0, 3,  2, 1, 4,  2, 2, 5,  4, 0, 1, 4, 3,  4, 1, 2, 5, 4,  4, 2, 0, 3, 5 };
constexpr std::uint8_t PyramidParts[] = { 2, 0, 1,  2, 1, 2,  2, 2, 3,  2, 3, 0,  2, 0, 4,  2, 1, 4,
  2, 2, 4,  2, 3, 4,  4, 0, 1, 2, 3,  3, 0, 1, 4,  3, 1, 2, 4,  3, 2, 3, 4,  3, 3, 0, 4,
  3, 0, 2, 4 };
// clang-format on

/** Makes the nodes of the first hosts of a list. */
CellNodes Make(std::size_t corners, std::span<const std::uint8_t> hosts, unsigned count)
{
  constexpr std::array slots{ CellNode::N1, CellNode::D12, CellNode::D13, CellNode::D23 };
  CellNodes result{ corners, corners + count, {} };
  for (std::size_t at = 0; result.Nodes.size() < count; at += 1u + hosts[at])
  {
    CellNode node;
    const unsigned size = hosts[at];
    node.Where = size == 2 ? CellNode::Kind::Edge
      : size == 3          ? CellNode::Kind::Triangle
                           : CellNode::Kind::Quad;
    node.IsBetween = true;
    node.Point = static_cast<std::uint16_t>(corners + result.Nodes.size());
    for (unsigned i = 0; i < size; ++i)
    {
      node.Host[i] = node.Near[slots[i]] = hosts[at + 1 + i];
      node.Weights[i] = 1;
    }
    result.Nodes.push_back(node);
  }
  return result;
}

CellNodes MakeFixed(int type)
{
  switch (type)
  {
    case 21: // quadratic
      return Make(2, Edge, 1);
    case 22:
      return Make(3, TriangleParts, 3);
    case 23:
      return Make(4, QuadParts, 4);
    case 24:
      return Make(4, TetraParts, 6);
    case 25:
      return Make(8, HexahedronParts, 12);
    case 26:
      return Make(6, WedgeParts, 9);
    case 27:
      return Make(5, PyramidParts, 8);
    case 28: // biquadratic
      return Make(4, QuadParts, 5);
    case 29: // triquadratic
      return Make(8, HexahedronParts, 19);
    case 30: // quadratic linear
      return Make(4, LinearQuad, 2);
    case 31:
      return Make(6, WedgeParts, 6);
    case 32: // biquadratic quadratic
      return Make(6, WedgeParts, 12);
    case 33:
      return Make(8, HexahedronParts, 16);
    case 34:
      return Make(3, TriangleParts, 4);
    case 37:
      return Make(5, PyramidParts, 14);
    default:
      return {};
  }
}

/** The shape of Lagrange (68 to 73) and Bezier cells (75 to 80). */
std::optional<LatticeShape> FindShape(int type)
{
  static constexpr std::array shapes{ LatticeShape::Curve, LatticeShape::Triangle,
    LatticeShape::Quad, LatticeShape::Tetra, LatticeShape::Hexahedron, LatticeShape::Wedge };
  const int number = type >= 75 ? type - 75 : type - 68;
  if (number < 0 || number >= static_cast<int>(shapes.size()))
  {
    return {};
  }
  return shapes[static_cast<std::size_t>(number)];
}
}

//------------------------------------------------------------------------------
const CellNodes& GetCellNodes(int type)
{
  constexpr std::size_t types = 38;
  static const auto tables = []
  {
    std::array<CellNodes, types> made;
    for (std::size_t t = 0; t < types; ++t)
    {
      made[t] = MakeFixed(static_cast<int>(t));
    }
    return made;
  }();
  static const CellNodes none;
  return type >= 0 && type < static_cast<int>(types) ? tables[static_cast<std::size_t>(type)]
                                                     : none;
}

bool HasNodeOrder(int type)
{
  return FindShape(type).has_value();
}

unsigned FindNodeOrder(int type, std::size_t points)
{
  const auto shape = FindShape(type);
  for (unsigned order = 1; shape && order <= MaxNodeOrder; ++order)
  {
    if (CountLatticePoints(*shape, order) == points)
    {
      return order;
    }
  }
  return 0;
}

const CellNodes& GetNodesOfOrder(int type, unsigned order)
{
  struct Table
  {
    std::once_flag IsMade;
    CellNodes Nodes;
  };
  static std::array<std::array<Table, MaxNodeOrder>, 6> tables;
  const auto shape = FindShape(type).value();
  auto& table = tables[static_cast<std::size_t>(shape)].at(order - 1);
  std::call_once(table.IsMade, [&] { table.Nodes = MakeLatticeNodes(shape, order); });
  return table.Nodes;
}

bool HasNodes(int type)
{
  return GetCellNodes(type).Corners > 0 || HasNodeOrder(type);
}

const CellNodes& FindCellNodes(int type, std::size_t points)
{
  static const CellNodes none;
  if (const auto order = FindNodeOrder(type, points))
  {
    return GetNodesOfOrder(type, order);
  }
  const auto& fixed = GetCellNodes(type);
  return fixed.Points == points ? fixed : none;
}

bool CanFindCellNodes(int type, std::size_t points)
{
  const auto& fixed = GetCellNodes(type);
  return fixed.Corners > 0 ? fixed.Points == points : FindNodeOrder(type, points) > 0;
}
}
