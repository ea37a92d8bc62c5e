// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunStrips.h"

#include <algorithm>
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
      // A neighbor with the same front has the edge the other way round.
      const auto end = this->Ends.find(MakeEdge(triangle[(i + 1) % 3], triangle[i]));
      if (end != this->Ends.end())
      {
        this->Extend(end->second, triangle[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3]);
        return;
      }
    }
    const auto strip = static_cast<std::uint32_t>(this->Strips.size());
    this->Strips.push_back({ triangle[0], triangle[1], triangle[2] });
    EachEnd(this->Strips.back(), [&](std::uint64_t edge) { this->Ends.emplace(edge, strip); });
  }

  std::vector<std::vector<std::uint32_t>> Strips;

private:
  using Strip = std::vector<std::uint32_t>;

  /** Adds the triangle a, b, c to a strip that ends at the edge b, a. */
  void Extend(std::uint32_t number, std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    Strip& strip = this->Strips[number];
    this->EachEnd(strip, [&](std::uint64_t edge) { this->Forget(edge, number); });
    if (strip.size() == 3)
    {
      // The first triangle can be turned so that it goes on at any edge.
      while (strip[1] != b || strip[2] != a)
      {
        std::rotate(strip.begin(), strip.begin() + 1, strip.end());
      }
    }
    else if (this->GetTail(strip) != MakeEdge(b, a))
    {
      std::reverse(strip.begin(), strip.end());
    }
    strip.push_back(c);
    this->EachEnd(strip, [&](std::uint64_t edge) { this->Ends.emplace(edge, number); });
  }

  /** The edge that the strip goes on at, in the direction that it has in the last triangle. */
  static std::uint64_t GetTail(const Strip& strip)
  {
    const std::uint32_t last = strip.back();
    const std::uint32_t before = strip[strip.size() - 2];
    return strip.size() % 2 == 1 ? MakeEdge(before, last) : MakeEdge(last, before);
  }

  /** Calls use(edge) for all edges at which a strip can go on. */
  template <typename Use>
  static void EachEnd(const Strip& strip, Use&& use)
  {
    if (strip.size() == 3)
    {
      use(MakeEdge(strip[0], strip[1]));
      use(MakeEdge(strip[1], strip[2]));
      use(MakeEdge(strip[2], strip[0]));
      return;
    }
    use(GetTail(strip));
    if (strip.size() % 2 == 0)
    {
      use(MakeEdge(strip[0], strip[1])); // as it may be turned round: fronts stay where they are
    }
  }

  void Forget(std::uint64_t edge, std::uint32_t strip)
  {
    const auto end = this->Ends.find(edge);
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
