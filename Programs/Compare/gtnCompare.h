// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnCompare_h
#define gtnCompare_h

#include "gtnGridView.h"
#include "gtnHash.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gtn
{
/** What differs, one line for each difference. */
using Differences = std::vector<std::string>;

/**
 * Compares two grids of tetrahedra bit for bit, time step after time step.
 *
 * Where an order is kept (flags of gatun::KeepOrder), points or cells are compared place by place.
 * Elsewhere they are compared as sets. A point is its coordinates and the values of its arrays, at
 * this step and at all steps before. A cell is its type, its points (those of
 * tetrahedra up to even permutations, those of polyhedra as sets of points and faces), and the
 * values of its arrays. Each point and each cell is represented by a hash of 128 bits, and the
 * sorted hashes of the two grids must be equal.
 *
 * Points that coincide in all values are indistinguishable: a cell may use one in place of another,
 * and that is not reported as a difference. Without such points, no difference means that the grids
 * are identical but for their order.
 */
class Comparison
{
public:
  /** Takes the names of the grids, for messages. */
  Comparison(std::string first, std::string second, std::uint8_t keptOrder);

  /** Lets the first grid have fewer points than the second one, whose points with the same
   * coordinates and values may have been joined: then every point of one grid is in the other, but
   * in the first one less often. The order of the points does not matter then. */
  void AllowJoined() { this->MayBeJoined = true; }

  /** Returns by how many points the second grid of the last step has more. */
  std::size_t GetJoinedPoints() const { return this->JoinedPoints; }

  /** Begins with another mesh, whose points and cells have an order of their own. */
  void BeginMesh();

  /** Compares the numbers of points and cells and the kinds of arrays, names of components
   * and roles. Leaves only those arrays that both have, in the same order. */
  Differences MatchArrays(GridView& first, GridView& second) const;

  /** Whether values can be compared after that. */
  bool AreAlike(const GridView& first, const GridView& second) const;

  /** Compares the values of a step whose numbers of points and cells and arrays are the same. */
  Differences CompareValues(const GridView& first, const GridView& second);

  Differences CompareFieldData(const GridView& first, const GridView& second) const;

  /** Returns the number of points of a mesh that coincide with another one in all values of its
   * steps, the largest of all meshes. */
  std::size_t GetIndistinguishablePoints() const;

  /** What tells the points or cells of a grid apart after a comparison, or nothing if all orders
   * are kept. */
  const std::vector<Hash>& GetFirst(bool points) const
  {
    return points ? this->First.Points : this->First.Cells;
  }
  const std::vector<Hash>& GetSecond(bool points) const
  {
    return points ? this->Second.Points : this->Second.Cells;
  }

private:
  struct Side
  {
    std::string Name;
    std::vector<Hash> Points; ///< of the steps of the mesh so far
    std::vector<Hash> Cells;
  };

  std::string CompareInOrder(const GridView& first, const GridView& second) const;
  std::string CompareTuples(const ArrayView& first, const ArrayView& second) const;
  bool HavePoints(const GridView& first, const GridView& second) const;
  void Match(
    std::vector<ArrayView>& first, std::vector<ArrayView>& second, Differences& differences) const;
  void CompareKeys(const std::string& title, const std::vector<std::string>& first,
    const std::vector<std::string>& second, Differences& differences) const;
  void CompareFieldArrays(
    vtkAbstractArray* first, vtkAbstractArray* second, Differences& differences) const;
  std::string ComparePoints(const GridView& first, const GridView& second);
  std::string CompareCells(const GridView& first, const GridView& second);

  Side First;
  Side Second;
  std::uint8_t Kept;
  bool MayBeJoined = false;
  std::size_t JoinedPoints = 0;
  std::size_t Indistinguishable = 0; ///< of the meshes before
};
}

#endif
