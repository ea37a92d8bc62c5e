// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartValues.h"

#include "gatunError.h"
#include "gatunLargeArray.h"
#include "gatunTreeSection.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <memory>
#include <numeric>
#include <utility>

namespace gatun
{
namespace
{
/** What is read at once, and what is read rather than skipped. */
constexpr std::size_t MostAtOnce = std::size_t{ 1 } << 18;
constexpr std::size_t LeastSkipped = std::size_t{ 1 } << 13;
}

//------------------------------------------------------------------------------
std::vector<const void*> ListPointers(const std::vector<Bytes>& values)
{
  std::vector<const void*> pointers;
  std::transform(values.begin(), values.end(), std::back_inserter(pointers),
    [](const Bytes& some) { return some.data(); });
  return pointers;
}

//------------------------------------------------------------------------------
bool HasCellArrays(const MetaTable& meta)
{
  return std::any_of(meta.Arrays.begin(), meta.Arrays.end(),
    [](const ArrayDescription& array) { return array.Where == Association::Cell; });
}

//------------------------------------------------------------------------------
PartValues::PartValues(
  const WriterState& state, std::size_t steps, bool keepsCells, std::string folder)
  : State(state)
  , KeepsCells(keepsCells)
  , Folder(std::move(folder))
  , File(AtomicFile::MakeScratch(this->Folder))
  , Coordinates{ 0, state.Meta.CoordinateType, 3 }
  , FirstOwn(state.Table.GetSharedPoints())
  , NextUnused(state.Meta.Points - state.Meta.UnusedPoints)
{
  const std::uint64_t points = state.Meta.Points;
  if (points >= None)
  {
    ThrowInvalid("a mesh of 2^32 points or more has no hierarchy and no boundary");
  }
  if (keepsCells && state.NumberOfCells >= None)
  {
    ThrowInvalid("a mesh of 2^32 cells or more has no coarser meshes and no boundary");
  }
  for (const ArrayDescription& array : state.Meta.Arrays)
  {
    auto& column = this->Columns.emplace_back(Column{ this->StepBytes, array.Type, 0 });
    const bool ofPoints = array.Where == Association::Point;
    if (ofPoints || keepsCells)
    {
      column.Components = array.Components;
      this->StepBytes += column.GetBytes() * (ofPoints ? points : state.NumberOfCells);
    }
  }
  this->Steps.resize(steps);
  this->File.Skip(this->Coordinates.GetBytes() * points + steps * this->StepBytes);
}

//------------------------------------------------------------------------------
PartValues::Column PartValues::GetColumn(std::size_t step, std::size_t array) const
{
  Column column = this->Columns[array];
  column.Offset += this->Coordinates.GetBytes() * this->State.Meta.Points + step * this->StepBytes;
  return column;
}

//------------------------------------------------------------------------------
void PartValues::AddPart(const WriterPart& part)
{
  this->FirstCell = part.Place.FirstCell;
  this->Cells = part.Mesh.GetMesh().Cells;
  this->Numbers = FindFileNumbers(this->State, part, this->FirstOwn);
  for (std::size_t c = 0; c < part.Chunks.size(); ++c)
  {
    this->FirstOwn += this->State.Table.Chunks[part.Place.FirstChunk + c].Info.OwnPoints;
  }
  for (const auto point : part.Layout.UnusedPoints)
  {
    this->Numbers[point] = static_cast<std::uint32_t>(this->NextUnused++);
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
  this->WritePoints(this->Coordinates, part.Mesh.GetMesh().Coordinates);
}

//------------------------------------------------------------------------------
void PartValues::AddStep(std::size_t step, const StepInput& input, const StepValues& values)
{
  this->Steps[step] = { values.HasTime, values.Time, input.GetRounded() };
  for (std::size_t a = 0; a < input.Arrays.size(); ++a)
  {
    const Column column = this->GetColumn(step, a);
    if (column.Components == 0)
    {
      continue;
    }
    if (this->State.Meta.Arrays[a].Where == Association::Point)
    {
      this->WritePoints(column, input.Arrays[a].Now);
      continue;
    }
    this->File.Overwrite(column.Offset + this->FirstCell * column.GetBytes(),
      { input.Arrays[a].Now, static_cast<std::size_t>(this->Cells) * column.GetBytes() });
  }
}

//------------------------------------------------------------------------------
/** Writes the tuples of the points of the last part. */
void PartValues::WritePoints(const Column& column, const void* values)
{
  const auto* const all = static_cast<const std::uint8_t*>(values);
  const auto bytes = column.GetBytes();
  Bytes run;
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    const auto* const tuple = all + bytes * this->Order[i];
    run.insert(run.end(), tuple, tuple + bytes);
    const std::uint64_t number = this->Numbers[this->Order[i]];
    if (i + 1 == this->Order.size() || this->Numbers[this->Order[i + 1]] != number + 1)
    {
      this->File.Overwrite(column.Offset + (number + 1) * bytes - run.size(), run);
      run.clear();
    }
  }
}

//------------------------------------------------------------------------------
TreeLayout::GetValue PartValues::Read(const Column& column, int component, bool isPlace) const
{
  const auto values = std::make_shared<LargeArray<double>>();
  values->assign(static_cast<std::size_t>(this->State.Meta.Points), std::nan(""));
  // Points that no cell uses are not merged.
  const auto used =
    static_cast<std::size_t>(this->State.Meta.Points - this->State.Meta.UnusedPoints);
  const auto bytes = column.GetBytes();
  const std::size_t most = std::max<std::size_t>(1, MostAtOnce / bytes);
  Bytes some;
  for (std::size_t first = 0; first < used; first += most)
  {
    const auto count = std::min(most, used - first);
    some.resize(count * bytes);
    this->File.ReadAt(column.Offset + first * bytes, some);
    const ComponentReader reader{ column.Type, some.data(), column.Components };
    for (std::size_t i = 0; i < count; ++i)
    {
      const double value = reader.Get(i, component);
      (*values)[first + i] = isPlace ? ArrayInput::Finite(value) : value;
    }
  }
  return [values](std::uint32_t point) { return (*values)[point]; };
}

//------------------------------------------------------------------------------
TreeLayout::GetValue PartValues::ReadCoordinates(unsigned axis) const
{
  return this->Read(this->Coordinates, static_cast<int>(axis), true);
}

//------------------------------------------------------------------------------
TreeLayout::GetValue PartValues::ReadRange(
  std::size_t step, std::size_t array, std::size_t range) const
{
  const Column column = this->GetColumn(step, array);
  return this->Read(column, range < column.Components ? static_cast<int>(range) : -1, false);
}

//------------------------------------------------------------------------------
Bytes PartValues::Gather(const Column& column, std::span<const std::uint32_t> tuples) const
{
  const auto bytes = column.GetBytes();
  std::vector<std::uint32_t> order(tuples.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto isBefore = [&](std::uint32_t a, std::uint32_t b) { return tuples[a] < tuples[b]; };
  if (!std::is_sorted(order.begin(), order.end(), isBefore))
  {
    std::sort(order.begin(), order.end(), isBefore);
  }
  const auto at = [&](std::size_t i) { return std::uint64_t{ tuples[order[i]] } * bytes; };
  Bytes all(tuples.size() * bytes);
  Bytes some;
  for (std::size_t first = 0, end = 0; first < order.size(); first = end)
  {
    for (end = first + 1; end < order.size() && at(end) - at(end - 1) <= LeastSkipped + bytes &&
         at(end) + bytes - at(first) <= MostAtOnce;)
    {
      ++end;
    }
    some.resize(static_cast<std::size_t>(at(end - 1) + bytes - at(first)));
    this->File.ReadAt(column.Offset + at(first), some);
    for (std::size_t i = first; i < end; ++i)
    {
      std::memcpy(all.data() + order[i] * bytes, some.data() + (at(i) - at(first)), bytes);
    }
  }
  return all;
}

//------------------------------------------------------------------------------
Bytes PartValues::GetCoordinates(std::span<const std::uint32_t> points) const
{
  return this->Gather(this->Coordinates, points);
}

//------------------------------------------------------------------------------
std::vector<Bytes> PartValues::GetValues(std::size_t step, std::span<const std::uint32_t> points,
  std::span<const std::uint32_t> cells) const
{
  std::vector<Bytes> values;
  for (std::size_t a = 0; a < this->Columns.size(); ++a)
  {
    values.push_back(this->Gather(this->GetColumn(step, a),
      this->State.Meta.Arrays[a].Where == Association::Point ? points : cells));
  }
  return values;
}
}
