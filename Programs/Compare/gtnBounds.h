// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnBounds_h
#define gtnBounds_h

#include "gtnCompare.h"
#include "gtnGridView.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace gatun
{
class FileReader;
}

namespace gtn
{
/**
 * Compares a .gtn file whose arrays have errors with its original, time step after time step: the
 * mesh and all arrays without errors bit by bit, and every value of the others by its bound.
 *
 * Points or cells whose order is not kept are paired by what they have in common without such
 * arrays. Those that are indistinguishable are paired in the order of each component.
 */
class BoundedComparison
{
public:
  /** comparison: that of the other arrays. It must live as long. */
  explicit BoundedComparison(Comparison& comparison)
    : Others(comparison)
  {
  }

  /** Begins with another mesh, whose points and cells have an order of their own. */
  void BeginMesh();

  /** Compares a step. mesh: of the file; step: among those of the mesh. Values are compared as long
   * as all those of the mesh before were equal. */
  Differences Compare(
    GridView packed, GridView original, const gatun::FileReader& mesh, std::size_t step);

  /** Whether there are arrays with errors, and the largest error as a part of its bound. */
  bool HasBounds() const { return this->IsBounded; }
  double GetWorst() const { return this->Worst; }

private:
  /** An array of both grids that has errors at some step. */
  struct Pair
  {
    std::size_t Array;
    ArrayView Packed;
    ArrayView Original;
  };

  static std::vector<Pair> Take(
    GridView& packed, GridView& original, const gatun::FileReader& mesh, bool ofPoints);
  std::string CheckArray(
    const Pair& pair, const gatun::FileReader& mesh, std::size_t step, bool ofPoints);

  Comparison& Others;
  bool AreValuesEqual = true; // of the mesh so far
  bool IsBounded = false;
  double Worst = 0;
};
}

#endif
