// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeFields_h
#define gatunMergeFields_h

#include "gatunLargeArray.h"
#include "gatunMergeInput.h"
#include "gatunMergeMesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
/** A field at a point: its value, and its gradient. */
struct FieldSample
{
  double Value = 0;
  glm::dvec3 Gradient{ 0 };
};

/**
 * Sums over the tetrahedra around each point, of which there may be parts in several meshes.
 *
 * Of each point there is first the point itself, as a gradient, with six times the volume around it
 * as the value, and then for each field its value and the sum of the gradients, each times six
 * times the volume.
 */
struct MergeSums
{
  using Tet = std::array<std::uint32_t, 4>;

  MergeSums(const MergeInput& input, std::span<const double> scales);

  /** Adds a tetrahedron. One whose volume is not finite is left out. */
  void Add(const Tet& corners);

  std::size_t Each; // samples of a point
  LargeArray<FieldSample> Samples;
  double Volume = 0;
  std::size_t Tets = 0;
};

/** The points of a mesh with the values of its fields and their gradients in the given mesh. */
class MergeFields
{
public:
  using Vec = glm::dvec3;

  /** A field at a point: the value, divided by the range and times the square root of the weight,
   * and the gradient, which is the mean of the gradients of the tetrahedra around. */
  using Sample = FieldSample;

  MergeFields(const MergeMesh& mesh, const MergeInput& input);

  /** Of a part of a mesh: 1 + fields samples for each point, as GetData has them. perWhole, perTet:
   * those of the whole mesh. */
  MergeFields(std::size_t fields, LargeArray<Sample> samples, double perWhole, double perTet)
    : Fields(fields)
    , PerWhole(perWhole)
    , PerTet(perTet)
    , Samples(std::move(samples))
  {
  }

  std::size_t GetNumber() const { return this->Fields; }

  const Vec& GetPoint(std::uint32_t point) const { return this->At(point).Gradient; }

  /** Returns six times the volume of the tetrahedra around a point in the given mesh. */
  double GetVolumeAround(std::uint32_t point) const { return this->At(point).Value; }

  /** Makes means of the sums of a point. */
  static void Finish(std::span<Sample> samples);

  /** Returns the point with the volume around it, and behind it one sample for each field. */
  const Sample* GetData(std::uint32_t point) const { return &this->At(point); }

  /** Returns one sample for each field. */
  const Sample* GetSamples(std::uint32_t point) const { return &this->At(point) + 1; }

  /** Returns 1 / volume of the mesh, or 0. */
  double GetPerWhole() const { return this->PerWhole; }

  /** Returns 1 / number of tetrahedra, or 0. */
  double GetPerTet() const { return this->PerTet; }

private:
  const Sample& At(std::uint32_t point) const { return this->Samples[point * (1 + this->Fields)]; }

  std::size_t Fields;
  double PerWhole = 0;
  double PerTet = 0;
  LargeArray<Sample> Samples; // of each point: the point and the volume around it, then all fields
};
}

#endif
