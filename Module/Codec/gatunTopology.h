// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTopology_h
#define gatunTopology_h

#include "gatunFront.h"

#include <array>
#include <cstdint>
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
 * The mesh of a chunk after its walk. Shared and own vertices are numbered in the order in which
 * the walk met them.
 */
struct Topology
{
  static constexpr std::uint32_t SharedFlag = 0x80000000u;
  static constexpr std::uint32_t NoTet = 0xffffffffu;

  std::vector<std::array<Vertex, 4>> Tets;
  std::vector<std::uint32_t> Parents; // the tetrahedron behind the gate, NoTet for a seed

  // The number of each vertex among the chunk's shared vertices, with SharedFlag, or its own ones.
  std::vector<std::uint32_t> Sources;
  std::vector<GateRecord> Records;            // one for each own vertex
  std::vector<std::array<Vertex, 2>> EdgeLog; // all edges in the order in which the walk made them

  bool IsShared(Vertex v) const { return (this->Sources[v] & SharedFlag) != 0; }
};
}

#endif
