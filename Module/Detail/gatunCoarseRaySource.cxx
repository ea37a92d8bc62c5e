// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunCoarseRaySource.h"

#include "gatunChunkCache.h"
#include "gatunCoarseLayout.h"
#include "gatunError.h"
#include "gatunParallel.h"
#include "gatunRayBlockCache.h"
#include "gatunRayBlockMaker.h"
#include "gatunRayChunks.h"
#include "gatunRayDecoder.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <unordered_map>
#include <vector>

namespace gatun
{
namespace
{
/** The place of a number in an ascending list; the length of the list if it is not there. */
std::size_t FindPlace(std::span<const std::uint32_t> list, std::uint32_t wanted)
{
  const auto found = std::lower_bound(list.begin(), list.end(), wanted);
  return found != list.end() && *found == wanted ? static_cast<std::size_t>(found - list.begin())
                                                 : list.size();
}

/** A simplified chunk without the corners that it gets from other chunks. */
struct Waiting
{
  /** A corner from another chunk: its place in Points, and its number in the file. */
  struct Foreign
  {
    std::uint32_t Place;
    std::uint32_t Point;
  };

  std::vector<MergeTree::Tet> Tets;
  std::vector<double> CellValues; // if these are drawn
  std::vector<RayPoint> Points;   // those from other chunks are not set yet
  std::vector<Foreign> Others;

  std::uint64_t GetMemorySize() const
  {
    return this->Tets.capacity() * sizeof(MergeTree::Tet) +
      this->CellValues.capacity() * sizeof(double) + this->Points.capacity() * sizeof(RayPoint) +
      this->Others.capacity() * sizeof(Foreign);
  }
};

/** Marks a chunk that need not be decoded. */
constexpr std::uint32_t NoChunk = 0xffffffffu;

/** The memory of waiting chunks is limited to this and a quarter of the budget. */
constexpr std::uint64_t RoomToWait = std::uint64_t{ 32 } << 20;

bool IsAt(const std::vector<bool>& flags, std::uint32_t point, bool ifEmpty)
{
  return flags.empty() ? ifEmpty : flags[point];
}
}

//------------------------------------------------------------------------------
class CoarseRaySource::Internals
{
public:
  Internals(std::shared_ptr<RayChunks> decoded, const MergeTree& tree, MergeCut cut,
    CoarseMask mask, const std::shared_ptr<CacheBudget>& budget)
    : File(decoded->GetFile())
    , Mask(std::move(mask))
    , Chunks(FindChunks())
    , Layout(File, tree, std::move(cut), Chunks)
    , Cache(budget)
    , RoomLeft(RoomToWait + budget->GetBytes() / 4)
    , Decoded(std::move(decoded))
    , Given(File->GetChunks().size())
    , HasGiven(File->GetChunks().size(), 0)
  {
    this->FindBoxes();
  }

  void Make(std::span<const std::size_t> missing, Blocks& made, const Progress& progress);
  void TakeSame(Internals& other);

  std::shared_ptr<const FileReader> File;
  CoarseMask Mask;
  std::vector<std::uint32_t> Chunks; // for each block, ascending
  CoarseLayout Layout;
  std::vector<Bounds> Boxes;                  // of the blocks
  RayBlockCache Cache;                        // by chunks
  std::atomic<std::int64_t> SimplifyTime = 0; // in nanoseconds, summed over threads
  std::uint64_t RoomLeft;                     // for waiting chunks
  std::shared_ptr<RayChunks> Decoded;

private:
  std::vector<std::uint32_t> FindChunks() const;
  bool IsNeeded(std::uint32_t chunk) const;
  void FindBoxes();
  bool IsSame(const Internals& other, std::uint32_t chunk) const;
  std::vector<std::uint32_t> FindSources(std::span<const std::size_t> chunks) const;
  void Give(std::uint32_t chunk, const RayBlock& block);
  RayPoint Get(std::uint32_t point) const;
  Waiting Simplify(std::uint32_t chunk, const RayBlock& whole) const;
  std::shared_ptr<const RayBlock> Finish(Waiting left) const;
  void Keep(std::uint32_t chunk, Waiting left);
  bool Take(std::uint32_t chunk, Waiting& left);

  // For each decoded chunk: the points that CoarseLayout::GetGiven lists.
  std::vector<std::vector<RayPoint>> Given;
  std::vector<char> HasGiven;

  // Chunks that were decoded because others needed them, and have not been requested yet.
  std::unordered_map<std::uint32_t, Waiting> Kept;
};

//------------------------------------------------------------------------------
/** Whether a chunk may have tetrahedra that are drawn. */
bool CoarseRaySource::Internals::IsNeeded(std::uint32_t chunk) const
{
  bool isAnyFine = false;
  bool isAnyNextCoarse = false;
  CoarseLayout::EachRun(*this->File, chunk,
    [&](std::uint32_t first, std::uint32_t last)
    {
      for (auto point = first; point < last; ++point)
      {
        isAnyFine = isAnyFine || !IsAt(this->Mask.TooCoarse, point, false);
        isAnyNextCoarse = isAnyNextCoarse || IsAt(this->Mask.NextTooCoarse, point, true);
      }
    });
  return isAnyFine && isAnyNextCoarse;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> CoarseRaySource::Internals::FindChunks() const
{
  std::vector<std::uint32_t> chunks;
  for (std::uint32_t chunk = 0; chunk < this->File->GetChunks().size(); ++chunk)
  {
    if (this->IsNeeded(chunk))
    {
      chunks.push_back(chunk);
    }
  }
  return chunks;
}

//------------------------------------------------------------------------------
/** The box of a chunk and of those whose points are ancestors of its points encloses it after the
 * merges, and so does the one that the file has for all merges up to the last one. */
void CoarseRaySource::Internals::FindBoxes()
{
  const MergeCut& cut = this->Layout.GetCut();
  const auto step = this->Decoded->GetValues().Step;
  for (const auto chunk : this->Chunks)
  {
    Bounds& box = this->Boxes.emplace_back(this->File->GetChunkBounds(chunk, cut.GetLast(), step));
    if (!cut.IsUniform())
    {
      Bounds parts = this->File->GetChunkBounds(chunk, 0, step);
      for (const auto source : this->Layout.GetSources(chunk))
      {
        parts.Include(this->File->GetChunkBounds(source, 0, step));
      }
      for (std::size_t axis = 0; axis < box.size(); ++axis)
      {
        box[axis].Min = std::max(box[axis].Min, parts[axis].Min);
        box[axis].Max = std::min(box[axis].Max, parts[axis].Max);
      }
    }
  }
}

//------------------------------------------------------------------------------
bool CoarseRaySource::Internals::IsSame(const Internals& other, std::uint32_t chunk) const
{
  bool isSame = true;
  CoarseLayout::EachRun(*this->File, chunk,
    [&](std::uint32_t first, std::uint32_t last)
    {
      for (auto point = first; isSame && point < last; ++point)
      {
        isSame = this->Layout.GetAncestors()[point] == other.Layout.GetAncestors()[point] &&
          IsAt(this->Mask.TooCoarse, point, false) == IsAt(other.Mask.TooCoarse, point, false) &&
          IsAt(this->Mask.NextTooCoarse, point, true) ==
            IsAt(other.Mask.NextTooCoarse, point, true);
      }
    });
  return isSame;
}

//------------------------------------------------------------------------------
void CoarseRaySource::Internals::TakeSame(Internals& other)
{
  for (const auto chunk : this->Chunks)
  {
    auto block = other.Cache.Find(chunk);
    if (block && this->IsSame(other, chunk))
    {
      this->Cache.Add(chunk, std::move(block));
    }
  }
}

//------------------------------------------------------------------------------
/** Chunks that have not yet given the points that others get from them. */
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
Waiting CoarseRaySource::Internals::Simplify(std::uint32_t chunk, const RayBlock& whole) const
{
  // The ancestor of each point: its place in the chunk or, behind these, among the others.
  const auto points = this->Layout.GetPoints(chunk);
  const auto isDrawn = [&](const MergeTree::Tet& tet)
  {
    return std::none_of(tet.begin(), tet.end(),
             [&](auto corner) { return IsAt(this->Mask.TooCoarse, points[corner], false); }) &&
      std::any_of(tet.begin(), tet.end(),
        [&](auto corner) { return IsAt(this->Mask.NextTooCoarse, points[corner], true); });
  };
  std::vector<std::uint32_t> ancestors(points.size());
  std::vector<std::uint32_t> others;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto ancestor = this->Layout.GetAncestors()[points[i]];
    const auto place = ancestor == points[i] ? i : FindPlace(points, ancestor);
    ancestors[i] = static_cast<std::uint32_t>(place);
    if (place == points.size())
    {
      others.push_back(ancestor);
    }
  }
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (ancestors[i] == points.size())
    {
      ancestors[i] +=
        static_cast<std::uint32_t>(FindPlace(others, this->Layout.GetAncestors()[points[i]]));
    }
  }
  Waiting left;
  std::vector<std::uint32_t> places(points.size() + others.size(), 0); // 1: is a corner
  for (std::size_t cell = 0; cell < whole.Tets.size(); ++cell)
  {
    auto tet = whole.Tets[cell];
    if (isDrawn(tet) && gatun::Simplify(tet, ancestors))
    {
      left.Tets.push_back(tet);
      if (!whole.CellValues.empty())
      {
        left.CellValues.push_back(whole.CellValues[cell]);
      }
      for (const auto corner : tet)
      {
        places[corner] = 1;
      }
    }
  }
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i] == 0)
    {
      continue;
    }
    places[i] = static_cast<std::uint32_t>(left.Points.size());
    if (i < points.size())
    {
      left.Points.push_back(whole.Points[i]);
    }
    else
    {
      left.Others.push_back({ places[i], others[i - points.size()] });
      left.Points.push_back({});
    }
  }
  for (auto& tet : left.Tets)
  {
    for (auto& corner : tet)
    {
      corner = places[corner];
    }
  }
  return left;
}

//------------------------------------------------------------------------------
std::shared_ptr<const RayBlock> CoarseRaySource::Internals::Finish(Waiting left) const
{
  auto block = std::make_shared<RayBlock>();
  block->Tets = std::move(left.Tets);
  block->CellValues = std::move(left.CellValues);
  block->Points = std::move(left.Points);
  for (const auto& other : left.Others)
  {
    block->Points[other.Place] = this->Get(other.Point);
  }
  block->Prepare();
  return block;
}

//------------------------------------------------------------------------------
/** Keeps a chunk until it is requested, if there is room for it. */
void CoarseRaySource::Internals::Keep(std::uint32_t chunk, Waiting left)
{
  const auto bytes = left.GetMemorySize();
  if (bytes <= this->RoomLeft && this->Kept.emplace(chunk, std::move(left)).second)
  {
    this->RoomLeft -= bytes;
  }
}

//------------------------------------------------------------------------------
bool CoarseRaySource::Internals::Take(std::uint32_t chunk, Waiting& left)
{
  const auto found = this->Kept.find(chunk);
  if (found == this->Kept.end())
  {
    return false;
  }
  this->RoomLeft += found->second.GetMemorySize();
  left = std::move(found->second);
  this->Kept.erase(found);
  return true;
}

//------------------------------------------------------------------------------
void CoarseRaySource::Internals::Make(
  std::span<const std::size_t> missing, Blocks& made, const Progress& progress)
{
  // First the chunks that only give corners, then the requested ones that are not waiting yet.
  auto chunks = this->FindSources(missing);
  const auto sources = chunks.size();
  std::vector<Waiting> left(sources);
  std::vector<std::size_t> places; // of the requested chunks, in left
  for (const auto chunk : missing)
  {
    places.push_back(left.size());
    left.emplace_back();
    if (!this->Take(static_cast<std::uint32_t>(chunk), left.back()))
    {
      chunks.resize(left.size(), NoChunk);
      chunks.back() = static_cast<std::uint32_t>(chunk);
    }
  }
  chunks.resize(left.size(), NoChunk);
  const double share =
    static_cast<double>(left.size()) / static_cast<double>(left.size() + missing.size());
  ParallelFor(
    left.size(),
    [&](std::size_t i)
    {
      if (chunks[i] != NoChunk)
      {
        const auto block = this->Decoded->Get(chunks[i]);
        const auto start = std::chrono::steady_clock::now();
        this->Give(chunks[i], *block);
        left[i] = this->Simplify(chunks[i], *block);
        this->SimplifyTime += std::chrono::duration_cast<std::chrono::nanoseconds>(
          std::chrono::steady_clock::now() - start)
                                .count();
      }
    },
    [&](double done) { return !progress || progress(share * done); });
  for (std::size_t i = 0; i < sources; ++i)
  {
    this->Keep(chunks[i], std::move(left[i]));
  }
  ParallelFor(
    missing.size(), [&](std::size_t i) { made[i] = this->Finish(std::move(left[places[i]])); },
    [&](double done) { return !progress || progress(share + (1 - share) * done); });
}

//------------------------------------------------------------------------------
CoarseRaySource::CoarseRaySource(std::shared_ptr<const FileReader> file, const MergeTree& tree,
  MergeCut cut, const RayValues& values, std::uint64_t budget)
{
  const auto forParts = GetBudgetForParts(budget);
  this->Self = std::make_unique<Internals>(
    std::make_shared<RayChunks>(
      std::make_shared<ChunkCache>(std::move(file), forParts), values, false),
    tree, std::move(cut), CoarseMask{}, std::make_shared<CacheBudget>(budget - forParts));
}

CoarseRaySource::CoarseRaySource(
  std::shared_ptr<ChunkCache> parts, const MergeTree& tree, MergeCut cut, const RayValues& values)
{
  const auto budget = parts->GetSharedBudget();
  this->Self =
    std::make_unique<Internals>(std::make_shared<RayChunks>(std::move(parts), values, false), tree,
      std::move(cut), CoarseMask{}, budget);
}

CoarseRaySource::CoarseRaySource(std::shared_ptr<RayChunks> chunks,
  std::shared_ptr<CacheBudget> budget, const MergeTree& tree, MergeCut cut, CoarseMask mask,
  const CoarseRaySource* other)
  : Self(std::make_unique<Internals>(
      std::move(chunks), tree, std::move(cut), std::move(mask), std::move(budget)))
{
  if (other && other->Self->Decoded == this->Self->Decoded)
  {
    this->Self->TakeSame(*other->Self);
  }
}

CoarseRaySource::~CoarseRaySource() = default;

//------------------------------------------------------------------------------
std::size_t CoarseRaySource::GetNumberOfBlocks() const
{
  return this->Self->Chunks.size();
}

//------------------------------------------------------------------------------
std::uint32_t CoarseRaySource::GetChunk(std::size_t block) const
{
  return this->Self->Chunks[block];
}

//------------------------------------------------------------------------------
const Bounds& CoarseRaySource::GetBounds(std::size_t block) const
{
  return this->Self->Boxes[block];
}

//------------------------------------------------------------------------------
Range CoarseRaySource::GetRange(std::size_t block) const
{
  const auto& values = this->Self->Decoded->GetValues();
  const CoarseLayout& layout = this->Self->Layout;
  const auto get = [&](std::size_t chunk, std::size_t merges)
  {
    return GetDrawnRange(
      this->Self->File->GetChunkRanges(values.Array, values.Step, chunk, merges), values.Component);
  };
  const auto chunk = this->Self->Chunks[block];
  if (layout.GetCut().IsUniform())
  {
    return get(chunk, layout.GetCut().GetLast());
  }
  Range all = get(chunk, 0);
  for (const auto source : layout.GetSources(chunk))
  {
    all.Include(get(source, 0));
  }
  return all;
}

//------------------------------------------------------------------------------
double CoarseRaySource::GetSimplifyTime() const
{
  return 1e-9 * static_cast<double>(this->Self->SimplifyTime.load()) / GetNumberOfThreads();
}

//------------------------------------------------------------------------------
RaySource::Blocks CoarseRaySource::GetBlocks(
  std::span<const std::size_t> blocks, const Progress& progress)
{
  std::vector<std::size_t> chunks(blocks.size());
  std::transform(blocks.begin(), blocks.end(), chunks.begin(),
    [&](std::size_t block) { return this->GetChunk(block); });
  return FindOrMakeTogether(this->Self->Cache, chunks,
    [&](std::span<const std::size_t> missing, Blocks& made)
    { this->Self->Make(missing, made, progress); });
}
}
