// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleySpectrum.h"

#include "gatunFourier.h"
#include "gatunHartleyTransform.h"
#include "gatunParallel.h"

#include <algorithm>
#include <array>
#include <complex>
#include <numbers>

namespace gatun
{
namespace
{
constexpr std::size_t LinesAtOnce = 8;

//------------------------------------------------------------------------------
/** The spectra of lines of voxels, about their middle. One a thread. */
class LineTransform
{
public:
  LineTransform(std::size_t voxels, std::size_t points)
    : Voxels(voxels)
    , Transform(points)
    , In(points)
    , Out(points)
    , Turns(points)
  {
    const double middle = (static_cast<double>(voxels) - 1) / 2;
    for (std::size_t u = 0; u < points; ++u)
    {
      const double part = static_cast<double>(u) / static_cast<double>(points);
      this->Turns[u] = std::polar(1.0, 2 * std::numbers::pi * part * middle);
    }
  }

  /** The places of the line's voxels; what lies behind them is always 0. */
  std::span<std::complex<double>> GetVoxels() { return { this->In.data(), this->Voxels }; }

  std::span<const std::complex<double>> Run()
  {
    this->Transform.Forward(this->In.data(), this->Out.data());
    for (std::size_t u = 0; u < this->Out.size(); ++u)
    {
      this->Out[u] *= this->Turns[u];
    }
    return this->Out;
  }

  /** Transforms neighbouring lines, whose voxels are so far apart; use(frequency, line, value) gets
   * what comes of them. */
  template <typename Use>
  void RunSome(const std::complex<float>* first, std::size_t apart, std::size_t count, Use&& use)
  {
    std::array<std::vector<std::complex<double>>, LinesAtOnce>& found = this->Found;
    this->Gathered.resize(this->Voxels * count);
    for (std::size_t voxel = 0; voxel < this->Voxels; ++voxel)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        this->Gathered[i * this->Voxels + voxel] = first[voxel * apart + i];
      }
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto from = this->Gathered.begin() + static_cast<std::ptrdiff_t>(i * this->Voxels);
      std::copy(from, from + static_cast<std::ptrdiff_t>(this->Voxels), this->In.begin());
      this->Run();
      found[i] = this->Out;
    }
    for (std::size_t u = 0; u < this->Out.size(); ++u)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        use(u, i, found[i][u]);
      }
    }
  }

private:
  std::size_t Voxels;
  std::vector<std::complex<double>> Gathered;
  std::array<std::vector<std::complex<double>>, LinesAtOnce> Found;
  FourierTransform Transform;
  std::vector<std::complex<double>> In, Out, Turns;
};

//------------------------------------------------------------------------------
std::vector<double> GetVoxels(
  const HartleyLayout::Triple& block, std::span<const HartleyTerm> terms)
{
  std::vector<double> values(std::size_t{ block[0] } * block[1] * block[2], 0.0);
  for (const HartleyTerm& term : terms)
  {
    values[term.Index] = term.Value;
  }
  HartleyTransform(block).Inverse(values);
  return values;
}

//------------------------------------------------------------------------------
/** The coefficients of a block whose first voxels along each axis are 1. */
std::vector<HartleyTerm> GetUnitTerms(
  const HartleyLayout::Triple& block, const HartleyLayout::Triple& filled)
{
  std::vector<double> values(std::size_t{ block[0] } * block[1] * block[2], 0.0);
  for (std::uint32_t z = 0; z < filled[2]; ++z)
  {
    for (std::uint32_t y = 0; y < filled[1]; ++y)
    {
      std::fill_n(
        values.begin() + static_cast<std::ptrdiff_t>((std::size_t{ z } * block[1] + y) * block[0]),
        filled[0], 1.0);
    }
  }
  HartleyTransform(block).Forward(values);
  std::vector<HartleyTerm> terms;
  for (std::uint32_t i = 0; i < values.size(); ++i)
  {
    if (values[i] != 0)
    {
      terms.push_back({ i, static_cast<float>(values[i]) });
    }
  }
  return terms;
}
}

//------------------------------------------------------------------------------
HartleySpectrum::HartleySpectrum(const SpectrumPlan& plan, std::span<const HartleyTerm> terms)
  : Points(plan.Points)
  , Stride(plan.Points[2] + Before + After)
{
  using Complex = std::complex<float>;
  const std::vector<double> voxels = GetVoxels(plan.Block, terms);
  std::array<std::size_t, 3> strides{ 1, plan.Block[0],
    std::size_t{ plan.Block[0] } * plan.Block[1] };
  std::array<std::size_t, 3> size;
  for (int i = 0; i < 3; ++i)
  {
    size[i] = plan.Block[plan.Axes[i]];
  }
  const auto stride = [&](int i) { return strides[plan.Axes[i]]; };

  // Along the third axis. One half of the frequencies is enough: the voxels are real.
  const std::size_t half = this->Points[2] / 2 + 1;
  std::vector<double> correction(size[2], 1.0);
  if (plan.Correction)
  {
    for (std::size_t z = 0; z < size[2]; ++z)
    {
      correction[z] = 1 /
        plan.Correction->GetTransform(
          static_cast<double>(z) - (static_cast<double>(size[2]) - 1) / 2);
    }
  }
  std::vector<Complex> one(size[1] * size[0] * half);
  ParallelFor(size[1],
    [&](std::size_t y)
    {
      LineTransform line(size[2], this->Points[2]);
      for (std::size_t x = 0; x < size[0]; ++x)
      {
        const auto in = line.GetVoxels();
        const double* const from = voxels.data() + x * stride(0) + y * stride(1);
        for (std::size_t z = 0; z < size[2]; ++z)
        {
          in[z] = from[z * stride(2)] * correction[z];
        }
        const auto out = line.Run();
        std::copy(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(half),
          one.begin() + static_cast<std::ptrdiff_t>((y * size[0] + x) * half));
      }
    });

  // Along the first. Some neighbouring lines at once, as a line's values are far apart.
  const std::size_t groups = (half + LinesAtOnce - 1) / LinesAtOnce;
  std::vector<Complex> two(size[1] * this->Points[0] * half);
  ParallelFor(size[1],
    [&](std::size_t y)
    {
      LineTransform line(size[0], this->Points[0]);
      for (std::size_t group = 0; group < groups; ++group)
      {
        line.RunSome(one.data() + y * size[0] * half + group * LinesAtOnce, half,
          std::min(LinesAtOnce, half - group * LinesAtOnce),
          [&](std::size_t u, std::size_t i, std::complex<double> value)
          { two[(y * this->Points[0] + u) * half + group * LinesAtOnce + i] = Complex(value); });
      }
    });
  std::vector<Complex>().swap(one);

  // Along the second; the other half of the frequencies comes with it.
  std::array<bool, 3> turns;
  for (std::size_t i = 0; i < 3; ++i)
  {
    turns[i] = size[i] % 2 == 0;
  }
  this->Values.resize(this->Points[0] * this->Points[1] * this->Stride);
  const auto at = [&](std::size_t u, std::size_t v, std::size_t w) -> float&
  { return this->Values[(v * this->Points[0] + u) * this->Stride + Before + w]; };
  const auto opposite = [&](std::size_t axis, std::size_t u)
  { return u == 0 ? 0 : this->Points[axis] - u; };
  ParallelFor(this->Points[0],
    [&](std::size_t u)
    {
      LineTransform line(size[1], this->Points[1]);
      for (std::size_t group = 0; group < groups; ++group)
      {
        line.RunSome(two.data() + u * half + group * LinesAtOnce, this->Points[0] * half,
          std::min(LinesAtOnce, half - group * LinesAtOnce),
          [&](std::size_t v, std::size_t i, std::complex<double> value)
          {
            const std::size_t w = group * LinesAtOnce + i;
            at(u, v, w) = static_cast<float>(value.real() - value.imag());
            if (w > 0 && 2 * w < this->Points[2])
            {
              const bool turned = (turns[0] && u > 0) != ((turns[1] && v > 0) != turns[2]);
              const double mirrored = value.real() + value.imag();
              at(opposite(0, u), opposite(1, v), opposite(2, w)) =
                static_cast<float>(turned ? -mirrored : mirrored);
            }
          });
      }
    });

  // What lies before and behind a period.
  const float sign = turns[2] ? -1.0f : 1.0f;
  ParallelFor(this->Points[1],
    [&](std::size_t v)
    {
      for (std::size_t u = 0; u < this->Points[0]; ++u)
      {
        float* const line = &at(u, v, 0);
        for (std::size_t i = 1; i <= Before; ++i)
        {
          line[-static_cast<std::ptrdiff_t>(i)] = sign * line[this->Points[2] - i];
        }
        for (std::size_t i = 0; i < After; ++i)
        {
          line[this->Points[2] + i] = sign * line[i];
        }
      }
    });
}

//------------------------------------------------------------------------------
std::shared_ptr<const HartleySpectrum> HartleySpectra::Get(
  std::size_t block, std::span<const HartleyTerm> terms)
{
  if (auto found = this->Kept.Find(block))
  {
    return found;
  }
  auto made = std::make_shared<const HartleySpectrum>(this->Plan, terms);
  this->Kept.Keep(block, made, made->GetBytes());
  return made;
}

//------------------------------------------------------------------------------
std::shared_ptr<const HartleySpectrum> HartleySpectra::GetUnit(const HartleyLayout::Triple& filled)
{
  if (auto found = this->KeptUnits.Find(filled))
  {
    return found;
  }
  auto made =
    std::make_shared<const HartleySpectrum>(this->Plan, GetUnitTerms(this->Plan.Block, filled));
  this->KeptUnits.Keep(filled, made, made->GetBytes());
  return made;
}
}
