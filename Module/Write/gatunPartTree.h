// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartTree_h
#define gatunPartTree_h

#include "gatunArrayInput.h"
#include "gatunPartLevels.h"
#include "gatunPartMerges.h"
#include "gatunPartValues.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/** The hierarchy of a mesh that is written in parts, whose tetrahedra go to PartMerges. */
class PartTree
{
public:
  /** state: its tables must be those of all parts. weights: of each array, 0 for those that do not
   * count. hasSteps: whether parts have values. makeLevel: see PartLevels. State and values must
   * exist as long as this object. */
  PartTree(WriterState& state, const PartValues& values, std::span<const double> weights,
    bool hasSteps, const PartMergeSettings& settings, PartLevels::MakeFile makeLevel);

  /** Adds the last part of PartValues, with the values of its first step; none if there are no
   * steps. isJoined: of each point, whether other parts have it. */
  void AddPart(const WriterPart& part, std::span<const std::uint8_t> isJoined,
    const std::vector<ArrayInput>& values);

  /** Finds the merges, and writes the base meshes into files of their own. progress: see
   * BuildMergeTree. */
  MergeTree Build(const std::function<bool(double)>& progress);

  /** See PartMerges. */
  MergeDependencies FindDependencies(const MergeTree& tree)
  {
    return this->Merges.FindDependencies(tree);
  }

  PartLevels& GetLevels() { return this->Levels; }

private:
  WriterState& State;
  const PartValues& Values;
  const std::vector<double> Weights;
  const bool KeepsCells;
  PartMerges Merges;
  PartLevels Levels;
};
}

#endif
