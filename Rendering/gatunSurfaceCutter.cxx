// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceCutter.h"

#include "gatunBaseMeshes.h"
#include "gatunDetailWeights.h"
#include "gatunFileReader.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace gatun
{
namespace
{
// Memory of a base mesh: a point, its normal, its merge and dependencies, two triangles, and what
// choosing takes.
constexpr std::uint64_t BytesPerPoint = 160;
}

//------------------------------------------------------------------------------
void SurfaceCutter::Clear()
{
  this->Worker.StopAndWait();
  this->Take();
  this->Bases.clear();
  this->Coarsest = nullptr;
}

//------------------------------------------------------------------------------
void SurfaceCutter::Request(SurfaceCutOrder order)
{
  this->Take();
  this->Worker.Request(
    [this, order = std::move(order)]
    {
      auto result = this->CarryOut(order, [this](double) { return this->Worker.GoOn(); });
      this->Worker.Publish([&] { this->Ready = std::move(result); });
    });
}

//------------------------------------------------------------------------------
std::optional<SurfaceCutResult> SurfaceCutter::Take()
{
  const auto lock = this->Worker.Lock();
  return std::exchange(this->Ready, std::nullopt);
}

//------------------------------------------------------------------------------
SurfaceCutResult SurfaceCutter::Make(const SurfaceCutOrder& order, const Progress& progress)
{
  this->Worker.StopAndWait();
  this->Take(); // what was ordered before takes the place of nothing any more
  return this->CarryOut(order, progress);
}

//------------------------------------------------------------------------------
SurfaceCutResult SurfaceCutter::CarryOut(const SurfaceCutOrder& order, const Progress& progress)
{
  SurfaceCutResult result;
  try
  {
    const Base base = this->FindBase(order, progress);
    if (base.Detail)
    {
      const std::size_t before = order.Source.File->GetMergesOfLevel(base.Level);
      result.Cut = std::make_shared<const SurfaceLevel>(order.Source, base.Level,
        base.Detail->Choose(order.View, order.Merges - std::min(order.Merges, before)), order.What);
    }
  }
  catch (...)
  {
    result.Failure = std::current_exception();
  }
  return result;
}

//------------------------------------------------------------------------------
/** At least the pixels of an error of 1 anywhere. */
double SurfaceCutter::BoundWeights(const SurfaceCutOrder& order, const Progress& progress)
{
  const FileReader& file = *order.Source.File->GetFile();
  const Bounds box = file.GetBounds(order.What.Step);
  const double size = GetDiagonal(box);
  if (file.GetLevels().empty())
  {
    return size > 0 ? order.View.Scale * double{ DetailWeights(order.View.View, size).Get(box) }
                    : 0;
  }
  if (!this->Coarsest)
  {
    this->Coarsest =
      ReadSurfaceDetail(*order.Source.File, file.GetLevels().size(), order.What.Step, progress);
  }
  return this->Coarsest->BoundWeights(order.View);
}

//------------------------------------------------------------------------------
/** The base mesh for an order; none if there is no room for one that is fine enough. */
SurfaceCutter::Base SurfaceCutter::FindBase(const SurfaceCutOrder& order, const Progress& progress)
{
  SharedFile& file = *order.Source.File;
  const std::uint64_t all = file.GetFile()->GetNumberOfPoints();
  const bool isCounted = order.View.Points < all;
  const auto countPoints = [&](std::size_t level) { return all - file.GetMergesOfLevel(level); };
  if (isCounted && !this->Bases.empty())
  {
    // The last one, as long as it is not much too coarse or too fine.
    const std::uint64_t points = countPoints(this->Bases.front().Level) / FinestToUniform;
    if (2 * points >= order.View.Points && points <= 4 * order.View.Points)
    {
      return this->Bases.front();
    }
  }
  const std::size_t levels = file.GetNumberOfLevels();
  std::size_t finest = 0;
  while (finest < levels && BytesPerPoint * countPoints(finest) > order.MemoryLimit)
  {
    ++finest;
  }
  if (finest == levels)
  {
    return {};
  }
  const BaseNeeds needs{ order.View.Points, order.View.PixelError,
    isCounted ? std::numeric_limits<double>::infinity() : this->BoundWeights(order, progress) };
  const std::size_t level = FindBaseMesh(file, levels - 1, finest, needs);
  if (!isCounted && level > 0 && !IsFineEnough(file, level, needs))
  {
    return {};
  }
  auto known = std::find_if(this->Bases.begin(), this->Bases.end(),
    [level](const Base& base) { return base.Level == level; });
  if (known == this->Bases.end())
  {
    // Room for the new one first.
    constexpr std::size_t kept = 1;
    this->Bases.resize(std::min(this->Bases.size(), kept));
    const std::uint64_t before = this->Bases.empty() ? 0 : countPoints(this->Bases.front().Level);
    if (BytesPerPoint * (before + countPoints(level)) > order.MemoryLimit)
    {
      this->Bases.clear();
    }
    this->Bases.push_back({ level, ReadSurfaceDetail(file, level, order.What.Step, progress) });
    known = this->Bases.end() - 1;
  }
  std::rotate(this->Bases.begin(), known, known + 1);
  return this->Bases.front();
}
}
