// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTreeSection.h"

#include "gatunMergeCodec.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
TreeSection::TreeSection(
  WriterState& state, MergeTree tree, const std::function<GetValue(unsigned axis)>& getCoordinates)
  : State(state)
  , Layout(std::move(tree), state.Table)
{
  this->Tree.Merges = static_cast<std::uint32_t>(this->Layout.GetTree().GetMerges().size());
  this->Tree.MergeCounts = this->Layout.GetMergeCounts();
  this->FindBoxes(getCoordinates);
}

//------------------------------------------------------------------------------
void TreeSection::FindBoxes(const std::function<GetValue(unsigned axis)>& getCoordinates)
{
  this->Tree.Boxes = std::vector(
    this->State.Table.Chunks.size(), std::vector<Bounds>(this->Tree.MergeCounts.size()));
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const auto ranges = this->Layout.FindRanges(getCoordinates(axis));
    for (std::size_t c = 0; c < ranges.size(); ++c)
    {
      for (std::size_t mergeCount = 0; mergeCount < ranges[c].size(); ++mergeCount)
      {
        this->Tree.Boxes[c][mergeCount][axis] = ranges[c][mergeCount];
      }
    }
  }
}

//------------------------------------------------------------------------------
void TreeSection::AddPart(
  const TreeSection& mesh, std::size_t merges, std::span<const std::uint32_t> map)
{
  const bool isSurface = mesh.State.Options.IsSurface;
  const auto& meta = mesh.State.Meta;
  const auto used = meta.Points - meta.UnusedPoints;
  TreePart part;
  part.Points = CountMergeablePoints(meta, isSurface);
  const auto& all = mesh.GetTree().GetMerges();
  if (std::any_of(all.begin(), all.end(),
        [&](const auto& merge) { return merge.Point >= part.Points || merge.Into >= used; }))
  {
    ThrowInvalid("the tree merges points that no cell has");
  }
  StreamBatch batch;
  if (merges > 0)
  {
    batch.Add(EncodeMerges(mesh.GetTree(), part.Points, merges,
                isSurface ? MergeKind::Surface : MergeKind::Tetrahedra),
      part.Merges);
  }
  if (!map.empty())
  {
    batch.Add(EncodePointMap(map), part.Map);
  }
  this->State.Statistics.TreeBytes += part.Merges.Length + part.Map.Length;
  batch.Write(this->State.File, SectionMerges, 0);
  this->Tree.Parts.push_back(part);
}

//------------------------------------------------------------------------------
void TreeSection::AddDependencies(std::size_t part, const Bytes& stream)
{
  StreamBatch batch;
  batch.Add(stream, this->Tree.Parts[part].Dependencies);
  this->State.Statistics.DependencyBytes += stream.size();
  batch.Write(this->State.File, SectionDependencies, 0);
}

//------------------------------------------------------------------------------
void TreeSection::AddStep(
  const std::function<GetValue(std::size_t array, std::size_t range)>& getValues,
  std::size_t stepsAfter)
{
  TreeStepTable step;
  const auto& arrays = this->State.Meta.Arrays;
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    auto& chunks = step.Ranges.emplace_back();
    if (arrays[a].Where != Association::Point)
    {
      continue;
    }
    const auto count = GetRangeCount(arrays[a].Components);
    chunks.assign(this->State.Table.Chunks.size(),
      std::vector<ArrayRanges>(this->Tree.MergeCounts.size(), ArrayRanges(count)));
    for (std::size_t r = 0; r < count; ++r)
    {
      const auto ranges = this->Layout.FindRanges(getValues(a, r));
      for (std::size_t c = 0; c < ranges.size(); ++c)
      {
        for (std::size_t mergeCount = 0; mergeCount < ranges[c].size(); ++mergeCount)
        {
          chunks[c][mergeCount][r] = ranges[c][mergeCount];
        }
      }
    }
  }
  auto bytes = step.Write();
  this->State.Statistics.TreeBytes += bytes.size();
  this->State.Steps.AddMerged(std::move(bytes), stepsAfter);
}

//------------------------------------------------------------------------------
void TreeSection::WriteTable(std::vector<std::uint32_t> levels)
{
  this->Tree.Levels = std::move(levels);
  const auto bytes = this->Tree.Write();
  this->State.Statistics.TreeBytes += bytes.size();
  this->State.File.AddSection(SectionTree, bytes, 0);
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> FindFileNumbers(
  const WriterState& state, const WriterPart& part, std::uint64_t firstOwn)
{
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(part.Mesh.GetMesh().Points), none);
  for (std::size_t c = 0; c < part.Chunks.size(); ++c)
  {
    const auto& entry = state.Table.Chunks[part.Place.FirstChunk + c];
    const auto shared = part.GetSharedPoints(state.Table, c);
    std::size_t at = 0;
    for (const auto& run : entry.Shared)
    {
      for (std::uint64_t i = 0; i < run.Points; ++i)
      {
        numbers[shared[at++]] = static_cast<std::uint32_t>(run.FirstPoint + i);
      }
    }
    const auto& sources = part.Chunks[c].Mesh.Walk.Sources;
    for (std::size_t v = 0; v < sources.size(); ++v)
    {
      if ((sources[v] & Topology::SharedFlag) == 0)
      {
        numbers[part.Chunks[c].PointOf[v]] = static_cast<std::uint32_t>(firstOwn + sources[v]);
      }
    }
    firstOwn += entry.Info.OwnPoints;
  }
  return numbers;
}
}
