// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnPieceRouter.h"

#include <algorithm>

namespace gtn
{
//------------------------------------------------------------------------------
PieceRouter::PieceRouter(std::size_t points, std::size_t leaves)
  : Leaves(points)
  , All(leaves)
{
}

//------------------------------------------------------------------------------
PieceRouter::Leaf& PieceRouter::Find(std::span<const std::uint32_t> corners)
{
  std::size_t least = corners.empty() ? 0 : this->All.size();
  for (const std::uint32_t corner : corners)
  {
    least = std::min<std::size_t>(least, this->Leaves[corner] & ~Used);
  }
  return this->All[least];
}

//------------------------------------------------------------------------------
void PieceRouter::Weigh(std::span<const std::uint32_t> corners, std::uint32_t faceValues)
{
  Leaf& leaf = this->Find(corners);
  ++leaf.Cells;
  leaf.Corners += corners.size();
  leaf.FaceValues += faceValues;
}

//------------------------------------------------------------------------------
std::size_t PieceRouter::Divide(const ElementBytes& bytes, std::uint64_t most, std::size_t least)
{
  std::uint64_t corners = 0;
  for (const Leaf& leaf : this->All)
  {
    corners += leaf.Corners;
  }
  // Points are divided like the corners that they are. Those between pieces are in several.
  constexpr double repeated = 1.15;
  const double points = corners == 0 ? 0
                                     : repeated * bytes.Point *
      static_cast<double>(this->Leaves.size()) / static_cast<double>(corners);
  std::vector<std::uint64_t> weights;
  for (const Leaf& leaf : this->All)
  {
    weights.push_back(static_cast<std::uint64_t>(bytes.Cell * static_cast<double>(leaf.Cells) +
      (bytes.Corner + points) * static_cast<double>(leaf.Corners) +
      bytes.FaceValue * static_cast<double>(leaf.FaceValues)));
  }
  const auto firsts = GroupLeaves(weights, most, least);
  std::uint32_t pieces = 0;
  for (std::size_t g = 0; g + 1 < firsts.size(); ++g)
  {
    std::uint64_t weight = 0;
    std::uint64_t cells = 0;
    for (std::size_t l = firsts[g]; l < firsts[g + 1]; ++l)
    {
      weight += weights[l];
      cells += this->All[l].Cells;
      this->All[l].FirstPiece = pieces;
    }
    // A leaf that is too heavy, such as one place with many points, is divided by the order of its
    // cells.
    std::uint32_t parts = 1;
    if (weight > most)
    {
      const auto heavy = std::max_element(weights.begin() + static_cast<std::ptrdiff_t>(firsts[g]),
        weights.begin() + static_cast<std::ptrdiff_t>(firsts[g + 1]));
      Leaf& leaf = this->All[static_cast<std::size_t>(heavy - weights.begin())];
      parts =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(cells, (weight + most - 1) / most));
      leaf.Pieces = parts;
    }
    pieces += parts;
  }
  return pieces;
}

//------------------------------------------------------------------------------
std::size_t PieceRouter::Route(std::span<const std::uint32_t> corners)
{
  Leaf& leaf = this->Find(corners);
  const std::uint64_t number = leaf.Routed++;
  for (const std::uint32_t corner : corners)
  {
    this->Leaves[corner] |= Used;
  }
  return leaf.FirstPiece +
    static_cast<std::size_t>(number * leaf.Pieces / std::max<std::uint64_t>(leaf.Cells, 1));
}
}
