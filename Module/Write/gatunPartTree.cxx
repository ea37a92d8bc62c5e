// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartTree.h"

#include "gatunMeshTets.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gatun
{
namespace
{
/** The part of the time until all merges are found. */
constexpr double PartOfMerges = 0.9;

std::size_t CountFields(const MetaTable& meta, std::span<const double> weights, bool hasSteps)
{
  std::size_t fields = 0;
  for (std::size_t a = 0; hasSteps && a < meta.Arrays.size(); ++a)
  {
    fields += weights[a] > 0 ? meta.Arrays[a].Components : 0;
  }
  return fields;
}

PartMergeSettings WithCells(PartMergeSettings settings, bool keepsCells)
{
  settings.KeepsCells = keepsCells;
  return settings;
}
}

//------------------------------------------------------------------------------
PartTree::PartTree(WriterState& state, const PartValues& values, std::span<const double> weights,
  bool hasSteps, const PartMergeSettings& settings, PartLevels::MakeFile makeLevel)
  : State(state)
  , Values(values)
  , Weights(weights.begin(), weights.end())
  , KeepsCells(state.Options.Levels > 0 && HasCellArrays(state.Meta))
  , Merges(static_cast<std::uint32_t>(state.Meta.Points),
      CountFields(state.Meta, weights, hasSteps), WithCells(settings, this->KeepsCells))
  , Levels(state, values, this->Merges, std::move(makeLevel))
{
}

//------------------------------------------------------------------------------
void PartTree::AddPart(const WriterPart& part, std::span<const std::uint8_t> isJoined,
  const std::vector<ArrayInput>& values)
{
  // The points in the order of the file, without those that no cell uses.
  const auto& meta = this->State.Meta;
  const auto all = this->Values.GetNumbers();
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> places(all.size(), PartValues::None);
  std::vector<std::uint32_t> numbers;
  std::vector<std::uint8_t> isShared;
  std::vector<std::array<double, 3>> points;
  for (const auto point : this->Values.GetOrder())
  {
    if (all[point] >= meta.Points - meta.UnusedPoints)
    {
      continue;
    }
    places[point] = static_cast<std::uint32_t>(numbers.size());
    order.push_back(point);
    numbers.push_back(all[point]);
    isShared.push_back(isJoined[point]);
    points.push_back({ part.Mesh.GetCoordinate(point, 0), part.Mesh.GetCoordinate(point, 1),
      part.Mesh.GetCoordinate(point, 2) });
  }
  std::vector<std::array<std::uint32_t, 4>> tets;
  std::vector<std::uint32_t> cells;
  ForEachTet(part.Mesh,
    [&](std::uint64_t cell, std::array<std::uint32_t, 4> tet)
    {
      std::transform(
        tet.begin(), tet.end(), tet.begin(), [&](std::uint32_t point) { return places[point]; });
      tets.push_back(tet);
      if (this->KeepsCells)
      {
        cells.push_back(static_cast<std::uint32_t>(part.Place.FirstCell + cell));
      }
    });
  std::vector<std::vector<double>> fields;
  MergePart merged{ { points, tets, {} }, numbers, isShared, cells };
  for (std::size_t a = 0; a < values.size(); ++a)
  {
    const auto components = meta.Arrays[a].Components;
    for (std::uint32_t c = 0; this->Weights[a] > 0 && c < components; ++c)
    {
      auto& field = fields.emplace_back();
      const auto reader = values[a].GetReader();
      for (const auto point : order)
      {
        field.push_back(reader.Get(point, static_cast<int>(c)));
      }
      merged.Mesh.Fields.push_back({ {}, this->Weights[a] / components });
    }
  }
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    merged.Mesh.Fields[f].Values = fields[f];
  }
  this->Merges.Add(merged);
}

//------------------------------------------------------------------------------
MergeTree PartTree::Build(const std::function<bool(double)>& progress)
{
  double last = 0;
  const auto report = [&](double done)
  {
    last = std::max(last, done);
    return !progress || progress(last);
  };
  const auto stay = [&](double) { return report(0); };
  this->Merges.SetListener([&](std::uint32_t merges) { this->Levels.Add(merges, stay); });
  MergeTree tree = this->Merges.Build([&](double done) { return report(PartOfMerges * done); });
  this->Levels.AddRest(tree, stay);
  report(1);
  return tree;
}
}
