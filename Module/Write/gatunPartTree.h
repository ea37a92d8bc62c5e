// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartTree_h
#define gatunPartTree_h

#include "gatunArrayInput.h"
#include "gatunAtomicFile.h"
#include "gatunPartMerges.h"
#include "gatunTreeSection.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/**
 * The hierarchy of a mesh that is written in parts. While parts are written, their tetrahedra go to
 * PartMerges, and the coordinates and values of points to a temporary file, from which the ranges
 * of chunks after merges are found.
 */
class PartTree
{
public:
  /** weights: of each array, 0 for those that do not count. steps: of all parts. State: its tables
   * must be those of all parts. Throws InvalidInput for too many points. */
  PartTree(WriterState& state, std::span<const double> weights, std::size_t steps,
    const PartMergeSettings& settings);

  /** Adds a part whose mesh has been written, with the values of its first step; none if there are
   * no steps. isJoined: of each point, whether other parts have it. */
  void AddPart(const WriterPart& part, std::span<const std::uint8_t> isJoined,
    const std::vector<ArrayInput>& values);

  /** Keeps the values of a step of that part. */
  void AddStep(std::size_t step, const std::vector<ArrayInput>& values);

  /** Finds the merges, and writes all sections. progress: see BuildMergeTree. */
  void Write(const std::function<bool(double)>& progress);

private:
  /** A value of each point of the file, in the temporary file. */
  using Column = std::size_t;

  Column GetColumn(std::size_t step, std::size_t array, std::size_t range) const;
  void WriteColumn(Column column, const std::function<double(std::uint32_t)>& getValue);
  TreeSection::GetValue ReadColumn(Column column) const;

  WriterState& State;
  const std::vector<double> Weights;
  const std::size_t Steps;
  const std::size_t Points;              // of the file
  std::vector<std::size_t> FirstColumns; // of each array, in a step
  std::size_t ColumnsOfStep = 0;
  PartMerges Merges;
  AtomicFile Columns;
  std::uint64_t FirstOwn; // the number in the file of the first own point of the next part

  // Of the current part.
  std::vector<std::uint32_t> Numbers; // in the file
  std::vector<std::uint32_t> Order;   // points with numbers, by number
};
}

#endif
