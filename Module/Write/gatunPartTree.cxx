// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartTree.h"

#include "gatunError.h"
#include "gatunMeshTets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace gatun
{
namespace
{
constexpr std::uint32_t None = MergeMesh::None;

std::size_t CountFields(const MetaTable& meta, std::span<const double> weights, std::size_t steps)
{
  std::size_t fields = 0;
  for (std::size_t a = 0; steps > 0 && a < meta.Arrays.size(); ++a)
  {
    fields += weights[a] > 0 ? meta.Arrays[a].Components : 0;
  }
  return fields;
}

std::uint32_t CheckPoints(const MetaTable& meta)
{
  if (meta.Points >= None)
  {
    ThrowInvalid("a mesh of more than 2^32 points has no hierarchy");
  }
  return static_cast<std::uint32_t>(meta.Points);
}
}

//------------------------------------------------------------------------------
PartTree::PartTree(WriterState& state, std::span<const double> weights, std::size_t steps,
  const PartMergeSettings& settings)
  : State(state)
  , Weights(weights.begin(), weights.end())
  , Steps(steps)
  , Points(CheckPoints(state.Meta))
  , Merges(CheckPoints(state.Meta), CountFields(state.Meta, weights, steps), settings)
  , Columns(AtomicFile::MakeScratch(settings.Folder))
  , FirstOwn(state.Table.GetSharedPoints())
{
  for (const ArrayDescription& array : state.Meta.Arrays)
  {
    this->FirstColumns.push_back(this->ColumnsOfStep);
    this->ColumnsOfStep += array.Where == Association::Point ? GetRangeCount(array.Components) : 0;
  }
  this->Columns.Skip((3 + steps * this->ColumnsOfStep) * this->Points * sizeof(double));
}

//------------------------------------------------------------------------------
PartTree::Column PartTree::GetColumn(std::size_t step, std::size_t array, std::size_t range) const
{
  return 3 + step * this->ColumnsOfStep + this->FirstColumns[array] + range;
}

//------------------------------------------------------------------------------
/** Writes the values of the points of the current part. */
void PartTree::WriteColumn(Column column, const std::function<double(std::uint32_t)>& getValue)
{
  std::vector<double> run;
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    run.push_back(getValue(this->Order[i]));
    const auto number = this->Numbers[this->Order[i]];
    if (i + 1 == this->Order.size() || this->Numbers[this->Order[i + 1]] != number + 1)
    {
      const auto first = std::uint64_t{ column } * this->Points + number + 1 - run.size();
      this->Columns.Overwrite(first * sizeof(double),
        { reinterpret_cast<const std::uint8_t*>(run.data()), run.size() * sizeof(double) });
      run.clear();
    }
  }
}

//------------------------------------------------------------------------------
TreeSection::GetValue PartTree::ReadColumn(Column column) const
{
  const auto values = std::make_shared<LargeArray<double>>();
  // Points that no cell uses are not merged.
  const std::size_t used = this->Points - this->State.Meta.UnusedPoints;
  values->assign(this->Points, std::nan(""));
  this->Columns.ReadAt(std::uint64_t{ column } * this->Points * sizeof(double),
    { reinterpret_cast<std::uint8_t*>(values->data()), used * sizeof(double) });
  return [values](std::uint32_t point) { return (*values)[point]; };
}

//------------------------------------------------------------------------------
void PartTree::AddPart(const WriterPart& part, std::span<const std::uint8_t> isJoined,
  const std::vector<ArrayInput>& values)
{
  this->Numbers = FindFileNumbers(this->State, part, this->FirstOwn);
  for (std::size_t c = 0; c < part.Chunks.size(); ++c)
  {
    this->FirstOwn += this->State.Table.Chunks[part.Place.FirstChunk + c].Info.OwnPoints;
  }
  this->Order.clear();
  for (std::uint32_t point = 0; point < this->Numbers.size(); ++point)
  {
    if (this->Numbers[point] != None)
    {
      this->Order.push_back(point);
    }
  }
  std::sort(this->Order.begin(), this->Order.end(),
    [this](std::uint32_t a, std::uint32_t b) { return this->Numbers[a] < this->Numbers[b]; });
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    this->WriteColumn(axis,
      [&](std::uint32_t point)
      { return ArrayInput::Finite(part.Mesh.GetCoordinate(point, axis)); });
  }

  // The points in the order of the file, without those that no cell uses.
  std::vector<std::uint32_t> places(this->Numbers.size(), None);
  std::vector<std::uint32_t> numbers;
  std::vector<std::uint8_t> isShared;
  std::vector<std::array<double, 3>> points;
  for (const auto point : this->Order)
  {
    places[point] = static_cast<std::uint32_t>(numbers.size());
    numbers.push_back(this->Numbers[point]);
    isShared.push_back(isJoined[point]);
    points.push_back({ part.Mesh.GetCoordinate(point, 0), part.Mesh.GetCoordinate(point, 1),
      part.Mesh.GetCoordinate(point, 2) });
  }
  std::vector<std::array<std::uint32_t, 4>> tets;
  ForEachTet(part.Mesh,
    [&](std::uint64_t, std::array<std::uint32_t, 4> tet)
    {
      std::transform(
        tet.begin(), tet.end(), tet.begin(), [&](std::uint32_t point) { return places[point]; });
      tets.push_back(tet);
    });
  std::vector<std::vector<double>> fields;
  MergePart merged{ { points, tets, {} }, numbers, isShared };
  for (std::size_t a = 0; a < values.size(); ++a)
  {
    const auto components = this->State.Meta.Arrays[a].Components;
    for (std::uint32_t c = 0; this->Weights[a] > 0 && c < components; ++c)
    {
      auto& field = fields.emplace_back();
      const auto reader = values[a].GetReader();
      for (const auto point : this->Order)
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
void PartTree::AddStep(std::size_t step, const std::vector<ArrayInput>& values)
{
  for (std::size_t a = 0; a < values.size(); ++a)
  {
    const ArrayDescription& array = this->State.Meta.Arrays[a];
    const auto ranges = array.Where == Association::Point ? GetRangeCount(array.Components) : 0;
    const auto reader = values[a].GetReader();
    for (std::size_t r = 0; r < ranges; ++r)
    {
      const int component = r < array.Components ? static_cast<int>(r) : -1;
      this->WriteColumn(this->GetColumn(step, a, r),
        [&](std::uint32_t point) { return reader.Get(point, component); });
    }
  }
}

//------------------------------------------------------------------------------
void PartTree::Write(const std::function<bool(double)>& progress)
{
  TreeSection section(this->State, this->Merges.Build(progress),
    [this](unsigned axis) { return this->ReadColumn(axis); });
  section.AddPart(section, section.GetTree().GetMerges().size());
  for (std::size_t step = 0; step < this->Steps; ++step)
  {
    section.AddStep([&](std::size_t array, std::size_t range)
      { return this->ReadColumn(this->GetColumn(step, array, range)); },
      this->Steps - 1 - step);
  }
  section.WriteTable({});
}
}
