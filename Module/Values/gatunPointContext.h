// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPointContext_h
#define gatunPointContext_h

// The data from which values are predicted, and the predictors.

#include "gatunCellRules.h"
#include "gatunGeometry.h"
#include "gatunTopology.h"
#include "gatunTypes.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
/** Prediction of the values of a stream within their time step. */
enum class SpatialMode : std::uint8_t
{
  Previous = 0,  ///< the previous value of the stream
  Gate = 1,      ///< points: the rule that predicted the coordinates; cells: the parent tetrahedron
  Fit = 2,       ///< points: a linear function fitted to the known neighbors
  Quadratic = 3, ///< a quadratic and a linear function, and the rule of Gate, blended
  PlainQuadratic = 4, ///< the quadratic function alone
  Fast = 5 ///< points: a rule of the stream for all gates; cells: the parent; without range coder
};

/** Whether a mode needs a QuadraticFit. */
constexpr bool IsQuadratic(SpatialMode mode)
{
  return mode == SpatialMode::Quadratic || mode == SpatialMode::PlainQuadratic;
}

/** Use of the values of the previous time step. */
enum class TemporalMode : std::uint8_t
{
  None = 0,
  Repeat = 1, ///< the value of the previous step
  Change = 2  ///< the value of the previous step plus a spatial prediction of the change
};

class NeighborFit;
class QuadraticFit;

/** The data from which all point arrays of a chunk are predicted. */
struct PointContext
{
  const Topology* Mesh = nullptr;
  std::span<const Vertex> OwnIds;                   // the number of each own vertex in the walk
  const PredictionRules* Rules = nullptr;           // of the geometry of a chunk of tetrahedra
  const std::vector<CellRule>* CellRules = nullptr; // and of another chunk, otherwise null
  std::span<const std::uint8_t> UsedRules;          // the rule of each own vertex
  const NeighborFit* Fit = nullptr;                 // may be null if no stream uses it
  const QuadraticFit* Quadratic = nullptr;          // likewise
};

/** The data from which all cell arrays of a chunk, or all point arrays of a block, are predicted.
 */
struct CellContext
{
  std::span<const std::uint32_t> Parents{}; // of the cells of a chunk, Topology::NoTet for a seed
  const QuadraticFit* Quadratic = nullptr;  // may be null if no stream uses it
  Profile Coding = Profile::Small;          // of streams to write

  bool IsBlock() const { return this->Parents.empty(); }
};

/**
 * The values of one component. For points of a chunk there is a key for every vertex of the walk,
 * and keys of shared vertices are known. Otherwise keys are in the order of coding.
 */
struct ComponentKeys
{
  std::vector<Key> Now;
  std::vector<Key> Before; // of the previous time step, or empty
};

/**
 * The prediction of an own vertex by the rule that predicted its coordinates. numbers: of all
 * vertices that are known. Nothing at a vertex where a component of the mesh begins.
 */
std::optional<double> PredictByGate(
  const PointContext& context, std::size_t ownVertex, std::span<const double> numbers);
}

#endif
