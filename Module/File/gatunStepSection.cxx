// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunStepSection.h"

#include "gatunFloatEnvironment.h"
#include "gatunPalette.h"
#include "gatunParallel.h"

#include <cmath>
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
void StepSection::Check(std::span<const void* const> values, bool hasTime, double time) const
{
  if (values.size() != this->State.Meta.Arrays.size())
  {
    ThrowInvalid("a step needs the values of every array");
  }
  if (this->Count > 0 && (!hasTime || !this->State.Meta.HasTime || !(time > this->LastTime)))
  {
    ThrowInvalid("the times of the steps must ascend: " + std::to_string(time) + " follows " +
      std::to_string(this->LastTime));
  }
  if (std::isnan(time))
  {
    ThrowInvalid("the time of a step is not a number");
  }
}

//------------------------------------------------------------------------------
StepInput StepSection::WriteValues(std::span<const void* const> values, const FieldData& field,
  bool hasTime, double time, const std::function<bool(double)>& progress)
{
  this->Check(values, hasTime, time);
  this->State.Meta.HasTime = hasTime;
  StepInput step;
  step.Table.Time = time;
  step.Table.Key = this->Count % this->State.Options.KeyStepInterval == 0;
  step.Table.Arrays.resize(values.size());
  step.Arrays.resize(values.size());
  step.IsPlain.assign(values.size(), true);
  StreamBatch batch;
  for (std::size_t a = 0; a < values.size(); ++a)
  {
    this->AddArray(a, values[a], step, batch);
  }
  this->AddFieldData(field, step.Table, batch);
  batch.Write(this->State.File, SectionValues);
  if (!field.empty())
  {
    this->LastFieldRef = step.Table.Field;
  }
  this->WriteBlockValues(step);
  this->WriteChunkValues(step, progress);
  return step;
}

//------------------------------------------------------------------------------
/** Describes an array and adds its palettes. */
void StepSection::AddArray(std::size_t a, const void* values, StepInput& step, StreamBatch& batch)
{
  const auto& array = this->State.Meta.Arrays[a];
  auto& input = step.Arrays[a];
  auto& entry = step.Table.Arrays[a];
  const auto tuples = this->State.GetTupleCount(array);
  if (!values && tuples > 0)
  {
    ThrowInvalid("array '" + array.Name + "' has no values");
  }
  input.Description = &array;
  input.Now = static_cast<const std::uint8_t*>(values);
  entry.Ranges.resize(GetRangeCount(array.Components));
  entry.Palettes.resize(array.Components);
  entry.Chunks.resize(this->State.Chunks.size());
  entry.ChunkRanges.resize(this->State.Chunks.size());
  for (std::uint32_t c = 0; c < array.Components; ++c)
  {
    auto palette = FindPalette(array.Type, values, tuples, array.Components, c);
    input.Domains.emplace_back(array.Type, palette);
    if (palette)
    {
      step.IsPlain[a] = false;
      entry.Palettes[c].Count = palette->size();
      const auto stream = EncodePalette(array.Type, *palette);
      batch.Add(stream, entry.Palettes[c].Stream);
      this->State.Statistics.ArrayBytes[a] += stream.size();
    }
  }
  if (!step.Table.Key && step.IsPlain[a] && this->BeforeIsPlain[a])
  {
    input.Before = this->Before[a].data();
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
void StepSection::WriteBlockValues(StepInput& step)
{
  const auto& inputs = step.Arrays;
  const auto blocks = this->State.Table.Blocks.size() + 1;
  const auto getPoints = [&](std::size_t b)
  {
    return b + 1 < blocks ? this->State.GetBlockPoints(b)
                          : std::span<const std::uint32_t>(this->State.Parts.UnusedPoints);
  };
  std::vector<std::vector<Bytes>> streams(inputs.size(), std::vector<Bytes>(blocks));
  ParallelFor(blocks,
    [&](std::size_t b)
    {
      const FloatEnvironment guard;
      const auto points = getPoints(b);
      for (std::size_t a = 0; a < inputs.size(); ++a)
      {
        if (inputs[a].Description->Where == Association::Point && !points.empty())
        {
          auto keys = inputs[a].GetKeys(points);
          streams[a][b] = EncodeCellValues({}, inputs[a].Domains, keys);
        }
      }
    });
  StreamBatch batch;
  for (std::size_t a = 0; a < inputs.size(); ++a)
  {
    if (inputs[a].Description->Where != Association::Point)
    {
      continue;
    }
    step.Table.Arrays[a].Blocks.resize(blocks);
    for (std::size_t b = 0; b < blocks; ++b)
    {
      if (!streams[a][b].empty())
      {
        batch.Add(streams[a][b], step.Table.Arrays[a].Blocks[b]);
        this->State.Statistics.ArrayBytes[a] += streams[a][b].size();
      }
    }
    inputs[a].Include(step.Table.Arrays[a].Ranges, this->State.Parts.UnusedPoints);
  }
  batch.Write(this->State.File, SectionValues);
}

//------------------------------------------------------------------------------
/** Encodes the values of a chunk, one stream for each array. Called by several threads. */
std::vector<Bytes> StepSection::EncodeChunk(StepInput& step, std::size_t chunk)
{
  const FloatEnvironment guard;
  auto& state = this->State.Chunks[chunk];
  state.Mesh.MakeContext(true);
  std::vector<Bytes> streams;
  for (std::size_t a = 0; a < step.Arrays.size(); ++a)
  {
    const auto& input = step.Arrays[a];
    const bool ofPoints = input.Description->Where == Association::Point;
    const auto& tuples = ofPoints ? state.PointOf : state.CellOf;
    auto keys = input.GetKeys(tuples);
    streams.push_back(ofPoints ? EncodePointValues(state.Mesh.Context, input.Domains, keys)
                               : EncodeCellValues(state.Mesh.Walk.Parents, input.Domains, keys));
    auto& ranges = step.Table.Arrays[a].ChunkRanges[chunk];
    ranges.resize(GetRangeCount(input.Description->Components));
    input.Include(ranges, tuples);
  }
  state.Mesh.Fit.reset();
  state.Mesh.Context.Fit = nullptr;
  return streams;
}

//------------------------------------------------------------------------------
void StepSection::WriteChunkValues(StepInput& step, const std::function<bool(double)>& progress)
{
  std::vector<std::vector<Bytes>> streams(ChunksPerBatch);
  StreamBatch batch;
  ForEachBatch(
    this->State.Chunks.size(),
    [&](std::size_t chunk) { streams[chunk % ChunksPerBatch] = this->EncodeChunk(step, chunk); },
    [&](std::size_t first, std::size_t count)
    {
      // Array by array, so that a reader of one array reads the batch in one go.
      for (std::size_t a = 0; a < step.Arrays.size(); ++a)
      {
        auto& array = step.Table.Arrays[a];
        for (std::size_t i = 0; i < count; ++i)
        {
          batch.Add(streams[i][a], array.Chunks[first + i]);
          this->State.Statistics.ArrayBytes[a] += streams[i][a].size();
          Include(array.Ranges, array.ChunkRanges[first + i]);
        }
      }
      batch.Write(this->State.File, SectionValues);
    },
    progress);
}

//------------------------------------------------------------------------------
void StepSection::KeepForNextStep(std::span<const void* const> values)
{
  this->Before.resize(values.size());
  for (std::size_t a = 0; a < values.size(); ++a)
  {
    const auto& array = this->State.Meta.Arrays[a];
    const auto size = this->State.GetTupleCount(array) * array.Components * SizeOf(array.Type);
    const auto* begin = static_cast<const std::uint8_t*>(values[a]);
    this->Before[a].assign(begin, begin + size);
  }
}

//------------------------------------------------------------------------------
void StepSection::Finish(std::span<const void* const> values, const StepInput& step)
{
  this->State.File.AddSection(SectionStep, step.Table.Write());
  if (this->State.Meta.HasTime)
  {
    this->KeepForNextStep(values);
    this->BeforeIsPlain = step.IsPlain;
  }
  this->LastTime = step.Table.Time;
  ++this->Count;
}
}
