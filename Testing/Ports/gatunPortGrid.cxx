// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A mesh that is larger than those of golden files, with the same bits on every system.

#include "gatunPartWriter.h"
#include "gatunPortMesh.h"

#include <array>

namespace gatun::port
{
namespace
{
constexpr int Steps = 2;

/** An arbitrary number below 1 of each number, exact on every system. */
double MakeNumber(std::uint64_t i)
{
  i = (i + 1) * 0x9e3779b97f4a7c15u;
  i = (i ^ i >> 29) * 0xbf58476d1ce4e5b9u;
  return static_cast<double>((i ^ i >> 32) >> 40) / (1u << 24);
}

/** Some layers of a grid of cubes, of six tetrahedra around a diagonal each. */
class Grid
{
public:
  Grid(std::int64_t cubes, std::int64_t begin, std::int64_t end)
  {
    const auto row = cubes + 1;
    for (auto i = row * row * begin; i < row * row * (end + 1); ++i)
    {
      this->AddPoint({ i % row, i / row % row, i / row / row }, static_cast<std::uint64_t>(i));
    }
    for (auto i = cubes * cubes * begin; i < cubes * cubes * end; ++i)
    {
      const auto layer = i / cubes / cubes - begin;
      this->AddCube(i % cubes + row * (i / cubes % cubes + row * layer), row, i);
    }
  }

  MeshInput GetInput() const
  {
    MeshInput input;
    input.Points = this->Smooth.size();
    input.CoordinateType = ScalarType::Float64;
    input.Coordinates = this->Coordinates.data();
    input.Cells = this->Numbers.size();
    input.Connectivity = this->Ids.data();
    return input;
  }

  static std::vector<ArrayDescription> Describe()
  {
    std::vector<ArrayDescription> arrays(3);
    arrays[0].Name = std::string("smooth");
    arrays[0].Type = ScalarType::Float64;
    arrays[1].Name = std::string("rough");
    arrays[1].Components = 2;
    arrays[2].Name = std::string("numbers");
    arrays[2].Where = Association::Cell;
    arrays[2].Type = ScalarType::Int32;
    return arrays;
  }

  /** Calls use(values) with the values of each step. */
  template <typename Use>
  void ForEachStep(Use&& use) const
  {
    auto smooth = this->Smooth;
    for (int step = 0; step < Steps; ++step)
    {
      const std::array<const void*, 3> values{ smooth.data(), this->Rough.data(),
        this->Numbers.data() };
      use(values, step);
      for (auto& value : smooth)
      {
        value *= 1.001;
      }
    }
  }

private:
  void AddPoint(const std::array<std::int64_t, 3>& place, std::uint64_t number)
  {
    for (const auto c : place)
    {
      this->Coordinates.push_back(
        static_cast<double>(c) + 0.4 * MakeNumber(3 * number + this->Coordinates.size() % 3));
    }
    const double* const x = &this->Coordinates[this->Coordinates.size() - 3];
    this->Smooth.push_back(x[0] * x[1] / (1 + x[2] * x[2]) + 1e-3 * MakeNumber(number));
    this->Rough.push_back(static_cast<float>(x[0] * x[2]));
    this->Rough.push_back(static_cast<float>(MakeNumber(number + 1)));
  }

  void AddCube(std::int64_t first, std::int64_t row, std::int64_t number)
  {
    constexpr std::array<std::array<int, 2>, 6> paths{ { { 1, 3 }, { 3, 2 }, { 2, 6 }, { 6, 4 },
      { 4, 5 }, { 5, 1 } } };
    const auto corner = [&](int bits)
    { return first + (bits & 1) + row * (bits >> 1 & 1) + row * row * (bits >> 2); };
    for (const auto& path : paths)
    {
      this->Ids.insert(this->Ids.end(), { corner(0), corner(path[0]), corner(path[1]), corner(7) });
      this->Numbers.push_back(static_cast<std::int32_t>(number / 7));
    }
  }

  std::vector<double> Coordinates;
  std::vector<std::int64_t> Ids;
  std::vector<double> Smooth;
  std::vector<float> Rough;
  std::vector<std::int32_t> Numbers;
};

void WriteGrid(const std::string& path, const Grid& grid)
{
  FileWriter writer(path, grid.GetInput(), Grid::Describe(), {});
  grid.ForEachStep([&](const auto& values, int step) { writer.WriteStep(values, {}, true, step); });
  writer.Finish();
}

void WriteParts(const std::string& path, const std::array<Grid, 2>& parts)
{
  PartWriterOptions options;
  options.File.Keep = KeepAll;
  options.File.Boundary = true;
  options.SpillMemory = 1000; // so that there are temporary files
  PartWriter writer(path, Grid::Describe(), options);
  for (const Grid& part : parts)
  {
    writer.Survey(part.GetInput());
    part.ForEachStep([&](const auto& values, int) { writer.SurveyStep(values); });
  }
  for (const Grid& part : parts)
  {
    writer.Write(part.GetInput());
    part.ForEachStep(
      [&](const auto& values, int step) { writer.WriteStep(values, {}, true, step); });
  }
  writer.Finish();
}
}

//------------------------------------------------------------------------------
void AddGrid(Line& line, std::uint32_t cubes)
{
  const Grid grid(cubes, 0, cubes);
  AddBytesOf(
    line.Encoded["grid"], [&](const std::string& path) { WriteGrid(path, grid); },
    [&](const std::string& path)
    {
      const PortMesh mesh(std::make_shared<const FileReader>(path));
      mesh.AddDecoded(line.Decoded);
      AddEncoded(line, mesh);
    });
  const std::array<Grid, 2> parts{ Grid(cubes, 0, cubes / 2), Grid(cubes, cubes / 2, cubes) };
  AddBytesOf(
    line.Encoded["parts"], [&](const std::string& path) { WriteParts(path, parts); },
    [&](const std::string& path)
    { PortMesh(std::make_shared<const FileReader>(path)).AddDecoded(line.Decoded); });
}
}
