// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeFields_h
#define gatunMergeFields_h

#include "gatunLargeArray.h"
#include "gatunMergeInput.h"
#include "gatunMergeMesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** The points of a mesh with the values of its fields and their gradients in the given mesh. */
class MergeFields
{
public:
  using Vec = glm::dvec3;

  /** A field at a point: the value, divided by the range and times the square root of the weight,
   * and the gradient, which is the mean of the gradients of the tetrahedra around. */
  struct Sample
  {
    double Value = 0;
    Vec Gradient{ 0 };
  };

  MergeFields(const MergeMesh& mesh, const MergeInput& input);

  std::size_t GetNumber() const { return this->Fields; }

  const Vec& GetPoint(std::uint32_t point) const { return this->At(point).Gradient; }

  /** Returns six times the volume of the tetrahedra around a point in the given mesh. */
  double GetVolumeAround(std::uint32_t point) const { return this->At(point).Value; }

  /** Returns one sample for each field. */
  const Sample* GetSamples(std::uint32_t point) const { return &this->At(point) + 1; }

  /** Loads the data of a point into the cache of the processor. */
  void Prefetch(std::uint32_t point) const { __builtin_prefetch(&this->At(point)); }

  /** Returns 1 / volume of the mesh, or 0. */
  double GetPerWhole() const { return this->PerWhole; }

  /** Returns 1 / number of tetrahedra, or 0. */
  double GetPerTet() const { return this->PerTet; }

private:
  const Sample& At(std::uint32_t point) const { return this->Samples[point * (1 + this->Fields)]; }
  void AddSlopes(const MergeMesh::Tet& corners, double volume);

  std::size_t Fields;
  double PerWhole = 0;
  double PerTet = 0;
  LargeArray<Sample> Samples; // of each point: the point and the volume around it, then all fields
};
}

#endif
