// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The boundary of a mesh that is written in parts is that of the whole mesh.

#include "gatunError.h"
#include "gatunHostile.h"
#include "gatunMeshParts.h"
#include "gatunParallel.h"
#include "gatunTestFile.h"
#include "gatunVerifyFile.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gatun::test
{
namespace
{
constexpr int StepsOfSurfaces = 2;

PartWriterOptions MakeSurfaceSettings(bool hasTree)
{
  PartWriterOptions options;
  options.File.ChunkSize = 300;
  options.File.Boundary = true;
  if (hasTree)
  {
    options.Weights = { 1, 0, 0, 0, 0 };
    options.File.Dependencies = true;
    options.TetsOfGroup = 700;
  }
  return options;
}

/** Compares the boundary of a mesh in parts with that of the whole. */
void ExpectSameBoundary(const PartMesh& mesh, std::size_t parts,
  const std::vector<std::size_t>& partOf, const PartWriterOptions& options)
{
  const auto path = GetPath("partSurface.gtn");
  const auto wholePath = GetPath("partSurfaceWhole.gtn");
  const auto statistics =
    WriteParts(path, Divide(mesh, parts, partOf), options, StepsOfSurfaces, true);
  EXPECT_GT(statistics.File.BoundaryBytes, 0u);
  WriterOptions whole = options.File;
  whole.Dependencies = false;
  WriteWhole(wholePath, mesh, whole, StepsOfSurfaces);
  const auto file = std::make_shared<FileReader>(path);
  EXPECT_TRUE(VerifyFile(*file));
  const auto boundary = file->OpenBoundary();
  const auto expected = FileReader(wholePath).OpenBoundary();
  EXPECT_EQ(boundary->GetNumberOfPoints(), expected->GetNumberOfPoints());
  EXPECT_GT(boundary->GetNumberOfCells(), 100u);
  for (std::size_t step = 0; step < StepsOfSurfaces; ++step)
  {
    const PartContent got(boundary, step);
    const PartContent wanted(expected, step);
    EXPECT_EQ(ListCells(got.Mesh, got.Values), ListCells(wanted.Mesh, wanted.Values)) << step;
  }
}
}

TEST(PartSurface, IsTheBoundaryOfTheWholeMesh)
{
  auto cubes = MakeCubes(8, 0.2);
  cubes.Coordinates.insert(cubes.Coordinates.end(), { 50, 0, 0 }); // unused
  const PartMesh mesh = MakePartMesh(cubes);
  for (const bool hasTree : { false, true })
  {
    const auto options = MakeSurfaceSettings(hasTree);
    ExpectSameBoundary(mesh, 1, DealSlabs(mesh, 1, 8), options);
    ExpectSameBoundary(mesh, 4, DealSlabs(mesh, 4, 8), options);
    // Nearly all faces are between parts.
    ExpectSameBoundary(mesh, 3, DealRandomly(mesh, 3, 5), options);
  }
}

TEST(PartSurface, OfCellsOfAllKindsAndOfRoundedValues)
{
  const PartMesh mesh = MakePartMesh(Mixture(6));
  auto options = MakeSurfaceSettings(false);
  ExpectSameBoundary(mesh, 3, DealSlabs(mesh, 3, 6), options);
  ExpectSameBoundary(mesh, 2, DealRandomly(mesh, 2, 1), options);
  options.File.Errors = { { "point", { ErrorKind::Absolute, 0.05 } } };
  ExpectSameBoundary(mesh, 3, DealSlabs(mesh, 3, 6), options);
}

TEST(PartSurface, IsSimplifiedWithTheMesh)
{
  const PartMesh mesh = MakePartMesh(MakeCubes(10, 0));
  const auto path = GetPath("partSurfaceTree.gtn");
  WriteParts(path, Divide(mesh, 3, DealSlabs(mesh, 3, 10)), MakeSurfaceSettings(true), 1);
  const auto boundary = FileReader(path).OpenBoundary();
  EXPECT_TRUE(boundary->HasDependencies());
  EXPECT_GT(boundary->GetNumberOfMerges(), boundary->GetNumberOfPoints() * 3 / 4);
}

TEST(PartSurface, DoesNotDependOnThreads)
{
  const PartMesh mesh = MakePartMesh(MakeCubes(9, 0.2));
  std::string first;
  for (const int threads : { 1, 2, 5 })
  {
    std::string bytes;
    WithNumberOfThreads(threads,
      [&]
      {
        const auto path = GetPath("partSurfaceThreads.gtn");
        WriteParts(path, Divide(mesh, 3, DealRandomly(mesh, 3, 2)), MakeSurfaceSettings(true), 1);
        bytes = ReadBytes(path);
      });
    first = first.empty() ? bytes : first;
    EXPECT_TRUE(bytes == first) << threads;
  }
}
}
