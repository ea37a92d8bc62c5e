// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunStepSection.h"

#include "gatunArrayContext.h"
#include "gatunDomainSurvey.h"
#include "gatunFloatEnvironment.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace gatun
{
namespace
{
void Include(ArrayRanges& all, const ArrayRanges& part)
{
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i].Include(part[i]);
  }
}
}

//------------------------------------------------------------------------------
StepScales GetScales(const StepDomains& domains)
{
  StepScales scales(domains.Components.size());
  for (std::size_t a = 0; a < scales.size(); ++a)
  {
    const auto& components = domains.Components[a];
    if (!domains.Copies[a] &&
      std::none_of(components.begin(), components.end(),
        [](const Domain& domain) { return domain.GetPalette() != nullptr; }))
    {
      auto& found = scales[a].emplace();
      for (const auto& domain : components)
      {
        found.push_back(domain.GetScale());
      }
    }
  }
  return scales;
}

const Scale* FindScale(const StepScales* before, std::size_t array, std::size_t component)
{
  return before && (*before)[array] ? &(*(*before)[array])[component] : nullptr;
}

//------------------------------------------------------------------------------
void StepSection::SetDomains(std::size_t step, StepDomains domains)
{
  this->Steps.resize(std::max(this->Steps.size(), step + 1));
  this->Steps[step].Domains = std::move(domains);
}

//------------------------------------------------------------------------------
StepDomains StepSection::FindDomains(const WriterPart& part, const StepValues& step) const
{
  const auto& values = step.Arrays;
  const auto& arrays = this->State.Meta.Arrays;
  const auto* before = this->IsKey(this->Count) ? nullptr : &this->Steps[this->Count - 1].Scales;
  const auto& mesh = part.Mesh.GetMesh();
  const auto listed = this->State.Meta.GetListedArrays();
  const std::vector<ArrayDescription> described(
    arrays.begin(), arrays.begin() + static_cast<std::ptrdiff_t>(listed));
  CopySurvey copies;
  copies.Add(described, values.first(listed), mesh.Points, mesh.Cells);
  StepDomains domains{ {}, copies.Finish(described, this->State.Options.Errors) };
  domains.Components.resize(arrays.size());
  domains.Copies.resize(arrays.size());
  if (this->State.Meta.PointsMove)
  {
    domains.Components.back() = this->FindPointDomains(part, values.back());
  }
  std::vector<std::pair<std::size_t, std::uint32_t>> components;
  for (std::size_t a = 0; a < listed; ++a)
  {
    domains.Components[a].resize(arrays[a].Components, Domain(arrays[a].Type));
    for (std::uint32_t c = 0; !domains.Copies[a] && c < arrays[a].Components; ++c)
    {
      components.emplace_back(a, c);
    }
  }
  ParallelFor(components.size(),
    [&](std::size_t i)
    {
      const auto [a, c] = components[i];
      if (step.Rounded && (*step.Rounded)[a][c].GetQuantizer())
      {
        domains.Components[a][c] = (*step.Rounded)[a][c];
        return;
      }
      const auto request =
        step.Rounded ? RoundingRequest() : GetRoundingRequest(this->State.Options, arrays[a]);
      domains.Components[a][c] =
        FindDomain(arrays[a].Type, values[a], part.GetTupleCount(arrays[a]), arrays[a].Components,
          c, PaletteUse::Array, FindScale(before, a, c), request);
    });
  return domains;
}

//------------------------------------------------------------------------------
void StepSection::Check(const WriterPart& part, const StepValues& values) const
{
  const auto& arrays = this->State.Meta.Arrays;
  if (values.Arrays.size() != arrays.size())
  {
    ThrowInvalid("a step needs the values of every array");
  }
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    if (!values.Arrays[a] && part.GetTupleCount(arrays[a]) > 0)
    {
      ThrowInvalid("array '" + arrays[a].Name + "' has no values");
    }
  }
  if (this->State.Meta.PointsMove && this->Count == 0 && !this->StandsStill(part, values))
  {
    ThrowInvalid("the points of the first time step are not those of the mesh");
  }
  if (std::isnan(values.Time))
  {
    ThrowInvalid("the time of a step is not a number");
  }
  if (!part.Place.IsFirstHere)
  {
    if (this->Count == this->Steps.size())
    {
      ThrowInvalid("a part has more time steps than the first one");
    }
    if (values.HasTime != this->State.Meta.HasTime ||
      (values.HasTime && values.Time != this->GetStep().Table.Time))
    {
      ThrowInvalid("parts have different times");
    }
    return;
  }
  if (this->Count > 0)
  {
    const double last = this->Steps[this->Count - 1].Table.Time;
    if (!values.HasTime || !this->State.Meta.HasTime || !(values.Time > last))
    {
      ThrowInvalid("the times of the steps must ascend: " + std::to_string(values.Time) +
        " follows " + std::to_string(last));
    }
  }
}

//------------------------------------------------------------------------------
/** Describes a step before the first part writes it. */
void StepSection::Begin(const WriterPart& part, const StepValues& values)
{
  this->State.Meta.HasTime = values.HasTime;
  const auto& arrays = this->State.Meta.Arrays;
  this->Steps.resize(std::max(this->Steps.size(), this->Count + 1));
  auto& step = this->GetStep();
  step.Table.Time = values.Time;
  step.Table.Key = this->IsKey(this->Count);
  step.Table.PointsMove =
    this->State.Meta.PointsMove && (this->Count == 0 || !this->StandsStill(part, values));
  step.Table.Arrays.resize(arrays.size());
  if (step.Domains.Components.empty())
  {
    step.Domains = this->FindDomains(part, values);
  }
  step.Scales = GetScales(step.Domains);
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    auto& entry = step.Table.Arrays[a];
    entry.Ranges.resize(GetRangeCount(arrays[a].Components));
    entry.Palettes.resize(arrays[a].Components);
    entry.Chunks.resize(this->State.Table.Chunks.size());
    entry.ChunkRanges.resize(this->State.Table.Chunks.size());
    if (arrays[a].Where == Association::Point)
    {
      entry.Blocks.resize(this->State.Table.Blocks.size() + 1);
    }
    this->WritePalettes(a, part.Place.IsFirst, this->Opening);
  }
  if (values.Field && part.Place.IsFirst)
  {
    this->AddFieldData(*values.Field, step.Table, this->Opening);
  }
}

//------------------------------------------------------------------------------
void StepSection::WritePalettes(std::size_t a, bool isFirst, StreamBatch& batch)
{
  auto& step = this->GetStep();
  auto& entry = step.Table.Arrays[a];
  for (std::size_t c = 0; c < entry.Palettes.size(); ++c)
  {
    if (step.Domains.Copies[a])
    {
      entry.Palettes[c].SourceArray = step.Domains.Copies[a]->Source;
      entry.Palettes[c].SourceComponent = step.Domains.Copies[a]->Components[c];
      continue;
    }
    const auto& palette = step.Domains.Components[a][c].GetPalette();
    entry.Palettes[c].Steps = step.Domains.Components[a][c].GetScale();
    entry.Palettes[c].Rounding = step.Domains.Components[a][c].GetQuantizer();
    if (palette)
    {
      entry.Palettes[c].Count = palette->size();
      if (!isFirst)
      {
        continue;
      }
      const auto stream = EncodePalette(this->State.Meta.Arrays[a].Type, *palette);
      batch.Add(stream, entry.Palettes[c].Stream);
      this->State.Statistics.ArrayBytes[a] += stream.size();
    }
  }
}

//------------------------------------------------------------------------------
StepInput& StepSection::WriteValues(
  WriterPart& part, const StepValues& values, const std::function<bool(double)>& progress)
{
  this->Prepare(part, values);
  return this->WritePrepared(part, progress);
}

//------------------------------------------------------------------------------
void StepSection::Prepare(const WriterPart& part, const StepValues& values)
{
  this->Check(part, values);
  if (part.Place.IsFirstHere)
  {
    this->Begin(part, values);
  }
  auto& step = this->GetStep();
  const auto& mesh = part.Mesh.GetMesh();
  CheckCopies(step.Domains.Copies, this->State.Meta.Arrays, values.Arrays, mesh.Points, mesh.Cells);
  step.Arrays.clear();
  for (std::size_t a = 0; a < values.Arrays.size(); ++a)
  {
    this->AddArray(a, part, values.Arrays[a]);
    auto& input = step.Arrays.back();
    input.IsAlive = values.Remaining ? &values.Remaining->Get(input.Description->Where) : nullptr;
  }
  this->RoundArrays(part, values);
  this->Ahead.assign(part.Layout.GetChunkCount(), {});
}

//------------------------------------------------------------------------------
StepInput& StepSection::WriteWithMesh(MeshSection& mesh, WriterPart& part, const StepValues& values,
  const std::function<bool(double)>& progress)
{
  this->Prepare(part, values);
  mesh.Write(part, progress,
    [&](std::size_t chunk)
    {
      this->Ahead[chunk] = this->EncodeChunk(part, chunk);
      part.Chunks[chunk] = {};
    });
  return this->WritePrepared(part, {});
}

//------------------------------------------------------------------------------
StepInput& StepSection::WritePrepared(WriterPart& part, const std::function<bool(double)>& progress)
{
  auto& step = this->GetStep();
  if (part.Place.IsFirstHere)
  {
    this->Opening.Write(this->State.File, SectionValues);
    this->LastFieldRef = step.Table.Field.Length > 0 ? step.Table.Field : this->LastFieldRef;
  }
  this->TakeUnused(part);
  this->WriteBlockValues(part);
  this->WriteChunkValues(part, progress);
  this->TakeErrors();
  this->Ahead.clear();
  return step;
}

//------------------------------------------------------------------------------
void StepSection::AddArray(std::size_t a, const WriterPart& part, const void* values)
{
  auto& step = this->GetStep();
  const auto& array = this->State.Meta.Arrays[a];
  auto& input = step.Arrays.emplace_back();
  input.Description = &array;
  input.Now = static_cast<const std::uint8_t*>(values);
  input.Domains = step.Domains.Components[a];
  input.IsPoints = this->IsPoints(a);
  input.IsLater = this->Count > 0;
  input.IsCopy = step.Domains.Copies[a].has_value() ||
    (input.IsPoints && (this->Count == 0 || !step.Table.PointsMove));
  if (this->HasBefore(a) && part.GetTupleCount(array) > 0)
  {
    input.Before = input.IsPoints && this->FindReference(a) == 0
      ? static_cast<const std::uint8_t*>(part.Mesh.GetMesh().Coordinates)
      : this->Before[a].data();
  }
}

//------------------------------------------------------------------------------
void StepSection::AddFieldData(const FieldData& field, StepTable& step, StreamBatch& batch)
{
  if (field.empty())
  {
    return;
  }
  auto stream = WriteFieldData(field);
  if (stream == this->LastField)
  {
    step.Field = this->LastFieldRef; // the same data of many steps are stored once
    return;
  }
  batch.Add(stream, step.Field);
  this->State.Statistics.FieldDataBytes += stream.size();
  this->LastField = std::move(stream);
}

//------------------------------------------------------------------------------
/** Keeps the values of the unused points of a part for the block that the last part writes. */
void StepSection::TakeUnused(const WriterPart& part)
{
  auto& steps = this->State.Unused.Values;
  auto& arrays = this->GetStep().Arrays;
  steps.resize(std::max(steps.size(), this->Count + 1));
  steps[this->Count].resize(arrays.size());
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const auto& array = *arrays[a].Description;
    if (array.Where == Association::Point)
    {
      auto& values = steps[this->Count][a];
      for (const auto point : part.Layout.UnusedPoints)
      {
        const auto* from = arrays[a].At(arrays[a].Now, point, 0);
        values.insert(values.end(), from, from + array.Components * SizeOf(array.Type));
      }
      arrays[a].Include(this->GetStep().Table.Arrays[a].Ranges, part.Layout.UnusedPoints);
    }
  }
}

//------------------------------------------------------------------------------
namespace
{
std::vector<std::array<double, 3>> GetPlaces(
  const MeshInput& mesh, std::span<const std::uint32_t> points)
{
  const auto size = SizeOf(mesh.CoordinateType);
  const auto* values = static_cast<const std::uint8_t*>(mesh.Coordinates);
  std::vector<std::array<double, 3>> places(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const auto* value = values + (std::size_t{ 3 } * points[i] + axis) * size;
      places[i][axis] = PlainKeys::PlainToNumber(
        mesh.CoordinateType, PlainKeys::ReadPlain(mesh.CoordinateType, value));
    }
  }
  return places;
}
}

//------------------------------------------------------------------------------
/** Encodes the values of a block, one stream for each array. Called by several threads. */
std::vector<Bytes> StepSection::EncodeBlock(const WriterPart& part, std::size_t block) const
{
  const auto points = part.GetBlockPoints(this->State.Table, block);
  const auto& inputs = this->GetStep().Arrays;
  std::vector<Bytes> streams(inputs.size());
  std::optional<QuadraticFit> fit;
  for (std::size_t a = 0; a < inputs.size(); ++a)
  {
    if (inputs[a].Description->Where == Association::Point && !inputs[a].IsCopy && !points.empty())
    {
      const auto profile = this->State.Options.Coding;
      if (!fit && profile == Profile::Small)
      {
        fit.emplace(GetPlaces(part.Mesh.GetMesh(), points));
      }
      auto keys = inputs[a].GetKeys(points);
      streams[a] = EncodeCellValues(
        { {}, fit ? &*fit : nullptr, profile }, inputs[a].Domains, keys, inputs[a].GetModeChoice());
    }
  }
  return streams;
}

//------------------------------------------------------------------------------
std::vector<Bytes> StepSection::EncodeUnused()
{
  const auto& unused = this->State.Unused.Values;
  const auto& step = this->GetStep();
  std::vector<Bytes> streams(step.Arrays.size());
  std::vector<std::uint32_t> points(static_cast<std::size_t>(this->State.Meta.UnusedPoints));
  std::iota(points.begin(), points.end(), 0u);
  for (std::size_t a = 0; a < streams.size(); ++a)
  {
    ArrayInput input = step.Arrays[a];
    if (input.Description->Where == Association::Point && !input.IsCopy && !points.empty())
    {
      input.Now = unused[this->Count][a].data();
      input.Before = !this->HasBefore(a)                ? nullptr
        : input.IsPoints && this->FindReference(a) == 0 ? this->State.Unused.Coordinates.data()
                                                        : unused[this->Count - 1][a].data();
      auto keys = input.GetKeys(points);
      streams[a] =
        EncodeCellValues({ {}, nullptr, this->State.Options.Coding }, input.Domains, keys);
    }
  }
  return streams;
}

//------------------------------------------------------------------------------
void StepSection::WriteBlockValues(const WriterPart& part)
{
  auto& step = this->GetStep();
  const auto& place = part.Place;
  std::vector<std::vector<Bytes>> streams(place.Blocks + (place.IsLast ? 1 : 0));
  ParallelFor(streams.size(),
    [&](std::size_t b)
    {
      const FloatEnvironment guard;
      streams[b] = b < place.Blocks ? this->EncodeBlock(part, b) : this->EncodeUnused();
    });
  StreamBatch batch;
  for (std::size_t a = 0; a < step.Arrays.size(); ++a)
  {
    auto& blocks = step.Table.Arrays[a].Blocks;
    for (std::size_t b = 0; b < streams.size(); ++b)
    {
      if (!streams[b][a].empty())
      {
        batch.Add(streams[b][a], b < place.Blocks ? blocks[place.FirstBlock + b] : blocks.back());
        this->State.Statistics.ArrayBytes[a] += streams[b][a].size();
      }
    }
  }
  batch.Write(this->State.File, SectionValues, FlagMandatory, step.Table.Key);
}

//------------------------------------------------------------------------------
/** Encodes the values of a chunk, one stream for each array. Called by several threads. */
std::vector<Bytes> StepSection::EncodeChunk(WriterPart& part, std::size_t chunk)
{
  const FloatEnvironment guard;
  auto& step = this->GetStep();
  auto& state = part.Chunks[chunk];
  const auto profile = this->State.Options.Coding;
  const auto fits = state.Mesh.Walk.HasTree() || !step.HasValues(Association::Point)
    ? ContextFits::None
    : profile == Profile::Fast ? ContextFits::Linear
                               : ContextFits::All;
  const ArrayContext points(state.Mesh, fits);
  std::optional<QuadraticFit> cellFit;
  if (step.HasValues(Association::Cell) && profile == Profile::Small)
  {
    cellFit.emplace(FitCells(state.Mesh));
  }
  const CellContext cells{ state.Mesh.Walk.Parents, cellFit ? &*cellFit : nullptr, profile };
  std::vector<Bytes> streams;
  for (std::size_t a = 0; a < step.Arrays.size(); ++a)
  {
    const auto& input = step.Arrays[a];
    const bool ofPoints = input.Description->Where == Association::Point;
    const auto& tuples = ofPoints ? state.PointOf : state.CellOf;
    auto& stream = streams.emplace_back();
    if (!input.IsCopy)
    {
      auto keys = input.GetKeys(tuples);
      stream = ofPoints
        ? EncodePointValues(points.GetPoints(), input.Domains, keys, input.GetModeChoice())
        : EncodeCellValues(cells, input.Domains, keys, input.GetModeChoice());
      const auto own = ofPoints ? state.Mesh.OwnIds.size() : tuples.size();
      for (std::size_t i = 0; input.Rounded && i < own; ++i)
      {
        const auto key = ofPoints ? state.Mesh.OwnIds[i] : i;
        input.TakeKeys(tuples[key], key, keys);
      }
    }
  }
  for (std::size_t a = 0; a < step.Arrays.size(); ++a)
  {
    const auto& input = step.Arrays[a];
    const auto& tuples =
      input.Description->Where == Association::Point ? state.PointOf : state.CellOf;
    if (input.IsCopy && input.Rounded)
    {
      // Points of other chunks are in them already.
      auto own = tuples;
      if (input.Description->Where == Association::Point)
      {
        const auto& ids = state.Mesh.OwnIds;
        own.resize(ids.size());
        std::transform(ids.begin(), ids.end(), own.begin(), [&](Vertex v) { return tuples[v]; });
      }
      this->CopyRounded(own, a);
    }
    auto& ranges = step.Table.Arrays[a].ChunkRanges[part.Place.FirstChunk + chunk];
    ranges.resize(GetRangeCount(input.Description->Components));
    input.Include(ranges, tuples);
  }
  return streams;
}

//------------------------------------------------------------------------------
void StepSection::WriteChunkValues(WriterPart& part, const std::function<bool(double)>& progress)
{
  auto& step = this->GetStep();
  std::vector<std::vector<Bytes>> streams(ChunksPerBatch);
  StreamBatch batch;
  ForEachBatch(
    part.Chunks.size(),
    [&](std::size_t chunk)
    {
      auto& ahead = this->Ahead[chunk];
      streams[chunk % ChunksPerBatch] =
        ahead.empty() && !step.Arrays.empty() ? this->EncodeChunk(part, chunk) : std::move(ahead);
    },
    [&](std::size_t first, std::size_t count)
    {
      // Array by array, so that a reader of one array reads the batch in one go.
      for (std::size_t a = 0; a < step.Arrays.size(); ++a)
      {
        auto& array = step.Table.Arrays[a];
        for (std::size_t i = 0; i < count; ++i)
        {
          const auto chunk = part.Place.FirstChunk + first + i;
          if (!step.Arrays[a].IsCopy)
          {
            batch.Add(streams[i][a], array.Chunks[chunk]);
            this->State.Statistics.ArrayBytes[a] += streams[i][a].size();
          }
          Include(array.Ranges, array.ChunkRanges[chunk]);
        }
      }
      batch.Write(this->State.File, SectionValues, FlagMandatory, step.Table.Key);
    },
    progress);
}

//------------------------------------------------------------------------------
void StepSection::Finish(WriterPart& part, const StepValues& values)
{
  auto& step = this->GetStep();
  this->PointStep = step.Table.PointsMove ? this->Count : this->PointStep;
  if (part.Place.IsLast && !this->KeepsTables)
  {
    this->State.AddStep(step.Table);
    step.Table.Arrays = {};
    step.Domains = {};
    if (this->Count > 0)
    {
      this->State.Unused.Values[this->Count - 1] = {};
    }
  }
  if (this->State.Meta.HasTime)
  {
    this->Before.resize(values.Arrays.size());
    for (std::size_t a = 0; a < values.Arrays.size(); ++a)
    {
      const auto& array = this->State.Meta.Arrays[a];
      const auto size = part.GetTupleCount(array) * array.Components * SizeOf(array.Type);
      const auto* begin = step.Arrays[a].Now; // what readers have
      this->Before[a].assign(begin, begin + size);
    }
  }
  step.Arrays = {};
  ++this->Count;
}

//------------------------------------------------------------------------------
void StepSection::EndPart()
{
  if (this->Count < this->Steps.size())
  {
    ThrowInvalid("a part has fewer time steps than the first one");
  }
  this->Count = 0;
  this->Before.clear();
}
}
