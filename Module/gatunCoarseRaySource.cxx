// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunCoarseRaySource.h"

#include "gatunChunkCache.h"
#include "gatunCoarseLayout.h"
#include "gatunError.h"
#include "gatunParallel.h"
#include "gatunRaySourceInternals.h"

#include <algorithm>
#include <vector>

namespace gatun
{
namespace
{
/** The place of something in an ascending list; the list's length if it is not there. */
std::size_t FindPlace(std::span<const std::uint32_t> list, std::uint32_t wanted)
{
  const auto found = std::lower_bound(list.begin(), list.end(), wanted);
  return found != list.end() && *found == wanted ? static_cast<std::size_t>(found - list.begin())
                                                 : list.size();
}
}

//------------------------------------------------------------------------------
class CoarseRaySource::Internals
{
public:
  Internals(std::shared_ptr<const FileReader> file, const MergeTree& tree, std::size_t merges,
    const RayValues& values, std::uint64_t forBlocks, std::uint64_t forParts)
    : File(std::move(file))
    , Layout(File, tree, merges)
    , Values(values)
    , Cache(forBlocks)
    , Parts(std::make_shared<ChunkCache>(File, forParts))
    , Given(File->GetChunks().size())
    , HasGiven(File->GetChunks().size(), 0)
  {
  }

  void Make(std::span<const std::size_t> missing, Blocks& made, const Progress& progress);

  std::shared_ptr<const FileReader> File;
  CoarseLayout Layout;
  RayValues Values;
  RayBlockCache Cache;
  std::shared_ptr<ChunkCache> Parts;

private:
  std::vector<std::uint32_t> FindSources(std::span<const std::size_t> chunks) const;
  void Give(std::uint32_t chunk, const RayBlock& block);
  RayPoint Get(std::uint32_t point) const;
  std::shared_ptr<const RayBlock> Simplify(std::uint32_t chunk, const RayBlock& whole) const;

  // Of each chunk: what CoarseLayout::GetGiven lists, once it has been decoded.
  std::vector<std::vector<RayPoint>> Given;
  std::vector<char> HasGiven;
};

//------------------------------------------------------------------------------
/** Chunks that others get points from, and that have not given them yet. */
std::vector<std::uint32_t> CoarseRaySource::Internals::FindSources(
  std::span<const std::size_t> chunks) const
{
  std::vector<std::uint32_t> sources;
  for (const auto chunk : chunks)
  {
    for (const auto source : this->Layout.GetSources(static_cast<std::uint32_t>(chunk)))
    {
      if (this->HasGiven[source] == 0 &&
        std::find(chunks.begin(), chunks.end(), source) == chunks.end())
      {
        sources.push_back(source);
      }
    }
  }
  std::sort(sources.begin(), sources.end());
  sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
  return sources;
}

//------------------------------------------------------------------------------
void CoarseRaySource::Internals::Give(std::uint32_t chunk, const RayBlock& block)
{
  if (this->HasGiven[chunk] != 0)
  {
    return;
  }
  const auto points = this->Layout.GetPoints(chunk);
  for (const auto given : this->Layout.GetGiven(chunk))
  {
    this->Given[chunk].push_back(block.Points[FindPlace(points, given)]);
  }
  this->HasGiven[chunk] = 1;
}

//------------------------------------------------------------------------------
RayPoint CoarseRaySource::Internals::Get(std::uint32_t point) const
{
  const auto giver = this->Layout.GetGiver(point);
  return this->Given[giver][FindPlace(this->Layout.GetGiven(giver), point)];
}

//------------------------------------------------------------------------------
std::shared_ptr<const RayBlock> CoarseRaySource::Internals::Simplify(
  std::uint32_t chunk, const RayBlock& whole) const
{
  const auto points = this->Layout.GetPoints(chunk);
  std::vector<std::uint32_t> ancestors(points.size());
  std::transform(points.begin(), points.end(), ancestors.begin(),
    [&](std::uint32_t point) { return this->Layout.GetAncestors()[point]; });
  auto block = std::make_shared<RayBlock>();
  for (std::size_t cell = 0; cell < whole.Tets.size(); ++cell)
  {
    auto tet = whole.Tets[cell];
    if (gatun::Simplify(tet, ancestors))
    {
      block->Tets.push_back(tet);
      if (!whole.CellValues.empty())
      {
        block->CellValues.push_back(whole.CellValues[cell]);
      }
    }
  }
  std::vector<std::uint32_t> used;
  for (const auto& tet : block->Tets)
  {
    used.insert(used.end(), tet.begin(), tet.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (auto& tet : block->Tets)
  {
    for (auto& corner : tet)
    {
      corner = static_cast<std::uint32_t>(FindPlace(used, corner));
    }
  }
  block->Points.reserve(used.size());
  for (const auto point : used)
  {
    const auto place = FindPlace(points, point);
    block->Points.push_back(place < points.size() ? whole.Points[place] : this->Get(point));
  }
  block->Prepare();
  return block;
}

//------------------------------------------------------------------------------
void CoarseRaySource::Internals::Make(
  std::span<const std::size_t> missing, Blocks& made, const Progress& progress)
{
  const auto sources = this->FindSources(missing);
  const auto all = sources.size() + missing.size();
  const double share = static_cast<double>(all) / static_cast<double>(all + missing.size());
  std::vector<RayBlock> whole(missing.size());
  ParallelFor(
    all,
    [&](std::size_t i)
    {
      const bool isSource = i < sources.size();
      const auto chunk =
        isSource ? sources[i] : static_cast<std::uint32_t>(missing[i - sources.size()]);
      auto block = DecodeRayBlock(this->Parts, this->Values, chunk);
      this->Give(chunk, block);
      if (!isSource)
      {
        whole[i - sources.size()] = std::move(block);
      }
    },
    [&](double done) { return !progress || progress(share * done); });
  made.resize(missing.size());
  ParallelFor(
    missing.size(),
    [&](std::size_t i)
    {
      made[i] = this->Simplify(static_cast<std::uint32_t>(missing[i]), whole[i]);
      whole[i] = {};
    },
    [&](double done) { return !progress || progress(share + (1 - share) * done); });
}

//------------------------------------------------------------------------------
CoarseRaySource::CoarseRaySource(std::shared_ptr<const FileReader> file, const MergeTree& tree,
  std::size_t merges, const RayValues& values, std::uint64_t budget)
{
  CheckRayValues(*file, values);
  if (merges > tree.GetMerges().size() || tree.GetNumberOfPoints() != file->GetNumberOfPoints())
  {
    ThrowInvalid(file->GetPath() + ": there are not so many merges");
  }
  const auto forParts = GetBudgetForParts(budget);
  this->Self =
    std::make_unique<Internals>(std::move(file), tree, merges, values, budget - forParts, forParts);
}

CoarseRaySource::~CoarseRaySource() = default;

//------------------------------------------------------------------------------
std::size_t CoarseRaySource::GetNumberOfBlocks() const
{
  return this->Self->File->GetChunks().size();
}

//------------------------------------------------------------------------------
const Bounds& CoarseRaySource::GetBounds(std::size_t block) const
{
  return this->Self->File->GetChunkBounds(block, this->Self->Layout.GetMerges());
}

//------------------------------------------------------------------------------
Range CoarseRaySource::GetRange(std::size_t block) const
{
  const auto& values = this->Self->Values;
  return GetDrawnRange(this->Self->File->GetChunkRanges(
                         values.Array, values.Step, block, this->Self->Layout.GetMerges()),
    values.Component);
}

//------------------------------------------------------------------------------
RaySource::Blocks CoarseRaySource::GetBlocks(
  std::span<const std::size_t> blocks, const Progress& progress)
{
  return FindOrMakeTogether(this->Self->Cache, blocks,
    [&](std::span<const std::size_t> missing, Blocks& made)
    { this->Self->Make(missing, made, progress); });
}
}
