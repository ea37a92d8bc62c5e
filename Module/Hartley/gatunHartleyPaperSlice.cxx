// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyPaperSlice.h"

#include "gatunHartleyKernel.h"
#include "gatunHartleyTransform.h"
#include "gatunVector.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gatun
{
//------------------------------------------------------------------------------
class HartleyPaperSlice::PaperBrush : public HartleyPainter::Brush
{
public:
  explicit PaperBrush(const HartleyPaperSlice& slice)
    : Slice(slice)
    , Across(ToVector(slice.Across))
    , Down(ToVector(slice.Down))
    , Inverse({ static_cast<std::uint32_t>(slice.Size), static_cast<std::uint32_t>(slice.Size), 1 })
    , Values(slice.Size * slice.Size)
  {
  }

  void Paint(std::span<const Task> tasks) override
  {
    for (const Task& task : tasks)
    {
      this->PaintOwn(*this->Slice.Spectra->Get(task.Block, task.Terms));
      this->ToLattice(task.Image);
    }
  }

  /** The image in the plane orthogonal to the rays. */
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
        const glm::dvec3 place = (across * this->Across + down * this->Down) / length *
          glm::dvec3(points[0], points[1], points[2]);
        this->Values[static_cast<std::size_t>(row * size + column)] =
          this->FindBetween(spectrum, place) * this->Slice.SamplesPerVoxel / length;
      }
    }
    this->Inverse.Inverse(this->Values);
    return this->Values;
  }

  void ToLattice(float* image)
  {
    // The image is surrounded by zeros.
    constexpr std::size_t margin = 2;
    const std::size_t size = this->Slice.Size;
    const std::size_t width = size + 2 * margin + 1;
    this->Padded.assign(width * width, 0.0f);
    for (std::size_t row = 0; row < size; ++row)
    {
      for (std::size_t column = 0; column < size; ++column)
      {
        this->Padded[(row + margin) * width + column + margin] =
          static_cast<float>(this->Values[row * size + column]);
      }
    }
    const auto highest = static_cast<double>(width - 3);
    const auto& lattice = this->Slice.Lattice;
    const auto& kernel = GetBestHartleyKernel();
    const double middle = (static_cast<double>(size) - 1) / 2;
    for (std::size_t y = 0; y < lattice.Points[1]; ++y)
    {
      for (std::size_t x = 0; x < lattice.Points[0]; ++x)
      {
        glm::dvec3 place(0);
        place[lattice.Axes[0]] = lattice.GetPlace(0, x);
        place[lattice.Axes[1]] = lattice.GetPlace(1, y);
        const double column = glm::dot(place, this->Across) + middle;
        const double row = glm::dot(place, this->Down) + middle;
        float& pixel = image[y * lattice.Points[0] + x];
        pixel = 0;
        const double most = static_cast<double>(size);
        if (column > -1 && row > -1 && column < most && row < most)
        {
          // The kernel interpolates two planes, which are the same here.
          std::array<float, 2> found{};
          kernel.AddSlab({}, { this->Padded.data(), width, 0, highest, highest },
            { column + margin, row + margin, 0, 0, 1 }, found.data(), 1);
          pixel = found[0];
        }
      }
    }
  }

private:
  double FindBetween(const HartleySpectrum& spectrum, const glm::dvec3& place) const
  {
    const auto& plan = this->Slice.Spectra->GetPlan();
    std::array<std::array<std::size_t, 2>, 3> indices;
    std::array<std::array<double, 2>, 3> weight;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double at = place[static_cast<int>(i)];
      const double floor = std::floor(at);
      const bool even = plan.Block[i] % 2 == 0;
      for (std::size_t side = 0; side < 2; ++side)
      {
        const auto points = static_cast<std::ptrdiff_t>(plan.Points[i]);
        const auto index = static_cast<std::ptrdiff_t>(floor) + static_cast<std::ptrdiff_t>(side);
        const auto wrapped = (index % points + points) % points;
        const bool odd = (index - wrapped) / points % 2 != 0;
        indices[i][side] = static_cast<std::size_t>(wrapped);
        weight[i][side] = side == 0 ? 1 - (at - floor) : at - floor;
        weight[i][side] *= even && odd ? -1 : 1;
      }
    }
    double sum = 0;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      const std::size_t x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
      sum += weight[0][x] * weight[1][y] * weight[2][z] *
        static_cast<double>(spectrum.GetLine(indices[0][x], indices[1][y])[indices[2][z]]);
    }
    return sum;
  }

  const HartleyPaperSlice& Slice;
  glm::dvec3 Across, Down;
  HartleyTransform Inverse;
  std::vector<double> Values;
  std::vector<float> Padded;
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
  // With rays along an axis, pixels coincide with voxels.
  this->Size += (this->Size + this->Spectra->GetPlan().Block[0]) % 2;

  const double length = glm::length(ToVector(view.Step));
  this->SamplesPerVoxel = 1 / length;
  const glm::dvec3 along = ToVector(view.Step) / length;
  const glm::dvec3 column = ToVector(view.ColumnStep);
  const glm::dvec3 across = glm::normalize(column - glm::dot(column, along) * along);
  this->Across = ToArray(across);
  this->Down = ToArray(glm::cross(along, across));
}

//------------------------------------------------------------------------------
std::unique_ptr<HartleyPainter::Brush> HartleyPaperSlice::MakeBrush() const
{
  return std::make_unique<PaperBrush>(*this);
}

//------------------------------------------------------------------------------
std::vector<float> HartleyPaperSlice::PaintUnit(const HartleyLayout::Triple& filled) const
{
  std::vector<float> image(this->Lattice.GetNumberOfPoints());
  PaperBrush brush(*this);
  brush.PaintOwn(*this->Spectra->GetUnit(filled));
  brush.ToLattice(image.data());
  return image;
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
