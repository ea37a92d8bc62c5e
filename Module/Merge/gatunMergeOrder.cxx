// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeOrder.h"

#include "gatunMorton.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
LocalMergeInput::LocalMergeInput(const MergeInput& input)
{
  this->OrderPoints(input);
  this->OrderTets(input);
  this->Points.reserve(this->Ids.size());
  for (const auto id : this->Ids)
  {
    this->Points.push_back(input.Points[id]);
  }
  this->Local = { this->Points, this->Tets, {} };
  this->Values.reserve(input.Fields.size());
  for (const auto& field : input.Fields)
  {
    auto& values = this->Values.emplace_back();
    values.reserve(this->Ids.size());
    for (const auto id : this->Ids)
    {
      values.push_back(field.Values[id]);
    }
    this->Local.Fields.push_back({ values, field.Weight });
  }
  if (!input.IsKept.empty())
  {
    this->IsKept.reserve(this->Ids.size());
    for (const auto id : this->Ids)
    {
      this->IsKept.push_back(input.IsKept[id]);
    }
    this->Local.IsKept = this->IsKept;
  }
}

//------------------------------------------------------------------------------
void LocalMergeInput::OrderPoints(const MergeInput& input)
{
  Bounds box;
  for (const auto& point : input.Points)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (std::isfinite(point[axis]))
      {
        box[axis].Include(point[axis]);
      }
    }
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> codes;
  codes.reserve(input.Points.size());
  for (const auto& point : input.Points)
  {
    codes.emplace_back(GetMortonCode(box, point), static_cast<std::uint32_t>(codes.size()));
  }
  std::sort(codes.begin(), codes.end());
  this->Ids.reserve(codes.size());
  for (const auto& code : codes)
  {
    this->Ids.push_back(code.second);
  }
}

//------------------------------------------------------------------------------
/** Sorts by the lowest point of each tetrahedron; the sort is stable. */
void LocalMergeInput::OrderTets(const MergeInput& input)
{
  std::vector<std::uint32_t> places(this->Ids.size());
  for (std::uint32_t i = 0; i < this->Ids.size(); ++i)
  {
    places[this->Ids[i]] = i;
  }
  std::vector<std::size_t> starts(this->Ids.size() + 1, 0);
  const auto getLowest = [&](const MergeTree::Tet& tet) {
    return std::min({ places[tet[0]], places[tet[1]], places[tet[2]], places[tet[3]] });
  };
  for (const auto& tet : input.Tets)
  {
    ++starts[getLowest(tet) + 1];
  }
  for (std::size_t i = 1; i < starts.size(); ++i)
  {
    starts[i] += starts[i - 1];
  }
  this->Tets.resize(input.Tets.size());
  for (const auto& tet : input.Tets)
  {
    this->Tets[starts[getLowest(tet)]++] = { places[tet[0]], places[tet[1]], places[tet[2]],
      places[tet[3]] };
  }
}
}
