// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayCaster.h"

#include "gatunError.h"
#include "gatunParallel.h"
#include "gatunRayBins.h"
#include "gatunRayFragments.h"
#include "gatunRayKernel.h"
#include "gatunRayPixel.h"
#include "gatunRayTile.h"
#include "gatunRayVisibility.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

namespace gatun
{
namespace
{
/** Adds its lifetime to a sum. */
class Timed
{
public:
  explicit Timed(double& sum)
    : Sum(sum)
  {
  }
  ~Timed()
  {
    this->Sum +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

private:
  double& Sum;
  const std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

/** A block in use. */
struct Work
{
  RayBins Bins;
  bool HasItems = false;
  double OrderTime = 0;
  double SetUpTime = 0;
};

/** A tile, once it is needed, and its times. */
struct TileSlot
{
  std::unique_ptr<RayTile> Tile;
  double DrawTime = 0;
  double FinishTime = 0;
  std::size_t MostFragments = 0;
  bool IsLeftOut = false;
};
}

//------------------------------------------------------------------------------
class RayCaster::Internals
{
public:
  RayView View;
  RayTable Table;
  RayLimits Limits;
  RaySettings Settings;
  const RayKernel& Kernel;
  int TilesX;
  int TilesY;
  std::vector<TileSlot> Tiles;
  RayVisibility Visibility;
  std::vector<Work> Works;
  RayStatistics Statistics;

  Internals(
    const RayView& view, RayTable table, const RayLimits& limits, const RaySettings& settings)
    : View(view)
    , Table(std::move(table))
    , Limits(limits)
    , Settings(settings)
    , Kernel(GetRayKernel(settings.Instructions))
    , TilesX((view.Width + RayTile::Size - 1) / RayTile::Size)
    , TilesY((view.Height + RayTile::Size - 1) / RayTile::Size)
    , Tiles(static_cast<std::size_t>(TilesX) * static_cast<std::size_t>(TilesY))
    , Visibility(View, Table, Limits)
  {
  }

  int GetX(std::size_t tile) const { return static_cast<int>(tile) % this->TilesX * RayTile::Size; }
  int GetY(std::size_t tile) const { return static_cast<int>(tile) / this->TilesX * RayTile::Size; }

  RayFilter GetFilter() const
  {
    // Without samples, every tetrahedron on a ray counts.
    return !this->Settings.Prefilter         ? RayFilter::None
      : this->Table.Mode == RayMode::Sampled ? RayFilter::Samples
                                             : RayFilter::Pixels;
  }

  /** Null for none. */
  const RayShading* GetShading() const
  {
    const bool hasSurfaces =
      this->Table.Mode == RayMode::Composite || this->Table.Mode == RayMode::Sampled;
    return hasSurfaces && this->Settings.Shading ? &*this->Settings.Shading : nullptr;
  }

  /** Null for none. */
  const RayColoring* GetColoring() const
  {
    return this->Table.Mode != RayMode::Maximum && this->Settings.Coloring
      ? &*this->Settings.Coloring
      : nullptr;
  }

  template <typename Skips, typename Use>
  void TakeTurns(RaySource& source, const Progress& progress, Skips&& skips, Use&& use);
  std::span<Work> SetBlocks(std::span<const std::shared_ptr<const RayBlock>> blocks);
  std::unique_ptr<RayTile> MakeTile(std::size_t index) const;
  void DrawTile(std::size_t index, std::span<const Work> works);
  void FinishTile(TileSlot& slot, int x0, int y0, float* rgba, float* depth) const;
  void CountMemory();
};

//------------------------------------------------------------------------------
std::unique_ptr<RayTile> RayCaster::Internals::MakeTile(std::size_t index) const
{
  const RayView& view = this->View;
  const int x0 = this->GetX(index);
  const int y0 = this->GetY(index);
  const int width = std::min(view.Width - x0, RayTile::Size);
  const int height = std::min(view.Height - y0, RayTile::Size);
  auto tile = std::make_unique<RayTile>(width, height);
  const bool whole = this->Table.Mode == RayMode::Sampled;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const int cell = RayTile::ToCell(x, y);
      RayPixels& block = tile->GetBlock(cell);
      const unsigned lane = RayTile::ToLane(cell);
      const double perDepth = view.GetSamplesPerDepth(x0 + x, y0 + y);
      block.LengthPerDepth[lane] = static_cast<float>(perDepth);
      block.DepthPerLength[lane] = static_cast<float>(1 / perDepth);
      double near = std::max(0.0, view.Near * perDepth);
      double far = view.Far * perDepth;
      if (!this->Limits.Near.empty())
      {
        const auto pixel = static_cast<std::size_t>(y0 + y) * static_cast<std::size_t>(view.Width) +
          static_cast<std::size_t>(x0 + x);
        near = std::max<double>(near, this->Limits.Near[pixel]);
        far = std::min<double>(far, this->Limits.Far[pixel]);
      }
      far = std::clamp<double>(far, -RayTile::Always, RayTile::Always);
      near = std::clamp<double>(near, 0, far < 0 ? 0 : far);
      block.Near[lane] = static_cast<float>(whole ? std::ceil(near) : near);
      block.Far[lane] = static_cast<float>(whole ? std::ceil(far) : far);
    }
  }
  return tile;
}

//------------------------------------------------------------------------------
void RayCaster::Internals::DrawTile(std::size_t index, std::span<const Work> works)
{
  TileSlot& slot = this->Tiles[index];
  const Timed timed(slot.DrawTime);
  const DrawContext context{ this->View.Perspective, this->Table.Cells.data(),
    this->Table.Pieces.All.data(), this->Settings.Opaque };
  for (const Work& work : works)
  {
    if (!work.HasItems)
    {
      continue;
    }
    TetItems items = work.Bins.GetItems(index);
    items.FirstX = this->GetX(index);
    items.FirstY = this->GetY(index);
    if (items.Count == 0)
    {
      continue;
    }
    if (!slot.Tile)
    {
      slot.Tile = this->MakeTile(index);
    }
    this->Kernel.Draw(this->Table.Mode, context, items, *slot.Tile);
    this->Visibility.SetTileLimit(index, slot.Tile->Limit);
    slot.MostFragments = std::max(slot.MostFragments, slot.Tile->CountFragments());
  }
}

//------------------------------------------------------------------------------
void RayCaster::Internals::FinishTile(
  TileSlot& slot, int x0, int y0, float* rgba, float* depth) const
{
  const Timed timed(slot.FinishTime);
  RayTile* const tile = slot.Tile.get();
  if (tile)
  {
    tile->Consolidate();
  }
  const auto width = static_cast<std::size_t>(this->View.Width);
  std::size_t next = 0; // of the others
  std::vector<Fragment> fragments;
  for (int cell = 0; cell < RayTile::Pixels; ++cell)
  {
    const int x = x0 + RayTile::ToX(cell);
    const int y = y0 + RayTile::ToY(cell);
    if (x >= this->View.Width || y >= this->View.Height)
    {
      continue;
    }
    Fragment sum = NoFragment();
    float largest = RayTile::Never;
    if (tile)
    {
      sum = tile->Get(0, cell);
      largest = sum.End;
      const auto& others = tile->Others;
      const auto isNext = [&]
      { return next < others.size() && others[next].Cell == static_cast<std::uint32_t>(cell); };
      const Fragment second = tile->Get(1, cell);
      if (second.End != RayTile::Never || isNext())
      {
        fragments.assign({ sum, second });
        for (; isNext(); ++next)
        {
          fragments.push_back(others[next]);
        }
        sum = CompositeFragments(fragments);
      }
    }
    const auto at = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
    ToPixel(this->Table, sum, largest, rgba + 4 * at);
    if (depth)
    {
      depth[at] = sum.First == -RayTile::Never
        ? std::numeric_limits<float>::infinity()
        : static_cast<float>(sum.First * this->View.SampleDistance);
    }
  }
}

//------------------------------------------------------------------------------
void RayCaster::Internals::CountMemory()
{
  std::uint64_t bytes = 0;
  for (const Work& work : this->Works)
  {
    bytes += work.Bins.GetMemorySize();
  }
  std::uint64_t fragments = 0;
  for (const TileSlot& slot : this->Tiles)
  {
    fragments += slot.MostFragments;
    if (slot.Tile)
    {
      bytes += sizeof(RayTile) + slot.Tile->Others.capacity() * sizeof(Fragment);
    }
  }
  this->Statistics.MostBytes = std::max(this->Statistics.MostBytes, bytes);
  this->Statistics.MostFragments = std::max(this->Statistics.MostFragments, fragments);
}

//------------------------------------------------------------------------------
RayCaster::RayCaster(
  const RayView& view, RayTable table, const RayLimits& limits, const RaySettings& settings)
  : Self(std::make_unique<Internals>(view, std::move(table), limits, settings))
{
}

RayCaster::~RayCaster() = default;

//------------------------------------------------------------------------------
/** Calls use(blocks) for the blocks of a source, as many at a time as there are threads. Skips the
 * blocks for which skips(block) returns true when their turn has come. */
template <typename Skips, typename Use>
void RayCaster::Internals::TakeTurns(
  RaySource& source, const Progress& progress, Skips&& skips, Use&& use)
{
  const auto candidates = this->Visibility.FindCandidates(source);
  this->Statistics.SkippedBlocks += source.GetNumberOfBlocks() - candidates.size();
  const auto most = static_cast<std::size_t>(GetNumberOfThreads());
  std::vector<std::size_t> turn;
  std::size_t next = 0;
  while (next < candidates.size())
  {
    if (progress && !progress(static_cast<double>(next) / static_cast<double>(candidates.size())))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
    turn.clear();
    const auto first = next;
    for (; next < candidates.size() &&
         (this->Settings.Repeatable ? next - first : turn.size()) < most;
         ++next)
    {
      if (skips(candidates[next]))
      {
        ++this->Statistics.SkippedBlocks;
      }
      else
      {
        turn.push_back(candidates[next]);
      }
    }
    RaySource::Blocks blocks;
    {
      const Timed timed(this->Statistics.FetchTime);
      const double before = source.GetSimplifyTime();
      blocks = source.GetBlocks(turn, {});
      this->Statistics.SimplifyTime += source.GetSimplifyTime() - before;
    }
    use(blocks);
  }
}

//------------------------------------------------------------------------------
void RayCaster::Draw(RaySource& source, const Progress& progress)
{
  this->Self->TakeTurns(
    source, progress,
    [&](std::size_t block) { return this->Self->Visibility.IsCovered(source.GetBounds(block)); },
    [&](const RaySource::Blocks& blocks) { this->Draw(blocks); });
}

//------------------------------------------------------------------------------
/** Projects blocks, each with its own Work. */
std::span<Work> RayCaster::Internals::SetBlocks(
  std::span<const std::shared_ptr<const RayBlock>> blocks)
{
  if (this->Works.size() < blocks.size())
  {
    this->Works.resize(blocks.size());
  }
  const std::span<Work> works(this->Works.data(), blocks.size());
  const RayFilter filter = this->GetFilter();
  const auto from = this->Settings.FromBothEnds ? ReleaseFrom::Both : ReleaseFrom::Front;
  ParallelFor(blocks.size(),
    [&](std::size_t i)
    {
      const Timed timed(works[i].OrderTime);
      works[i].Bins.SetBlock(this->Kernel, this->View, this->Table, *blocks[i], filter, from);
    });
  return works;
}

//------------------------------------------------------------------------------
std::size_t RayCaster::GetNumberOfTiles() const
{
  return this->Self->Tiles.size();
}

//------------------------------------------------------------------------------
std::vector<std::uint64_t> RayCaster::GetFingerprints(RaySource& source, const Progress& progress)
{
  auto& self = *this->Self;
  std::vector<std::uint64_t> result(self.Tiles.size(), 0);
  // The last call of the kernel for each tile. The boundaries of calls affect the result, too.
  std::vector<std::uint64_t> calls(self.Tiles.size(), 0);
  std::uint64_t call = 0;
  self.TakeTurns(
    source, progress, [](std::size_t) { return false; },
    [&](const RaySource::Blocks& blocks)
    {
      const auto works = self.SetBlocks(blocks);
      bool hasItems = true;
      while (hasItems)
      {
        hasItems = false;
        for (Work& work : works)
        {
          ++call;
          hasItems |= work.Bins.Skim(self.TilesX,
            [&](std::size_t tile, std::uint64_t fingerprint)
            {
              const std::uint64_t isFirst = calls[tile] == call ? 0 : 1;
              calls[tile] = call;
              result[tile] = MixFingerprints(result[tile], fingerprint + isFirst);
            });
        }
      }
    });
  return result;
}

//------------------------------------------------------------------------------
void RayCaster::Restrict(std::span<const std::uint8_t> tiles)
{
  auto& self = *this->Self;
  for (std::size_t tile = 0; tile < self.Tiles.size(); ++tile)
  {
    if (tiles[tile] == 0)
    {
      self.Tiles[tile].IsLeftOut = true;
      self.Visibility.SetTileLimit(tile, RayTile::Never);
    }
  }
}

//------------------------------------------------------------------------------
void RayCaster::Draw(std::span<const std::shared_ptr<const RayBlock>> blocks)
{
  auto& self = *this->Self;
  const auto works = self.SetBlocks(blocks);
  const SetUpContext context{ &self.View, self.TilesX, self.Visibility.GetTileLimits(),
    self.Table.VisibleCells.data(), RayTable::Size,
    self.Table.Pieces.OfCells.empty() ? nullptr : self.Table.Pieces.OfCells.data(), self.Table.Low,
    self.Table.Scale };
  for (;;)
  {
    ParallelFor(works.size(),
      [&](std::size_t i)
      {
        const Timed timed(works[i].SetUpTime);
        works[i].HasItems = works[i].Bins.Fill(self.Kernel, context, self.GetShading(),
          self.GetColoring(), self.Tiles.size(), self.Settings.Repeatable);
      });
    if (std::none_of(works.begin(), works.end(), [](const Work& work) { return work.HasItems; }))
    {
      break;
    }
    ParallelFor(self.Tiles.size(), [&](std::size_t tile) { self.DrawTile(tile, works); });
  }
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    ++self.Statistics.Blocks;
    self.Statistics.Tets += blocks[i]->Tets.size();
    self.Statistics.SeenTets += works[i].Bins.GetNumberOfSeenTets();
    self.Statistics.MostWaiting =
      std::max<std::uint64_t>(self.Statistics.MostWaiting, works[i].Bins.GetMostWaiting());
  }
  self.CountMemory();
}

//------------------------------------------------------------------------------
void RayCaster::Finish(float* rgba, float* depth)
{
  auto& self = *this->Self;
  ParallelFor(self.Tiles.size(),
    [&](std::size_t tile)
    {
      if (!self.Tiles[tile].IsLeftOut)
      {
        self.FinishTile(self.Tiles[tile], self.GetX(tile), self.GetY(tile), rgba, depth);
      }
    });
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> RayCaster::TakeFragments(
  std::span<const std::size_t> tiles, bool withDepths)
{
  auto& self = *this->Self;
  std::vector<ByteWriter> parts(tiles.size());
  ParallelFor(tiles.size(),
    [&](std::size_t i)
    {
      TileSlot& slot = self.Tiles[tiles[i]];
      if (slot.Tile)
      {
        const Timed timed(slot.FinishTime);
        WriteFragments(self.Table.Mode, tiles[i], *slot.Tile, withDepths, parts[i]);
        slot.Tile.reset();
      }
    });
  std::size_t size = 0;
  for (const ByteWriter& part : parts)
  {
    size += part.Data.size();
  }
  std::vector<std::uint8_t> message;
  message.reserve(size);
  for (ByteWriter& part : parts)
  {
    message.insert(message.end(), part.Data.begin(), part.Data.end());
    part = {};
  }
  return message;
}

//------------------------------------------------------------------------------
RayStatistics RayCaster::GetStatistics() const
{
  RayStatistics result = this->Self->Statistics;
  for (const Work& work : this->Self->Works)
  {
    result.OrderTime += work.OrderTime;
    result.SetUpTime += work.SetUpTime;
  }
  for (const TileSlot& slot : this->Self->Tiles)
  {
    result.DrawTime += slot.DrawTime;
    result.FinishTime += slot.FinishTime;
  }
  return result;
}

//------------------------------------------------------------------------------
const char* RayCaster::GetInstructions() const
{
  return this->Self->Kernel.Name;
}
}
