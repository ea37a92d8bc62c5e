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

using Blocks = RaySource::Blocks;
using Progress = RaySource::Progress;

//------------------------------------------------------------------------------
/** The chunks of one mesh. */
class CutChunks
{
public:
  CutChunks(CoarsePart part, const std::shared_ptr<CacheBudget>& budget)
    : File(part.Chunks->GetFile())
    , Mask(std::move(part.Mask))
    , Chunks(FindChunks())
    , Layout(File, *part.Tree, std::move(part.Cut), Chunks)
    , Cache(budget)
    , RoomLeft(RoomToWait + budget->GetBytes() / 4)
    , Decoded(std::move(part.Chunks))
    , Given(File->GetChunks().size())
    , HasGiven(File->GetChunks().size(), 0)
  {
    const auto step = this->Decoded->GetValues().Step;
    std::transform(this->Chunks.begin(), this->Chunks.end(), std::back_inserter(this->Boxes),
      [&](std::uint32_t chunk) { return this->Layout.GetBounds(chunk, step); });
  }

  Blocks Get(std::span<const std::size_t> chunks, const Progress& progress)
  {
    return FindOrMakeTogether(this->Cache, chunks,
      [&](std::span<const std::size_t> missing, Blocks& made)
      { this->Make(missing, made, progress); });
  }
  Range GetRange(std::uint32_t chunk) const;
  void TakeSame(CutChunks& other);

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
  void Make(std::span<const std::size_t> missing, Blocks& made, const Progress& progress);
  std::vector<std::uint32_t> FindChunks() const;
  bool IsNeeded(std::uint32_t chunk) const;
  bool IsSame(const CutChunks& other, std::uint32_t chunk) const;
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
bool CutChunks::IsNeeded(std::uint32_t chunk) const
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
std::vector<std::uint32_t> CutChunks::FindChunks() const
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
bool CutChunks::IsSame(const CutChunks& other, std::uint32_t chunk) const
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
void CutChunks::TakeSame(CutChunks& other)
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
std::vector<std::uint32_t> CutChunks::FindSources(std::span<const std::size_t> chunks) const
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
void CutChunks::Give(std::uint32_t chunk, const RayBlock& block)
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
RayPoint CutChunks::Get(std::uint32_t point) const
{
  const auto giver = this->Layout.GetGiver(point);
  return this->Given[giver][FindPlace(this->Layout.GetGiven(giver), point)];
}

//------------------------------------------------------------------------------
Waiting CutChunks::Simplify(std::uint32_t chunk, const RayBlock& whole) const
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
std::shared_ptr<const RayBlock> CutChunks::Finish(Waiting left) const
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
void CutChunks::Keep(std::uint32_t chunk, Waiting left)
{
  const auto bytes = left.GetMemorySize();
  if (bytes <= this->RoomLeft && this->Kept.emplace(chunk, std::move(left)).second)
  {
    this->RoomLeft -= bytes;
  }
}

//------------------------------------------------------------------------------
bool CutChunks::Take(std::uint32_t chunk, Waiting& left)
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
void CutChunks::Make(std::span<const std::size_t> missing, Blocks& made, const Progress& progress)
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
Range CutChunks::GetRange(std::uint32_t chunk) const
{
  const auto& values = this->Decoded->GetValues();
  const auto get = [&](std::size_t of, std::size_t merges)
  {
    return GetDrawnRange(
      this->File->GetChunkRanges(values.Array, values.Step, of, merges), values.Component);
  };
  if (this->Layout.GetCut().IsUniform())
  {
    return get(chunk, this->Layout.GetCut().GetLast());
  }
  Range all = get(chunk, 0);
  for (const auto source : this->Layout.GetSources(chunk))
  {
    all.Include(get(source, 0));
  }
  return all;
}

std::vector<CoarsePart> ListOne(CoarsePart part)
{
  std::vector<CoarsePart> list;
  list.push_back(std::move(part));
  return list;
}
}

//------------------------------------------------------------------------------
class CoarseRaySource::Internals
{
public:
  std::vector<std::unique_ptr<CutChunks>> Parts;
  std::vector<std::pair<CutChunks*, std::size_t>> Places; // of blocks: part, and number in it
};

//------------------------------------------------------------------------------
CoarseRaySource::CoarseRaySource(std::vector<CoarsePart> parts,
  const std::shared_ptr<CacheBudget>& budget, const CoarseRaySource* before)
  : Self(std::make_unique<Internals>())
{
  for (CoarsePart& part : parts)
  {
    auto& chunks =
      *this->Self->Parts.emplace_back(std::make_unique<CutChunks>(std::move(part), budget));
    for (std::size_t block = 0; block < chunks.Chunks.size(); ++block)
    {
      this->Self->Places.emplace_back(&chunks, block);
    }
    for (std::size_t i = 0; before && i < before->Self->Parts.size(); ++i)
    {
      if (before->Self->Parts[i]->Decoded == chunks.Decoded)
      {
        chunks.TakeSame(*before->Self->Parts[i]);
      }
    }
  }
}

CoarseRaySource::CoarseRaySource(
  std::shared_ptr<ChunkCache> parts, const MergeTree& tree, MergeCut cut, const RayValues& values)
  : CoarseRaySource(
      ListOne({ std::make_shared<RayChunks>(parts, values, false), &tree, std::move(cut), {} }),
      parts->GetSharedBudget(), nullptr)
{
}

CoarseRaySource::~CoarseRaySource() = default;

//------------------------------------------------------------------------------
std::size_t CoarseRaySource::GetNumberOfBlocks() const
{
  return this->Self->Places.size();
}

//------------------------------------------------------------------------------
const Bounds& CoarseRaySource::GetBounds(std::size_t block) const
{
  const auto& [part, number] = this->Self->Places[block];
  return part->Boxes[number];
}

//------------------------------------------------------------------------------
Range CoarseRaySource::GetRange(std::size_t block) const
{
  const auto& [part, number] = this->Self->Places[block];
  return part->GetRange(part->Chunks[number]);
}

//------------------------------------------------------------------------------
double CoarseRaySource::GetSimplifyTime() const
{
  double nanoseconds = 0;
  for (const auto& part : this->Self->Parts)
  {
    nanoseconds += static_cast<double>(part->SimplifyTime.load());
  }
  return 1e-9 * nanoseconds / GetNumberOfThreads();
}

//------------------------------------------------------------------------------
RaySource::Blocks CoarseRaySource::GetBlocks(
  std::span<const std::size_t> blocks, const Progress& progress)
{
  Blocks result(blocks.size());
  for (const auto& part : this->Self->Parts)
  {
    std::vector<std::size_t> chunks;
    std::vector<std::size_t> where;
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      const auto& [of, number] = this->Self->Places[blocks[i]];
      if (of == part.get())
      {
        chunks.push_back(of->Chunks[number]);
        where.push_back(i);
      }
    }
    auto made = part->Get(chunks, progress);
    for (std::size_t i = 0; i < made.size(); ++i)
    {
      result[where[i]] = std::move(made[i]);
    }
  }
  return result;
}
}
