// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Arrays that are copies of components of others.

#include "gatunArrayCopies.h"
#include "gatunFileSurface.h"
#include "gatunHostile.h"
#include "gatunTestFile.h"
#include "gatunVerifyFile.h"

#include <cmath>

namespace
{
using namespace gatun;
using namespace gatun::test;

std::vector<ArrayDescription> DescribeArrays()
{
  return { { "second", Association::Point, ScalarType::Float32, 1, 0, 0, {} },
    { "vector", Association::Point, ScalarType::Float32, 3, 0, 0, {} },
    { "turned", Association::Point, ScalarType::Float32, 2, 0, 0, {} },
    { "ids", Association::Cell, ScalarType::Int64, 1, 0, 0, {} },
    { "again", Association::Cell, ScalarType::Int64, 1, 0, 0, {} } };
}

/** "second" is a component of "vector" except at step 2, "turned" two of them, and "again" is "ids"
 * up to step 3. */
struct StepArrays
{
  StepArrays(const TestMesh& mesh, int step)
  {
    for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        this->Vector.push_back(
          static_cast<float>(std::sin(mesh.Coordinates[3 * p + c] + 0.3 * step)));
      }
      const float* vector = &this->Vector[3 * p];
      this->Second.push_back(vector[1] + (step == 2 ? 0.5f : 0.0f));
      this->Turned.insert(this->Turned.end(), { vector[2], vector[0] });
    }
    for (std::size_t t = 0; t < mesh.GetTets(); ++t)
    {
      this->Ids.push_back(static_cast<std::int64_t>(3 * t + 1));
      this->Again.push_back(this->Ids.back() + (step > 3 ? 1 : 0));
    }
  }

  std::array<const void*, 5> Get() const
  {
    return { this->Second.data(), this->Vector.data(), this->Turned.data(), this->Ids.data(),
      this->Again.data() };
  }

  std::vector<float> Second, Vector, Turned;
  std::vector<std::int64_t> Ids, Again;
};

constexpr int CopiedSteps = 6;

std::shared_ptr<const FileReader> WriteSteps(const TestMesh& mesh)
{
  const auto path = GetPath("copies.gtn");
  WriterOptions options;
  options.ChunkSize = 200;
  options.Keep = KeepAll;
  options.KeyStepInterval = 5;
  FileWriter writer(path, mesh.GetInput(), DescribeArrays(), options);
  for (int step = 0; step < CopiedSteps; ++step)
  {
    writer.WriteStep(StepArrays(mesh, step).Get(), {}, true, step);
  }
  writer.Finish();
  return std::make_shared<const FileReader>(path);
}

/** Some arrays at a step, in the original order. */
StepArrays ReadArrays(PieceDecoder& decoder, const FileReader& file, const TestMesh& mesh,
  const std::vector<std::uint32_t>& arrays, std::size_t step)
{
  StepArrays back(mesh, 99);
  auto request = AskForAll(file);
  request.Arrays = arrays;
  request.Step = step;
  request.RestoreOrder = true;
  decoder.SetRequest(request);
  const std::array<void*, 5> all{ back.Second.data(), back.Vector.data(), back.Turned.data(),
    back.Ids.data(), back.Again.data() };
  PieceTarget target;
  for (const auto array : arrays)
  {
    target.Arrays.push_back(all[array]);
  }
  decoder.Fill(target);
  return back;
}

TEST(ArrayCopies, AreReadAtAllStepsInAnyOrder)
{
  const auto mesh = MakeCubes(8, 0.2);
  const auto file = WriteSteps(mesh);
  ASSERT_GT(file->GetChunks().size(), 5u);
  EXPECT_TRUE(VerifyFile(*file));
  PieceDecoder decoder(file);
  for (const int step : { 5, 0, 3, 2, 4, 1, 2, 0, 3 })
  {
    const StepArrays expected(mesh, step);
    const auto at = static_cast<std::size_t>(step);
    const auto all = ReadArrays(decoder, *file, mesh, { 0, 1, 2, 3, 4 }, at);
    EXPECT_EQ(all.Second, expected.Second) << step;
    EXPECT_EQ(all.Vector, expected.Vector) << step;
    EXPECT_EQ(all.Turned, expected.Turned) << step;
    EXPECT_EQ(all.Ids, expected.Ids) << step;
    EXPECT_EQ(all.Again, expected.Again) << step;
    // Alone, and with a new cache.
    PieceDecoder other(file);
    EXPECT_EQ(ReadArrays(decoder, *file, mesh, { 2 }, at).Turned, expected.Turned) << step;
    EXPECT_EQ(ReadArrays(other, *file, mesh, { 0 }, at).Second, expected.Second) << step;
    EXPECT_EQ(ReadArrays(other, *file, mesh, { 4 }, at).Again, expected.Again) << step;
  }
}

TEST(ArrayCopies, TakeNoBytes)
{
  const auto mesh = MakeCubes(8, 0.2);
  const auto bytes = WriteSteps(mesh)->GetStatistics().ArrayBytes;
  EXPECT_GT(bytes[0], 0u); // at step 2
  EXPECT_LT(bytes[0], bytes[1] / 6);
  EXPECT_EQ(bytes[2], 0u);
  EXPECT_LT(bytes[4], bytes[3]);
}

TEST(ArrayCopies, AreContouredLikeTheirSources)
{
  const auto file = WriteSteps(MakeCubes(8, 0.2));
  FileSurface extractor(file);
  FileSurfaceRequest request;
  request.Step = 1;
  request.Options.Values = { 0.3, 0.6 };
  request.Array = 1;
  request.Component = 1;
  const auto expected = extractor.Extract(request);
  request.Array = 0;
  request.Component = 0;
  const auto found = extractor.Extract(request);
  ASSERT_GT(found.GetNumberOfTriangles(), 100u);
  ASSERT_EQ(found.GetNumberOfPoints(), expected.GetNumberOfPoints());
  std::vector<double> one(3 * found.GetNumberOfPoints()), other(one.size());
  found.FillPoints(one.data());
  expected.FillPoints(other.data());
  EXPECT_EQ(one, other);
}

TEST(ArrayCopies, OfEmptyArraysAreNone)
{
  const auto arrays = DescribeArrays();
  const std::array<const void*, 5> none{};
  CopySurvey survey;
  survey.Add(arrays, none, 0, 0);
  const std::array<float, 1> value{ 1 };
  const std::array<const void*, 5> empty{ value.data(), value.data(), value.data(), value.data(),
    value.data() };
  survey.Add(arrays, empty, 0, 0);
  for (const auto& copy : survey.Finish(arrays))
  {
    EXPECT_FALSE(copy);
  }
}

TEST(ArrayCopies, OfPartsMustBeCopiesInAllOfThem)
{
  const std::vector<ArrayDescription> arrays{ { "a", Association::Point, ScalarType::Int32, 1, 0, 0,
                                                {} },
    { "b", Association::Point, ScalarType::Int32, 1, 0, 0, {} } };
  const std::vector<std::int32_t> same{ 5, 6, 7 }, other{ 5, 6, 8 };
  const std::array<const void*, 2> equal{ same.data(), same.data() };
  const std::array<const void*, 2> different{ same.data(), other.data() };
  CopySurvey first, second;
  first.Add(arrays, equal, 3, 0);
  EXPECT_TRUE(first.Finish(arrays)[1]);
  EXPECT_FALSE(first.Finish(arrays)[0]);
  second.Add(arrays, different, 3, 0);
  ByteWriter message;
  second.Put(message);
  ByteReader in(message.Data);
  first.Add(in);
  EXPECT_FALSE(first.Finish(arrays)[1]);
  ArrayCopies wrong(2);
  wrong[1] = ArrayCopy{ 0, { 0 } };
  EXPECT_NO_THROW(CheckCopies(wrong, arrays, equal, 3, 0));
  EXPECT_THROW(CheckCopies(wrong, arrays, different, 3, 0), Error);
}

TEST(ArrayCopies, MustBeOfArraysThatAreThere)
{
  const auto path = WriteSteps(MakeCubes(6, 0.2))->GetPath();
  const auto expectRefused = [&](const std::string& what, auto&& change)
  {
    FileImage image(path);
    change(image, image.Steps[1].Arrays);
    const auto changed = PutFile("changed.gtn", image.Build());
    EXPECT_GATUN_ERROR(ErrorCode::Corrupt, changed, what, [&] { ReadAll(changed); });
  };
  const auto copy = [](ArrayStep& array, std::size_t c, std::uint32_t from, std::uint32_t component)
  {
    array.Palettes[c] = {};
    array.Palettes[c].SourceArray = from;
    array.Palettes[c].SourceComponent = component;
  };
  const std::string missing = "an array is copied from one that is not there";
  expectRefused(missing, [&](FileImage&, auto& arrays) { copy(arrays[0], 0, 5, 0); });
  expectRefused(missing, [&](FileImage&, auto& arrays) { copy(arrays[0], 0, 0, 0); }); // itself
  expectRefused(missing, [&](FileImage&, auto& arrays) { copy(arrays[0], 0, 2, 0); }); // a copy
  expectRefused(
    missing, [&](FileImage&, auto& arrays) { copy(arrays[0], 0, 3, 0); }); // another type
  expectRefused(missing, [&](FileImage&, auto& arrays) { copy(arrays[0], 0, 1, 3); }); // component
  const std::string part = "only a part of an array is copied from another one";
  expectRefused(part, [&](FileImage&, auto& arrays) { arrays[2].Palettes[1] = {}; });
  expectRefused(part, [&](FileImage&, auto& arrays) { copy(arrays[2], 1, 3, 0); });
  expectRefused("coordinates are copied from an array",
    [&](FileImage& image, auto&) { image.Mesh.Palettes[1].SourceArray = 0; });
}
}
