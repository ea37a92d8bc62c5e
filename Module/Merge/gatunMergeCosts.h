// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeCosts_h
#define gatunMergeCosts_h

#include "gatunMergeBends.h"
#include "gatunMergeChoice.h"
#include "gatunMergeFields.h"
#include "gatunMergeInput.h"
#include "gatunMergeLinks.h"
#include "gatunMergeMesh.h"
#include "gatunMergeStar.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Finds the best merge of a point. NumberOfFields is that of the input, or 0 for any. */
template <std::size_t NumberOfFields>
class MergeCosts
{
public:
  MergeCosts(const MergeMesh& mesh, const MergeFields& fields, const MergeSettings& settings);

  static constexpr std::uint8_t MostChanges = 3; // see MergeRounds

  /** Ratio of estimated to measured RMS error. */
  static constexpr double ChangePerError = 6;

  /** Returns the cheapest merge of a point that turns no tetrahedron or face over, and preserves
   * the topology if that is checked. Its cost is the change divided by the number of tetrahedra
   * that vanish. A good first neighbor to try makes this faster. */
  MergeChoice Choose(std::uint32_t point, std::uint32_t tryFirst, bool checkTopology);

  bool MayMerge(std::uint32_t point, std::uint32_t into)
  {
    return this->Links.MayMerge(point, into);
  }

private:
  void FindBounds();
  double GetLeastFieldChange(std::uint32_t place) const;
  std::uint32_t TakeCandidate(double mostCost);
  void Try(std::uint32_t place, bool checkTopology, MergeChoice& best);
  bool FindVolumes(std::uint32_t place);
  bool WouldInvertAny(std::size_t block, const std::array<Mask2, 2>& doubtful) const;
  bool WouldInvert(std::size_t tet, double volume) const;
  double GetFieldChange(std::uint32_t place) const;
  double GetBendChange(std::uint32_t place, double enough);
  double GetShapeChange(std::uint32_t place) const;

  const MergeSettings& Settings;
  MergeLinks Links;
  MergeStar<NumberOfFields> Star;
  MergeBends<NumberOfFields> Bends;

  // Around the current point.
  std::uint32_t Point = 0;
  double FieldWeight = 1;
  double BendWeight = 0;
  bool HasBends = false;            // whether Bends are those of the point
  std::vector<double> LengthCosts;  // of each neighbor
  std::vector<double> LeastChanges; // lower bounds of the change of the fields, of each neighbor
  std::vector<double> Bounds;       // lower bounds of the costs, of each neighbor
  std::vector<std::array<Double2, 2>> Volumes; // after a merge, of each block; 0 if they vanish
};

extern template class MergeCosts<0>;
extern template class MergeCosts<1>;
}

#endif
