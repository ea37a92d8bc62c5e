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
//------------------------------------------------------------------------------
class HartleyBasis::PairBrush : public HartleyPainter::Brush
{
public:
  explicit PairBrush(const HartleyBasis& basis)
    : Basis(basis)
    , Weights(basis.Pairs.size())
  {
  }

  void Paint(std::span<const Task> tasks) override
  {
    for (std::size_t first = 0; first < tasks.size(); first += BlocksAtOnce)
    {
      this->PaintSome(tasks.subspan(first, std::min(BlocksAtOnce, tasks.size() - first)));
    }
  }

private:
  // A segment of the images stays in the cache while this number of blocks uses it.
  static constexpr std::size_t BlocksAtOnce = 32;

  void PaintSome(std::span<const Task> tasks)
  {
    for (std::size_t i = 0; i < tasks.size(); ++i)
    {
      this->Collect(tasks[i].Terms, this->Shares[i]);
    }
    const auto& kernel = GetBestHartleyKernel();
    const std::size_t half = this->Basis.Half;
    const std::size_t points = 2 * half - 1;
    const std::size_t step = this->Basis.Pairs.size() * 2 * HartleySegment;
    for (std::size_t segment = 0; segment < this->Basis.Segments; ++segment)
    {
      const float* const values = this->Basis.Images.data() + segment * step;
      const std::size_t first = segment * HartleySegment;
      const std::size_t count = std::min(HartleySegment, half - first);
      for (std::size_t i = 0; i < tasks.size(); ++i)
      {
        std::array<float, HartleySegment> even, odd;
        const auto& shares = this->Shares[i];
        kernel.Combine(values, shares[0].data(), shares[0].size(), even.data());
        kernel.Combine(values, shares[1].data(), shares[1].size(), odd.data());
        float* const front = tasks[i].Image + first;
        float* const back = tasks[i].Image + points - 1 - first;
        for (std::size_t k = 0; k < count; ++k)
        {
          front[k] = even[k] + odd[k];
          *(back - k) = even[k] - odd[k];
        }
      }
    }
  }

  /** The weights of each pair's even and odd image in the image of a block. */
  void Collect(std::span<const HartleyTerm> terms, std::array<std::vector<HartleyShare>, 2>& shares)
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
    shares[0].clear();
    shares[1].clear();
    for (const std::uint32_t pair : this->Touched)
    {
      auto& weight = this->Weights[pair];
      for (std::uint32_t part = 0; part < 2; ++part)
      {
        if (weight[part] != 0)
        {
          const auto where = static_cast<std::uint32_t>((2 * pair + part) * HartleySegment);
          shares[part].push_back({ where, weight[part] });
        }
      }
      weight = {};
    }
  }

  const HartleyBasis& Basis;
  std::vector<std::array<float, 2>> Weights; // of each pair: even, odd; 0 outside of Collect
  std::vector<std::uint32_t> Touched;
  std::array<std::array<std::vector<HartleyShare>, 2>, BlocksAtOnce> Shares;
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
  const std::size_t step = this->Pairs.size() * 2 * HartleySegment;
  this->Segments = (this->Half + HartleySegment - 1) / HartleySegment;
  this->Images.resize(this->Segments * step);

  // The values of all images at one point are the transform of the ray's weights. Transposing a
  // batch of points at a time gives the images.
  constexpr std::size_t pointsAtOnce = 16;
  static_assert(HartleySegment % pointsAtOnce == 0);
  ParallelFor((this->Half + pointsAtOnce - 1) / pointsAtOnce,
    [&](std::size_t batch)
    {
      HartleyTransform transform(block);
      HartleyRay ray(block, lattice);
      const std::size_t first = batch * pointsAtOnce;
      const std::size_t count = std::min(pointsAtOnce, this->Half - first);
      std::vector<double> values(voxels * count, 0.0);
      for (std::size_t i = 0; i < count; ++i)
      {
        const std::span<double> mine(values.data() + i * voxels, voxels);
        ray.AddWeights(lattice.GetPlace(0, (first + i) % lattice.Points[0]),
          lattice.GetPlace(1, (first + i) / lattice.Points[0]), mine);
        transform.Forward(mine);
      }
      float* even = this->Images.data() + first / HartleySegment * step + first % HartleySegment;
      for (const Pair& pair : this->Pairs)
      {
        float* const odd = even + HartleySegment;
        for (std::size_t i = 0; i < count; ++i)
        {
          const double here = values[i * voxels + pair.First];
          const double mirrored =
            static_cast<double>(pair.Mirror) * values[i * voxels + pair.Second];
          even[i] = static_cast<float>((here + mirrored) / 2);
          odd[i] = static_cast<float>((here - mirrored) / 2);
        }
        even = odd + HartleySegment;
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
        // The frequency n / 2 is its own opposite up to the sign, which differs at positions
        // between voxels, where the middle of a block of even size is.
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
  std::vector<float> image(this->Lattice.GetNumberOfPoints());
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
        image[row * this->Lattice.Points[0] + column] = static_cast<float>(sum);
      }
    });
  return image;
}
}
