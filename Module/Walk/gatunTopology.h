// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTopology_h
#define gatunTopology_h

#include "gatunFront.h"
#include "gatunTetTree.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

namespace gatun
{
/**
 * The known vertices at the moment when a walk met an own vertex: the gate's corners, the apex
 * behind it, and the far corners over the gate's three sides. All are NoVertex if the vertex began
 * a component.
 */
struct GateRecord
{
  static constexpr unsigned Size = 7;
  std::array<Vertex, Size> Known{ NoVertex, NoVertex, NoVertex, NoVertex, NoVertex, NoVertex,
    NoVertex };
  std::uint8_t EdgeGrade = 0;      // numbers of tetrahedra at the gate's edges, 0 to 26
  std::uint8_t CandidateGrade = 0; // number of other candidates, 0 to 3

  bool IsSeed() const { return this->Known[0] == NoVertex; }
};

/**
 * The known vertices when an own vertex of another cell than a tetrahedron was met. Vertices that
 * are missing are NoVertex. All are if nothing around the vertex was known.
 */
struct CellRecord
{
  static constexpr unsigned Size = 10;

  /** The meaning of the vertices. */
  enum Slot : std::uint8_t
  {
    N1,  ///< the first neighbor of the vertex along an edge of the cell; never missing alone
    N2,  ///< the second one
    N3,  ///< the third one
    D12, ///< opposite to the vertex in a quadrilateral between N1 and N2
    D13,
    D23,
    O,  ///< opposite in a hexahedron
    B1, ///< the next vertex on the other side of N1, in a row
    B2,
    B3
  };

  std::array<Vertex, Size> Known{ NoVertex, NoVertex, NoVertex, NoVertex, NoVertex, NoVertex,
    NoVertex, NoVertex, NoVertex, NoVertex };

  bool IsSeed() const { return this->Known[N1] == NoVertex; }

  /** Bit i is set if vertex i is there. */
  unsigned GetMask() const
  {
    unsigned mask = 0;
    for (unsigned k = 0; k < Size; ++k)
    {
      mask |= unsigned{ this->Known[k] != NoVertex } << k;
    }
    return mask;
  }
};

/** The corners of a tetrahedron in either form. */
inline const std::array<Vertex, 4>& UnpackTet(const std::array<Vertex, 4>& tet)
{
  return tet;
}
inline std::array<Vertex, 4> UnpackTet(PackedTet tet)
{
  return { GetCorner(tet, 0), GetCorner(tet, 1), GetCorner(tet, 2), GetCorner(tet, 3) };
}

/**
 * The mesh of a chunk after its walk. Shared and own vertices are numbered in the order in which
 * the walk met them.
 */
struct Topology
{
  static constexpr std::uint32_t SharedFlag = TetTree::SharedFlag;
  static constexpr std::uint32_t NoTet = TetTree::NoTet;

  std::vector<std::array<Vertex, 4>> Tets; // of a walk
  PaddedTets Packed;                       // of a tree, in place of Tets
  std::vector<std::uint32_t> Parents;      // the tetrahedron behind the gate, NoTet for a seed

  // The number of each vertex among the chunk's shared vertices, with SharedFlag, or its own ones.
  std::vector<std::uint32_t> Sources;

  // A chunk in the fast profile has gates (TetTree, CellTree) and nothing of the following.
  std::vector<PackedTet> Gates;               // one for each vertex
  std::vector<GateRecord> Records;            // one for each own vertex of a chunk of tetrahedra
  std::vector<CellRecord> CellRecords;        // and of other chunks
  std::vector<std::array<Vertex, 2>> EdgeLog; // all edges in the order in which the walk made them

  bool HasTree() const { return !this->Gates.empty(); }
  std::size_t GetOwnVertices() const { return this->Records.size() + this->CellRecords.size(); }
  /** Calls use(tets) with those of the walk or of the tree, which UnpackTet takes. */
  template <typename Use>
  void UseTets(Use&& use) const
  {
    this->HasTree() ? use(std::span<const PackedTet>(this->Packed)) : use(std::span(this->Tets));
  }

  std::vector<std::array<Vertex, 4>> CopyTets() const
  {
    std::vector<std::array<Vertex, 4>> copy;
    this->UseTets(
      [&copy](const auto& tets)
      {
        copy.reserve(tets.size());
        std::transform(tets.begin(), tets.end(), std::back_inserter(copy),
          [](const auto& tet) { return UnpackTet(tet); });
      });
    return copy;
  }

  bool IsShared(Vertex v) const { return (this->Sources[v] & SharedFlag) != 0; }

  /** The number of each own vertex in the walk. */
  std::vector<Vertex> FindOwnIds() const { return FindOwn(this->Sources); }
};
}

#endif
