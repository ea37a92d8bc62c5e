// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunStrips.h"

#include <cstddef>
#include <unordered_map>

namespace gatun
{
namespace
{
/** An edge with its direction along the border of a triangle. */
std::uint64_t MakeEdge(std::uint32_t from, std::uint32_t to)
{
  return std::uint64_t{ from } << 32 | to;
}

class Stripper
{
public:
  explicit Stripper(std::size_t triangles) { this->Ends.reserve(triangles); }

  void Add(const std::array<std::uint32_t, 3>& triangle)
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      // A neighbour with the same front has the edge the other way round.
      const auto end = this->Ends.find(MakeEdge(triangle[(i + 1) % 3], triangle[i]));
      if (end != this->Ends.end())
      {
        this->Extend(end->second, triangle[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3]);
        return;
      }
    }
    const auto strip = static_cast<std::uint32_t>(this->Strips.size());
    this->Strips.push_back({ triangle[0], triangle[1], triangle[2] });
    for (unsigned i = 0; i < 3; ++i)
    {
      this->Ends.emplace(MakeEdge(triangle[i], triangle[(i + 1) % 3]), strip);
    }
  }

  std::vector<std::vector<std::uint32_t>> Strips;

private:
  /** Adds the triangle a, b, c to a strip that has the edge b, a at its end. */
  void Extend(std::uint32_t number, std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    auto& strip = this->Strips[number];
    if (strip.size() == 3)
    {
      // The first triangle can be turned so that it goes on at any edge.
      std::array<std::uint32_t, 3> first = { strip[0], strip[1], strip[2] };
      for (unsigned i = 0; i < 3; ++i)
      {
        this->Forget(first[i], first[(i + 1) % 3], number);
      }
      while (first[1] != b || first[2] != a)
      {
        first = { first[1], first[2], first[0] };
      }
      strip.assign(first.begin(), first.end());
    }
    else
    {
      this->Forget(b, a, number);
    }
    // The new triangle goes on where its last two points are, in the direction that it has there.
    const bool odd = strip.size() % 2 == 1;
    strip.push_back(c);
    const std::uint32_t before = strip[strip.size() - 2];
    this->Ends.emplace(odd ? MakeEdge(c, before) : MakeEdge(before, c), number);
  }

  void Forget(std::uint32_t from, std::uint32_t to, std::uint32_t strip)
  {
    const auto end = this->Ends.find(MakeEdge(from, to));
    if (end != this->Ends.end() && end->second == strip)
    {
      this->Ends.erase(end);
    }
  }

  std::unordered_map<std::uint64_t, std::uint32_t> Ends; // of strips, by their edges
};
}

//------------------------------------------------------------------------------
std::vector<std::vector<std::uint32_t>> MakeStrips(
  std::span<const std::array<std::uint32_t, 3>> triangles)
{
  Stripper stripper(triangles.size());
  for (const auto& triangle : triangles)
  {
    stripper.Add(triangle);
  }
  return std::move(stripper.Strips);
}
}
