// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPointSet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace gatun
{
namespace
{
using Place = std::array<double, 3>;
using Face = std::vector<std::uint8_t>;

constexpr std::size_t MostPoints = 64; // a bit each
constexpr double Flatness = 1e-6;
constexpr double Rounding = 0x1p-22; // of a few coordinates of type float, to their size

Place Subtract(const Place& a, const Place& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Place Cross(const Place& a, const Place& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double Dot(const Place& a, const Place& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** The faces of the hull, found by trying all planes through three points. */
class Hull
{
public:
  /** places: in units of their extent, in which flatness is a length, too. */
  Hull(std::span<const Place> places, double flatness)
    : Places(places)
    , MostDistance(flatness)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      if (std::find(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(i), places[i]) ==
        places.begin() + static_cast<std::ptrdiff_t>(i))
      {
        this->Points.push_back(static_cast<std::uint8_t>(i));
      }
    }
  }

  std::vector<Face> FindFaces()
  {
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      for (std::size_t j = i + 1; j < this->Points.size(); ++j)
      {
        for (std::size_t k = j + 1; k < this->Points.size(); ++k)
        {
          this->Try(this->Points[i], this->Points[j], this->Points[k]);
        }
      }
    }
    return std::move(this->Faces);
  }

private:
  /** Adds the face in the plane of three points if all other points are on one side of it. */
  void Try(std::uint8_t i, std::uint8_t j, std::uint8_t k)
  {
    const std::uint64_t three =
      std::uint64_t{ 1 } << i | std::uint64_t{ 1 } << j | std::uint64_t{ 1 } << k;
    if (std::any_of(this->Found.begin(), this->Found.end(),
          [&](std::uint64_t found) { return (found & three) == three; }))
    {
      return;
    }
    const Place& origin = this->Places[i];
    const Place along = Subtract(this->Places[j], origin);
    Place normal = Cross(along, Subtract(this->Places[k], origin));
    const double length = std::sqrt(Dot(normal, normal));
    if (length < this->MostDistance)
    {
      return; // on a line
    }
    std::uint64_t in = 0;
    bool above = false;
    bool below = false;
    for (const auto p : this->Points)
    {
      const double distance = Dot(normal, Subtract(this->Places[p], origin)) / length;
      above |= distance > this->MostDistance;
      below |= distance < -this->MostDistance;
      if (above && below)
      {
        return;
      }
      in |= std::uint64_t{ std::abs(distance) <= this->MostDistance } << p;
    }
    if (!above && !below)
    {
      return; // all points lie in the plane
    }
    if (above)
    {
      normal = { -normal[0], -normal[1], -normal[2] };
    }
    this->Found.push_back(in);
    this->Faces.push_back(this->FindPolygon(in, along, Cross(normal, along)));
  }

  /** The convex polygon around points of a plane, counterclockwise from u to v, by Andrew's chains
   * (1979). */
  Face FindPolygon(std::uint64_t in, const Place& u, const Place& v) const
  {
    struct Corner
    {
      double U;
      double V;
      std::uint8_t Point;
    };
    std::vector<Corner> corners;
    const double scale = std::sqrt(Dot(u, u) / Dot(v, v));
    for (const auto p : this->Points)
    {
      if ((in >> p & 1) != 0)
      {
        corners.push_back({ Dot(this->Places[p], u), Dot(this->Places[p], v) * scale, p });
      }
    }
    std::sort(corners.begin(), corners.end(),
      [](const Corner& a, const Corner& b)
      { return std::tie(a.U, a.V, a.Point) < std::tie(b.U, b.V, b.Point); });
    std::vector<Corner> chain;
    const auto add = [&](const Corner& next, std::size_t first)
    {
      const auto turnsLeft = [&]
      {
        const Corner& a = chain[chain.size() - 2];
        const Corner& b = chain.back();
        return (b.U - a.U) * (next.V - a.V) - (b.V - a.V) * (next.U - a.U) > 0;
      };
      while (chain.size() >= first + 2 && !turnsLeft())
      {
        chain.pop_back();
      }
      chain.push_back(next);
    };
    for (const Corner& corner : corners)
    {
      add(corner, 0);
    }
    const std::size_t turn = chain.size() - 1;
    for (std::size_t i = corners.size() - 1; i-- > 0;)
    {
      add(corners[i], turn);
    }
    Face face;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) // the first one is the last one, too
    {
      face.push_back(chain[i].Point);
    }
    return face;
  }

  const std::span<const Place> Places;
  const double MostDistance;        // of a point in a plane
  Face Points;                      // one at each place
  std::vector<std::uint64_t> Found; // the points of each face
  std::vector<Face> Faces;
};
}

//------------------------------------------------------------------------------
std::vector<std::vector<std::uint8_t>> FindHullFaces(std::span<const Place> places)
{
  if (places.size() < 4 || places.size() > MostPoints)
  {
    return {};
  }
  Place least = places[0];
  Place most = places[0];
  double largest = 0;
  for (const Place& place : places)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      least[axis] = std::min(least[axis], place[axis]);
      most[axis] = std::max(most[axis], place[axis]);
      largest = std::max(largest, std::abs(place[axis]));
    }
  }
  const Place size = Subtract(most, least);
  const double extent = std::max({ size[0], size[1], size[2] });
  std::vector<Place> scaled;
  for (const Place& place : places)
  {
    Place next = Subtract(place, least);
    for (double& x : next)
    {
      x /= extent;
      if (!std::isfinite(x))
      {
        return {};
      }
    }
    scaled.push_back(next);
  }
  return Hull(scaled, std::max(Flatness, Rounding * largest / extent)).FindFaces();
}
}
