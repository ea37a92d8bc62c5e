// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunVolumeDetail.h"

#include "gatunDetailWeights.h"
#include "gatunError.h"

#include <algorithm>

namespace gatun
{
namespace
{
/** The values at a place. */
Range GetValues(const VolumeDetail::Place& place)
{
  return place.Values.IsEmpty() ? Range{ place.Point.Value, place.Point.Value } : place.Values;
}
}

//------------------------------------------------------------------------------
VolumeDetail::VolumeDetail(CutChooser chooser, std::vector<Place> places,
  std::vector<std::uint32_t> placeOf, std::vector<std::uint32_t> open, double size)
  : Chooser(std::move(chooser))
  , Places(std::move(places))
  , PlaceOf(std::move(placeOf))
  , Open(std::move(open))
  , Size(size > 0 ? size : 1)
{
  const auto isKnown = [&](std::uint32_t place) { return place <= this->Places.size(); };
  if (this->PlaceOf.size() != this->GetTree().GetNumberOfPoints() ||
    !std::all_of(this->PlaceOf.begin(), this->PlaceOf.end(), isKnown))
  {
    ThrowInvalid("there is not a place for each point");
  }
}

//------------------------------------------------------------------------------
MergeCut VolumeDetail::Choose(const DetailView& view, std::uint64_t points) const
{
  auto ofPlaces = DetailWeights(view.View, this->Size)
                    .GetAll(
                      this->Places.size(),
                      [&](std::size_t i)
                      {
                        const RayPoint& point = this->Places[i].Point;
                        return DetailWeights::Point{ point.X, point.Y, point.Z };
                      },
                      [&](std::size_t i)
                      {
                        const bool isHidden =
                          view.Table && view.Table->IsTransparent(GetValues(this->Places[i]));
                        return isHidden ? 0.0 : 1.0;
                      });
  float ofOpen = 0;
  for (const auto place : this->Open)
  {
    ofOpen = std::max(ofOpen, ofPlaces[place]);
  }
  ofPlaces.push_back(ofOpen);
  std::vector<float> weights(this->PlaceOf.size());
  std::transform(this->PlaceOf.begin(), this->PlaceOf.end(), weights.begin(),
    [&](std::uint32_t place) { return ofPlaces[place]; });
  return this->Chooser.Choose(weights, { points, view.PixelError });
}
}
