// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTestSolids_h
#define gatunTestSolids_h

// Solids of several topologies, made of tetrahedra, and what is left of them after merges.

#include "gatunMergeInput.h"
#include "gatunMergeTree.h"
#include "gatunPartMerges.h"
#include "gatunTestMeshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace gatun::test
{
using Position = std::array<double, 3>;

struct Solid
{
  std::vector<Position> Points;
  std::vector<MergeTree::Tet> Tets;
  std::vector<double> Values;

  MergeInput GetInput() const { return { this->Points, this->Tets, { { this->Values, 1 } } }; }
};

inline Solid MakeSolid(
  std::int64_t n, double jitter, const std::function<bool(const Position&)>& isIn)
{
  const auto mesh = MakeCubes(n, jitter);
  Solid solid;
  for (std::size_t i = 0; i < mesh.GetPoints(); ++i)
  {
    const Position p{ mesh.Coordinates[3 * i], mesh.Coordinates[3 * i + 1],
      mesh.Coordinates[3 * i + 2] };
    solid.Points.push_back(p);
    solid.Values.push_back(std::sin(0.7 * p[0]) * std::cos(0.5 * p[1]) + 0.1 * p[2] * p[2]);
  }
  for (std::size_t i = 0; i < mesh.GetTets(); ++i)
  {
    MergeTree::Tet tet{};
    for (std::size_t c = 0; c < 4; ++c)
    {
      tet[c] = static_cast<std::uint32_t>(mesh.Ids[4 * i + c]);
    }
    // Whole cubes, six tetrahedra each, by the corner that is nearest to the origin.
    Position low{ 1e9, 1e9, 1e9 };
    const auto first = 6 * (i / 6);
    for (std::size_t k = 4 * first; k < 4 * first + 24; ++k)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        low[c] = std::min(
          low[c], std::round(mesh.Coordinates[3 * static_cast<std::size_t>(mesh.Ids[k]) + c]));
      }
    }
    if (isIn(low))
    {
      solid.Tets.push_back(tet);
    }
  }
  return solid;
}

/** All in one piece; a ring; with a void; in two parts. */
inline Solid MakeSolid(const std::string& name)
{
  if (name == "Ring")
  {
    return MakeSolid(
      7, 0.2, [](const Position& p) { return p[0] < 2 || p[0] > 4 || p[1] < 2 || p[1] > 4; });
  }
  if (name == "Void")
  {
    return MakeSolid(7, 0.2,
      [](const Position& p)
      { return std::any_of(p.begin(), p.end(), [](double x) { return x < 2 || x > 4; }); });
  }
  if (name == "Parts")
  {
    return MakeSolid(6, 0.2, [](const Position& p) { return p[2] < 2 || p[2] > 3; });
  }
  return MakeSolid(6, name == "Lattice" ? 0 : 0.25, [](const Position&) { return true; });
}

inline double GetTetVolume(const std::vector<Position>& points, const MergeTree::Tet& tet)
{
  std::array<Position, 3> u;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      u[i][c] = points[tet[i + 1]][c] - points[tet[0]][c];
    }
  }
  return (u[0][0] * (u[1][1] * u[2][2] - u[1][2] * u[2][1]) +
           u[0][1] * (u[1][2] * u[2][0] - u[1][0] * u[2][2]) +
           u[0][2] * (u[1][0] * u[2][1] - u[1][1] * u[2][0])) /
    6;
}

using Simplex = std::set<std::uint32_t>;

/** Faces with how many tetrahedra have them. */
inline std::map<Simplex, int> CountFaces(const std::vector<MergeTree::Tet>& tets)
{
  std::map<Simplex, int> faces;
  for (const MergeTree::Tet& tet : tets)
  {
    for (std::size_t side = 0; side < 4; ++side)
    {
      Simplex face(tet.begin(), tet.end());
      face.erase(tet[side]);
      ++faces[face];
    }
  }
  return faces;
}

inline std::set<Simplex> GetBoundary(const std::vector<MergeTree::Tet>& tets)
{
  std::set<Simplex> boundary;
  for (const auto& [face, count] : CountFaces(tets))
  {
    if (count == 1)
    {
      boundary.insert(face);
    }
  }
  return boundary;
}

/** Points - edges + faces - tetrahedra. */
inline int GetEulerCharacteristic(const std::set<Simplex>& simplices)
{
  std::set<Simplex> all = simplices;
  for (std::size_t size = 4; size > 1; --size)
  {
    std::set<Simplex> next;
    for (const Simplex& simplex : all)
    {
      for (const auto point : simplex)
      {
        if (simplex.size() == size)
        {
          Simplex side = simplex;
          side.erase(point);
          next.insert(side);
        }
      }
    }
    all.insert(next.begin(), next.end());
  }
  int sum = 0;
  for (const Simplex& simplex : all)
  {
    sum += simplex.size() % 2 == 1 ? 1 : -1;
  }
  return sum;
}

inline std::vector<MergeTree::Tet> SimplifyAll(
  std::vector<MergeTree::Tet> tets, const MergeTree& tree, std::size_t merges)
{
  const auto ancestors = tree.FindAncestors(merges);
  std::erase_if(tets, [&](MergeTree::Tet& tet) { return !Simplify(tet, ancestors); });
  return tets;
}

/** The merges of a solid in parts, which are slices of its list of tetrahedra. */
inline MergeTree BuildInParts(const Solid& solid, std::size_t parts,
  const PartMergeSettings& settings, MergeDependencies* dependencies = nullptr)
{
  PartMerges merges(static_cast<std::uint32_t>(solid.Points.size()), 1, settings);
  const std::size_t tets = solid.Tets.size();
  for (std::size_t part = 0; part < parts; ++part)
  {
    Solid own;
    std::vector<std::uint32_t> numbers;
    std::map<std::uint32_t, std::uint32_t> places;
    for (std::size_t t = tets * part / parts; t < tets * (part + 1) / parts; ++t)
    {
      auto& tet = own.Tets.emplace_back();
      for (std::size_t i = 0; i < 4; ++i)
      {
        const auto point = solid.Tets[t][i];
        tet[i] =
          places.try_emplace(point, static_cast<std::uint32_t>(numbers.size())).first->second;
        if (tet[i] == numbers.size())
        {
          numbers.push_back(point);
          own.Points.push_back(solid.Points[point]);
          own.Values.push_back(solid.Values[point]);
        }
      }
    }
    const std::vector<std::uint8_t> isShared(numbers.size(), parts > 1 ? 1 : 0);
    merges.Add({ own.GetInput(), numbers, isShared });
  }
  MergeTree tree = merges.Build();
  if (dependencies)
  {
    *dependencies = merges.FindDependencies(tree);
  }
  return tree;
}
}

#endif
