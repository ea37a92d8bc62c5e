// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// StepSection: values with bounds of errors.

#include "gatunRoundedArrays.h"
#include "gatunStepSection.h"

#include <algorithm>
#include <numeric>

namespace gatun
{
//------------------------------------------------------------------------------
/** Makes room for the values that readers will have of arrays with errors. Those that more than one
 * chunk or process has are rounded now, because all of them must get the same. */
void StepSection::RoundArrays(const WriterPart& part, const StepValues& values)
{
  auto& step = this->GetStep();
  this->Rounded.clear();
  this->Rounded.resize(step.Arrays.size());
  if (values.Rounded)
  {
    return; // they are what readers will have
  }
  for (std::size_t a = 0; a < step.Arrays.size(); ++a)
  {
    auto& input = step.Arrays[a];
    const auto source = step.Domains.Copies[a] ? step.Domains.Copies[a]->Source : a;
    const auto& domains = step.Domains.Components[source];
    if (std::none_of(domains.begin(), domains.end(),
          [](const Domain& domain) { return static_cast<bool>(domain.GetQuantizer()); }))
    {
      continue;
    }
    const auto tuples = part.GetTupleCount(*input.Description);
    this->Rounded[a] = std::make_unique<RoundedArray>(*input.Description, input.Now, tuples);
    input.Rounded = this->Rounded[a].get();
    input.Now = input.Rounded->GetValues();
    const bool isOnPoints = input.Description->Where == Association::Point;
    if (!input.IsCopy)
    {
      input.Rounded->PutOnLattice(input.Domains,
        isOnPoints ? std::span(part.SharedPoints) : std::span<const std::uint32_t>(),
        isOnPoints ? std::span(part.Layout.UnusedPoints) : std::span<const std::uint32_t>());
    }
  }
  for (std::size_t a = 0; a < step.Arrays.size(); ++a)
  {
    if (this->Rounded[a] && step.Arrays[a].IsCopy)
    {
      std::vector<std::uint32_t> all(part.GetTupleCount(*step.Arrays[a].Description));
      std::iota(all.begin(), all.end(), 0u);
      this->CopyRounded(all, a);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::vector<Domain>> StepInput::GetRounded() const
{
  std::vector<std::vector<Domain>> domains;
  for (std::size_t a = 0; a < this->Arrays.size(); ++a)
  {
    const ScalarType type = this->Arrays[a].Description->Type;
    auto& components = domains.emplace_back();
    for (const auto& palette : this->Table.Arrays[a].Palettes)
    {
      components.push_back(palette.Rounding ? Domain(type, palette.Rounding) : Domain(type));
    }
  }
  return domains;
}

//------------------------------------------------------------------------------
/** Gives tuples of a copy the values of its source. */
void StepSection::CopyRounded(std::span<const std::uint32_t> tuples, std::size_t array) const
{
  const auto& copy = *this->GetStep().Domains.Copies[array];
  this->Rounded[array]->Copy(*this->Rounded[copy.Source], copy.Components, tuples);
}

//------------------------------------------------------------------------------
/** Enters the largest errors of the part. */
void StepSection::TakeErrors()
{
  auto& step = this->GetStep();
  for (std::size_t a = 0; a < step.Arrays.size(); ++a)
  {
    auto& palettes = step.Table.Arrays[a].Palettes;
    for (std::size_t c = 0; this->Rounded[a] && c < palettes.size(); ++c)
    {
      auto& reached = palettes[c].Rounding.Reached;
      reached = std::max(reached, this->Rounded[a]->GetError(c));
    }
  }
}
}
