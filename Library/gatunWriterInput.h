// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunWriterInput_h
#define gatunWriterInput_h

// What a caller of C gives to a writer, in the form of the core. Everything that is wrong throws
// Error(InvalidInput).

#include "gatunBorder.h"

#include "gatunErrorBound.h"
#include "gatunFieldData.h"
#include "gatunMeshInput.h"
#include "gatunMeshMerges.h"
#include "gatunWriterOptions.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
/** A mesh whose cells have as many points as they need, and points that exist. */
MeshInput TakeMesh(const gatun_mesh& from);

/** Descriptions of arrays with what else a writer is told of them. */
class TakenArrays
{
public:
  TakenArrays() = default;
  TakenArrays(const gatun_array* arrays, std::size_t count);

  const std::vector<ArrayDescription>& GetList() const { return this->List; }

  /** The values at the first step, null where there are none. */
  const std::vector<const void*>& GetValues() const { return this->Values; }

  /** Gives the arrays of a file the errors and weights of these ones, if there are any. */
  void SetList(const std::vector<ArrayDescription>& list);

  /** The weights of the arrays in a hierarchy, or the default ones if all are 0. */
  std::vector<double> FindWeights() const;

  /** The hierarchy of a mesh, by the values of its first step and the weights. */
  MergeTree BuildTree(const MeshInput& mesh, bool isSurface, std::span<const void* const> values,
    const MeshMerges::Progress& progress) const;

  /** The bounds of errors. The core knows them by the names of arrays, which may repeat.
   * everything: of all arrays of floating-point numbers without one of their own, or null. */
  std::vector<ArrayError> MakeErrors(const char* everything) const;

private:
  void AddFields(MeshMerges& merges, std::span<const void* const> values) const;

  std::vector<ArrayDescription> List;
  std::vector<std::string> Errors;
  std::vector<double> Weights;
  std::vector<const void*> Values;
};

/** Options without the tree of a hierarchy and the values for layers. */
WriterOptions TakeOptions(const gatun_options& from, const TakenArrays& arrays);

FieldData TakeFields(const gatun_field* fields, std::size_t count);

/** The arrays of a step, for so many points and cells. */
std::vector<const void*> TakeValues(const gatun_values& from,
  const std::vector<ArrayDescription>& arrays, std::uint64_t points, std::uint64_t cells);

RemainingCells TakeRemaining(const gatun_values& from);
}

#endif
