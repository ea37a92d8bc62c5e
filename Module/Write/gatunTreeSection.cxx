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
TreeSection::TreeSection(WriterState& state, const WriterPart& part)
  : State(state)
  , Part(part)
  , Layout(*state.Options.Tree, this->GetPointOrder(), state.Table)
{
  this->Tree.Merges = static_cast<std::uint32_t>(this->Layout.GetTree().GetMerges().size());
  this->Tree.MergeCounts = this->Layout.GetMergeCounts();
  this->FindBoxes();
  if (this->Tree.Merges > 0)
  {
    this->WriteMerges();
  }
}

//------------------------------------------------------------------------------
/** The point of the input for each point of the file. */
std::vector<std::uint32_t> TreeSection::GetPointOrder() const
{
  auto points = this->Part.SharedPoints;
  for (std::size_t c = 0; c < this->Part.Chunks.size(); ++c)
  {
    const auto first = points.size();
    points.resize(first + static_cast<std::size_t>(this->State.Table.Chunks[c].Info.OwnPoints));
    const auto& sources = this->Part.Chunks[c].Mesh.Walk.Sources;
    for (std::size_t v = 0; v < sources.size(); ++v)
    {
      if ((sources[v] & Topology::SharedFlag) == 0)
      {
        points[first + sources[v]] = this->Part.Chunks[c].PointOf[v];
      }
    }
  }
  const auto& unused = this->Part.Layout.UnusedPoints;
  points.insert(points.end(), unused.begin(), unused.end());
  return points;
}

//------------------------------------------------------------------------------
void TreeSection::FindBoxes()
{
  this->Tree.Boxes =
    std::vector(this->Part.Chunks.size(), std::vector<Bounds>(this->Tree.MergeCounts.size()));
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const auto ranges = this->Layout.FindRanges([&](std::uint32_t point)
      { return ArrayInput::Finite(this->Part.Mesh.GetCoordinate(point, axis)); });
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
void TreeSection::WriteMerges()
{
  StreamBatch batch;
  const bool isSurface = this->State.Options.IsSurface;
  const auto mergeable = CountMergeablePoints(this->State.Meta, isSurface);
  const auto used = this->State.Meta.Points - this->State.Meta.UnusedPoints;
  const auto& merges = this->Layout.GetTree().GetMerges();
  if (std::any_of(merges.begin(), merges.end(),
        [=](const auto& merge) { return merge.Point >= mergeable || merge.Into >= used; }))
  {
    ThrowInvalid("the tree merges points that no cell has");
  }
  const auto stream = EncodeMerges(
    this->Layout.GetTree(), mergeable, isSurface ? MergeKind::Surface : MergeKind::Tetrahedra);
  batch.Add(stream, this->Tree.Stream);
  this->State.Statistics.TreeBytes += stream.size();
  batch.Write(this->State.File, SectionMerges, 0);
}

//------------------------------------------------------------------------------
void TreeSection::AddStep(const std::vector<ArrayInput>& inputs)
{
  TreeStepTable step;
  for (const ArrayInput& input : inputs)
  {
    auto& chunks = step.Ranges.emplace_back();
    if (input.Description->Where != Association::Point)
    {
      continue;
    }
    const auto components = input.Description->Components;
    const auto count = GetRangeCount(components);
    const auto reader = input.GetReader();
    chunks.assign(this->Part.Chunks.size(),
      std::vector<ArrayRanges>(this->Tree.MergeCounts.size(), ArrayRanges(count)));
    for (std::size_t r = 0; r < count; ++r)
    {
      const int component = r < components ? static_cast<int>(r) : -1;
      const auto ranges = this->Layout.FindRanges(
        [&](std::uint32_t point)
        {
          const double value = reader.Get(point, component);
          return input.IsPoints ? ArrayInput::Finite(value) : value;
        });
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
  this->State.Steps.AddMerged(std::move(bytes));
}

//------------------------------------------------------------------------------
void TreeSection::WriteTable(std::vector<std::uint32_t> levels)
{
  this->Tree.Levels = std::move(levels);
  const auto bytes = this->Tree.Write();
  this->State.Statistics.TreeBytes += bytes.size();
  this->State.File.AddSection(SectionTree, bytes, 0);
}
}
