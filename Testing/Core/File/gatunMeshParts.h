// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMeshParts_h
#define gatunMeshParts_h

// Meshes that are divided into parts, written by a PartWriter, read, and compared.

#include "gatunCellMixture.h"
#include "gatunFileReader.h"
#include "gatunPartWriter.h"
#include "gatunPieceDecoder.h"
#include "gatunTestMeshes.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gatun::test
{
/** A mesh with values that follow from its points and the numbers of its cells. */
struct PartMesh
{
  Mixture Cells{ 0 };
  bool IsTetrahedral = false; // written without types
  std::vector<std::int64_t> PointIds;
  std::vector<std::int64_t> CellIds;
  std::function<double(const double*)> Bias; // added to the point values, if any

  std::size_t GetPoints() const { return this->Cells.Coordinates.size() / 3; }
  std::size_t GetCells() const { return this->Cells.Types.size(); }

  MeshInput GetInput() const
  {
    auto input = this->Cells.GetInput();
    if (this->IsTetrahedral)
    {
      input.Types = nullptr;
      input.Offsets = nullptr;
    }
    if (this->IsTetrahedral || this->Cells.Faces.empty())
    {
      input.FaceLocations = input.Faces = nullptr;
    }
    return input;
  }

  static std::vector<ArrayDescription> Describe()
  {
    return { { "point", Association::Point, ScalarType::Float64, 1, 0, 0, {} },
      { "level", Association::Point, ScalarType::Float32, 2, 0, 0, {} },
      { "cell", Association::Cell, ScalarType::Int32, 1, 0, 0, {} },
      { "rounded", Association::Point, ScalarType::Float64, 1, 0, 0, {} },
      { "twin", Association::Point, ScalarType::Float64, 1, 0, 0, {} } };
  }
};

/** The values of PartMesh::Describe at a step. */
struct PartValues
{
  std::vector<double> Point;
  std::vector<float> Level; // few different ones
  std::vector<std::int32_t> Cell;
  std::vector<double> Rounded; // to three decimals
  std::vector<double> Twin;    // at most steps the first array once more

  PartValues() = default;
  PartValues(const PartMesh& mesh, int step)
  {
    for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
    {
      const double* x = &mesh.Cells.Coordinates[3 * p];
      this->Point.push_back(std::sin(x[0] + step) + x[1] * x[2] + (mesh.Bias ? mesh.Bias(x) : 0.0));
      this->Rounded.push_back(std::floor(this->Point.back() * 1000) / 1000);
      this->Twin.push_back(this->Point.back() + (step == 2 ? 1 : 0));
      this->Level.push_back(std::floor(static_cast<float>(x[2])));
      this->Level.push_back(static_cast<float>(step));
    }
    for (const auto id : mesh.CellIds)
    {
      this->Cell.push_back(static_cast<std::int32_t>(id + step));
    }
  }

  std::array<const void*, 5> Get() const
  {
    return { this->Point.data(), this->Level.data(), this->Cell.data(), this->Rounded.data(),
      this->Twin.data() };
  }
};

inline PartMesh MakePartMesh(const Mixture& cells, bool isTetrahedral = false)
{
  PartMesh mesh;
  mesh.Cells = cells;
  mesh.IsTetrahedral = isTetrahedral;
  mesh.PointIds.resize(mesh.GetPoints());
  std::iota(mesh.PointIds.begin(), mesh.PointIds.end(), 0);
  mesh.CellIds.resize(mesh.GetCells());
  std::iota(mesh.CellIds.begin(), mesh.CellIds.end(), 0);
  return mesh;
}

inline PartMesh MakePartMesh(const TestMesh& tets)
{
  Mixture cells(0);
  cells.Coordinates = tets.Coordinates;
  for (std::size_t t = 0; t < tets.GetTets(); ++t)
  {
    const auto* ids = &tets.Ids[4 * t];
    cells.AddCell(Tetra, { ids[0], ids[1], ids[2], ids[3] });
  }
  return MakePartMesh(cells, true);
}

/** The parts of a mesh. partOf: the part of each cell. Points are in the order of the mesh; those
 * of no cell belong to the first part. */
inline std::vector<PartMesh> Divide(
  const PartMesh& mesh, std::size_t parts, const std::vector<std::size_t>& partOf)
{
  std::vector<PartMesh> result(parts);
  std::vector<std::uint8_t> isUsed(mesh.GetPoints(), 0);
  const auto& cells = mesh.Cells;
  for (std::size_t p = parts; p-- > 0;)
  {
    auto& part = result[p];
    part.Cells = Mixture(0);
    part.Cells.Coordinates.clear();
    part.IsTetrahedral = mesh.IsTetrahedral;
    part.Bias = mesh.Bias;
    std::vector<std::int64_t> place(mesh.GetPoints(), -1);
    const auto forEachId = [&](auto&& use)
    {
      for (std::size_t c = 0; c < partOf.size(); ++c)
      {
        for (auto i = cells.Offsets[c]; partOf[c] == p && i < cells.Offsets[c + 1]; ++i)
        {
          use(c, cells.Ids[static_cast<std::size_t>(i)]);
        }
      }
    };
    forEachId([&](std::size_t, std::int64_t id) { place[static_cast<std::size_t>(id)] = 0; });
    for (std::size_t i = 0; i < place.size(); ++i)
    {
      isUsed[i] |= place[i] == 0;
      if (place[i] == 0 || (p == 0 && !isUsed[i]))
      {
        place[i] = static_cast<std::int64_t>(part.PointIds.size());
        part.PointIds.push_back(mesh.PointIds[i]);
        const auto* x = &cells.Coordinates[3 * i];
        part.Cells.Coordinates.insert(part.Cells.Coordinates.end(), x, x + 3);
      }
    }
    for (std::size_t c = 0; c < partOf.size(); ++c)
    {
      if (partOf[c] != p)
      {
        continue;
      }
      part.CellIds.push_back(mesh.CellIds[c]);
      part.Cells.AddCell(cells.Types[c], {});
      for (auto i = cells.Offsets[c]; i < cells.Offsets[c + 1]; ++i)
      {
        part.Cells.Ids.push_back(
          place[static_cast<std::size_t>(cells.Ids[static_cast<std::size_t>(i)])]);
      }
      part.Cells.Offsets.back() = static_cast<std::int64_t>(part.Cells.Ids.size());
      if (cells.FaceLocations[c] >= 0)
      {
        part.Cells.FaceLocations.back() = static_cast<std::int64_t>(part.Cells.Faces.size());
        auto at = static_cast<std::size_t>(cells.FaceLocations[c]);
        const auto faces = cells.Faces[at++];
        part.Cells.Faces.push_back(faces);
        for (std::int64_t face = 0; face < faces; ++face)
        {
          auto points = cells.Faces[at++];
          part.Cells.Faces.push_back(points);
          for (; points > 0; --points)
          {
            part.Cells.Faces.push_back(place[static_cast<std::size_t>(cells.Faces[at++])]);
          }
        }
      }
    }
  }
  return result;
}

/** Cells to parts at random. */
inline std::vector<std::size_t> DealRandomly(const PartMesh& mesh, std::size_t parts, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::size_t> partOf(mesh.GetCells());
  std::generate(partOf.begin(), partOf.end(), [&] { return random() % parts; });
  return partOf;
}

/** Cells to parts by the height of their first point. */
inline std::vector<std::size_t> DealSlabs(const PartMesh& mesh, std::size_t parts, double height)
{
  std::vector<std::size_t> partOf;
  for (std::size_t c = 0; c < mesh.GetCells(); ++c)
  {
    const auto id =
      static_cast<std::size_t>(mesh.Cells.Ids[static_cast<std::size_t>(mesh.Cells.Offsets[c])]);
    const double place = mesh.Cells.Coordinates[3 * id + 2] / height * static_cast<double>(parts);
    partOf.push_back(
      static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(parts) - 1)));
  }
  return partOf;
}

/** Writes parts. steps: 0 and more; with times if there are several. */
inline PartStatistics WriteParts(const std::string& path, const std::vector<PartMesh>& parts,
  const PartWriterOptions& options = {}, int steps = 1, bool withIds = false)
{
  PartWriter writer(path, PartMesh::Describe(), options);
  for (const auto& part : parts)
  {
    writer.Survey(part.GetInput(), withIds ? part.PointIds.data() : nullptr);
    for (int step = 0; step < steps; ++step)
    {
      writer.SurveyStep(PartValues(part, step).Get());
    }
  }
  for (const auto& part : parts)
  {
    writer.Write(part.GetInput(), withIds ? part.PointIds.data() : nullptr);
    for (int step = 0; step < steps; ++step)
    {
      writer.WriteStep(PartValues(part, step).Get(), {}, steps > 1, step);
    }
  }
  return writer.Finish();
}

/** Writes a mesh as a whole. */
inline void WriteWhole(
  const std::string& path, const PartMesh& mesh, const WriterOptions& options = {}, int steps = 1)
{
  FileWriter writer(path, mesh.GetInput(), PartMesh::Describe(), options);
  for (int step = 0; step < steps; ++step)
  {
    writer.WriteStep(PartValues(mesh, step).Get(), {}, steps > 1, step);
  }
  writer.Finish();
}

/** What a file has. */
struct PartContent
{
  PartMesh Mesh;
  PartValues Values;

  PartContent(const std::string& path, std::size_t step)
    : PartContent(std::make_shared<FileReader>(path), step)
  {
  }

  /** merges: how many of the tree to make before. Given: the tetrahedra alone. */
  PartContent(const std::shared_ptr<const FileReader>& file, std::size_t step,
    std::optional<std::size_t> merges = {})
  {
    PieceDecoder decoder(file);
    PieceRequest request;
    request.Chunks.resize(file->GetChunks().size());
    std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
    request.WithUnusedPoints = !merges;
    request.Arrays = { 0, 1, 2, 3, 4 };
    request.Form = merges ? PieceForm::Tetrahedra : PieceForm::Original;
    if (merges)
    {
      request.Merges = *merges;
      request.Tree = std::make_shared<const MergeTree>(file->GetMergeTree());
    }
    request.Step = step;
    decoder.SetRequest(request);
    const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
    const auto cells = static_cast<std::size_t>(decoder.GetNumberOfCells());
    auto& back = this->Mesh.Cells;
    back.Coordinates.resize(3 * points);
    back.Types.assign(cells, Tetra);
    back.Offsets.resize(cells + 1);
    back.FaceLocations.assign(cells, -1);
    back.Ids.resize(static_cast<std::size_t>(
      decoder.IsTetrahedral() ? 4 * cells : decoder.GetConnectivitySize()));
    back.Faces.resize(static_cast<std::size_t>(decoder.GetFacesSize()));
    this->Values.Point.resize(points);
    this->Values.Level.resize(2 * points);
    this->Values.Cell.resize(cells);
    this->Values.Rounded.resize(points);
    this->Values.Twin.resize(points);
    PieceTarget target;
    target.Points = back.Coordinates.data();
    target.Connectivity = back.Ids.data();
    if (decoder.IsTetrahedral())
    {
      for (std::size_t c = 0; c <= cells; ++c)
      {
        back.Offsets[c] = static_cast<std::int64_t>(4 * c);
      }
    }
    else
    {
      target.Offsets = back.Offsets.data();
      target.Types = back.Types.data();
      target.FaceLocations = back.FaceLocations.data();
      target.Faces = back.Faces.data();
    }
    target.Arrays = { this->Values.Point.data(), this->Values.Level.data(),
      this->Values.Cell.data(), this->Values.Rounded.data(), this->Values.Twin.data() };
    decoder.Fill(target);
  }
};

/** A cell by its type, the places and values of its corners and faces, and its own value. */
using CellText = std::vector<double>;

/** All cells of a mesh, whatever the numbers of its points and cells are. */
inline std::multiset<CellText> ListCells(const PartMesh& mesh, const PartValues& values)
{
  const auto& cells = mesh.Cells;
  const auto getPoint = [&](std::int64_t id)
  {
    const auto p = static_cast<std::size_t>(id);
    return CellText{ cells.Coordinates[3 * p], cells.Coordinates[3 * p + 1],
      cells.Coordinates[3 * p + 2], values.Point[p], values.Level[2 * p], values.Level[2 * p + 1],
      values.Rounded[p], values.Twin[p] };
  };
  const auto join = [](const std::vector<CellText>& texts)
  {
    CellText all;
    for (const auto& text : texts)
    {
      all.insert(all.end(), text.begin(), text.end());
    }
    return all;
  };
  std::multiset<CellText> result;
  for (std::size_t c = 0; c < cells.Types.size(); ++c)
  {
    std::vector<CellText> corners;
    for (auto i = cells.Offsets[c]; i < cells.Offsets[c + 1]; ++i)
    {
      corners.push_back(getPoint(cells.Ids[static_cast<std::size_t>(i)]));
    }
    CellText text{ static_cast<double>(cells.Types[c]), static_cast<double>(values.Cell[c]) };
    if (cells.Types[c] == Tetra)
    {
      // The order of corners is kept but for even permutations.
      bool isOdd = false;
      for (std::size_t i = 0; i < 4; ++i)
      {
        for (std::size_t j = 0; j < i; ++j)
        {
          isOdd = isOdd != (corners[i] < corners[j]);
        }
      }
      text.push_back(isOdd);
    }
    if (cells.Types[c] == Tetra || cells.Types[c] == Polyhedron)
    {
      std::sort(corners.begin(), corners.end());
    }
    if (cells.Types[c] == Triangle)
    {
      // It may begin with any corner.
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    }
    std::vector<CellText> faces;
    if (cells.FaceLocations[c] >= 0)
    {
      auto at = static_cast<std::size_t>(cells.FaceLocations[c]);
      for (auto count = cells.Faces[at++]; count > 0; --count)
      {
        std::vector<CellText> face;
        for (auto points = cells.Faces[at++]; points > 0; --points)
        {
          face.push_back(getPoint(cells.Faces[at++]));
        }
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        faces.push_back(join(face));
      }
      std::sort(faces.begin(), faces.end());
    }
    for (const auto& more : { join(corners), join(faces) })
    {
      text.insert(text.end(), more.begin(), more.end());
    }
    result.insert(text);
  }
  return result;
}

inline std::string ReadBytes(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>() };
}
}

#endif
