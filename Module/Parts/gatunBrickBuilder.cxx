// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunBrickBuilder.h"

#include "gatunError.h"
#include "gatunMergeInputCheck.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace gatun
{
namespace
{
constexpr std::uint32_t None = MergeMesh::None;

/** Four times the center of a tetrahedron along an axis. */
double GetPlace(const MergeInput& mesh, std::uint32_t tet, std::size_t axis)
{
  double sum = 0;
  for (const auto point : mesh.Cells[tet])
  {
    sum += mesh.Points[point][axis];
  }
  return std::isfinite(sum) ? sum : 0;
}

std::size_t FindLongestAxis(const MergeInput& mesh, std::span<const std::uint32_t> tets)
{
  Bounds box;
  for (const auto tet : tets)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box[axis].Include(GetPlace(mesh, tet, axis));
    }
  }
  const auto isShorter = [](const Range& a, const Range& b)
  { return a.Max - a.Min < b.Max - b.Min; };
  return static_cast<std::size_t>(
    std::max_element(box.begin(), box.end(), isShorter) - box.begin());
}

/** Calls use with tetrahedra that are near each other, by bisection until there are few of them. */
template <typename Use>
void Divide(const MergeInput& mesh, std::span<std::uint32_t> tets, std::size_t most, const Use& use)
{
  if (tets.size() <= most)
  {
    use(tets);
    return;
  }
  const auto axis = FindLongestAxis(mesh, tets);
  const auto middle = tets.size() / 2;
  std::nth_element(tets.begin(), tets.begin() + static_cast<std::ptrdiff_t>(middle), tets.end(),
    [&](std::uint32_t a, std::uint32_t b)
    { return std::pair(GetPlace(mesh, a, axis), a) < std::pair(GetPlace(mesh, b, axis), b); });
  Divide(mesh, tets.first(middle), most, use);
  Divide(mesh, tets.subspan(middle), most, use);
}

Bounds FindBox(const MergeBrick& brick, std::size_t each)
{
  Bounds box;
  for (std::size_t i = 0; i < brick.Points.size(); ++i)
  {
    const auto& point = brick.Samples[i * each].Gradient;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (std::isfinite(point[axis]))
      {
        box[static_cast<std::size_t>(axis)].Include(point[axis]);
      }
    }
  }
  return box;
}
}

//------------------------------------------------------------------------------
void BrickBuilder::Add(const MergePart& part, const Take& take)
{
  const MergeInput& mesh = part.Mesh;
  if (part.Numbers.size() != mesh.Points.size() || mesh.Fields.size() != this->Fields.size() ||
    (!part.IsShared.empty() && part.IsShared.size() != mesh.Points.size()) ||
    (!part.Cells.empty() && part.Cells.size() != mesh.Cells.size()))
  {
    ThrowInvalid("a part of a mesh is not described completely");
  }
  CheckMergeInput(mesh);
  const std::vector<double> unscaled(this->Fields.size(), 1); // ranges are not known yet
  MergeSums sums(mesh, unscaled);
  for (const auto& tet : mesh.Cells)
  {
    sums.Add(tet);
  }
  this->AddSums(part, sums);
  this->Places.assign(mesh.Points.size(), None);
  std::vector<std::uint32_t> tets(mesh.Cells.size());
  std::iota(tets.begin(), tets.end(), 0u);
  Divide(mesh, tets, this->Most,
    [&](std::span<std::uint32_t> some)
    {
      if (!some.empty())
      {
        const MergeBrick brick = this->Make(part, sums, some);
        take(brick, FindBox(brick, sums.Each));
      }
    });
}

//------------------------------------------------------------------------------
/** Adds what the whole mesh and the points of several parts have of a part. */
void BrickBuilder::AddSums(const MergePart& part, const MergeSums& sums)
{
  this->Volume += sums.Volume;
  this->Tets += sums.Tets;
  for (std::size_t f = 0; f < this->Fields.size(); ++f)
  {
    this->Fields[f].Weight = part.Mesh.Fields[f].Weight;
    this->Fields[f].Include(part.Mesh.Fields[f].Values);
  }
  for (std::size_t i = 0; i < part.IsShared.size(); ++i)
  {
    if (part.IsShared[i] == 0)
    {
      continue;
    }
    const auto own = std::span(sums.Samples).subspan(i * sums.Each, sums.Each);
    auto& all = this->Shared[part.Numbers[i]];
    if (all.empty())
    {
      all.assign(own.begin(), own.end());
      continue;
    }
    all[0].Value += own[0].Value;
    for (std::size_t f = 1; f < own.size(); ++f)
    {
      all[f].Gradient += own[f].Gradient;
    }
  }
}

//------------------------------------------------------------------------------
MergeBrick BrickBuilder::Make(
  const MergePart& part, const MergeSums& sums, std::span<std::uint32_t> tets)
{
  MergeBrick brick;
  std::vector<std::uint32_t> points;
  std::sort(tets.begin(), tets.end());
  for (const auto tet : tets)
  {
    brick.Tets.push_back(part.Mesh.Cells[tet]);
    if (!part.Cells.empty())
    {
      brick.Cells.push_back(part.Cells[tet]);
    }
    for (const auto point : part.Mesh.Cells[tet])
    {
      if (this->Places[point] == None)
      {
        this->Places[point] = 0;
        points.push_back(point);
      }
    }
  }
  std::sort(points.begin(), points.end(),
    [&](std::uint32_t a, std::uint32_t b) { return part.Numbers[a] < part.Numbers[b]; });
  for (const auto point : points)
  {
    const auto samples = std::span(sums.Samples).subspan(point * sums.Each, sums.Each);
    this->Places[point] = static_cast<std::uint32_t>(brick.Points.size());
    brick.Points.push_back(part.Numbers[point]);
    brick.Samples.insert(brick.Samples.end(), samples.begin(), samples.end());
  }
  for (auto& tet : brick.Tets)
  {
    std::transform(tet.begin(), tet.end(), tet.begin(),
      [&](std::uint32_t point) { return this->Places[point]; });
  }
  for (const auto point : points)
  {
    this->Places[point] = None;
  }
  brick.Hints.resize(brick.Points.size());
  brick.Keys.assign(brick.Tets.size(), 0);
  brick.Last.assign(brick.Tets.size(), None);
  return brick;
}

//------------------------------------------------------------------------------
void BrickBuilder::End()
{
  this->Scales = FindFieldScales(std::span<const FieldRange>(this->Fields));
  this->Places = {};
  for (auto& [number, samples] : this->Shared)
  {
    this->Finish(samples);
  }
}

//------------------------------------------------------------------------------
void BrickBuilder::Finish(std::span<FieldSample> samples) const
{
  for (std::size_t f = 0; f < this->Scales.size(); ++f)
  {
    samples[1 + f].Value *= this->Scales[f];
    samples[1 + f].Gradient *= this->Scales[f];
  }
  MergeFields::Finish(samples);
}

//------------------------------------------------------------------------------
void BrickBuilder::Finish(MergeBrick& brick) const
{
  const std::size_t each = 1 + this->Fields.size();
  for (std::size_t i = 0; i < brick.Points.size(); ++i)
  {
    const auto samples = std::span(brick.Samples).subspan(i * each, each);
    const auto found = this->Shared.find(brick.Points[i]);
    if (found == this->Shared.end())
    {
      this->Finish(samples);
    }
    else
    {
      std::copy(found->second.begin(), found->second.end(), samples.begin());
    }
  }
}
}
