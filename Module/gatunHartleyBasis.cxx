// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyBasis.h"

#include "gatunHartleyKernel.h"
#include "gatunHartleyRay.h"
#include "gatunHartleyTransform.h"
#include "gatunParallel.h"

#include <algorithm>
#include <numeric>

namespace gatun
{
namespace
{
// Points whose rays are transformed before their values are sorted to basis functions.
constexpr std::size_t PointsAtOnce = 16;
}

//------------------------------------------------------------------------------
class HartleyBasis::PairBrush : public HartleyPainter::Brush
{
public:
  explicit PairBrush(const HartleyBasis& basis)
    : Basis(basis)
    , Weights(basis.Pairs.size())
    , Even(basis.Half)
    , Odd(basis.Half)
  {
  }

  void Paint(std::size_t, std::span<const HartleyTerm> terms, std::span<float> picture) override
  {
    this->Touched.clear();
    for (const HartleyTerm& term : terms)
    {
      const Place& place = this->Basis.Places[term.Index];
      auto& weight = this->Weights[place.Pair];
      if (weight[0] == 0 && weight[1] == 0)
      {
        this->Touched.push_back(place.Pair);
      }
      weight[0] += place.Even * term.Value;
      weight[1] += place.Odd * term.Value;
    }

    const std::size_t half = this->Basis.Half;
    this->EvenShares.clear();
    this->OddShares.clear();
    for (const std::uint32_t pair : this->Touched)
    {
      auto& weight = this->Weights[pair];
      const float* const even = this->Basis.Pictures.data() + 2 * pair * half;
      if (weight[0] != 0)
      {
        this->EvenShares.push_back({ even, weight[0] });
      }
      if (weight[1] != 0)
      {
        this->OddShares.push_back({ even + half, weight[1] });
      }
      weight = {};
    }
    const auto& kernel = GetBestHartleyKernel();
    kernel.Combine(this->EvenShares.data(), this->EvenShares.size(), half, this->Even.data());
    kernel.Combine(this->OddShares.data(), this->OddShares.size(), half, this->Odd.data());
    for (std::size_t i = 0; i < half; ++i)
    {
      picture[i] = this->Even[i] + this->Odd[i];
      picture[picture.size() - 1 - i] = this->Even[i] - this->Odd[i];
    }
  }

private:
  const HartleyBasis& Basis;
  std::vector<std::array<float, 2>> Weights; // of each pair: even, odd; 0 between blocks
  std::vector<std::uint32_t> Touched;
  std::vector<HartleyShare> EvenShares, OddShares;
  std::vector<float> Even, Odd;
};

//------------------------------------------------------------------------------
HartleyBasis::HartleyBasis(const HartleyLayout::Triple& block, const HartleyLattice& lattice,
  const std::function<bool(double)>& progress)
  : Lattice(lattice)
  , Block(block)
  , Half(lattice.GetNumberOfPoints() / 2 + 1)
{
  this->FindPairs();
  const std::size_t voxels = this->Places.size();
  this->Pictures.resize(this->Pairs.size() * 2 * this->Half);

  // At one point, the pictures of all basis functions are the transform of the ray's weights.
  const std::size_t batches = (this->Half + PointsAtOnce - 1) / PointsAtOnce;
  ParallelFor(
    batches,
    [&](std::size_t batch)
    {
      HartleyTransform transform(block);
      HartleyRay ray(block, lattice);
      const std::size_t first = batch * PointsAtOnce;
      const std::size_t count = std::min(PointsAtOnce, this->Half - first);
      std::vector<double> values(voxels * count, 0.0);
      for (std::size_t i = 0; i < count; ++i)
      {
        const std::span<double> mine(values.data() + i * voxels, voxels);
        ray.AddWeights(lattice.GetPlace(0, (first + i) % lattice.Points[0]),
          lattice.GetPlace(1, (first + i) / lattice.Points[0]), mine);
        transform.Forward(mine);
      }
      float* even = this->Pictures.data() + first;
      for (const Pair& pair : this->Pairs)
      {
        float* const odd = even + this->Half;
        for (std::size_t i = 0; i < count; ++i)
        {
          const double here = values[i * voxels + pair.First];
          const double mirrored = pair.Mirror * values[i * voxels + pair.Second];
          even[i] = static_cast<float>((here + mirrored) / 2);
          odd[i] = static_cast<float>((here - mirrored) / 2);
        }
        even = odd + this->Half;
      }
    },
    progress);
}

//------------------------------------------------------------------------------
void HartleyBasis::FindPairs()
{
  const auto& n = this->Block;
  this->Places.resize(std::size_t{ n[0] } * n[1] * n[2]);
  const auto opposite = [](std::uint32_t u, std::uint32_t size) { return u == 0 ? 0 : size - u; };
  std::uint32_t index = 0;
  for (std::uint32_t w = 0; w < n[2]; ++w)
  {
    for (std::uint32_t v = 0; v < n[1]; ++v)
    {
      for (std::uint32_t u = 0; u < n[0]; ++u, ++index)
      {
        const std::uint32_t other =
          (opposite(w, n[2]) * n[1] + opposite(v, n[1])) * n[0] + opposite(u, n[0]);
        // The frequency n / 2 stands for its opposite as well, whose functions have the other sign
        // at places that are half a voxel off whole ones.
        const int signs = (2 * u == n[0]) + (2 * v == n[1]) + (2 * w == n[2]);
        const float mirror = signs % 2 == 0 ? 1.0f : -1.0f;
        if (index <= other)
        {
          this->Places[index] = { static_cast<std::uint32_t>(this->Pairs.size()), 1, 1 };
          this->Pairs.push_back({ index, other, mirror });
        }
        else
        {
          this->Places[index] = { this->Places[other].Pair, mirror, -mirror };
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
std::unique_ptr<HartleyPainter::Brush> HartleyBasis::MakeBrush() const
{
  return std::make_unique<PairBrush>(*this);
}

//------------------------------------------------------------------------------
std::vector<float> HartleyBasis::PaintUnit(const HartleyLayout::Triple& filled) const
{
  std::vector<float> picture(this->Lattice.GetNumberOfPoints());
  ParallelFor(this->Lattice.Points[1],
    [&](std::size_t row)
    {
      HartleyRay ray(this->Block, this->Lattice);
      std::vector<double> weights(this->Places.size());
      for (std::size_t column = 0; column < this->Lattice.Points[0]; ++column)
      {
        std::fill(weights.begin(), weights.end(), 0.0);
        ray.AddWeights(this->Lattice.GetPlace(0, column), this->Lattice.GetPlace(1, row), weights);
        double sum = 0;
        for (std::uint32_t z = 0; z < filled[2]; ++z)
        {
          for (std::uint32_t y = 0; y < filled[1]; ++y)
          {
            const auto from = weights.begin() +
              static_cast<std::ptrdiff_t>((std::size_t{ z } * this->Block[1] + y) * this->Block[0]);
            sum = std::accumulate(from, from + filled[0], sum);
          }
        }
        picture[row * this->Lattice.Points[0] + column] = static_cast<float>(sum);
      }
    });
  return picture;
}
}
