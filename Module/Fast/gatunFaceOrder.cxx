// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFaceOrder.h"

#include <algorithm>
#include <utility>

namespace gatun
{
namespace
{
using Ids = std::vector<std::uint32_t>;

constexpr std::uint32_t None = 0xffffffffu;

/** The points of faces in the order of their first use. */
Ids FindPoints(std::span<const std::uint32_t> faces)
{
  Ids points;
  for (std::size_t at = 0; at < faces.size(); at += 1 + faces[at])
  {
    points.insert(points.end(), faces.begin() + static_cast<std::ptrdiff_t>(at + 1),
      faces.begin() + static_cast<std::ptrdiff_t>(at + 1 + faces[at]));
  }
  // Each point's first place, found without comparing all with all.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places;
  places.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    places.emplace_back(points[i], i);
  }
  std::sort(places.begin(), places.end());
  Ids kept;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (i == 0 || places[i].first != places[i - 1].first)
    {
      kept.push_back(places[i].second);
    }
  }
  std::sort(kept.begin(), kept.end());
  std::transform(
    kept.begin(), kept.end(), kept.begin(), [&](std::uint32_t place) { return points[place]; });
  return kept;
}

/** Names the corners of faces by the first places of points. */
Ids MakePattern(std::span<const std::uint32_t> points, std::span<const std::uint32_t> faces)
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places;
  places.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    places.emplace_back(points[i], i);
  }
  std::sort(places.begin(), places.end());
  Ids pattern(faces.begin(), faces.end());
  for (std::size_t at = 0; at < pattern.size(); at += 1 + pattern[at])
  {
    for (std::size_t i = at + 1; i <= at + pattern[at]; ++i)
    {
      pattern[i] =
        std::lower_bound(places.begin(), places.end(), std::pair(pattern[i], 0u))->second;
    }
  }
  return pattern;
}

/** The sides of a closed surface, each with the one that has its edge in the other direction. */
class ClosedSurface
{
public:
  static constexpr std::size_t MaxSides = 128;

  explicit ClosedSurface(std::span<const std::uint32_t> faces)
  {
    for (std::size_t at = 0; at < faces.size(); at += 1 + faces[at])
    {
      const auto first = static_cast<std::uint32_t>(this->Points.size());
      const auto size = faces[at];
      if (size < 3 || first + size > MaxSides)
      {
        return;
      }
      for (std::uint32_t i = 0; i < size; ++i)
      {
        this->Points.push_back(faces[at + 1 + i]);
        this->Next.push_back(first + (i + 1) % size);
        this->Faces.push_back(this->FaceCount);
      }
      this->Sizes.push_back(size);
      ++this->FaceCount;
    }
    this->IsClosed = this->FindTwins();
  }

  /** Whether the surface is closed and its sides are few. */
  bool IsClosed = false;

  /** Walks over the faces, from the one of a side on. meet(point) for each new point returns
   * whether to go on. Sets the pattern, which is empty if not all faces are reached. */
  template <typename Meet>
  void Walk(std::uint32_t start, Ids& pattern, Meet&& meet)
  {
    pattern.clear();
    this->IsMet.assign(this->FaceCount, 0);
    this->Firsts.assign(1, start);
    this->IsMet[this->Faces[start]] = 1;
    this->Labels.assign(this->Points.size(), None);
    std::uint32_t met = 0;
    for (std::size_t head = 0; head < this->Firsts.size(); ++head)
    {
      auto side = this->Firsts[head];
      pattern.push_back(this->Sizes[this->Faces[side]]);
      for (auto left = pattern.back(); left > 0; --left, side = this->Next[side])
      {
        auto& label = this->Labels[this->Places[side]];
        if (label == None)
        {
          label = met++;
          if (!meet(this->Points[side]))
          {
            pattern.clear();
            return;
          }
        }
        pattern.push_back(label);
        const auto twin = this->Twins[side];
        if (std::exchange(this->IsMet[this->Faces[twin]], 1) == 0)
        {
          this->Firsts.push_back(twin);
        }
      }
    }
    if (this->Firsts.size() != this->FaceCount)
    {
      pattern.clear();
    }
  }

  std::size_t GetNumberOfSides() const { return this->Points.size(); }

private:
  bool FindTwins()
  {
    const auto count = static_cast<std::uint32_t>(this->Points.size());
    this->Twins.assign(count, None);
    this->Places.resize(count);
    for (std::uint32_t a = 0; a < count; ++a)
    {
      this->Places[a] = static_cast<std::uint32_t>(
        std::find(this->Points.begin(), this->Points.end(), this->Points[a]) -
        this->Points.begin());
      const auto from = this->Points[a];
      const auto to = this->Points[this->Next[a]];
      for (std::uint32_t b = 0; b < count; ++b)
      {
        const auto otherFrom = this->Points[b];
        const auto otherTo = this->Points[this->Next[b]];
        if (from == to || (b != a && otherFrom == from && otherTo == to) ||
          (otherFrom == to && otherTo == from && std::exchange(this->Twins[a], b) != None))
        {
          return false;
        }
      }
      if (this->Twins[a] == None)
      {
        return false;
      }
    }
    return count > 0;
  }

  Ids Points; // at which each side begins
  Ids Next;
  Ids Faces;
  Ids Twins;
  Ids Places; // the first side with the same point
  Ids Sizes;  // of faces
  std::uint32_t FaceCount = 0;

  // Of a walk.
  std::vector<char> IsMet; // by face
  Ids Firsts;              // the first side of each face
  Ids Labels;              // of the places of points
};

/** Orders a closed surface: of all walks the one that meets new points last, of those the one with
 * the least pattern. */
bool OrderClosed(std::span<const std::uint32_t> faces,
  const std::function<bool(std::uint32_t)>& isNew, OrderedFaces& best)
{
  ClosedSurface surface(faces);
  if (!surface.IsClosed)
  {
    return false;
  }
  std::vector<char> leastNews;
  OrderedFaces other;
  std::vector<char> news;
  for (std::uint32_t side = 0; side < surface.GetNumberOfSides(); ++side)
  {
    other.Points.clear();
    news.clear();
    bool isBehind = false; // whether it is better already
    surface.Walk(side, other.Pattern,
      [&](std::uint32_t point)
      {
        other.Points.push_back(point);
        news.push_back(isNew(point) ? 1 : 0);
        if (best.Pattern.empty() || isBehind)
        {
          return true;
        }
        const auto least = leastNews[news.size() - 1];
        isBehind = news.back() < least;
        return news.back() <= least;
      });
    if (!other.Pattern.empty() &&
      (best.Pattern.empty() || isBehind || other.Pattern < best.Pattern))
    {
      std::swap(best, other);
      std::swap(leastNews, news);
    }
  }
  return !best.Pattern.empty();
}
}

//------------------------------------------------------------------------------
OrderedFaces OrderFaces(std::span<const std::uint32_t> corners,
  std::span<const std::uint32_t> faces, const std::function<bool(std::uint32_t)>& isNew)
{
  OrderedFaces result;
  const auto ofFaces = FindPoints(faces);
  Ids sorted(corners.begin(), corners.end());
  std::sort(sorted.begin(), sorted.end());
  auto other = ofFaces;
  std::sort(other.begin(), other.end());
  if (sorted == other)
  {
    if (!OrderClosed(faces, isNew, result))
    {
      result.Points = ofFaces;
      result.Pattern = MakePattern(result.Points, faces);
    }
    return result;
  }
  result.Points.assign(corners.begin(), corners.end());
  for (const auto point : ofFaces)
  {
    if (!std::binary_search(sorted.begin(), sorted.end(), point))
    {
      result.Points.push_back(point);
      ++result.Hidden;
    }
  }
  result.Pattern = MakePattern(result.Points, faces);
  return result;
}
}
