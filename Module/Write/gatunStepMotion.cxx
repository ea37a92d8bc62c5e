// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// StepSection: coordinates of points that move, and what values are predicted from.

#include "gatunDomainSurvey.h"
#include "gatunParallel.h"
#include "gatunStepSection.h"

#include <cstring>

namespace gatun
{
//------------------------------------------------------------------------------
/** Coordinates have no palette, and a scale that has those from which they are predicted, too. */
std::vector<Domain> StepSection::FindPointDomains(
  const WriterPart& part, const void* coordinates) const
{
  const auto points = this->State.Meta.Arrays.size() - 1;
  const auto& description = this->State.Meta.Arrays[points];
  const auto reference =
    this->GetStep().Table.PointsMove ? this->FindReference(points) : this->PointStep;
  const void* const others = !reference ? nullptr
    : *reference == 0                   ? part.Mesh.GetMesh().Coordinates
                                        : this->Before.back().data();
  std::vector<Domain> domains(description.Components, Domain(description.Type));
  ParallelFor(domains.size(),
    [&](std::size_t c)
    {
      const auto* before =
        reference ? FindScale(&this->Steps[*reference].Scales, points, c) : nullptr;
      const auto count = part.GetTupleCount(description);
      const auto survey = [&](const void* more)
      {
        DomainSurvey all(description.Type, 0);
        all.Add(coordinates, count, description.Components, c);
        if (more)
        {
          all.Add(more, count, description.Components, c);
        }
        return all.Finish(count, PaletteUse::Array, before);
      };
      domains[c] = survey(nullptr);
      if (before && !(domains[c].GetScale() == *before))
      {
        domains[c] = survey(others);
      }
    });
  return domains;
}

//------------------------------------------------------------------------------
/** Whether the points are where they were at the step before, or in the mesh. */
bool StepSection::StandsStill(const WriterPart& part, const StepValues& values) const
{
  const auto& mesh = part.Mesh.GetMesh();
  const auto size = static_cast<std::size_t>(mesh.Points) * 3 * SizeOf(mesh.CoordinateType);
  const auto* before = this->Count == 0 ? mesh.Coordinates : this->Before.back().data();
  return size == 0 || std::memcmp(values.Arrays.back(), before, size) == 0;
}

//------------------------------------------------------------------------------
/** The step from which the values of an array are predicted: the one before; for coordinates the
 * last one with coordinates since the key step, otherwise the first one, which is the mesh. */
std::optional<std::size_t> StepSection::FindReference(std::size_t a) const
{
  if (this->IsPoints(a))
  {
    const auto key = this->Count - this->Count % this->State.Options.KeyStepInterval;
    return this->Count == 0    ? std::nullopt
      : this->PointStep >= key ? std::optional(this->PointStep)
                               : std::optional<std::size_t>(0);
  }
  return this->IsKey(this->Count) ? std::nullopt : std::optional(this->Count - 1);
}

//------------------------------------------------------------------------------
/** Whether the values of an array may be predicted from another step. */
bool StepSection::HasBefore(std::size_t a) const
{
  const auto& step = this->GetStep();
  if (this->IsPoints(a))
  {
    return this->Count > 0; // FindPointDomains takes care of the scale
  }
  return !step.Table.Key && step.Scales[a] &&
    step.Scales[a] == this->Steps[this->Count - 1].Scales[a];
}
}
