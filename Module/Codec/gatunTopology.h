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
 * What was known when a walk met an own vertex: the gate's corners, the apex behind it, and the
 * far corners over the gate's three sides. All NoVertex when the vertex began a component.
 */
struct GateRecord
{
  static constexpr unsigned Size = 7;
  std::array<Vertex, Size> Known{ NoVertex, NoVertex, NoVertex, NoVertex, NoVertex, NoVertex,
    NoVertex };
  std::uint8_t EdgeGrade = 0;      // how many tetrahedra the gate's edges have, 0 to 26
  std::uint8_t CandidateGrade = 0; // how many vertices competed with this one, 0 to 3

  bool IsSeed() const { return this->Known[0] == NoVertex; }
};

/**
 * A chunk's mesh as its walk leaves it. Vertices are numbered in the order in which the walk met
 * them, whether shared or own.
 */
struct Topology
{
  static constexpr std::uint32_t SharedFlag = 0x80000000u;
  static constexpr std::uint32_t NoTet = 0xffffffffu;

  std::vector<std::array<Vertex, 4>> Tets;
  std::vector<std::uint32_t> Parents; // tetrahedron behind the gate, NoTet for a seed

  // Of each vertex: its place among the chunk's shared vertices with SharedFlag, or among its own.
  std::vector<std::uint32_t> Sources;
  std::vector<GateRecord> Records;            // one an own vertex
  std::vector<std::array<Vertex, 2>> EdgeLog; // every edge that the walk made, in that order

  bool IsShared(Vertex v) const { return (this->Sources[v] & SharedFlag) != 0; }
};
}

#endif
