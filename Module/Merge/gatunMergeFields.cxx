// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeFields.h"

#include "gatunMergeRange.h"
#include "gatunVector.h"

#include <cmath>

namespace gatun
{
//------------------------------------------------------------------------------
MergeFields::MergeFields(const MergeMesh& mesh, const MergeInput& input)
  : Fields(input.Fields.size())
{
  const std::vector<double> scales = FindFieldScales(input.Fields);
  const std::size_t each = 1 + this->Fields;
  const std::size_t points = input.Points.size();
  this->Samples.resize(points * each);
  for (std::size_t point = 0; point < points; ++point)
  {
    this->Samples[point * each].Gradient = ToVector(input.Points[point]);
    for (std::size_t f = 0; f < this->Fields; ++f)
    {
      this->Samples[point * each + 1 + f].Value = scales[f] * input.Fields[f].Values[point];
    }
  }
  double whole = 0;
  std::size_t tets = 0;
  for (std::uint32_t tet = 0; tet < mesh.GetNumberOfTets(); ++tet)
  {
    const auto& corners = mesh.GetTet(tet);
    if (corners[0] == MergeMesh::None)
    {
      continue;
    }
    const Vec& origin = this->GetPoint(corners[0]);
    const double volume = GetDeterminant(this->GetPoint(corners[1]) - origin,
      this->GetPoint(corners[2]) - origin, this->GetPoint(corners[3]) - origin);
    if (std::isfinite(volume))
    {
      whole += std::abs(volume) / 6;
      ++tets;
      this->AddSlopes(corners, volume);
    }
  }
  for (std::size_t point = 0; point < points; ++point)
  {
    const double volume = this->Samples[point * each].Value;
    for (std::size_t f = 0; f < this->Fields; ++f)
    {
      this->Samples[point * each + 1 + f].Gradient *= volume > 0 ? 1 / volume : 0;
    }
  }
  this->PerWhole = whole > 0 ? 1 / whole : 0;
  this->PerTet = tets > 0 ? 1 / static_cast<double>(tets) : 0;
}

//------------------------------------------------------------------------------
/** Adds the gradients in a tetrahedron to those of its corners, weighted by six times its volume.
 */
void MergeFields::AddSlopes(const MergeMesh::Tet& corners, double volume)
{
  const Vec& origin = this->GetPoint(corners[0]);
  const Vec a = this->GetPoint(corners[1]) - origin;
  const Vec b = this->GetPoint(corners[2]) - origin;
  const Vec c = this->GetPoint(corners[3]) - origin;
  const std::size_t each = 1 + this->Fields;
  for (const auto corner : corners)
  {
    this->Samples[corner * each].Value += std::abs(volume);
  }
  for (std::size_t f = 1; f < each; ++f)
  {
    const auto at = [&](std::size_t i) -> Sample& { return this->Samples[corners[i] * each + f]; };
    const double value = at(0).Value;
    const Vec sum = (at(1).Value - value) * glm::cross(b, c) +
      (at(2).Value - value) * glm::cross(c, a) + (at(3).Value - value) * glm::cross(a, b);
    // What is not a number is not to reach further than to its neighbors.
    for (std::size_t i = 0; i < 4 && std::isfinite(glm::dot(sum, sum)); ++i)
    {
      at(i).Gradient += volume < 0 ? -sum : sum;
    }
  }
}
}
