// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunWalkSamples_h
#define gatunWalkSamples_h

// Meshes for walks over cells, and their round trip.

#include "gatunTestCells.h"

#include "gatunError.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace gatun::test
{
/** The shapes of a mesh as a reader has them. */
inline ShapeTable MakeShapes(const CellList& cells)
{
  ShapeTable table;
  table.Add(cells);
  return ShapeTable::Read(table.Write());
}

inline EncodedCells ExpectWalk(const TestCells& mesh, const CellCaseOptions& options = {})
{
  const auto chunk = MakeCellCase(mesh, options);
  auto encoded = ExpectRoundTrip(chunk, MakeShapes(chunk.Cells));
  EXPECT_EQ(encoded.Connectivity[0] & 1, 1)
    << GetBits(encoded.Connectivity, encoded); // with a walk
  return encoded;
}

inline bool IsLeft(const std::array<double, 3>& point)
{
  return point[0] < 3.5;
}

/** Replaces all cells by others with the same points. split(corners) adds them. */
template <typename Split>
TestCells SplitHexes(int n, double jitter, Split&& split)
{
  const auto hexes = MakeHexes(n, jitter);
  TestCells mesh;
  mesh.Points = hexes.Points;
  for (std::size_t c = 0; c < hexes.Cells.GetNumber(); ++c)
  {
    split(mesh, hexes.Cells.GetCorners(c), c);
  }
  return mesh;
}

inline void AddWedges(TestCells& mesh, std::span<const std::uint32_t> c, std::size_t)
{
  mesh.Add(13, { c[0], c[2], c[1], c[4], c[6], c[5] });
  mesh.Add(13, { c[0], c[3], c[2], c[4], c[7], c[6] });
}

inline void AddPyramids(TestCells& mesh, std::span<const std::uint32_t> c, std::size_t)
{
  std::array<double, 3> center{ 0, 0, 0 };
  for (const auto corner : c)
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      center[i] += mesh.Points[corner][i] / 8;
    }
  }
  const auto apex = mesh.AddPoint(center[0], center[1], center[2]);
  for (const auto& face : { std::array{ 0, 1, 2, 3 }, { 7, 6, 5, 4 }, { 0, 4, 5, 1 },
         { 1, 5, 6, 2 }, { 2, 6, 7, 3 }, { 3, 7, 4, 0 } })
  {
    mesh.Add(14, { c[face[0]], c[face[1]], c[face[2]], c[face[3]], apex });
  }
}

inline void AddTets(TestCells& mesh, std::span<const std::uint32_t> c, std::size_t)
{
  for (const auto& tet : { std::array{ 0, 1, 2, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 }, { 0, 7, 4, 6 },
         { 0, 4, 5, 6 }, { 0, 5, 1, 6 } })
  {
    mesh.Add(10, { c[tet[0]], c[tet[1]], c[tet[2]], c[tet[3]] });
  }
}

inline void ExpectCorrupt(const std::function<void()>& run)
{
  try
  {
    run();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Corrupt);
  }
}

/** Decodes damaged streams. They must give a mesh or Error(Corrupt). */
inline void ExpectSafe(const TestCells& mesh)
{
  const auto chunk = MakeCellCase(mesh, { .IsShared = IsLeft });
  const auto shapes = MakeShapes(chunk.Cells);
  const auto encoded = ExpectRoundTrip(chunk, shapes);
  std::mt19937 random(4);
  for (unsigned i = 0; i < 400; ++i)
  {
    auto connectivity = encoded.Connectivity;
    for (auto flips = random() % 3; flips > 0; --flips)
    {
      connectivity[1 + random() % (connectivity.size() - 1)] ^=
        static_cast<std::uint8_t>(1 + random() % 255);
    }
    if (random() % 4 == 0)
    {
      connectivity.resize(random() % connectivity.size());
    }
    ExpectCorrupt(
      [&]
      {
        auto decoded = DecodeCells(chunk.Frame, shapes, connectivity, encoded.Geometry);
        ArrayContext(decoded, ContextFits::All);
        RestoreCorners(decoded.Cells, encoded.Corners);
      });
  }
}
}

#endif
