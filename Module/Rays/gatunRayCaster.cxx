// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayCaster.h"

#include "gatunError.h"
#include "gatunParallel.h"
#include "gatunRayBins.h"
#include "gatunRayKernel.h"
#include "gatunRayTile.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

namespace gatun
{
namespace
{
/** Adds the time of its life to a sum. */
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

/** A block at work. */
struct Work
{
  RayBins Bins;
  bool HasItems = false;
  double OrderTime = 0;
  double SetUpTime = 0;
};

/** A tile, or room for one, and its times. */
struct TileSlot
{
  std::unique_ptr<RayTile> Tile;
  double DrawTime = 0;
  double FinishTime = 0;
  std::size_t MostFragments = 0;
  bool IsLeftOut = false;
};

/** Where a box is seen. */
struct SeenBox
{
  bool IsOutside = false;
  double FirstX = 0, FirstY = 0, LastX = 0, LastY = 0; // pixels
  double Nearest = 0, Farthest = 0;                    // depth in units of z in ray coordinates
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
  std::vector<float> TileLimits; // what is behind them is in none of the tile's pixels
  double MostPerDepth;           // samples, of all pixels
  std::vector<Work> Works;
  RayStatistics Statistics;

  Internals(
    const RayView& view, RayTable table, const RayLimits& limits, const RaySettings& settings)
    : View(view)
    , Table(std::move(table))
    , Limits(limits)
    , Settings(settings)
    , Kernel(settings.Portable ? GetPortableRayKernel() : GetBestRayKernel())
    , TilesX((view.Width + RayTile::Size - 1) / RayTile::Size)
    , TilesY((view.Height + RayTile::Size - 1) / RayTile::Size)
    , Tiles(static_cast<std::size_t>(TilesX) * static_cast<std::size_t>(TilesY))
    , TileLimits(Tiles.size(), RayTile::Always)
    , MostPerDepth(0)
  {
    for (const int x : { 0, view.Width })
    {
      for (const int y : { 0, view.Height })
      {
        this->MostPerDepth = std::max(this->MostPerDepth, view.GetSamplesPerDepth(x, y));
      }
    }
    if (!limits.Far.empty())
    {
      this->LimitTiles();
    }
  }

  std::size_t GetTile(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(this->TilesX) +
      static_cast<std::size_t>(x);
  }
  int GetX(std::size_t tile) const { return static_cast<int>(tile) % this->TilesX * RayTile::Size; }
  int GetY(std::size_t tile) const { return static_cast<int>(tile) / this->TilesX * RayTile::Size; }

  RayFilter GetFilter() const
  {
    // In mode Area there are no samples that a tetrahedron could be between.
    return !this->Settings.Prefilter      ? RayFilter::None
      : this->Table.Mode == RayMode::Area ? RayFilter::Pixels
                                          : RayFilter::Samples;
  }

  /** Null for none. */
  const RayShading* GetShading() const
  {
    const bool hasSurfaces =
      this->Table.Mode == RayMode::Composite || this->Table.Mode == RayMode::Area;
    return hasSurfaces && this->Settings.Shading ? &*this->Settings.Shading : nullptr;
  }

  void LimitTiles();
  std::vector<std::size_t> FindCandidates(const RaySource& source);
  template <typename Skips, typename Use>
  void TakeTurns(RaySource& source, const Progress& progress, Skips&& skips, Use&& use);
  std::span<Work> SetBlocks(std::span<const std::shared_ptr<const RayBlock>> blocks);
  bool IsNeverSeen(const Bounds& box, const Range& values) const;
  bool IsCutAway(const Bounds& box) const;
  std::unique_ptr<RayTile> MakeTile(std::size_t index) const;
  void DrawTile(std::size_t index, std::span<const Work> works);
  void FinishTile(TileSlot& slot, int x0, int y0, float* rgba, float* depth) const;
  void Colour(const Fragment& sum, float largest, float* rgba) const;
  SeenBox See(const Bounds& box) const;
  void RequireFewSamples(double farthest) const;
  void CountMemory();
};

//------------------------------------------------------------------------------
/** Blocks behind the limits of all pixels need not be fetched. With a sample to spare. */
void RayCaster::Internals::LimitTiles()
{
  std::fill(this->TileLimits.begin(), this->TileLimits.end(), RayTile::Never);
  const auto width = static_cast<std::size_t>(this->View.Width);
  for (int y = 0; y < this->View.Height; ++y)
  {
    for (int x = 0; x < this->View.Width; ++x)
    {
      const auto pixel = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
      const float near = this->Limits.Near[pixel];
      const float far = this->Limits.Far[pixel];
      if (near < far)
      {
        const auto tile = this->GetTile(x / RayTile::Size, y / RayTile::Size);
        this->TileLimits[tile] =
          std::max(this->TileLimits[tile], std::min(far + 1, RayTile::Always));
      }
    }
  }
}

//------------------------------------------------------------------------------
/** Whether all of a box is on the negative side of a plane, beyond rounding. */
bool RayCaster::Internals::IsCutAway(const Bounds& box) const
{
  return std::any_of(this->Limits.Planes.begin(), this->Limits.Planes.end(),
    [&](const std::array<double, 4>& plane)
    {
      double most = plane[3];
      double size = std::abs(plane[3]);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double first = plane[axis] * box[axis].Min;
        const double last = plane[axis] * box[axis].Max;
        most += std::max(first, last);
        size += std::max(std::abs(first), std::abs(last));
      }
      return most < -1e-6 * size;
    });
}

//------------------------------------------------------------------------------
std::unique_ptr<RayTile> RayCaster::Internals::MakeTile(std::size_t index) const
{
  const RayView& view = this->View;
  const int x0 = this->GetX(index);
  const int y0 = this->GetY(index);
  const int width = std::min(view.Width - x0, RayTile::Size);
  const int height = std::min(view.Height - y0, RayTile::Size);
  auto tile = std::make_unique<RayTile>(width, height);
  const bool whole = this->Table.Mode != RayMode::Area;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const int cell = y * RayTile::Stride + x;
      const double perDepth = view.GetSamplesPerDepth(x0 + x, y0 + y);
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
      tile->Near[cell] = static_cast<float>(whole ? std::ceil(near) : near);
      tile->Far[cell] = static_cast<float>(whole ? std::ceil(far) : far);
    }
  }
  return tile;
}

//------------------------------------------------------------------------------
void RayCaster::Internals::DrawTile(std::size_t index, std::span<const Work> works)
{
  TileSlot& slot = this->Tiles[index];
  const Timed timed(slot.DrawTime);
  const DrawContext context{ &this->View, this->Table.Cells.data(), this->Settings.Opaque,
    this->GetX(index), this->GetY(index) };
  for (const Work& work : works)
  {
    if (!work.HasItems)
    {
      continue;
    }
    const TetItems items = work.Bins.GetItems(index);
    if (items.Count == 0)
    {
      continue;
    }
    if (!slot.Tile)
    {
      slot.Tile = this->MakeTile(index);
    }
    this->Kernel.Draw(this->Table.Mode, context, items, *slot.Tile);
    this->TileLimits[index] = slot.Tile->Limit;
    slot.MostFragments = std::max(slot.MostFragments, slot.Tile->CountFragments());
  }
}

//------------------------------------------------------------------------------
void RayCaster::Internals::Colour(const Fragment& sum, float largest, float* rgba) const
{
  std::array<float, 4> colour{};
  switch (this->Table.Mode)
  {
    case RayMode::Composite:
    case RayMode::Area:
      colour = { sum.Sum[0], sum.Sum[1], sum.Sum[2], 1 - sum.Sum[3] };
      break;
    case RayMode::Maximum:
      if (largest != RayTile::Never)
      {
        const RayTable::Cell& cell = this->Table.Cells[static_cast<std::size_t>(largest)];
        const float fraction = largest - std::floor(largest);
        for (std::size_t c = 0; c < 4; ++c)
        {
          colour[c] = cell.Value[c] + fraction * cell.Change[c];
        }
        colour[3] = -colour[3];
      }
      break;
    case RayMode::XRay:
      if (const float depth = sum.Sum[3] - 1; depth > 0)
      {
        const float opacity = -std::expm1(-depth);
        colour = { sum.Sum[0] / depth * opacity, sum.Sum[1] / depth * opacity,
          sum.Sum[2] / depth * opacity, opacity };
      }
      break;
  }
  std::copy(colour.begin(), colour.end(), rgba);
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
  auto other = tile ? tile->Others.cbegin() : std::vector<Fragment>::const_iterator{};
  std::vector<Fragment> fragments;
  for (int pixel = 0; pixel < RayTile::Pixels; ++pixel)
  {
    const int x = x0 + pixel % RayTile::Size;
    const int y = y0 + pixel / RayTile::Size;
    Fragment sum{ 0, 0, -RayTile::Never, 0, { 0, 0, 0, 1 } };
    float largest = RayTile::Never;
    if (tile)
    {
      fragments.clear();
      for (; other != tile->Others.cend() && other->Pixel == static_cast<std::uint32_t>(pixel);
           ++other)
      {
        fragments.push_back(*other);
      }
      for (int i = 0; i < RayTile::Slots; ++i)
      {
        fragments.push_back(tile->Get(i, pixel));
      }
      std::sort(fragments.begin(), fragments.end(),
        [](const Fragment& a, const Fragment& b) { return a.Begin < b.Begin; });
      for (const Fragment& fragment : fragments)
      {
        sum.Append(fragment);
      }
      largest = tile->End[0][RayTile::ToCell(pixel)];
    }
    if (x < this->View.Width && y < this->View.Height)
    {
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(this->View.Width) +
        static_cast<std::size_t>(x);
      this->Colour(sum, largest, rgba + 4 * at);
      if (depth)
      {
        depth[at] = sum.First == -RayTile::Never
          ? std::numeric_limits<float>::infinity()
          : static_cast<float>(sum.First * this->View.SampleDistance);
      }
    }
  }
}

//------------------------------------------------------------------------------
SeenBox RayCaster::Internals::See(const Bounds& box) const
{
  const double inf = std::numeric_limits<double>::infinity();
  SeenBox seen{ false, inf, inf, -inf, -inf, inf, -inf };
  if (!(box[0].Min <= box[0].Max))
  {
    seen.IsOutside = true; // of a block whose tetrahedra are all hidden, or have no place
    return seen;
  }
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const auto get = [&](unsigned axis)
    { return (corner >> axis & 1) != 0 ? box[axis].Max : box[axis].Min; };
    const auto p = this->View.Transform({ get(0), get(1), get(2) });
    const double perDepth = this->View.Perspective ? 1 / p[2] : 1;
    const bool inFront = !this->View.Perspective || p[2] > 0;
    seen.FirstX = std::min(seen.FirstX, inFront ? p[0] * perDepth : -inf);
    seen.FirstY = std::min(seen.FirstY, inFront ? p[1] * perDepth : -inf);
    seen.LastX = std::max(seen.LastX, inFront ? p[0] * perDepth : inf);
    seen.LastY = std::max(seen.LastY, inFront ? p[1] * perDepth : inf);
    seen.Nearest = std::min(seen.Nearest, p[2]);
    seen.Farthest = std::max(seen.Farthest, p[2]);
  }
  const double perUnit = this->View.Perspective ? 1 : this->View.SampleDistance;
  seen.IsOutside = seen.LastX < -1 || seen.LastY < -1 || seen.FirstX > this->View.Width ||
    seen.FirstY > this->View.Height || seen.Farthest < 0 ||
    seen.Farthest * perUnit < this->View.Near || seen.Nearest * perUnit > this->View.Far;
  return seen;
}

//------------------------------------------------------------------------------
/** Depth in units of z in ray coordinates. */
void RayCaster::Internals::RequireFewSamples(double farthest) const
{
  if (farthest * (this->View.Perspective ? this->MostPerDepth : 1) > RayView::MostSamples)
  {
    throw Error(ErrorCode::InvalidInput,
      "the sample distance is too small: there are more than 4 million of them to the far side of "
      "the mesh");
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
/** Whether such values in a box cannot be seen, whatever else there is. */
bool RayCaster::Internals::IsNeverSeen(const Bounds& box, const Range& values) const
{
  return this->Table.IsTransparent(values) || !(box[0].Min <= box[0].Max) || this->IsCutAway(box) ||
    this->See(box).IsOutside;
}

//------------------------------------------------------------------------------
bool RayCaster::IsHidden(const Bounds& box, const Range& values) const
{
  const auto& self = *this->Self;
  if (self.IsNeverSeen(box, values))
  {
    return true;
  }
  const SeenBox seen = self.See(box);
  // In perspective, samples are not nearer than depth says.
  const double nearest =
    self.View.Perspective ? seen.Nearest / self.View.SampleDistance : seen.Nearest;
  const auto toTile = [](double pixel, int tiles)
  { return static_cast<int>(std::clamp(pixel / RayTile::Size, 0.0, tiles - 1.0)); };
  for (int y = toTile(seen.FirstY - 1, self.TilesY); y <= toTile(seen.LastY + 1, self.TilesY); ++y)
  {
    for (int x = toTile(seen.FirstX - 1, self.TilesX); x <= toTile(seen.LastX + 1, self.TilesX);
         ++x)
    {
      if (nearest < self.TileLimits[self.GetTile(x, y)])
      {
        return false;
      }
    }
  }
  return true;
}

/** The blocks of a source that may be seen, the nearest first. */
std::vector<std::size_t> RayCaster::Internals::FindCandidates(const RaySource& source)
{
  struct Candidate
  {
    std::size_t Block;
    double Depth;
  };
  std::vector<Candidate> candidates;
  double farthest = 0;
  for (std::size_t block = 0; block < source.GetNumberOfBlocks(); ++block)
  {
    const SeenBox seen = this->See(source.GetBounds(block));
    farthest = seen.IsOutside ? farthest : std::max(farthest, seen.Farthest);
    if (this->IsNeverSeen(source.GetBounds(block), source.GetRange(block)))
    {
      ++this->Statistics.SkippedBlocks;
    }
    else
    {
      candidates.push_back({ block, seen.Nearest + seen.Farthest });
    }
  }
  this->RequireFewSamples(farthest);
  std::sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b)
    { return a.Depth != b.Depth ? a.Depth < b.Depth : a.Block < b.Block; });
  std::vector<std::size_t> blocks;
  for (const Candidate& candidate : candidates)
  {
    blocks.push_back(candidate.Block);
  }
  return blocks;
}

//------------------------------------------------------------------------------
/** Calls use(blocks) for the blocks of a source, as many at a time as there are threads. Those are
 * left out that skips says when their turn has come. */
template <typename Skips, typename Use>
void RayCaster::Internals::TakeTurns(
  RaySource& source, const Progress& progress, Skips&& skips, Use&& use)
{
  const auto candidates = this->FindCandidates(source);
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
      blocks = source.GetBlocks(turn, {});
    }
    use(blocks);
  }
}

//------------------------------------------------------------------------------
void RayCaster::Draw(RaySource& source, const Progress& progress)
{
  this->Self->TakeTurns(
    source, progress,
    [&](std::size_t block)
    { return this->IsHidden(source.GetBounds(block), source.GetRange(block)); },
    [&](const RaySource::Blocks& blocks) { this->Draw(blocks); });
}

//------------------------------------------------------------------------------
/** Brings blocks into view, each in a work of its own. */
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
  // Which call of the kernel was the last for a tile: when one ends matters, too.
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
      self.TileLimits[tile] = RayTile::Never;
    }
  }
}

//------------------------------------------------------------------------------
void RayCaster::Draw(std::span<const std::shared_ptr<const RayBlock>> blocks)
{
  auto& self = *this->Self;
  const auto works = self.SetBlocks(blocks);
  const SetUpContext context{ &self.View, self.TilesX, self.TileLimits.data(),
    self.Table.VisibleCells.data(), RayTable::Size, self.Table.Low, self.Table.Scale };
  for (;;)
  {
    ParallelFor(works.size(),
      [&](std::size_t i)
      {
        const Timed timed(works[i].SetUpTime);
        works[i].HasItems = works[i].Bins.Fill(
          self.Kernel, context, self.GetShading(), self.Tiles.size(), self.Settings.Repeatable);
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
