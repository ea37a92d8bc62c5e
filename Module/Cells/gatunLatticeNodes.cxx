// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunLatticeNodes.h"

#include <array>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

// Points of a lattice have the coordinates i, j, k from 0 to the order. VTK numbers the corners
// first, then the points on edges, on faces, and inside, see vtkHigherOrderTriangle,
// vtkHigherOrderTetra, vtkHigherOrderQuadrilateral, vtkHigherOrderHexahedron and
// vtkHigherOrderWedge.

namespace gatun
{
namespace
{
using LatticePlace = std::array<int, 3>;

/** The corners of an edge, triangle or quadrilateral. Its own lattice begins at the first corner, i
 * grows toward the second one, and j toward the last one. */
struct LatticePart
{
  std::uint8_t Size;
  std::array<std::uint8_t, 4> Corners;
};

struct LatticeParts
{
  std::span<const LatticePlace> Corners; // of order 1
  std::span<const LatticePart> Edges, Faces;
};

constexpr std::array<LatticePlace, 8> CubeCorners{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
  { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } } };
constexpr std::array<LatticePlace, 6> WedgeCorners{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
  { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 } } };
constexpr std::array<LatticePlace, 4> TetraCorners{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
  { 0, 0, 1 } } };

constexpr std::array<LatticePart, 12> CubeEdges{ { { 2, { 0, 1 } }, { 2, { 1, 2 } },
  { 2, { 3, 2 } }, { 2, { 0, 3 } }, { 2, { 4, 5 } }, { 2, { 5, 6 } }, { 2, { 7, 6 } },
  { 2, { 4, 7 } }, { 2, { 0, 4 } }, { 2, { 1, 5 } }, { 2, { 2, 6 } }, { 2, { 3, 7 } } } };
constexpr std::array<LatticePart, 9> WedgeEdges{ { { 2, { 0, 1 } }, { 2, { 1, 2 } },
  { 2, { 2, 0 } }, { 2, { 3, 4 } }, { 2, { 4, 5 } }, { 2, { 5, 3 } }, { 2, { 0, 3 } },
  { 2, { 1, 4 } }, { 2, { 2, 5 } } } };
constexpr std::array<LatticePart, 6> TetraEdges{ { { 2, { 0, 1 } }, { 2, { 1, 2 } },
  { 2, { 2, 0 } }, { 2, { 0, 3 } }, { 2, { 1, 3 } }, { 2, { 2, 3 } } } };

constexpr std::array<LatticePart, 6> CubeFaces{ { { 4, { 0, 3, 7, 4 } }, { 4, { 1, 2, 6, 5 } },
  { 4, { 0, 1, 5, 4 } }, { 4, { 3, 2, 6, 7 } }, { 4, { 0, 1, 2, 3 } }, { 4, { 4, 5, 6, 7 } } } };
constexpr std::array<LatticePart, 5> WedgeFaceParts{ { { 3, { 0, 1, 2 } }, { 3, { 3, 4, 5 } },
  { 4, { 0, 1, 4, 3 } }, { 4, { 1, 2, 5, 4 } }, { 4, { 2, 0, 3, 5 } } } };
constexpr std::array<LatticePart, 4> TetraFaceParts{ { { 3, { 0, 1, 3 } }, { 3, { 2, 3, 1 } },
  { 3, { 0, 3, 2 } }, { 3, { 0, 2, 1 } } } };
constexpr LatticePart TriangleFace{ 3, { 0, 1, 2 } };
constexpr LatticePart QuadFace{ 4, { 0, 1, 2, 3 } };

LatticeParts GetParts(LatticeShape shape)
{
  const std::span<const LatticePlace> cube(CubeCorners), wedge(WedgeCorners);
  switch (shape)
  {
    case LatticeShape::Curve:
      return { cube.first(2), std::span<const LatticePart>(CubeEdges).first(1), {} };
    case LatticeShape::Triangle:
      return { wedge.first(3), std::span<const LatticePart>(WedgeEdges).first(3),
        { &TriangleFace, 1 } };
    case LatticeShape::Quad:
      return { cube.first(4), std::span<const LatticePart>(CubeEdges).first(4), { &QuadFace, 1 } };
    case LatticeShape::Tetra:
      return { TetraCorners, TetraEdges, TetraFaceParts };
    case LatticeShape::Wedge:
      return { wedge, WedgeEdges, WedgeFaceParts };
    default:
      return { cube, CubeEdges, CubeFaces };
  }
}

/** The lattice of an edge or a face. */
class PartLattice
{
public:
  PartLattice(const LatticeParts& parts, const LatticePart& part, int order)
    : Begin(parts.Corners[part.Corners[0]])
    , Right(Subtract(parts.Corners[part.Corners[1]], this->Begin))
    , Up(Subtract(parts.Corners[part.Corners[part.Size - 1u]], this->Begin))
    , Order(order)
  {
  }

  LatticePlace Get(int i, int j = 0) const
  {
    LatticePlace place{};
    for (unsigned a = 0; a < 3; ++a)
    {
      place[a] = this->Order * this->Begin[a] + i * this->Right[a] + j * this->Up[a];
    }
    return place;
  }

private:
  static LatticePlace Subtract(const LatticePlace& a, const LatticePlace& b)
  {
    return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
  }

  const LatticePlace Begin, Right, Up;
  const int Order;
};

bool IsSimplex(LatticeShape shape)
{
  return shape == LatticeShape::Triangle || shape == LatticeShape::Tetra;
}

/** Where row j of layer k ends: at the border. */
int GetRowEnd(LatticeShape shape, int order, int j, int k)
{
  return shape == LatticeShape::Tetra ? order - j - k
    : shape == LatticeShape::Wedge    ? order - j
                                      : order;
}

/** Calls use(i, j) for the points inside a face, row by row. */
template <typename Use>
void ForEachInFace(unsigned corners, int order, Use&& use)
{
  for (int j = 1; j < order; ++j)
  {
    for (int i = 1; i < (corners == 3 ? order - j : order); ++i)
    {
      use(i, j);
    }
  }
}

/** Calls use(a, b, c) for the coordinates of points inside a solid, the first one growing fastest.
 * getEnd(b, c): where a row ends. */
template <typename GetEnd, typename Use>
void ForEachInSolid(LatticeShape shape, int order, GetEnd&& getEnd, Use&& use)
{
  const bool isSolid = shape == LatticeShape::Tetra || shape == LatticeShape::Hexahedron ||
    shape == LatticeShape::Wedge;
  for (int c = 1; isSolid && c < order; ++c)
  {
    for (int b = 1; b < order; ++b)
    {
      const int end = getEnd(b, c);
      for (int a = 1; a < end; ++a)
      {
        use(a, b, c);
      }
    }
  }
}

/** The points of a lattice in VTK's order. What is inside of triangles and tetrahedra is numbered
 * like a smaller one, except on wedges. */
std::vector<LatticePlace> ListPlaces(LatticeShape shape, int order)
{
  if (order <= 0)
  {
    return std::vector<LatticePlace>(order == 0 ? 1 : 0);
  }
  const auto parts = GetParts(shape);
  std::vector<LatticePlace> places;
  for (const auto& corner : parts.Corners)
  {
    places.push_back({ order * corner[0], order * corner[1], order * corner[2] });
  }
  for (const auto& edge : parts.Edges)
  {
    const PartLattice lattice(parts, edge, order);
    for (int i = 1; i < order; ++i)
    {
      places.push_back(lattice.Get(i));
    }
  }
  for (const auto& face : parts.Faces)
  {
    const PartLattice lattice(parts, face, order);
    if (IsSimplex(shape))
    {
      for (const auto& inner : ListPlaces(LatticeShape::Triangle, order - 3))
      {
        places.push_back(lattice.Get(inner[0] + 1, inner[1] + 1));
      }
    }
    else
    {
      ForEachInFace(face.Size, order, [&](int i, int j) { places.push_back(lattice.Get(i, j)); });
    }
  }
  if (shape == LatticeShape::Tetra)
  {
    for (const auto& inner : ListPlaces(shape, order - 4))
    {
      places.push_back({ inner[0] + 1, inner[1] + 1, inner[2] + 1 });
    }
  }
  else
  {
    ForEachInSolid(
      shape, order, [&](int j, int k) { return GetRowEnd(shape, order, j, k); },
      [&](int i, int j, int k) {
        places.push_back({ i, j, k });
      });
  }
  return places;
}

/** Makes the nodes of a lattice. */
class LatticeBuilder
{
public:
  LatticeBuilder(LatticeShape shape, int order)
    : Shape(shape)
    , Parts(GetParts(shape))
    , Order(order)
    , Numbers(static_cast<std::size_t>(order + 1) * static_cast<std::size_t>(order + 1) *
          static_cast<std::size_t>(order + 1),
        CellNode::None)
  {
    const auto places = ListPlaces(shape, order);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      this->Numbers[this->GetIndex(places[i])] = static_cast<std::uint16_t>(i);
    }
    this->Result.Corners = this->Parts.Corners.size();
    this->Result.Points = places.size();
  }

  CellNodes Run()
  {
    for (const auto& edge : this->Parts.Edges)
    {
      this->AddEdge(edge);
    }
    for (const auto& face : this->Parts.Faces)
    {
      ForEachInFace(face.Size, this->Order, [&](int i, int j) { this->AddToFace(face, i, j); });
    }
    ForEachInSolid(
      this->Shape, this->Order, [&](int b, int c) { return this->GetLineEnd(b, c); },
      [&](int a, int b, int c) { this->AddInside(a, b, c); });
    return std::move(this->Result);
  }

private:
  std::size_t GetIndex(const LatticePlace& place) const
  {
    const auto size = this->Order + 1;
    return static_cast<std::size_t>((place[2] * size + place[1]) * size + place[0]);
  }

  std::uint16_t GetNumber(const LatticePlace& place) const
  {
    return this->Numbers[this->GetIndex(place)];
  }

  static void SetWeights(CellNode& node, std::initializer_list<int> weights)
  {
    unsigned i = 0;
    for (const int weight : weights)
    {
      node.Weights[i++] = static_cast<std::uint16_t>(weight);
    }
  }

  CellNode MakeNode(CellNode::Kind kind, const LatticePlace& place) const
  {
    CellNode node;
    node.Where = kind;
    node.Point = this->GetNumber(place);
    for (unsigned i = 0; i < place.size(); ++i)
    {
      node.Place[i] = static_cast<std::uint8_t>(place[i]);
    }
    return node;
  }

  CellNode MakeNode(const LatticePart& part, CellNode::Kind kind, const LatticePlace& place) const
  {
    auto node = this->MakeNode(kind, place);
    for (unsigned i = 0; i < part.Size; ++i)
    {
      node.Host[i] = part.Corners[i];
    }
    return node;
  }

  void AddEdge(const LatticePart& edge)
  {
    const PartLattice lattice(this->Parts, edge, this->Order);
    for (int i = 1; i < this->Order; ++i)
    {
      auto node = this->MakeNode(edge, CellNode::Kind::Edge, lattice.Get(i));
      SetWeights(node, { this->Order - i, i });
      node.Near[CellNode::N1] = this->GetNumber(lattice.Get(i - 1));
      node.IsBetween = i == 1;
      if (i == 1)
      {
        node.Near[CellNode::D12] = edge.Corners[1];
      }
      else
      {
        node.Near[CellNode::B1] = this->GetNumber(lattice.Get(i - 2));
      }
      this->Result.Nodes.push_back(node);
    }
  }

  void AddToFace(const LatticePart& face, int i, int j)
  {
    const PartLattice lattice(this->Parts, face, this->Order);
    const bool isTriangle = face.Size == 3;
    const int o = this->Order;
    const int end = isTriangle ? o - j : o;
    auto node = this->MakeNode(
      face, isTriangle ? CellNode::Kind::Triangle : CellNode::Kind::Quad, lattice.Get(i, j));
    if (isTriangle)
    {
      SetWeights(node, { o - i - j, i, j });
    }
    else
    {
      SetWeights(node, { (o - i) * (o - j), i * (o - j), i * j, (o - i) * j });
    }
    this->SetNear(
      node, [&](int a, int b) { return lattice.Get(a, b); }, i, j, end);
    if (isTriangle)
    {
      node.Near[CellNode::D23] = this->GetNumber(lattice.Get(0, j + 1));
    }
    this->Result.Nodes.push_back(node);
  }

  /** Of wedges, lines run from triangle to triangle, where points of straight cells are at equal
   * distances from each other. */
  LatticePlace GetPlace(int a, int b, int c) const
  {
    return this->Shape == LatticeShape::Wedge ? LatticePlace{ b, c, a } : LatticePlace{ a, b, c };
  }

  /** Where a line of a solid ends; 0 if there is none. */
  int GetLineEnd(int b, int c) const
  {
    return this->Shape != LatticeShape::Wedge ? GetRowEnd(this->Shape, this->Order, b, c)
      : b + c < this->Order                   ? this->Order
                                              : 0;
  }

  void AddInside(int a, int b, int c)
  {
    auto node = this->MakeNode(CellNode::Kind::Inside, this->GetPlace(a, b, c));
    this->SetNear(
      node, [&](int x, int z) { return this->GetPlace(x, b, z); }, a, c, this->GetLineEnd(b, c));
    node.Near[CellNode::D23] = this->GetNumber(this->GetPlace(a, b - 1, c - 1));
    node.Near[CellNode::B3] = this->GetNumber(this->GetPlace(a, b - 1, c));
    this->Result.Nodes.push_back(node);
  }

  /** Sets the points around one in the plane of its row and the row before. end: of the row. */
  template <typename GetPlace>
  void SetNear(CellNode& node, GetPlace&& getPlace, int i, int j, int end) const
  {
    const auto get = [&](int a, int b) { return this->GetNumber(getPlace(a, b)); };
    node.Near[CellNode::N1] = get(i, j - 1);
    node.Near[CellNode::N2] = get(i - 1, j);
    node.Near[CellNode::N3] = get(end, j);
    node.Near[CellNode::D12] = get(i - 1, j - 1);
    node.Near[CellNode::D13] = get(end, j - 1);
    if (j > 1)
    {
      node.Near[CellNode::B1] = get(i, j - 2);
    }
    if (i > 1)
    {
      node.Near[CellNode::B2] = get(i - 2, j);
    }
  }

  const LatticeShape Shape;
  const LatticeParts Parts;
  const int Order;
  std::vector<std::uint16_t> Numbers; // of the points, by their places
  CellNodes Result;
};
}

//------------------------------------------------------------------------------
std::size_t CountLatticePoints(LatticeShape shape, unsigned order)
{
  const std::size_t n = order + 1;
  switch (shape)
  {
    case LatticeShape::Curve:
      return n;
    case LatticeShape::Triangle:
      return n * (n + 1) / 2;
    case LatticeShape::Quad:
      return n * n;
    case LatticeShape::Tetra:
      return n * (n + 1) * (n + 2) / 6;
    case LatticeShape::Wedge:
      return n * n * (n + 1) / 2;
    default:
      return n * n * n;
  }
}

CellNodes MakeLatticeNodes(LatticeShape shape, unsigned order)
{
  return LatticeBuilder(shape, static_cast<int>(order)).Run();
}
}
