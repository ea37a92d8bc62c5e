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
using Complex = std::complex<float>;

constexpr std::size_t LinesAtOnce = 8;

//------------------------------------------------------------------------------
/** Computes the spectra of lines of voxels about their middle. Each thread needs one of its own. */
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

  /** The input. The padding after the voxels is always 0. */
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

  /** Transforms count neighboring lines. Apart: distance of a line's voxels. Calls use(frequency,
   * line, value) for the results. */
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
/** The transforms of a spectrum, one axis after the other. */
class HartleySpectrum::Builder
{
public:
  Builder(HartleySpectrum& spectrum, const SpectrumPlan& plan)
    : Spectrum(spectrum)
    , Points(plan.Points)
    , Half(plan.Points[2] / 2 + 1)
    , Groups((Half + LinesAtOnce - 1) / LinesAtOnce)
  {
    const std::array<std::size_t, 3> strides{ 1, plan.Block[0],
      std::size_t{ plan.Block[0] } * plan.Block[1] };
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto axis = static_cast<std::size_t>(plan.Axes[i]);
      this->Size[i] = plan.Block[axis];
      this->Strides[i] = strides[axis];
      this->Alternates[i] = this->Size[i] % 2 == 0;
    }
  }

  /** Transforms voxels along the third axis. One half of the frequencies suffices, because the
   * voxels are real. */
  std::vector<Complex> TransformThird(
    std::span<const double> voxels, const KaiserBessel* correction) const
  {
    const std::size_t length = this->Size[2];
    std::vector<double> factors(length, 1.0);
    for (std::size_t z = 0; correction && z < length; ++z)
    {
      const double place = static_cast<double>(z) - (static_cast<double>(length) - 1) / 2;
      factors[z] = 1 / correction->GetTransform(place);
    }
    std::vector<Complex> out(this->Size[1] * this->Size[0] * this->Half);
    ParallelFor(this->Size[1],
      [&](std::size_t y)
      {
        LineTransform line(length, this->Points[2]);
        for (std::size_t x = 0; x < this->Size[0]; ++x)
        {
          const auto in = line.GetVoxels();
          const double* const from = voxels.data() + x * this->Strides[0] + y * this->Strides[1];
          for (std::size_t z = 0; z < length; ++z)
          {
            in[z] = from[z * this->Strides[2]] * factors[z];
          }
          const auto found = line.Run();
          std::copy(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(this->Half),
            out.begin() + static_cast<std::ptrdiff_t>((y * this->Size[0] + x) * this->Half));
        }
      });
    return out;
  }

  /** Transforms along the first axis. Several neighboring lines at a time, because the values of a
   * line are far apart in memory. */
  std::vector<Complex> TransformFirst(const std::vector<Complex>& in) const
  {
    std::vector<Complex> out(this->Size[1] * this->Points[0] * this->Half);
    ParallelFor(this->Size[1],
      [&](std::size_t y)
      {
        LineTransform line(this->Size[0], this->Points[0]);
        for (std::size_t group = 0; group < this->Groups; ++group)
        {
          const std::size_t first = group * LinesAtOnce;
          line.RunSome(in.data() + y * this->Size[0] * this->Half + first, this->Half,
            std::min(LinesAtOnce, this->Half - first),
            [&](std::size_t u, std::size_t i, std::complex<double> value)
            { out[(y * this->Points[0] + u) * this->Half + first + i] = Complex(value); });
        }
      });
    return out;
  }

  /** Transforms along the second axis and stores the Hartley spectrum with both halves of the
   * frequencies. */
  void TransformSecond(const std::vector<Complex>& in)
  {
    ParallelFor(this->Points[0],
      [&](std::size_t u)
      {
        LineTransform line(this->Size[1], this->Points[1]);
        for (std::size_t group = 0; group < this->Groups; ++group)
        {
          const std::size_t first = group * LinesAtOnce;
          line.RunSome(in.data() + u * this->Half + first, this->Points[0] * this->Half,
            std::min(LinesAtOnce, this->Half - first),
            [&](std::size_t v, std::size_t i, std::complex<double> value)
            { this->Store(u, v, first + i, value); });
        }
      });
  }

  /** Continues each line before and after its period. */
  void Extend()
  {
    const float sign = this->Alternates[2] ? -1.0f : 1.0f;
    ParallelFor(this->Points[1],
      [&](std::size_t v)
      {
        for (std::size_t u = 0; u < this->Points[0]; ++u)
        {
          float* const line = &this->At(u, v, 0);
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

private:
  float& At(std::size_t u, std::size_t v, std::size_t w)
  {
    return this->Spectrum.Values[(v * this->Points[0] + u) * this->Spectrum.Stride + Before + w];
  }

  std::size_t Opposite(std::size_t axis, std::size_t u) const
  {
    return u == 0 ? 0 : this->Points[axis] - u;
  }

  /** Stores a frequency and its opposite. */
  void Store(std::size_t u, std::size_t v, std::size_t w, const std::complex<double>& value)
  {
    this->At(u, v, w) = static_cast<float>(value.real() - value.imag());
    if (w > 0 && 2 * w < this->Points[2])
    {
      const bool turned =
        (this->Alternates[0] && u > 0) != ((this->Alternates[1] && v > 0) != this->Alternates[2]);
      const double mirrored = value.real() + value.imag();
      this->At(this->Opposite(0, u), this->Opposite(1, v), this->Opposite(2, w)) =
        static_cast<float>(turned ? -mirrored : mirrored);
    }
  }

  HartleySpectrum& Spectrum;
  std::array<std::size_t, 3> Points;
  std::array<std::size_t, 3> Size{};    // of a block, along the plan's axes
  std::array<std::size_t, 3> Strides{}; // of its voxels
  std::array<bool, 3> Alternates{};     // whether the sign changes from each period to the next
  std::size_t Half;                     // frequencies along the third axis that are transformed
  std::size_t Groups;                   // of lines that are transformed at a time
};

//------------------------------------------------------------------------------
HartleySpectrum::HartleySpectrum(const SpectrumPlan& plan, std::span<const HartleyTerm> terms)
  : Points(plan.Points)
  , Stride(plan.Points[2] + Before + After)
{
  Builder builder(*this, plan);
  std::vector<Complex> lines =
    builder.TransformThird(GetVoxels(plan.Block, terms), plan.Correction.get());
  lines = builder.TransformFirst(lines);
  this->Values.resize(this->Points[0] * this->Points[1] * this->Stride);
  builder.TransformSecond(lines);
  builder.Extend();
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
