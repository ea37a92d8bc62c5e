// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunWriterInput.h"

#include "gatunFindCells.h"
#include "gatunPointRounding.h"

#include <algorithm>

using namespace gatun;

namespace
{
/** Copies numbers into a buffer with room for so many. */
void GiveNumbers(const std::vector<std::uint64_t>& numbers, std::uint64_t* to)
{
  if (to)
  {
    std::copy(numbers.begin(), numbers.end(), to);
  }
}

ErrorBound TakePointBound(const char* error, bool isPart)
{
  const auto bound = ParseBound(error);
  Need(bound.has_value(), "the bound of coordinates is none of abs:E, rel:E and bits:N");
  CheckPointBound(*bound);
  Need(!isPart || bound->Kind == ErrorKind::Absolute,
    "parts of a mesh need an absolute bound of coordinates, as they have other bounds each");
  return *bound;
}
}

//------------------------------------------------------------------------------
gatun_status gatun_find_remaining(const gatun_mesh* mesh, const gatun_mesh* part,
  const gatun_buffer* cells, const gatun_buffer* points, gatun_remaining* found)
{
  return Guard(
    [&]
    {
      NeedPointers(mesh, part, cells, points, found);
      const auto whole = TakeMesh(Take(mesh));
      const auto some = TakeMesh(Take(part));
      auto* const ofCells =
        TakeBuffer<std::uint64_t>(*cells, Product(some.Cells, 8), "the numbers of the cells");
      auto* const ofPoints =
        TakeBuffer<std::uint64_t>(*points, Product(some.Points, 8), "the numbers of the points");
      gatun_remaining own{};
      if (const auto remaining = FindCells(whole, some))
      {
        own.is_part = 1;
        own.drops_points = remaining->DropsPoints;
        own.points_moved = remaining->HaveMoved;
        GiveNumbers(remaining->Cells, ofCells);
        GiveNumbers(remaining->Points, ofPoints);
      }
      Give(own, found);
    });
}

//------------------------------------------------------------------------------
gatun_status gatun_round_points(const gatun_mesh* mesh, const char* error, int32_t is_part,
  const gatun_buffer* rounded, double* largest)
{
  return Guard(
    [&]
    {
      NeedPointers(mesh, error, rounded);
      const auto input = TakeMesh(Take(mesh));
      auto* const to = TakeBuffer(
        *rounded, Product(input.Points, 3 * SizeOf(input.CoordinateType)), "the coordinates");
      Need(to != nullptr, "there is no buffer for the coordinates");
      const double difference =
        RoundPoints(input, TakePointBound(error, is_part != 0), is_part == 0, to);
      if (largest)
      {
        *largest = difference;
      }
    });
}
