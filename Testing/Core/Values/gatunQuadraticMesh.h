// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticMesh_h
#define gatunQuadraticMesh_h

// Chunks for tests of the quadratic modes.

#include "gatunArrayContext.h"
#include "gatunTestMeshes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace gatun::test
{
constexpr double Inf = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/** A chunk with the weights of neighbors. */
struct QuadraticMesh : ChunkMesh
{
  explicit QuadraticMesh(ChunkMesh&& mesh)
    : ChunkMesh(std::move(mesh))
    , Context(*this, ContextFits::All)
  {
  }

  ArrayContext Context;
};

/** A chunk of n^3 cubes, some vertices of which are shared. move: changes places. */
inline std::unique_ptr<const QuadraticMesh> MakeMesh(
  std::int64_t n, const std::function<void(double*)>& move = [](double*) {})
{
  TestMesh mesh = MakeCubes(n, 0.2);
  ChunkFrame frame;
  const Domain domain(ScalarType::Float64);
  frame.Domains = { domain, domain, domain };
  frame.Box = { Range{ -1, n + 1.0 }, Range{ -1, n + 1.0 }, Range{ -1, n + 1.0 } };
  std::vector<PointKeys> shared, own;
  std::vector<std::uint32_t> number(mesh.GetPoints());
  for (const bool isShared : { true, false })
  {
    for (std::size_t v = 0; v < number.size(); ++v)
    {
      double* p = mesh.Coordinates.data() + 3 * v;
      if ((v % 7 == 0) == isShared)
      {
        number[v] = static_cast<std::uint32_t>(shared.size() + own.size());
        move(p);
        (isShared ? shared : own)
          .push_back({ domain.Read(p), domain.Read(p + 1), domain.Read(p + 2) });
      }
    }
  }
  std::vector<std::array<std::uint32_t, 4>> tets(mesh.GetTets());
  for (std::size_t i = 0; i < mesh.Ids.size(); ++i)
  {
    tets[i / 4][i % 4] = number[static_cast<std::size_t>(mesh.Ids[i])];
  }
  frame.Tets = static_cast<std::uint32_t>(tets.size());
  frame.OwnPoints = static_cast<std::uint32_t>(own.size());
  frame.SharedKeys = shared;
  frame.SharedUsers.assign(shared.size(), 1);
  return std::make_unique<QuadraticMesh>(EncodeChunk(frame, tets, own).Mesh);
}

/** Moves vertices so that neighborhoods are singular in several ways. */
inline void MoveToSingular(double* p)
{
  if (p[0] > 4)
  {
    p[0] = 5; // a plane
  }
  if (p[2] < 1.5)
  {
    p[1] = p[2] = 0; // a line
  }
  if (p[1] > 3.5)
  {
    p[0] = p[1] = p[2] = 3; // a point
  }
  if (p[2] > 4.5)
  {
    p[0] = p[1] > 2 ? NaN : Inf;
    p[1] *= 1e300;
  }
}
}

#endif
