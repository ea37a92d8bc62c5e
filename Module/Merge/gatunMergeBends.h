// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeBends_h
#define gatunMergeBends_h

#include "gatunMergeStar.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * The error of linear interpolation around a point, estimated by how the fields bend along the
 * edges: by how much the slope along an edge changes from one end to the other, times its length,
 * which is the second derivative times the square of the length. Single precision is enough, as
 * places and gradients are relative to the point.
 */
template <std::size_t NumberOfFields>
class MergeBends
{
public:
  /** The volumes of four tetrahedra, times six; 0 without one. */
  using Volumes = std::array<Double2, 2>;

  explicit MergeBends(const MergeStar<NumberOfFields>& star)
    : Star(star)
  {
  }

  /** Finds the current error around the point of the star. */
  void Gather();

  /** Returns the error with a neighbor, which is the new point, and the new volumes, minus that
   * before; anything above enough if it is more. */
  double GetChange(std::uint32_t place, const std::vector<Volumes>& volumes, double enough);

private:
  /** The bends of the edges of four tetrahedra that are opposite to the current point. */
  struct Opposite
  {
    std::array<Float4, 3> Edges;
    Float4 Sum;
    Float4 Squares; // their sum
  };

  Float4 GetMeanSquare(std::size_t block, std::size_t field) const;

  const MergeStar<NumberOfFields>& Star;
  std::vector<Float4> Offsets;   // of the neighbors
  std::vector<Float4> Gradients; // of the neighbors, all fields
  std::vector<Opposite> Bends;   // of each block of tetrahedra, all fields
  std::vector<float> Spokes;     // bends of the edges to a place, of each neighbor, all fields
  double Before = 0;
};

extern template class MergeBends<0>;
extern template class MergeBends<1>;
}

#endif
