// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileSurfaceSamples_h
#define gatunFileSurfaceSamples_h

// Files for tests of isosurfaces, and their isosurfaces from the decoded mesh.

#include "gatunFileSurface.h"
#include "gatunPieceDecoder.h"
#include "gatunTestFile.h"
#include "gatunTestTrees.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace gatun::test
{
inline constexpr std::uint32_t FieldArray = 0;
inline constexpr std::uint32_t VectorArray = 1;
inline constexpr std::uint32_t MaterialArray = 2;

/** A triangle with all it has, beginning with its smallest corner. */
struct FoundTriangle
{
  std::array<std::vector<double>, 3> Corners; // place, arrays
  double Material = 0;

  auto operator<=>(const FoundTriangle&) const = default;
};

/** The triangles of a surface, sorted; of a request with all arrays, or some of them. */
inline std::vector<FoundTriangle> GetTriangles(
  const Surface& surface, ScalarType type, const std::vector<std::uint32_t>& arrays = { 0, 1, 2 })
{
  const std::size_t count = surface.GetNumberOfPoints();
  std::vector<std::vector<double>> points(count);
  const auto append = [&](auto&& fill, auto zero, std::size_t components)
  {
    std::vector<decltype(zero)> values(components * count);
    fill(values.data());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      points[i / components].push_back(values[i]);
    }
  };
  const auto fillPoints = [&](void* to) { surface.FillPoints(to); };
  type == ScalarType::Float32 ? append(fillPoints, 0.0f, 3) : append(fillPoints, 0.0, 3);
  std::size_t number = 0;
  if (std::count(arrays.begin(), arrays.end(), FieldArray) > 0)
  {
    append([&](void* to) { surface.FillPointArray(number++, 4, to); }, 0.0f, 1);
  }
  if (std::count(arrays.begin(), arrays.end(), VectorArray) > 0)
  {
    append([&](void* to) { surface.FillPointArray(number++, 24, to); }, 0.0, 3);
  }
  std::vector<std::int32_t> materials(surface.GetNumberOfTriangles());
  if (std::count(arrays.begin(), arrays.end(), MaterialArray) > 0)
  {
    surface.FillCellArray(0, 4, materials.data());
  }
  const auto corners = surface.GetTriangles();
  std::vector<FoundTriangle> triangles;
  for (std::size_t i = 0; i < materials.size(); ++i)
  {
    const auto& t = corners[i];
    FoundTriangle triangle{ { points[t[0]], points[t[1]], points[t[2]] },
      static_cast<double>(materials[i]) };
    std::rotate(triangle.Corners.begin(),
      std::min_element(triangle.Corners.begin(), triangle.Corners.end()), triangle.Corners.end());
    triangles.push_back(std::move(triangle));
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/** The normal of each point, by its place. */
inline std::map<std::array<double, 3>, std::array<float, 3>> GetNormals(const Surface& surface)
{
  std::vector<double> points(3 * surface.GetNumberOfPoints());
  std::vector<float> normals(points.size());
  surface.FillPoints(points.data());
  surface.FillNormals(normals.data());
  std::map<std::array<double, 3>, std::array<float, 3>> all;
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    all[{ points[i], points[i + 1], points[i + 2] }] = { normals[i], normals[i + 1],
      normals[i + 2] };
  }
  return all;
}

inline FileSurfaceRequest AskFor(const std::vector<double>& values,
  std::uint32_t array = FieldArray, int component = -1, std::size_t step = 0)
{
  FileSurfaceRequest request;
  request.Options.Values = values;
  request.Options.CoordinateType = ScalarType::Float64;
  request.Array = array;
  request.Component = component;
  request.Step = step;
  request.Arrays = { 0, 1, 2 };
  return request;
}

/** The surface of the mesh that a file, or a chunk of it, gives when it is decoded. */
inline Surface MakeSlowly(const std::shared_ptr<const FileReader>& file,
  const FileSurfaceRequest& request, std::size_t merges = 0)
{
  PieceDecoder decoder(file);
  auto piece = AskForAll(*file);
  piece.Step = request.Step;
  piece.Merges = merges;
  if (merges > 0)
  {
    piece.Tree = std::make_shared<const MergeTree>(file->GetMergeTree());
  }
  const Piece whole(decoder, piece);
  SurfaceInput input;
  input.Mesh.Points = whole.Mesh.GetPoints();
  input.Mesh.Connectivity = whole.Mesh.Ids.data();
  input.Points = { whole.Mesh.Coordinates.data(), ScalarType::Float64, 3 };
  input.PointArrays = { { whole.Field.data(), ScalarType::Float32, 1 },
    { whole.Vector.data(), ScalarType::Float64, 3 } };
  input.CellArrays = { { whole.Material.data(), ScalarType::Int32, 1 } };
  std::vector<double> converted;
  SetMarchValues(input.Mesh, input.PointArrays[request.Array], whole.Mesh.GetPoints(),
    request.Component, converted);
  return Surface(
    MakeSurfaceParts(input, request.Options, whole.Mesh.GetTets()), request.Options.CoordinateType);
}

inline std::shared_ptr<const FileReader> MakeFile(const std::string& name, std::uint32_t chunkTets,
  int steps = 1, const TestMesh& mesh = MakeCubes(8, 0.2))
{
  const auto path = TempPath("file-surface-" + name);
  WriterOptions options;
  options.ChunkSize = chunkTets;
  Write(path, mesh, options, steps);
  return std::make_shared<const FileReader>(path);
}

/** Writes cubes with a tree by the field. */
inline std::shared_ptr<const FileReader> MakeTreeFile(const std::string& name)
{
  const auto mesh = MakeCubes(8, 0.2);
  const auto tree = BuildTree(mesh);
  WriterOptions options;
  options.ChunkSize = 100;
  options.Tree = &tree;
  const auto path = TempPath("file-surface-" + name);
  Write(path, mesh, options, 2);
  return std::make_shared<const FileReader>(path);
}

/** Chunks whose tetrahedra, decoded one chunk at a time, a value passes through. */
inline std::vector<std::uint32_t> FindSlowly(
  const std::shared_ptr<const FileReader>& file, const FileSurfaceRequest& request)
{
  PieceDecoder decoder(file);
  std::vector<std::uint32_t> found;
  for (std::uint32_t chunk = 0; chunk < file->GetChunks().size(); ++chunk)
  {
    auto piece = AskForAll(*file);
    piece.Chunks = { chunk };
    piece.Step = request.Step;
    piece.WithUnusedPoints = false;
    const Piece part(decoder, piece);
    MarchInput mesh;
    std::vector<double> values;
    const TupleView field{ part.Field.data(), ScalarType::Float32, 1 };
    const TupleView vector{ part.Vector.data(), ScalarType::Float64, 3 };
    SetMarchValues(mesh, request.Array == FieldArray ? field : vector, part.Mesh.GetPoints(),
      request.Component, values);
    if (request.Array == FieldArray)
    {
      values.assign(part.Field.begin(), part.Field.end());
    }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    if (std::any_of(request.Options.Values.begin(), request.Options.Values.end(),
          [&, low = *least, high = *most](double v) { return low < v && v <= high; }))
    {
      found.push_back(chunk);
    }
  }
  return found;
}
}

#endif
