// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPointContext.h"

#include <array>

namespace gatun
{
//------------------------------------------------------------------------------
std::optional<double> PredictByGate(
  const PointContext& context, std::size_t ownVertex, std::span<const double> numbers)
{
  const auto rule = context.UsedRules[ownVertex];
  if (context.CellRules)
  {
    const auto& record = context.Mesh->CellRecords[ownVertex];
    const auto number = [&](unsigned k)
    {
      const auto v = record.Known[k];
      return std::array{ v != NoVertex ? numbers[v] : 0.0 };
    };
    return record.IsSeed() ? std::nullopt
                           : std::optional(ApplyRule<1>((*context.CellRules)[rule], number)[0]);
  }
  const auto& record = context.Mesh->Records[ownVertex];
  const auto number = [&](unsigned k) { return std::array{ numbers[record.Known[k]] }; };
  return record.IsSeed() ? std::nullopt
                         : std::optional(ApplyRule<1>((*context.Rules)[rule], number)[0]);
}
}
