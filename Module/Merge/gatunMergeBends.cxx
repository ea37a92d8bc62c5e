// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeBends.h"

#include <algorithm>

namespace gatun
{
namespace
{
GATUN_INLINE Float4 ToFloats(const glm::dvec3& v)
{
  return Float4{ static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0 };
}

/** The sums of the lanes of four vectors. */
GATUN_INLINE Float4 SumEach(const std::array<Float4, 4>& v)
{
  const Float4 even = Interleave(v[0], v[2]) + InterleaveHigh(v[0], v[2]);
  const Float4 odd = Interleave(v[1], v[3]) + InterleaveHigh(v[1], v[3]);
  return Interleave(even, odd) + InterleaveHigh(even, odd);
}
}

//------------------------------------------------------------------------------
template <std::size_t N>
void MergeBends<N>::Gather()
{
  const auto& star = this->Star;
  const std::size_t fields = star.GetFields();
  const std::size_t neighbors = star.Neighbors.size();
  this->Offsets.resize(neighbors);
  this->Gradients.resize(neighbors * fields);
  this->Spokes.resize(neighbors * fields);
  for (std::size_t i = 0; i < neighbors; ++i)
  {
    this->Offsets[i] = ToFloats(star.Neighbors[i].Offset);
    for (std::size_t f = 0; f < fields; ++f)
    {
      const Float4 gradient = ToFloats(star.Around[i * fields + f].Gradient);
      this->Gradients[i * fields + f] = gradient;
      const Float4 products = this->Offsets[i] * gradient;
      this->Spokes[i * fields + f] = products[0] + products[1] + products[2];
    }
  }
  this->Bends.resize(star.Tets.size() * fields);
  this->Before = 0;
  for (std::size_t block = 0; block < star.Tets.size(); ++block)
  {
    const MergeTets& tets = star.Tets[block];
    for (std::size_t f = 0; f < fields; ++f)
    {
      Opposite& bends = this->Bends[block * fields + f];
      for (std::size_t side = 0; side < 3; ++side)
      {
        const auto& from = tets.Corners[(side + 1) % 3];
        const auto& to = tets.Corners[(side + 2) % 3];
        std::array<Float4, 4> products;
        for (std::size_t lane = 0; lane < 4; ++lane)
        {
          products[lane] = (this->Offsets[from[lane]] - this->Offsets[to[lane]]) *
            (this->Gradients[from[lane] * fields + f] - this->Gradients[to[lane] * fields + f]);
        }
        bends.Edges[side] = SumEach(products);
      }
      const auto& e = bends.Edges;
      bends.Sum = e[0] + e[1] + e[2];
      bends.Squares = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
      const Float4 square = this->GetMeanSquare(block, f);
      for (std::size_t lane = 0; lane < 4; ++lane)
      {
        this->Before += tets.Weight[lane / 2][lane % 2] * square[lane];
      }
    }
  }
}

//------------------------------------------------------------------------------
/**
 * The mean squares of the errors of linear interpolation in four tetrahedra, of a field of constant
 * second derivatives, by its bends along the edges: the error is half the sum of bend times both
 * weights over all edges.
 */
template <std::size_t N>
inline Float4 MergeBends<N>::GetMeanSquare(std::size_t block, std::size_t field) const
{
  const std::size_t fields = this->Star.GetFields();
  const auto& corners = this->Star.Tets[block].Corners;
  const float* const spokes = this->Spokes.data() + field;
  const Float4 a = GatherFour(spokes, corners[0], fields);
  const Float4 b = GatherFour(spokes, corners[1], fields);
  const Float4 c = GatherFour(spokes, corners[2], fields);
  const Opposite& opposite = this->Bends[block * fields + field];
  const auto& edges = opposite.Edges;
  const Float4 sum = a + b + c + opposite.Sum;
  return (sum * sum + a * (a - edges[0]) + b * (b - edges[1]) + c * (c - edges[2]) +
           opposite.Squares) *
    Splat(1.0f / 1680);
}

//------------------------------------------------------------------------------
template <std::size_t N>
double MergeBends<N>::GetChange(
  std::uint32_t place, const std::vector<Volumes>& volumes, double enough)
{
  const auto& star = this->Star;
  const std::size_t fields = star.GetFields();
  const std::size_t neighbors = this->Offsets.size();
  for (std::size_t f = 0; f < fields; ++f)
  {
    const Float4 gradient = this->Gradients[place * fields + f];
    for (std::size_t first = 0; first < neighbors; first += 4)
    {
      std::array<Float4, 4> products;
      for (std::size_t lane = 0; lane < 4; ++lane)
      {
        const std::size_t other = std::min(first + lane, neighbors - 1);
        products[lane] = (this->Offsets[other] - this->Offsets[place]) *
          (this->Gradients[other * fields + f] - gradient);
      }
      const Float4 sums = SumEach(products);
      for (std::size_t lane = 0; lane < 4 && first + lane < neighbors; ++lane)
      {
        this->Spokes[(first + lane) * fields + f] = sums[lane];
      }
    }
  }
  Double2 now = Splat2(0);
  for (std::size_t block = 0; block < star.Tets.size() && !(Sum(now) - this->Before > enough);
       ++block)
  {
    std::array<Double2, 2> weight;
    for (std::size_t half = 0; half < 2; ++half)
    {
      weight[half] = SelectGreater(volumes[block][half], Splat2(0),
        Splat2(star.PerVolume) * volumes[block][half] + Splat2(star.PerTet), Splat2(0));
    }
    for (std::size_t f = 0; f < fields; ++f)
    {
      const Float4 square = this->GetMeanSquare(block, f);
      now = now + weight[0] * Double2{ square[0], square[1] } +
        weight[1] * Double2{ square[2], square[3] };
    }
  }
  return Sum(now) - this->Before;
}

template class MergeBends<0>;
template class MergeBends<1>;
}
