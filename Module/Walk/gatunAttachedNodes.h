// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunAttachedNodes_h
#define gatunAttachedNodes_h

#include "gatunCellBuilder.h"
#include "gatunCellNodes.h"
#include "gatunCellRules.h"
#include "gatunNumberModel.h"
#include "gatunSharedNames.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace gatun
{
/** Codes the nodes of nonlinear cells. Cells with a common edge or face have its nodes in common.
 */
template <typename Coder, typename Side>
class AttachedNodes
{
public:
  AttachedNodes(Coder& coder, CellBuilder<Side>& mesh)
    : Symbols(coder)
    , Mesh(mesh)
    , LastOrders(256, 2)
    , SameOrder(256)
  {
  }

  /** Appends the nodes of a cell of any type to its corners, and codes the order of Lagrange and
   * Bezier cells. actual: all points of the encoder's cell. */
  void CodeOfType(
    std::uint8_t type, std::vector<Vertex>& corners, std::span<const std::uint32_t> actual)
  {
    this->Code(HasNodeOrder(type) ? GetNodesOfOrder(type, this->CodeOrder(type, actual.size()))
                                  : GetCellNodes(type),
      corners, actual);
  }

  /** Appends these nodes to the corners of a cell. */
  void Code(
    const CellNodes& nodes, std::vector<Vertex>& corners, std::span<const std::uint32_t> actual)
  {
    if (nodes.Nodes.empty())
    {
      return;
    }
    if (nodes.Points > this->Mesh.GetCornersLeft())
    {
      ThrowCorrupt("the nodes of a cell are more than its chunk's directory entry says");
    }
    corners.resize(nodes.Points, NoVertex);
    for (const auto& node : nodes.Nodes)
    {
      corners[node.Point] = this->CodeNode(node, corners, Coder::Encoding ? actual[node.Point] : 0);
    }
  }

private:
  /** The vertices of the corners that a node lies between and their weights, in ascending order. */
  using Key = std::array<std::uint64_t, 4>;

  struct HashKey
  {
    std::size_t operator()(const Key& key) const
    {
      std::uint64_t hash = 0;
      for (const auto item : key)
      {
        hash = (hash ^ item) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
      }
      return static_cast<std::size_t>(hash);
    }
  };

  unsigned CodeOrder(std::uint8_t type, std::size_t points)
  {
    auto& last = this->LastOrders[type];
    const unsigned order = Coder::Encoding ? FindNodeOrder(type, points) : 0;
    if (!this->Symbols.Bit(this->SameOrder[type], order == last))
    {
      const auto coded = this->Order.Code(this->Symbols, order);
      if (coded < 1 || coded > MaxNodeOrder)
      {
        ThrowCorrupt("a cell has an impossible order");
      }
      last = static_cast<std::uint8_t>(coded);
    }
    return last;
  }

  static Key MakeKey(const CellNode& node, std::span<const Vertex> corners)
  {
    Key key;
    key.fill(~std::uint64_t{ 0 });
    for (unsigned i = 0; i < key.size() && node.Host[i] != CellNode::None; ++i)
    {
      key[i] = std::uint64_t{ corners[node.Host[i]] } << 32 | node.Weights[i];
    }
    std::sort(key.begin(), key.end());
    return key;
  }

  /** points: of the cell, as far as they are known. */
  Vertex CodeNode(const CellNode& node, std::span<const Vertex> points, std::uint32_t target)
  {
    const bool canBeFound = node.Where != CellNode::Kind::Inside;
    const auto kind = static_cast<unsigned>(node.Where);
    const auto key = MakeKey(node, points);
    const auto found = canBeFound ? this->Nodes.find(key) : this->Nodes.end();
    const bool has = found != this->Nodes.end();
    const Vertex known = Coder::Encoding ? this->Mesh.Actual.GetMet(target) : NoVertex;
    if (has && this->Symbols.Bit(this->IsHosts[kind], known == found->second))
    {
      return found->second;
    }
    if (!this->Symbols.Bit(this->IsNew[kind * 2 + has], known == NoVertex))
    {
      return CodeIndex(this->Symbols, known, this->Mesh.GetVertices());
    }
    const auto record = MakeRecord(node, points);
    unsigned shared = 0;
    for (const auto v : record.Known)
    {
      shared += v != NoVertex && this->Mesh.GetPlace(v).Users != 0;
    }
    const bool isShared = this->Symbols.Bit(
      this->IsShared[std::min(shared, 4u)], Coder::Encoding && this->Mesh.Actual.IsShared(target));
    const auto vertex = isShared
      ? this->Mesh.MeetShared(target, this->NameShared(node, points, record, target))
      : this->Mesh.MeetOwn(target, record);
    this->LogEdges(node, record, vertex);
    if (canBeFound)
    {
      this->Nodes[key] = vertex;
    }
    return vertex;
  }

  static CellRecord MakeRecord(const CellNode& node, std::span<const Vertex> points)
  {
    static_assert(unsigned{ CellNode::Slots } == unsigned{ CellRecord::Size } &&
      unsigned{ CellNode::B1 } == unsigned{ CellRecord::B1 });
    CellRecord record;
    for (unsigned k = 0; k < CellRecord::Size; ++k)
    {
      if (node.Near[k] != CellNode::None)
      {
        record.Known[k] = points[node.Near[k]];
      }
    }
    return record;
  }

  /** The neighbors of a new vertex that were met before. */
  void LogEdges(const CellNode& node, const CellRecord& record, Vertex vertex)
  {
    for (unsigned k = 0; k < CellRecord::B1; ++k)
    {
      const bool isNear = node.IsBetween || k == CellRecord::N1 || k == CellRecord::N2;
      if (isNear && record.Known[k] != NoVertex)
      {
        this->Mesh.LogEdge(record.Known[k], vertex);
      }
    }
  }

  /** Looks around the place where a node of a straight cell is, or where it is predicted. */
  std::uint32_t NameShared(const CellNode& node, std::span<const Vertex> points,
    const CellRecord& record, std::uint32_t target)
  {
    const auto& begin = this->Mesh.GetPlace(record.Known[CellRecord::N1]);
    LatticePoint place;
    if (node.IsBetween)
    {
      float count = 0;
      for (unsigned i = 0; i < node.Host.size() && node.Host[i] != CellNode::None; ++i)
      {
        const auto& corner = this->Mesh.GetPlace(points[node.Host[i]]);
        const auto weight = static_cast<float>(node.Weights[i]);
        place.X += weight * corner.X;
        place.Y += weight * corner.Y;
        place.Z += weight * corner.Z;
        count += weight;
      }
      place = { place.X / count, place.Y / count, place.Z / count, 0 };
    }
    else
    {
      place = PredictPlace(
        record, [&](Vertex v) -> const LatticePoint& { return this->Mesh.GetPlace(v); });
    }
    const Vec3 edge = ToVector(begin) - ToVector(place);
    return this->Shared.Code(
      this->Symbols, this->Mesh.GetSharedSearch(), place, Dot(edge, edge), target);
  }

  Coder& Symbols;
  CellBuilder<Side>& Mesh;
  std::unordered_map<Key, Vertex, HashKey> Nodes;
  std::array<BitModel, 3> IsHosts; // by the kind of a node
  std::array<BitModel, 8> IsNew;
  std::array<BitModel, 5> IsShared; // by the number of shared vertices that it is predicted from
  SharedNames Shared;
  std::vector<std::uint8_t> LastOrders; // of the cells of each type
  std::vector<BitModel> SameOrder;
  NumberModel Order;
};
}

#endif
