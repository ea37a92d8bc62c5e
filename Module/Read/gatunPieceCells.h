// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPieceCells_h
#define gatunPieceCells_h

#include "gatunCellShapes.h"
#include "gatunPieceRequest.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The cells of a piece in memory. */
class PieceCells
{
public:
  /** Makes room. sizes: of Connectivity and Faces. Tetrahedra have no offsets. */
  PieceCells(bool tetrahedra, std::size_t cells, std::size_t connectivity, std::size_t faces);

  /** The memory for a decoder to fill. */
  PieceTarget GetTarget();

  std::size_t GetNumber() const { return this->Number; }
  std::uint8_t GetType(std::size_t cell) const
  {
    return this->Tetrahedra ? TetraType : this->Types[cell];
  }
  std::size_t GetConnectivitySize() const { return this->Connectivity.size(); }
  std::size_t GetFacesSize() const { return this->Faces.size(); }

  /** Calls use with each point of a cell, and with those of a polyhedron's faces again. */
  template <typename Use>
  void ForEachPoint(std::size_t cell, Use&& use) const
  {
    for (const auto id : this->GetPoints(cell))
    {
      use(static_cast<std::size_t>(id));
    }
    const auto faces = this->GetFaces(cell);
    for (std::size_t at = faces.empty() ? 0 : 1; at < faces.size();)
    {
      for (auto points = faces[at++]; points > 0; --points)
      {
        use(static_cast<std::size_t>(faces[at++]));
      }
    }
  }

  /** Some of the cells. placeOf: the new id of each point. */
  PieceCells Select(
    std::span<const std::uint64_t> cells, std::span<const std::int64_t> placeOf) const;

  /** Copies the cells to a target. */
  void Store(const PieceTarget& target) const;

private:
  std::span<const std::int64_t> GetPoints(std::size_t cell) const;

  /** The faces of a polyhedron, with their number. Empty for other cells. */
  std::span<const std::int64_t> GetFaces(std::size_t cell) const;

  std::size_t Number;
  bool Tetrahedra;
  std::vector<std::int64_t> Connectivity;
  std::vector<std::int64_t> Offsets; // if not all are tetrahedra
  std::vector<std::uint8_t> Types;
  std::vector<std::int64_t> FaceLocations; // if there are faces
  std::vector<std::int64_t> Faces;
};
}

#endif
