// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// What a survey finds out about the values of a mesh does not depend on where the mesh is, on its
// chunks, or on threads; of a large mesh, a part is enough.

#include "gatunDefaultOpacity.h"
#include "gatunFileRaySource.h"
#include "gatunMemoryRaySource.h"
#include "gatunParallel.h"
#include "gatunRayImages.h"
#include "gatunTestFile.h"
#include "gatunValueSurvey.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

namespace gatun::test
{
namespace
{
std::vector<OpacityNode> GetNodes(const ValueSurvey& survey)
{
  return MakeDefaultTransfer(survey, 0.1).Opacities;
}

TEST(ValueSurvey, IsTheSameForFilesOfAnyChunksAndForMeshesInMemory)
{
  const TestMesh mesh = MakeCubes(12, 0.2);
  const Values values(mesh);
  for (const bool ofCells : { false, true })
  {
    RayValuesInput input;
    if (ofCells)
    {
      input = { Association::Cell, ScalarType::Int32, 1, 0, values.Material.data() };
    }
    else
    {
      input = { Association::Point, ScalarType::Float32, 1, 0, values.Field.data() };
    }
    MemoryRaySource whole(mesh.GetInput(), input, nullptr, 0, 1 << 20);
    const ValueSurvey expected = SurveyValues(whole);
    EXPECT_GT(GetNodes(expected).size(), 5u);
    for (const int threads : { 1, 4 })
    {
      WithNumberOfThreads(threads,
        [&]
        {
          for (const std::uint32_t blockTets : { 100, 3000 })
          {
            MemoryRaySource memory(mesh.GetInput(), input, nullptr, 0, blockTets);
            const ValueSurvey found = SurveyValues(memory);
            EXPECT_EQ(GetNodes(found), GetNodes(expected));
            EXPECT_EQ(found.Volume, expected.Volume);

            const std::string path = TempPath("survey.gtn");
            WriterOptions options;
            options.ChunkSize = blockTets;
            Write(path, mesh, options);
            FileRaySource file(std::make_shared<FileReader>(path), { ofCells ? 2u : 0u, 0, 0 }, 0);
            EXPECT_EQ(GetNodes(SurveyValues(file)), GetNodes(expected));
          }
        });
    }
  }
}

TEST(ValueSurvey, WeighsByVolume)
{
  // Two boxes of the same number of tetrahedra, one of them 1000 times as large.
  TestMesh mesh = MakeCubes(4, 0);
  const TestMesh small = mesh;
  const auto first = static_cast<std::int64_t>(mesh.GetPoints());
  std::vector<double> values(mesh.GetPoints(), 1.0);
  for (double& x : mesh.Coordinates)
  {
    x *= 10;
  }
  for (std::size_t i = 0; i < small.Coordinates.size(); ++i)
  {
    mesh.Coordinates.push_back(small.Coordinates[i] + (i % 3 == 0 ? 50 : 0));
  }
  for (const auto id : small.Ids)
  {
    mesh.Ids.push_back(id + first);
  }
  values.resize(mesh.GetPoints(), 2.0);
  MemoryRaySource source(mesh.GetInput(),
    { Association::Point, ScalarType::Float64, 1, 0, values.data() }, nullptr, 0, 50);
  const ValueSurvey survey = SurveyValues(source);
  const double all = 64000 + 64;
  EXPECT_NEAR(survey.Volume, all, 1e-6 * all);
  const auto fractions = survey.Values.GetFractions({ 1, 2 }, 2);
  EXPECT_NEAR(fractions[0], 64000 / all, 1e-6);
  EXPECT_NEAR(fractions[1], 64 / all, 1e-6);
}

TEST(ValueSurvey, LooksAtAPartOfALargeMesh)
{
  const auto mesh = ToReference(MakeCubes(16, 0.1));
  CountingSource whole(mesh, 100);
  const ValueSurvey expected = SurveyValues(whole);
  EXPECT_GE(whole.Asked, whole.GetNumberOfBlocks());
  CountingSource part(mesh, 100);
  const ValueSurvey found = SurveyValues(part, Range{ 0, 1 }, {}, 5000);
  EXPECT_LE(part.Asked, 60u);
  EXPECT_GE(part.Asked, 50u);
  EXPECT_NEAR(found.Volume, expected.Volume, 0.05 * expected.Volume);
  const auto a = expected.Values.GetFractions({ 0, 1 }, 8);
  const auto b = found.Values.GetFractions({ 0, 1 }, 8);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_NEAR(a[i], b[i], 0.05);
  }
}

TEST(ValueSurvey, LeavesOutWhatIsNotFinite)
{
  TestMesh mesh = MakeCubes(6, 0.1);
  std::vector<double> values(mesh.GetPoints());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<double>(i % 7);
  }
  values[30] = std::nan("");
  values[60] = std::numeric_limits<double>::infinity();
  values[90] = -std::numeric_limits<double>::infinity();
  mesh.Coordinates[3 * 120 + 1] = std::nan("");
  MemoryRaySource source(mesh.GetInput(),
    { Association::Point, ScalarType::Float64, 1, 0, values.data() }, nullptr, 0, 100);
  const DefaultTransfer transfer = MakeDefaultTransfer(SurveyValues(source), 0.1);
  EXPECT_NEAR(transfer.Colors.Min, 0, 0.1);
  EXPECT_NEAR(transfer.Colors.Max, 6, 0.1);

  // All flat: they count alike.
  for (std::size_t i = 2; i < mesh.Coordinates.size(); i += 3)
  {
    mesh.Coordinates[i] = 0;
  }
  MemoryRaySource flat(mesh.GetInput(),
    { Association::Point, ScalarType::Float64, 1, 0, values.data() }, nullptr, 0, 100);
  EXPECT_GT(SurveyValues(flat).Values.GetTotal(), 0u);

  const TestMesh none;
  MemoryRaySource empty(none.GetInput(),
    { Association::Point, ScalarType::Float64, 1, 0, values.data() }, nullptr, 0, 100);
  EXPECT_EQ(SurveyValues(empty).Values.GetTotal(), 0u);
}
}
}
