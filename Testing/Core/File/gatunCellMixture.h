// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunCellMixture_h
#define gatunCellMixture_h

#include "gatunMeshInput.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <random>
#include <vector>

namespace gatun::test
{
inline constexpr std::uint8_t Line = 3;
inline constexpr std::uint8_t Triangle = 5;
inline constexpr std::uint8_t Quad = 9;
inline constexpr std::uint8_t Tetra = 10;
inline constexpr std::uint8_t Hexahedron = 12;
inline constexpr std::uint8_t Wedge = 13;
inline constexpr std::uint8_t Polyhedron = 42;

/** Cubes, each of which is a hexahedron, two wedges or a polyhedron, or has other cells beside it;
 * and a wall. */
struct Mixture
{
  std::vector<double> Coordinates;
  std::vector<std::uint8_t> Types;
  std::vector<std::int64_t> Offsets{ 0 };
  std::vector<std::int64_t> Ids;
  std::vector<std::int64_t> FaceLocations;
  std::vector<std::int64_t> Faces;

  explicit Mixture(std::int64_t n)
  {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> move(-0.1, 0.1);
    for (std::int64_t i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i)
    {
      for (const auto c : { i % (n + 1), i / (n + 1) % (n + 1), i / ((n + 1) * (n + 1)) })
      {
        this->Coordinates.push_back(static_cast<double>(c) + move(random));
      }
    }
    for (std::int64_t i = 0; i < n * n * n; ++i)
    {
      this->AddCube(n, { i % n, i / n % n, i / (n * n) }, static_cast<unsigned>(i % 4));
    }
    this->AddWall(n);
  }

  /** Quadrilaterals and triangles with common edges in the middle of the cubes. */
  void AddWall(std::int64_t n)
  {
    for (std::int64_t i = 0; i < n * n; ++i)
    {
      const auto a = (n / 2 * (n + 1) + i / n) * (n + 1) + i % n;
      const auto b = a + n + 1;
      if (i % 3 == 0)
      {
        this->AddCell(Triangle, { a, a + 1, b });
        this->AddCell(Triangle, { b, a + 1, b + 1 });
      }
      else
      {
        this->AddCell(Quad, { a, a + 1, b + 1, b });
      }
    }
  }

  void AddCell(std::uint8_t type, std::initializer_list<std::int64_t> ids)
  {
    this->Types.push_back(type);
    this->Ids.insert(this->Ids.end(), ids.begin(), ids.end());
    this->Offsets.push_back(static_cast<std::int64_t>(this->Ids.size()));
    this->FaceLocations.push_back(-1);
  }

  void AddCube(std::int64_t n, const std::array<std::int64_t, 3>& at, unsigned kind)
  {
    std::array<std::int64_t, 8> c{};
    constexpr std::int64_t corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
      { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
    for (std::size_t i = 0; i < 8; ++i)
    {
      const auto& o = corners[i];
      c[i] = ((at[2] + o[2]) * (n + 1) + at[1] + o[1]) * (n + 1) + at[0] + o[0];
    }
    if (kind == 0)
    {
      this->AddCell(Wedge, { c[0], c[2], c[1], c[4], c[6], c[5] });
      this->AddCell(Wedge, { c[0], c[3], c[2], c[4], c[7], c[6] });
    }
    else if (kind == 1)
    {
      this->AddCell(Polyhedron, { c[7], c[0], c[1], c[2], c[3], c[4], c[5], c[6] });
      this->FaceLocations.back() = static_cast<std::int64_t>(this->Faces.size());
      const std::int64_t faces[] = { 6, 4, c[3], c[2], c[1], c[0], 4, c[4], c[5], c[6], c[7], 4,
        c[0], c[1], c[5], c[4], 4, c[1], c[2], c[6], c[5], 4, c[2], c[3], c[7], c[6], 4, c[3], c[0],
        c[4], c[7] };
      this->Faces.insert(this->Faces.end(), std::begin(faces), std::end(faces));
    }
    else
    {
      this->AddCell(Hexahedron, { c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7] });
    }
    if (kind == 3)
    {
      this->AddCell(Quad, { c[0], c[1], c[2], c[3] });
      this->AddCell(Line, { c[0], c[6] });
    }
  }

  MeshInput GetInput() const
  {
    MeshInput input;
    input.Points = this->Coordinates.size() / 3;
    input.CoordinateType = ScalarType::Float64;
    input.Coordinates = this->Coordinates.data();
    input.Cells = this->Types.size();
    input.Connectivity = this->Ids.data();
    input.Types = this->Types.data();
    input.Offsets = this->Offsets.data();
    input.FaceLocations = this->FaceLocations.data();
    input.Faces = this->Faces.data();
    input.FacesSize = this->Faces.size();
    return input;
  }
};

}

#endif
