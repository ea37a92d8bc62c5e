// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Seeds that are files of smooth values, of changing meshes and dying cells, and of other cells
// than tetrahedra.

#include "makeCorpus.h"

#include "gatunSampleFile.h"
#include "gatunTestMeshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace
{
using namespace gatun;

/** Of all targets that read files. */
void AddFile(Corpus& corpus, const std::string& path)
{
  const test::FileImage image(path);
  std::ifstream in(path, std::ios::binary);
  const std::vector<char> chars{ std::istreambuf_iterator<char>(in), {} };
  const Bytes bytes(chars.begin(), chars.end());
  corpus.Add("File", bytes);
  corpus.Add("Sections", bytes);
  corpus.Add("Tables", GetTables(image));
  std::filesystem::remove(path);
}

/** A smooth function of a point. */
float GetSmooth(const test::TestMesh& mesh, std::size_t i, int step)
{
  const auto* const at = &mesh.Coordinates[3 * i];
  return static_cast<float>(
    std::sin(0.5 * at[0] + 0.2 * step) * std::cos(0.4 * at[1]) + 0.3 * at[2] * at[2]);
}

/** Hexahedra, or quadrilaterals of a sheet. */
struct Grid
{
  Grid(std::int64_t n, bool isSheet)
  {
    const std::int64_t row = n + 1;
    const std::int64_t layers = isSheet ? 0 : n;
    for (std::int64_t z = 0; z <= layers; ++z)
    {
      for (std::int64_t i = 0; i < row * row; ++i)
      {
        const auto x = static_cast<double>(i % row);
        const auto y = static_cast<double>(i / row);
        this->Coordinates.insert(this->Coordinates.end(),
          { x, y + 0.1 * x * x, isSheet ? x * y : static_cast<double>(z) });
      }
    }
    for (std::int64_t cell = 0; cell < n * n * std::max<std::int64_t>(1, layers); ++cell)
    {
      const auto first = cell % n + cell / n % n * row + cell / (n * n) * row * row;
      for (const auto corner : { first, first + 1, first + row + 1, first + row })
      {
        this->Ids.push_back(corner);
      }
      for (std::size_t i = 0; !isSheet && i < 4; ++i)
      {
        this->Ids.push_back(*(this->Ids.end() - 4) + row * row);
      }
      this->Types.push_back(isSheet ? 9 : 12);
      this->Offsets.push_back(static_cast<std::int64_t>(this->Ids.size()));
    }
  }

  MeshInput GetInput() const
  {
    MeshInput mesh;
    mesh.Points = this->Coordinates.size() / 3;
    mesh.CoordinateType = ScalarType::Float64;
    mesh.Coordinates = this->Coordinates.data();
    mesh.Cells = this->Types.size();
    mesh.Connectivity = this->Ids.data();
    mesh.Types = this->Types.data();
    mesh.Offsets = this->Offsets.data();
    return mesh;
  }

  std::vector<double> Coordinates;
  std::vector<std::int64_t> Ids;
  std::vector<std::uint8_t> Types;
  std::vector<std::int64_t> Offsets{ 0 };
};
}

/** The tables of a file as one input: of the mesh and its pages, then of the first step. */
gatun::Bytes GetTables(test::FileImage image)
{
  std::vector<Bytes> mesh(2);
  std::vector<Bytes> pages;
  std::vector<Bytes> step;
  image.ChangeTable = [&](FourCC name, std::size_t number, const Bytes& table)
  {
    if (name == SectionMeta || name == SectionTable)
    {
      mesh[name == SectionTable] = table;
    }
    else if (name == SectionPages)
    {
      pages.push_back(table);
    }
    else if (number == 0)
    {
      step.push_back(table);
    }
  };
  image.Build();
  const auto count = GetPageCount(image.Mesh.Chunks.size());
  for (std::size_t page = 0; page < count; ++page)
  {
    mesh.insert(mesh.begin() + static_cast<std::ptrdiff_t>(2 + page), pages[2 * page]);
    mesh.push_back(pages[2 * page + 1]);
  }
  if (!step.empty())
  {
    const auto first = pages.begin() + static_cast<std::ptrdiff_t>(2 * count);
    step.insert(step.end(), first,
      first + static_cast<std::ptrdiff_t>(image.Meta.Arrays.empty() ? 0 : count));
  }
  mesh.insert(mesh.end(), step.begin(), step.end());
  ByteWriter out;
  for (const auto& table : mesh)
  {
    out.Put(static_cast<std::uint16_t>(table.size()));
    out.PutBytes(table);
  }
  return std::move(out.Data);
}

void AddSmoothFiles(Corpus& corpus)
{
  const auto path = (corpus.GetFolder() / "smooth.gtn").string();
  const std::array<std::pair<ErrorKind, double>, 5> bounds{ { { ErrorKind::None, 0 },
    { ErrorKind::Absolute, 1e-3 }, { ErrorKind::Relative, 1e-4 }, { ErrorKind::Pointwise, 1e-3 },
    { ErrorKind::Bits, 9 } } };
  for (const auto& [kind, bound] : bounds)
  {
    for (const std::int64_t n : { 3, 5 })
    {
      const auto mesh = test::MakeCubes(n, 0.1);
      WriterOptions options;
      options.ChunkSize = 500;
      if (kind != ErrorKind::None)
      {
        options.Errors.push_back({ "*", { kind, bound, n == 3 } });
      }
      test::WriteSample(path, mesh, options, n == 3 ? 1 : 3,
        [&](std::size_t i, int step) { return GetSmooth(mesh, i, step); });
      AddFile(corpus, path);
    }
  }
}

void AddSeriesFiles(Corpus& corpus)
{
  const auto path = (corpus.GetFolder() / "series.gtn").string();
  for (const bool hasBoundary : { false, true })
  {
    const std::array meshes{ test::MakeCubes(2, 0.1), test::MakeCubes(1, 0.2, 5) };
    WriterOptions options;
    options.ChunkSize = 64;
    options.Boundary = hasBoundary;
    options.PointsMove = hasBoundary;
    std::vector<ArrayDescription> arrays(1);
    arrays[0].Name = std::string("p");
    FileWriter writer(path, meshes[0].GetInput(), arrays, options);
    for (int step = 0; step < 5; ++step)
    {
      // The first mesh returns at the end.
      const auto& mesh = meshes[step == 2 || step == 3];
      if (step == 2)
      {
        writer.AddMesh(mesh.GetInput(), options);
      }
      else if (step == 4)
      {
        writer.UseMesh(0);
      }
      std::vector<float> values;
      for (std::size_t i = 0; i < mesh.GetPoints(); ++i)
      {
        values.push_back(GetSmooth(mesh, i, step));
      }
      const std::array<const void*, 1> pointers{ values.data() };
      auto moved = mesh.Coordinates;
      std::for_each(moved.begin(), moved.end(), [](double& x) { x *= 1.25; });
      writer.WriteStep(
        pointers, {}, true, step, {}, options.PointsMove && step == 1 ? moved.data() : nullptr);
    }
    writer.Finish();
    AddFile(corpus, path);
  }
}

void AddDeletedCellFiles(Corpus& corpus)
{
  const auto path = (corpus.GetFolder() / "deleted.gtn").string();
  const auto mesh = test::MakeCubes(3, 0.2);
  const auto other = test::MakeCubes(1, 0.1);
  std::vector<ArrayDescription> arrays(1);
  arrays[0].Name = std::string("p");
  std::vector<std::uint64_t> cells(mesh.GetTets() - 10);
  std::iota(cells.begin(), cells.end(), std::uint64_t{ 10 });
  const std::vector<float> values(mesh.GetPoints(), 0.5f);
  const std::array<const void*, 1> pointers{ values.data() };
  for (const std::uint8_t keep : { KeepNone, KeepAll })
  {
    WriterOptions options;
    options.ChunkSize = 64;
    options.KeyStepInterval = 2;
    options.Keep = keep;
    FileWriter writer(path, mesh.GetInput(), arrays, options);
    writer.WriteStep(pointers, {}, true, 0);
    RemainingCells remaining;
    remaining.Cells = cells;
    writer.WriteStep(pointers, {}, true, 1, {}, nullptr, &remaining);
    remaining.Cells = remaining.Cells.subspan(5);
    writer.WriteStep(pointers, {}, true, 2, {}, nullptr, &remaining);
    for (int i = 0; i < 3; ++i)
    {
      writer.AddMesh((i == 1 ? mesh : other).GetInput(), options);
      writer.WriteStep(pointers, {}, true, 3 + i);
    }
    writer.Finish();
    AddFile(corpus, path);
  }
}

void AddCellFiles(Corpus& corpus)
{
  const auto path = (corpus.GetFolder() / "cells.gtn").string();
  for (const bool isSheet : { false, true })
  {
    for (const std::int64_t n : { 1, 4 })
    {
      const Grid grid(n, isSheet);
      WriterOptions options;
      options.ChunkSize = 64;
      options.IsSurface = isSheet;
      options.Boundary = !isSheet;
      options.Keep = n == 1 ? KeepAll : KeepNone;
      FileWriter writer(path, grid.GetInput(), {}, options);
      writer.WriteStep({}, {}, false, 0);
      writer.Finish();
      AddFile(corpus, path);
    }
  }
}
