// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeInputCheck.h"

#include "gatunError.h"
#include "gatunMergeChoice.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
void Require(bool isTrue, const char* what)
{
  if (!isTrue)
  {
    throw Error(ErrorCode::InvalidInput, what);
  }
}
}

//------------------------------------------------------------------------------
template <std::size_t Corners>
void CheckMergeInput(const BasicMergeInput<Corners>& input)
{
  const std::size_t points = input.Points.size();
  Require(points < MergeChoice::None && input.Cells.size() < MergeChoice::None,
    Corners == 4 ? "more than four thousand million points or tetrahedra cannot be simplified"
                 : "more than four thousand million points or triangles cannot be simplified");
  for (const auto& cell : input.Cells)
  {
    Require(*std::max_element(cell.begin(), cell.end()) < points,
      Corners == 4 ? "a tetrahedron has a point that does not exist"
                   : "a triangle has a point that does not exist");
  }
  for (const auto& field : input.Fields)
  {
    Require(field.Values.size() == points, "a field must have one value for each point");
    Require(
      field.Weight >= 0 && std::isfinite(field.Weight), "the weight of a field must be 0 or more");
  }
  Require(input.IsKept.empty() || input.IsKept.size() == points,
    "there must be a mark for each point, or none");
}

template void CheckMergeInput<3>(const BasicMergeInput<3>& input);
template void CheckMergeInput<4>(const BasicMergeInput<4>& input);

//------------------------------------------------------------------------------
void CheckMergeSettings(const MergeSettings& settings)
{
  Require(settings.BoundaryWeight >= 0 && settings.BoundaryWeight <= 1,
    "the weight of the boundary must be from 0 to 1");
  Require(settings.PartAtOnce >= 0 && settings.PartAtOnce <= 1,
    "the part of the merges that are made at once must be from 0 to 1");
}

void CheckMergeSettings(const SurfaceMergeSettings& settings)
{
  Require(settings.ShapeWeight >= 0 && settings.ShapeWeight <= 1,
    "the weight of the shape must be from 0 to 1");
  Require(settings.FeatureAngle >= 0 && settings.FeatureAngle <= 180,
    "the feature angle must be from 0 to 180 degrees");
}
}
