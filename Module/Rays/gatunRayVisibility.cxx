// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayVisibility.h"

#include "gatunError.h"
#include "gatunRayTile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gatun
{
//------------------------------------------------------------------------------
RayVisibility::RayVisibility(const RayView& view, const RayTable& table, const RayLimits& limits)
  : View(view)
  , Table(table)
  , Limits(limits)
  , TilesX((view.Width + RayTile::Size - 1) / RayTile::Size)
  , TilesY((view.Height + RayTile::Size - 1) / RayTile::Size)
  , TileLimits(static_cast<std::size_t>(TilesX) * static_cast<std::size_t>(TilesY), RayTile::Always)
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

//------------------------------------------------------------------------------
void RayVisibility::LimitTiles()
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
bool RayVisibility::IsCutAway(const Bounds& box) const
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
SeenBox RayVisibility::See(const Bounds& box) const
{
  const double inf = std::numeric_limits<double>::infinity();
  SeenBox seen{ false, inf, inf, -inf, -inf, inf, -inf };
  if (!(box[0].Min <= box[0].Max))
  {
    seen.IsOutside = true; // no tetrahedra, or none with finite coordinates
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
void RayVisibility::RequireFewSamples(double farthest) const
{
  if (farthest * (this->View.Perspective ? this->MostPerDepth : 1) > RayView::MostSamples)
  {
    throw Error(ErrorCode::InvalidInput,
      "the sample distance is too small: there are more than 4 million samples to the far side of "
      "the mesh");
  }
}

//------------------------------------------------------------------------------
bool RayVisibility::IsOutOfView(const Bounds& box) const
{
  return !(box[0].Min <= box[0].Max) || this->IsCutAway(box) || this->See(box).IsOutside;
}

//------------------------------------------------------------------------------
bool RayVisibility::IsCovered(const Bounds& box) const
{
  const SeenBox seen = this->See(box);
  // In perspective, the distance of a sample is not smaller than its depth.
  const double nearest =
    this->View.Perspective ? seen.Nearest / this->View.SampleDistance : seen.Nearest;
  const auto toTile = [](double pixel, int tiles)
  { return static_cast<int>(std::clamp(pixel / RayTile::Size, 0.0, tiles - 1.0)); };
  for (int y = toTile(seen.FirstY - 1, this->TilesY); y <= toTile(seen.LastY + 1, this->TilesY);
       ++y)
  {
    for (int x = toTile(seen.FirstX - 1, this->TilesX); x <= toTile(seen.LastX + 1, this->TilesX);
         ++x)
    {
      if (nearest < this->TileLimits[this->GetTile(x, y)])
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<std::size_t> RayVisibility::FindCandidates(const RaySource& source) const
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
    // The range comes last, because it may have to be read from the file.
    if (!this->IsOutOfView(source.GetBounds(block)) &&
      !this->Table.IsTransparent(source.GetRange(block)))
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
}
