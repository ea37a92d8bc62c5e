// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkMesh_h
#define gatunChunkMesh_h

#include "gatunBytes.h"
#include "gatunCellList.h"
#include "gatunCellRules.h"
#include "gatunGeometry.h"
#include "gatunTetTree.h"
#include "gatunTopology.h"
#include "gatunTypes.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The maximum number of tetrahedra in a chunk. All numbers in a chunk fit 32 bits. */
constexpr std::uint32_t MaxChunkTets = 1u << 20;

/** The maximum number of vertices of a chunk that has the fast profile. */
constexpr std::uint32_t MaxFastVertices = TetTree::MaxVertices;

/** The sizes of a chunk of cells that are not all tetrahedra. */
struct CellCounts
{
  std::uint32_t Cells = 0;
  std::uint32_t Corners = 0;    // the sum of all cells' point numbers
  std::uint32_t FaceValues = 0; // the length of CellList::Faces
};

/** The data of a chunk that must be known before its streams are decoded. */
struct ChunkFrame
{
  std::uint32_t Tets = 0;
  std::uint32_t OwnPoints = 0;
  Bounds Box;
  std::vector<PointKeys> SharedKeys;
  std::vector<std::uint32_t> SharedUsers; // as LatticePoint::Users
  PointDomain Domains;
  CellCounts Cells; // all 0 in a chunk of tetrahedra, where Tets counts
};

/** A mesh in the order of its walk, which is the order of its arrays. */
struct ChunkMesh
{
  Topology Walk;
  CellList Cells;                      // empty in a chunk of tetrahedra, otherwise Walk.Tets is
  std::vector<PointKeys> Keys;         // of all vertices in the order of the walk
  std::vector<Vertex> OwnIds;          // the number of each own vertex in the walk
  PredictionRules Rules;               // of a chunk of tetrahedra
  std::vector<CellRule> CellRules;     // of another chunk, never empty there unless it has gates
  std::vector<std::uint8_t> UsedRules; // one for each own vertex
  PointDomain Domains;

  /** The coordinates of all vertices. */
  std::vector<std::array<double, 3>> GetPlaces() const;
};

/** The coordinates of points. */
std::vector<std::array<double, 3>> GetPlaces(
  std::span<const PointKeys> keys, const PointDomain& domains);

struct EncodedChunk
{
  Bytes Connectivity;
  Bytes Geometry;
  ChunkMesh Mesh;
  std::vector<std::uint32_t> OwnOrder; // own vertex -> own vertex of the input
  std::vector<std::uint32_t> TetOrder; // tetrahedron -> tetrahedron of the input

  /** For each tetrahedron, the rotation that restores the input's corners: see RotateCorners. */
  std::vector<std::uint8_t> Corners;
};

struct EncodedCells
{
  Bytes Connectivity;
  Bytes Geometry;

  /** Restores the input's order of corners where the streams do not keep it; see RestoreCorners.
   * Empty unless asked for. */
  Bytes Corners;

  /** The mesh as it is decoded. Its walk has no tetrahedra, and a parent for each cell. */
  ChunkMesh Mesh;
  std::vector<std::uint32_t> OwnOrder;  // own vertex -> own vertex of the input
  std::vector<std::uint32_t> CellOrder; // cell -> cell of the input
};
}

#endif
