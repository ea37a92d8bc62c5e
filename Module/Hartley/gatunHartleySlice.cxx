// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleySlice.h"

#include "gatunFourier.h"
#include "gatunHartleyKernel.h"
#include "gatunHartleyTent.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gatun
{
namespace
{
// The lattice cannot represent frequencies above 1 / Spacing: higher frequencies of the tent
// functions alias to lower ones. This number of bands on each side of the lowest is summed.
constexpr int Bands = 1;

// Frequencies at which the tent functions' spectrum is smaller are skipped.
constexpr float Negligible = 1e-4f;

// Resolution of the table of the tent function's spectrum, in steps per cycle.
constexpr std::size_t TentSteps = 1024;

//------------------------------------------------------------------------------
/** The sum of the tent function's spectrum over a frequency and all its aliases on the lattice,
 * where the tent function has the values 1/2, 1 and 1/2. */
double GetAliasedTents(double frequency)
{
  static_assert(HartleyLattice::PerVoxel == 2);
  return (1 + std::cos(std::numbers::pi * frequency)) / 2;
}

//------------------------------------------------------------------------------
/** A point of the periodic spectrum, mapped to the first period. */
struct Wrapped
{
  std::size_t Index;
  bool Odd; // whether the number of periods between the two is odd

  Wrapped(std::ptrdiff_t at, std::size_t points)
  {
    const auto size = static_cast<std::ptrdiff_t>(points);
    std::ptrdiff_t period = at / size;
    period -= period * size > at;
    this->Index = static_cast<std::size_t>(at - period * size);
    this->Odd = period % 2 != 0;
  }
};
}

//------------------------------------------------------------------------------
class HartleySlice::SliceBrush : public HartleyPainter::Brush
{
public:
  explicit SliceBrush(const HartleySlice& slice)
    : Slice(slice)
    , Plan(slice.Spectra->GetPlan())
    , Width(this->Plan.Points[0] * HartleyLattice::PerVoxel)
    , Height(this->Plan.Points[1] * HartleyLattice::PerVoxel)
    , Inverse(this->Height, this->Width)
    , Values(this->Width * this->Height)
    , Spectrum((this->Width / 2 + 1) * this->Height)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Even[axis] = this->Plan.Block[this->Plan.Axes[axis]] % 2 == 0;
      this->MakeBands(axis, axis == 0 ? this->Width : this->Height);
    }
    // Bands reach three cycles across and down, and no more along the rays.
    constexpr std::size_t cycles = 2 * (Bands * HartleyLattice::PerVoxel + 1);
    for (std::size_t i = 0; i <= cycles * TentSteps + 1; ++i)
    {
      this->TentTable.push_back(
        static_cast<float>(GetTentSpectrum(static_cast<double>(i) / TentSteps)));
    }
    this->Between = { this->Plan.Correction->GetWeights(), static_cast<float>(KaiserBessel::Steps),
      this->TentTable.data(), static_cast<float>(TentSteps),
      static_cast<double>(this->Plan.Points[2]), slice.Lattice.Shear[0], slice.Lattice.Shear[1],
      this->Plan.Block[this->Plan.Axes[2]] % 2 == 0 };
  }

  void Paint(std::span<const Task> tasks) override
  {
    for (const Task& task : tasks)
    {
      this->PaintSlice(*this->Slice.Spectra->Get(task.Block, task.Terms), task.Image);
    }
  }

  void PaintSlice(const HartleySpectrum& spectrum, float* image)
  {
    ParallelFor(this->Height, [&](std::size_t row) { this->CutRow(spectrum, row); });
    this->ToFourier();
    this->Inverse.Run(this->Spectrum.data(), this->Values.data());

    // The transform has its origin in the middle of the image.
    const auto& points = this->Slice.Lattice.Points;
    for (std::size_t y = 0; y < points[1]; ++y)
    {
      const std::size_t row = (y + this->Height - points[1] / 2) % this->Height;
      for (std::size_t x = 0; x < points[0]; ++x)
      {
        const std::size_t column = (x + this->Width - points[0] / 2) % this->Width;
        image[y * points[0] + x] = static_cast<float>(this->Values[row * this->Width + column]);
      }
    }
  }

private:
  static constexpr std::size_t BandCount = 2 * Bands + 1;

  void MakeBands(int axis, std::size_t count)
  {
    const auto points = static_cast<double>(this->Plan.Points[axis]);
    // How much neighboring bands sample the same part of the spectrum: 1 for rays along an axis.
    const auto same = static_cast<float>(std::max(0.0,
      1 -
        HartleyLattice::PerVoxel *
          std::abs(this->Slice.Lattice.Shear[static_cast<std::size_t>(axis)]) *
          this->Slice.Lattice.Block[2]));
    for (std::size_t i = 0; i < count; ++i)
    {
      for (int band = -Bands; band <= Bands; ++band)
      {
        const double frequency =
          static_cast<double>(this->GetSigned(i, count)) / points + band * HartleyLattice::PerVoxel;
        this->BandsOf[axis].push_back(
          { frequency, static_cast<float>(GetTentSpectrum(frequency)) });
      }
      // The sum of all other bands is divided among the two outermost ones. That is exact for rays
      // along an axis, where all bands sample the same part of the spectrum.
      HartleyBand* const bands = &this->BandsOf[axis][i * BandCount];
      float rest = static_cast<float>(
        GetAliasedTents(static_cast<double>(this->GetSigned(i, count)) / points));
      for (std::size_t band = 0; band < BandCount; ++band)
      {
        rest -= bands[band].Tent;
      }
      bands[0].Tent += same * rest / 2;
      bands[BandCount - 1].Tent += same * rest / 2;
    }
  }

  static std::ptrdiff_t GetSigned(std::size_t i, std::size_t count)
  {
    const auto index = static_cast<std::ptrdiff_t>(i);
    return 2 * i <= count ? index : index - static_cast<std::ptrdiff_t>(count);
  }

  void CutRow(const HartleySpectrum& spectrum, std::size_t row)
  {
    const auto& kernel = GetBestHartleyKernel();
    const Wrapped v(this->GetSigned(row, this->Height), this->Plan.Points[1]);
    const HartleyBand* const down = this->BandsOf[1].data() + row * BandCount;
    for (std::size_t column = 0; column < this->Width; ++column)
    {
      const Wrapped u(this->GetSigned(column, this->Width), this->Plan.Points[0]);
      const float sum =
        kernel.SumBands(spectrum.GetLine(u.Index, v.Index) - HartleySpectrum::Before, this->Between,
          this->BandsOf[0].data() + column * BandCount, down, BandCount, Negligible);
      const bool turned = (this->Even[0] && u.Odd) != (this->Even[1] && v.Odd);
      this->Values[row * this->Width + column] = static_cast<double>(turned ? -sum : sum);
    }
  }

  /** Converts the Hartley spectrum of the image to its Fourier spectrum: H(f) is the real minus the
   * imaginary part, H(-f) their sum. */
  void ToFourier()
  {
    const std::size_t half = this->Width / 2 + 1;
    const double scale = this->Slice.Lattice.SamplesPerVoxel /
      static_cast<double>(this->Plan.Points[0] * this->Plan.Points[1]);
    for (std::size_t row = 0; row < this->Height; ++row)
    {
      const std::size_t opposite = (this->Height - row) % this->Height;
      for (std::size_t column = 0; column < half; ++column)
      {
        const double here = this->Values[row * this->Width + column];
        const double there =
          this->Values[opposite * this->Width + (this->Width - column) % this->Width];
        this->Spectrum[row * half + column] = { (here + there) / 2 * scale,
          (there - here) / 2 * scale };
      }
    }
  }

  const HartleySlice& Slice;
  const SpectrumPlan& Plan;
  std::size_t Width, Height;
  InversePlaneTransform Inverse;
  std::array<bool, 2> Even{};
  std::array<std::vector<HartleyBand>, 2> BandsOf; // BandCount of each column, of each row
  std::vector<float> TentTable;
  HartleyBetween Between{};
  std::vector<double> Values;
  std::vector<std::complex<double>> Spectrum;
};

//------------------------------------------------------------------------------
SpectrumPlan HartleySlice::MakePlan(
  const HartleyLayout::Triple& block, const HartleyLattice& lattice, double padding)
{
  SpectrumPlan plan;
  plan.Block = block;
  plan.Axes = lattice.Axes;
  std::array<std::size_t, 3> size;
  for (int i = 0; i < 3; ++i)
  {
    size[i] = block[plan.Axes[i]];
  }
  // Across the rays, the image must fit for every shear; otherwise it would wrap around.
  for (int i = 0; i < 2; ++i)
  {
    plan.Points[i] = GetFastSize(size[i] + size[2] + 2);
  }
  plan.Points[2] = GetFastSize(std::max<std::size_t>(KaiserBessel::Taps,
    static_cast<std::size_t>(std::ceil(padding * static_cast<double>(size[2])))));
  plan.Correction = std::make_shared<const KaiserBessel>(size[2], plan.Points[2]);
  return plan;
}

//------------------------------------------------------------------------------
HartleySlice::HartleySlice(const HartleyLattice& lattice, std::shared_ptr<HartleySpectra> spectra)
  : Lattice(lattice)
  , Spectra(std::move(spectra))
{
}

//------------------------------------------------------------------------------
std::unique_ptr<HartleyPainter::Brush> HartleySlice::MakeBrush() const
{
  return std::make_unique<SliceBrush>(*this);
}

//------------------------------------------------------------------------------
std::vector<float> HartleySlice::PaintUnit(const HartleyLayout::Triple& filled) const
{
  std::vector<float> image(this->Lattice.GetNumberOfPoints());
  SliceBrush(*this).PaintSlice(*this->Spectra->GetUnit(filled), image.data());
  return image;
}
}
