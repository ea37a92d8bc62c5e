// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyPaperSlice.h"

#include "gatunHartleyKernel.h"
#include "gatunHartleyTransform.h"

#include <algorithm>
#include <numeric>

namespace gatun
{
namespace
{
using Vector = HartleyView::Vector;

double Dot(const Vector& a, const Vector& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

Vector Scaled(const Vector& a, double scale)
{
  return { a[0] * scale, a[1] * scale, a[2] * scale };
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}
}

//------------------------------------------------------------------------------
class HartleyPaperSlice::PaperBrush : public HartleyPainter::Brush
{
public:
  explicit PaperBrush(const HartleyPaperSlice& slice)
    : Slice(slice)
    , Inverse({ static_cast<std::uint32_t>(slice.Size), static_cast<std::uint32_t>(slice.Size), 1 })
    , Values(slice.Size * slice.Size)
  {
  }

  void Paint(std::span<const Task> tasks) override
  {
    for (const Task& task : tasks)
    {
      this->PaintOwn(*this->Slice.Spectra->Get(task.Block, task.Terms));
      this->ToLattice(task.Picture);
    }
  }

  /** The picture that lies in the plane across the rays. */
  std::span<const double> PaintOwn(const HartleySpectrum& spectrum)
  {
    const auto size = static_cast<std::ptrdiff_t>(this->Slice.Size);
    const auto length = static_cast<double>(size);
    const auto& points = this->Slice.Spectra->GetPlan().Points;
    for (std::ptrdiff_t row = 0; row < size; ++row)
    {
      for (std::ptrdiff_t column = 0; column < size; ++column)
      {
        const auto across = static_cast<double>(2 * column <= size ? column : column - size);
        const auto down = static_cast<double>(2 * row <= size ? row : row - size);
        std::array<double, 3> place;
        for (std::size_t i = 0; i < 3; ++i)
        {
          place[i] = (across * this->Slice.Across[i] + down * this->Slice.Down[i]) / length *
            static_cast<double>(points[i]);
        }
        this->Values[static_cast<std::size_t>(row * size + column)] =
          this->FindBetween(spectrum, place) * this->Slice.SamplesPerVoxel / length;
      }
    }
    this->Inverse.Inverse(this->Values);
    return this->Values;
  }

  void ToLattice(float* picture)
  {
    // Around the picture there is nothing.
    constexpr std::size_t margin = 2;
    const std::size_t size = this->Slice.Size;
    const std::size_t width = size + 2 * margin;
    this->Channels.assign(width * width * 4, 0.0f);
    for (std::size_t row = 0; row < size; ++row)
    {
      for (std::size_t column = 0; column < size; ++column)
      {
        this->Channels[((row + margin) * width + column + margin) * 4] =
          static_cast<float>(this->Values[row * size + column]);
      }
    }
    const auto& lattice = this->Slice.Lattice;
    const auto& kernel = GetBestHartleyKernel();
    const double middle = (static_cast<double>(size) - 1) / 2;
    for (std::size_t y = 0; y < lattice.Points[1]; ++y)
    {
      for (std::size_t x = 0; x < lattice.Points[0]; ++x)
      {
        Vector place{};
        place[lattice.Axes[0]] = lattice.GetPlace(0, x);
        place[lattice.Axes[1]] = lattice.GetPlace(1, y);
        const double column = Dot(place, this->Slice.Across) + middle;
        const double row = Dot(place, this->Slice.Down) + middle;
        float& pixel = picture[y * lattice.Points[0] + x];
        pixel = 0;
        const double most = static_cast<double>(size);
        if (column > -1 && row > -1 && column < most && row < most)
        {
          const double left = std::floor(column);
          const double top = std::floor(row);
          const auto first = (static_cast<std::size_t>(top + margin - 1) * width +
                               static_cast<std::size_t>(left + margin - 1)) *
            4;
          std::array<float, 4> found;
          kernel.Interpolate(this->Channels.data() + first, width * 4,
            static_cast<float>(column - left), static_cast<float>(row - top), found.data());
          pixel = found[0];
        }
      }
    }
  }

private:
  double FindBetween(const HartleySpectrum& spectrum, const std::array<double, 3>& place) const
  {
    const auto& plan = this->Slice.Spectra->GetPlan();
    std::array<std::array<std::size_t, 2>, 3> index;
    std::array<std::array<double, 2>, 3> weight;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double floor = std::floor(place[i]);
      const bool even = plan.Block[i] % 2 == 0;
      for (std::size_t side = 0; side < 2; ++side)
      {
        const auto points = static_cast<std::ptrdiff_t>(plan.Points[i]);
        const auto at = static_cast<std::ptrdiff_t>(floor) + static_cast<std::ptrdiff_t>(side);
        const auto wrapped = (at % points + points) % points;
        const bool odd = (at - wrapped) / points % 2 != 0;
        index[i][side] = static_cast<std::size_t>(wrapped);
        weight[i][side] = side == 0 ? 1 - (place[i] - floor) : place[i] - floor;
        weight[i][side] *= even && odd ? -1 : 1;
      }
    }
    double sum = 0;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      const std::size_t x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
      sum += weight[0][x] * weight[1][y] * weight[2][z] *
        static_cast<double>(spectrum.GetLine(index[0][x], index[1][y])[index[2][z]]);
    }
    return sum;
  }

  const HartleyPaperSlice& Slice;
  HartleyTransform Inverse;
  std::vector<double> Values;
  std::vector<float> Channels;
};

//------------------------------------------------------------------------------
SpectrumPlan HartleyPaperSlice::MakePlan(const HartleyLayout::Triple& block, double padding)
{
  SpectrumPlan plan;
  plan.Block = block;
  for (std::size_t i = 0; i < 3; ++i)
  {
    plan.Points[i] = std::max<std::size_t>(
      block[i], static_cast<std::size_t>(std::lround(padding * static_cast<double>(block[i]))));
  }
  return plan;
}

//------------------------------------------------------------------------------
HartleyPaperSlice::HartleyPaperSlice(
  const HartleyLattice& lattice, const HartleyView& view, std::shared_ptr<HartleySpectra> spectra)
  : Lattice(lattice)
  , Spectra(std::move(spectra))
{
  const auto& points = this->Spectra->GetPlan().Points;
  this->Size = *std::max_element(points.begin(), points.end());
  // Pixels see voxels' places where the rays are along an axis.
  this->Size += (this->Size + this->Spectra->GetPlan().Block[0]) % 2;

  const double length = std::sqrt(Dot(view.Step, view.Step));
  this->SamplesPerVoxel = 1 / length;
  const Vector along = Scaled(view.Step, 1 / length);
  Vector across = view.ColumnStep;
  const double depth = Dot(across, along);
  for (std::size_t i = 0; i < 3; ++i)
  {
    across[i] -= depth * along[i];
  }
  this->Across = Scaled(across, 1 / std::sqrt(Dot(across, across)));
  this->Down = Cross(along, this->Across);
}

//------------------------------------------------------------------------------
std::unique_ptr<HartleyPainter::Brush> HartleyPaperSlice::MakeBrush() const
{
  return std::make_unique<PaperBrush>(*this);
}

//------------------------------------------------------------------------------
std::vector<float> HartleyPaperSlice::PaintUnit(const HartleyLayout::Triple& filled) const
{
  std::vector<float> picture(this->Lattice.GetNumberOfPoints());
  PaperBrush brush(*this);
  brush.PaintOwn(*this->Spectra->GetUnit(filled));
  brush.ToLattice(picture.data());
  return picture;
}

//------------------------------------------------------------------------------
std::vector<float> HartleyPaperSlice::PaintOwn(
  std::size_t block, std::span<const HartleyTerm> terms) const
{
  PaperBrush brush(*this);
  const auto values = brush.PaintOwn(*this->Spectra->Get(block, terms));
  return { values.begin(), values.end() };
}
}
