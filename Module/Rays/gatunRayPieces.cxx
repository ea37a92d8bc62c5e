// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayPieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
namespace
{
using Entry = std::array<double, 4>;

/** A place of the table with its entry. */
struct Knot
{
  double Place;
  Entry Value;
};

double GetDistance(const Entry& a, const Entry& b)
{
  double most = 0;
  for (std::size_t c = 0; c < 4; ++c)
  {
    most = std::max(most, std::abs(a[c] - b[c]));
  }
  return most;
}

Entry Interpolate(const Knot& a, const Knot& b, double place)
{
  const double part = b.Place > a.Place ? (place - a.Place) / (b.Place - a.Place) : 0;
  Entry result;
  for (std::size_t c = 0; c < 4; ++c)
  {
    result[c] = a.Value[c] + part * (b.Value[c] - a.Value[c]);
  }
  return result;
}

/** Whether the function steps between two knots. If so, they move to both sides of the step. */
bool FindStep(const RayEntry& getEntry, Knot& low, Knot& high)
{
  constexpr int halvings = 14;
  constexpr int decisive = 6;
  const double whole = GetDistance(low.Value, high.Value);
  for (int i = 0; i < halvings; ++i)
  {
    const double place = (low.Place + high.Place) / 2;
    const Knot middle{ place, getEntry(place) };
    const bool isBelow =
      GetDistance(low.Value, middle.Value) > GetDistance(middle.Value, high.Value);
    (isBelow ? high : low) = middle;
    if (i < decisive && GetDistance(low.Value, high.Value) < 0.9 * whole)
    {
      return false;
    }
  }
  return true;
}

/** The table between two steps or changes of visibility: linear between knots. */
struct Stretch
{
  std::vector<Knot> Knots;
  bool IsVisible = false;

  Entry Get(double place) const
  {
    const auto after = std::upper_bound(this->Knots.begin() + 1, this->Knots.end() - 1, place,
      [](double value, const Knot& knot) { return value < knot.Place; });
    return Interpolate(*(after - 1), *after, place);
  }

  /** Makes the piece between two knots: parabolas through both ends and the middle. Returns whether
   * they are exact enough. */
  bool Fit(std::size_t first, std::size_t last, RayPiece& piece) const;
};

bool Stretch::Fit(std::size_t first, std::size_t last, RayPiece& piece) const
{
  constexpr double tolerance = 1.0 / 4096;
  const Knot& low = this->Knots[first];
  const Knot& high = this->Knots[last];
  const double half = (high.Place - low.Place) / 2;
  const double center = low.Place + half;
  const Entry middle = this->Get(center);
  piece.From = static_cast<float>(low.Place);
  piece.To = static_cast<float>(high.Place);
  piece.Center = static_cast<float>(center);
  std::array<std::array<double, 3>, 4> c{};
  for (std::size_t channel = 0; channel < 4; ++channel)
  {
    const double change = high.Value[channel] - low.Value[channel];
    const double bend = high.Value[channel] + low.Value[channel] - 2 * middle[channel];
    c[channel] = { middle[channel], change / (2 * half), bend / (2 * half * half) };
    piece.C0[channel] = static_cast<float>(c[channel][0]);
    piece.C1[channel] = static_cast<float>(c[channel][1]);
    piece.C2[channel] = static_cast<float>(c[channel][2]);
  }
  if (last - first == 1)
  {
    return true;
  }
  Entry largest{};
  Entry deviation{};
  const auto check = [&](double place, const Entry& value)
  {
    const double x = place - center;
    for (std::size_t channel = 0; channel < 4; ++channel)
    {
      const auto& [c0, c1, c2] = c[channel];
      largest[channel] = std::max(largest[channel], std::abs(value[channel]));
      deviation[channel] =
        std::max(deviation[channel], std::abs(c0 + x * (c1 + x * c2) - value[channel]));
    }
  };
  for (auto i = first; i < last; ++i)
  {
    const Knot& knot = this->Knots[i];
    const Knot& next = this->Knots[i + 1];
    const double between = (knot.Place + next.Place) / 2;
    check(knot.Place, knot.Value);
    check(between, Interpolate(knot, next, between));
  }
  check(high.Place, high.Value);
  for (std::size_t channel = 0; channel < 4; ++channel)
  {
    if (deviation[channel] > tolerance * largest[channel])
    {
      return false;
    }
  }
  return true;
}

std::vector<Stretch> FindStretches(const RayEntry& getEntry, std::size_t cells)
{
  std::vector<Stretch> stretches(1);
  const auto getKnot = [&](std::size_t cell)
  {
    const auto place = static_cast<double>(cell);
    return Knot{ place, getEntry(place) };
  };
  const auto isVisible = [](const Knot& a, const Knot& b)
  { return a.Value[3] != 0 || b.Value[3] != 0; };
  Knot high = getKnot(0);
  stretches.back().Knots.push_back(high);
  const auto addLine = [&](const Knot& from, const Knot& to)
  {
    const bool visible = isVisible(from, to);
    Stretch& last = stretches.back();
    const bool continues = last.Knots.back().Value == from.Value;
    if (last.Knots.size() > 1 && (!continues || last.IsVisible != visible))
    {
      stretches.push_back({ { from, to }, visible });
      return;
    }
    last.IsVisible = visible;
    last.Knots.back() = from;
    last.Knots.push_back(to);
  };
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    const Knot low = high;
    high = getKnot(cell + 1);
    Knot below = low;
    Knot above = high;
    if (low.Value != high.Value && FindStep(getEntry, below, above))
    {
      // Both sides of the step are at the same place.
      below.Place = above.Place = std::clamp(
        (below.Place + above.Place) / 2, low.Place + 1.0 / 4096, high.Place - 1.0 / 4096);
      addLine(low, below);
      addLine(above, high);
    }
    else
    {
      addLine(low, high);
    }
  }
  return stretches;
}

/** Beyond the ends of the table, colors are those of its ends. */
RayPiece MakeConstantPiece(const Entry& value, float from, float to)
{
  RayPiece piece;
  piece.From = from;
  piece.To = to;
  for (std::size_t channel = 0; channel < 4; ++channel)
  {
    piece.C0[channel] = static_cast<float>(value[channel]);
  }
  return piece;
}

/** Adds the longest piece of a stretch that begins at a knot. Returns the knot where it ends. */
std::size_t AddLongest(const Stretch& stretch, std::size_t first, std::vector<RayPiece>& pieces)
{
  const std::size_t end = stretch.Knots.size() - 1;
  RayPiece piece;
  stretch.Fit(first, first + 1, piece);
  std::size_t last = first + 1;
  // Grow by steps of double size, then by steps of half the size.
  bool grows = true;
  for (std::size_t step = 1; step > 0; step = grows ? 2 * step : step / 2)
  {
    RayPiece longer;
    const bool fits = last + step <= end && stretch.Fit(first, last + step, longer);
    grows &= fits;
    if (fits)
    {
      last += step;
      piece = longer;
    }
  }
  pieces.push_back(piece);
  return last;
}
}

//------------------------------------------------------------------------------
RayPieces MakeRayPieces(const RayEntry& getEntry, std::size_t cells)
{
  constexpr float endless = 1e30f;
  RayPieces pieces;
  pieces.All.push_back(MakeConstantPiece(getEntry(0), -endless, 0));
  for (const Stretch& stretch : FindStretches(getEntry, cells))
  {
    for (std::size_t knot = 0; knot + 1 < stretch.Knots.size();)
    {
      knot = AddLongest(stretch, knot, pieces.All);
    }
  }
  std::size_t piece = 0;
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    while (pieces.All[piece].To <= static_cast<float>(cell))
    {
      ++piece;
    }
    const auto first = static_cast<std::uint16_t>(piece);
    while (pieces.All[piece].To < static_cast<float>(cell + 1))
    {
      ++piece;
    }
    pieces.OfCells.push_back({ first, static_cast<std::uint16_t>(piece) });
  }
  const auto last = static_cast<std::uint16_t>(piece);
  pieces.OfCells.push_back({ last, last });
  const auto top = static_cast<double>(cells);
  pieces.All.push_back(MakeConstantPiece(getEntry(top), static_cast<float>(top), endless));
  return pieces;
}
}
