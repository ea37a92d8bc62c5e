// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTestFile_h
#define gatunTestFile_h

// Files with arrays of several kinds, and what they hold.

#include "gatunFileReader.h"
#include "gatunFileWriter.h"
#include "gatunPieceDecoder.h"
#include "gatunTestMeshes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace gatun::test
{
inline std::string TempPath(const std::string& name)
{
  return (std::filesystem::path(GATUN_TEST_TEMP) / name).string();
}

/** Point and cell arrays of different kinds, a function of the step. */
struct Values
{
  explicit Values(const TestMesh& mesh, double step = 0)
  {
    for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
    {
      const double* x = &mesh.Coordinates[3 * p];
      this->Field.push_back(static_cast<float>(std::sin(x[0] + step) * std::cos(x[1]) + x[2]));
      for (int c = 0; c < 3; ++c)
      {
        this->Vector.push_back(x[(c + 1) % 3] * x[c] + step);
      }
    }
    for (std::size_t t = 0; t < mesh.GetTets(); ++t)
    {
      this->Material.push_back(static_cast<std::int32_t>(t / 100) - 3);
    }
  }

  static std::vector<ArrayDescription> Describe()
  {
    std::vector<ArrayDescription> arrays(3);
    arrays[0].Name = "field";
    arrays[1].Name = "vector";
    arrays[1].Type = ScalarType::Float64;
    arrays[1].Components = 3;
    arrays[1].ComponentNames = { "u", "v", "w" };
    arrays[2].Name = "material";
    arrays[2].Where = Association::Cell;
    arrays[2].Type = ScalarType::Int32;
    return arrays;
  }

  std::array<const void*, 3> Get() const
  {
    return { this->Field.data(), this->Vector.data(), this->Material.data() };
  }

  std::vector<float> Field;
  std::vector<double> Vector;
  std::vector<std::int32_t> Material;
};

inline void Write(
  const std::string& path, const TestMesh& mesh, const WriterOptions& options, int steps = 1)
{
  FileWriter writer(path, mesh.GetInput(), Values::Describe(), options);
  for (int step = 0; step < steps; ++step)
  {
    const Values values(mesh, 0.25 * step);
    writer.WriteStep(values.Get(), {}, steps > 1, step);
  }
  writer.Finish();
}

/** What a PieceDecoder fills. */
struct Piece
{
  Piece(PieceDecoder& decoder, const PieceRequest& request)
  {
    decoder.SetRequest(request);
    const auto points = decoder.GetNumberOfPoints();
    const auto tets = decoder.GetNumberOfCells();
    this->Mesh.Coordinates.resize(3 * points);
    this->Mesh.Ids.resize(4 * tets);
    this->Field.resize(points);
    this->Vector.resize(3 * points);
    this->Material.resize(tets);
    this->PointIds.resize(points);
    this->CellIds.resize(tets);
    this->PointGhosts.assign(points, 77);
    this->CellGhosts.assign(tets, 77);
    PieceTarget target;
    target.Points = this->Mesh.Coordinates.data();
    target.Connectivity = this->Mesh.Ids.data();
    target.GlobalPointIds = this->PointIds.data();
    target.GlobalCellIds = this->CellIds.data();
    target.PointGhosts = this->PointGhosts.data();
    target.CellGhosts = this->CellGhosts.data();
    target.Arrays = { this->Field.data(), this->Vector.data(), this->Material.data() };
    decoder.Fill(target);
  }

  TestMesh Mesh;
  std::vector<float> Field;
  std::vector<double> Vector;
  std::vector<std::int32_t> Material;
  std::vector<std::int64_t> PointIds, CellIds;
  std::vector<unsigned char> PointGhosts, CellGhosts;
};

inline PieceRequest AskForAll(const FileReader& file)
{
  PieceRequest request;
  request.Chunks.resize(file.GetChunks().size());
  std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
  request.Arrays = { 0, 1, 2 };
  request.WithUnusedPoints = true;
  return request;
}

/**
 * A cell by all it is: coordinates and values of its corners, the smallest even permutation of
 * them, and its own value. Two meshes with the same multiset of these hold the same cells.
 */
using CellContent = std::vector<double>;

template <typename Mesh, typename Data>
std::multiset<CellContent> GetCells(const Mesh& mesh, const Data& data, std::size_t begin = 0)
{
  constexpr int even[12][4] = { { 0, 1, 2, 3 }, { 0, 2, 3, 1 }, { 0, 3, 1, 2 }, { 1, 0, 3, 2 },
    { 1, 2, 0, 3 }, { 1, 3, 2, 0 }, { 2, 0, 1, 3 }, { 2, 1, 3, 0 }, { 2, 3, 0, 1 }, { 3, 0, 2, 1 },
    { 3, 1, 0, 2 }, { 3, 2, 1, 0 } };
  std::multiset<CellContent> cells;
  for (std::size_t t = begin; t < mesh.GetTets(); ++t)
  {
    CellContent best;
    for (const auto& order : even)
    {
      CellContent content;
      for (const int corner : order)
      {
        const auto p = static_cast<std::size_t>(mesh.Ids[4 * t + static_cast<std::size_t>(corner)]);
        content.insert(content.end(), &mesh.Coordinates[3 * p], &mesh.Coordinates[3 * p] + 3);
        content.push_back(data.Field[p]);
        content.insert(content.end(), &data.Vector[3 * p], &data.Vector[3 * p] + 3);
      }
      if (best.empty() || content < best)
      {
        best = content;
      }
    }
    best.push_back(data.Material[t]);
    cells.insert(best);
  }
  return cells;
}
}

#endif
