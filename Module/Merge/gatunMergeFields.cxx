// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeFields.h"

#include "gatunMergeRange.h"
#include "gatunVector.h"

#include <cmath>

namespace gatun
{
//------------------------------------------------------------------------------
MergeSums::MergeSums(const MergeInput& input, std::span<const double> scales)
  : Each(1 + input.Fields.size())
{
  this->Samples.resize(input.Points.size() * this->Each);
  for (std::size_t point = 0; point < input.Points.size(); ++point)
  {
    FieldSample* const samples = this->Samples.data() + point * this->Each;
    samples[0].Gradient = ToVector(input.Points[point]);
    for (std::size_t f = 0; f < input.Fields.size(); ++f)
    {
      samples[1 + f].Value = scales[f] * input.Fields[f].Values[point];
    }
  }
}

//------------------------------------------------------------------------------
void MergeSums::Add(const Tet& corners)
{
  using Vec = glm::dvec3;
  const auto at = [&](std::size_t i, std::size_t f) -> FieldSample&
  { return this->Samples[corners[i] * this->Each + f]; };
  const Vec& origin = at(0, 0).Gradient;
  const Vec a = at(1, 0).Gradient - origin;
  const Vec b = at(2, 0).Gradient - origin;
  const Vec c = at(3, 0).Gradient - origin;
  const double volume = GetDeterminant(a, b, c);
  if (!std::isfinite(volume))
  {
    return;
  }
  this->Volume += std::abs(volume) / 6;
  ++this->Tets;
  for (std::size_t i = 0; i < 4; ++i)
  {
    at(i, 0).Value += std::abs(volume);
  }
  for (std::size_t f = 1; f < this->Each; ++f)
  {
    const double value = at(0, f).Value;
    const Vec sum = (at(1, f).Value - value) * glm::cross(b, c) +
      (at(2, f).Value - value) * glm::cross(c, a) + (at(3, f).Value - value) * glm::cross(a, b);
    // What is not a number is not to reach further than to its neighbors.
    for (std::size_t i = 0; i < 4 && std::isfinite(glm::dot(sum, sum)); ++i)
    {
      at(i, f).Gradient += volume < 0 ? -sum : sum;
    }
  }
}

//------------------------------------------------------------------------------
void MergeFields::Finish(std::span<Sample> samples)
{
  const double volume = samples[0].Value;
  for (Sample& sample : samples.subspan(1))
  {
    sample.Gradient *= volume > 0 ? 1 / volume : 0;
  }
}

//------------------------------------------------------------------------------
MergeFields::MergeFields(const MergeMesh& mesh, const MergeInput& input)
  : Fields(input.Fields.size())
{
  MergeSums sums(input, FindFieldScales(input.Fields));
  for (std::uint32_t tet = 0; tet < mesh.GetNumberOfTets(); ++tet)
  {
    const auto& corners = mesh.GetTet(tet);
    if (corners[0] != MergeMesh::None)
    {
      sums.Add(corners);
    }
  }
  for (std::size_t point = 0; point < input.Points.size(); ++point)
  {
    Finish(std::span(sums.Samples).subspan(point * sums.Each, sums.Each));
  }
  this->Samples = std::move(sums.Samples);
  this->PerWhole = sums.Volume > 0 ? 1 / sums.Volume : 0;
  this->PerTet = sums.Tets > 0 ? 1 / static_cast<double>(sums.Tets) : 0;
}
}
