// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// make-surface: surfaces for studies of files. surface-files: their sizes and times of decoding as
// .vtp and by meshoptimizer with zstd beside .gtn. Draco and OpenCTM are programs of their own,
// which runSurfaces.py starts on the file that surface-files leaves for them.

#include "benchCases.h"
#include "benchTriangles.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkGatunSurfaceReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <zstd.h>

#if BENCH_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <numbers>
#include <random>

namespace bench
{
namespace
{
struct SurfaceFilesOptions
{
  std::string Kind;
  std::size_t Triangles = 0;
  std::string In, Packed, Out;
  int Rounds = 1;
};

//------------------------------------------------------------------------------
// Surfaces

/** A place of a head of many bumps, as a scanner on a turntable sees it. */
std::array<double, 3> ToPlace(double u, double v, double noise)
{
  const double a = 2 * std::numbers::pi * u;
  const double b = std::numbers::pi * (0.04 + 0.92 * v);
  double radius = 100;
  for (int octave = 0; octave < 5; ++octave)
  {
    const int f = 2 << octave;
    radius += 14.0 / (1 << octave) * std::sin(f * b + octave) * std::cos(f * a + 1.3 * octave);
  }
  radius += noise;
  return { radius * std::sin(b) * std::cos(a), radius * std::sin(b) * std::sin(a),
    radius * std::cos(b) };
}

/** The normal of the surface without noise. */
std::array<double, 3> ToNormal(double u, double v)
{
  constexpr double step = 1e-6;
  std::array<double, 3> a{};
  std::array<double, 3> b{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    a[i] = ToPlace(u + step, v, 0)[i] - ToPlace(u - step, v, 0)[i];
    b[i] = ToPlace(u, v + step, 0)[i] - ToPlace(u, v - step, 0)[i];
  }
  const std::array<double, 3> n{ b[1] * a[2] - b[2] * a[1], b[2] * a[0] - b[0] * a[2],
    b[0] * a[1] - b[1] * a[0] };
  const double length = std::hypot(n[0], n[1], n[2]);
  return { n[0] / length, n[1] / length, n[2] / length };
}

/** Rows of a scanner: places moved at random, the shorter diagonals; with noise along the ray, or
 * smooth, with normals and texture coordinates. */
Triangles MakeScan(std::size_t count, bool isTextured)
{
  const auto rows = static_cast<vtkIdType>(std::sqrt(static_cast<double>(count) / 4)) + 2;
  const vtkIdType columns = 2 * rows;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> move(-0.3, 0.3);
  std::normal_distribution<double> noise(0, 0.02);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TCoords");
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType row = 0; row < rows; ++row)
  {
    for (vtkIdType column = 0; column < columns; ++column)
    {
      const double u = (static_cast<double>(column) + move(random)) / static_cast<double>(columns);
      const double v = (static_cast<double>(row) + move(random)) / static_cast<double>(rows);
      points->InsertNextPoint(ToPlace(u, v, isTextured ? 0 : noise(random)).data());
      if (isTextured)
      {
        normals->InsertNextTuple(ToNormal(u, v).data());
        coordinates->InsertNextTuple2(u, v);
      }
    }
  }
  const auto distance = [&](vtkIdType a, vtkIdType b)
  {
    double p[3];
    double q[3];
    points->GetPoint(a, p);
    points->GetPoint(b, q);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  vtkNew<vtkCellArray> polys;
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const vtkIdType ids[] = { a, b, c };
    polys->InsertNextCell(3, ids);
  };
  for (vtkIdType row = 0; row + 1 < rows; ++row)
  {
    for (vtkIdType column = 0; column < columns; ++column)
    {
      const vtkIdType a = row * columns + column;
      const vtkIdType b = row * columns + (column + 1) % columns;
      const vtkIdType c = b + columns;
      const vtkIdType d = a + columns;
      if (distance(a, c) < distance(b, d))
      {
        add(a, b, c);
        add(a, c, d);
      }
      else
      {
        add(a, b, d);
        add(b, c, d);
      }
    }
  }
  Triangles surface = Triangles::New();
  surface->SetPoints(points);
  surface->SetPolys(polys);
  if (isTextured)
  {
    surface->GetPointData()->SetNormals(normals);
    surface->GetPointData()->SetTCoords(coordinates);
  }
  return surface;
}

void WriteVtp(vtkPolyData* surface, const std::string& file, int compressor)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName(file.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorType(compressor);
  if (writer->Write() == 0)
  {
    throw Failure(file + " cannot be written");
  }
}

void Make(const SurfaceFilesOptions& options)
{
  const bool isTextured = options.Kind == "textured";
  const Triangles surface = options.Kind == "scan" || isTextured
    ? MakeScan(options.Triangles, isTextured)
    : options.Kind == "boundary" ? LoadTriangles(options.In, "", "", 0)
                                 : MakeTriangles(options.Kind, options.Triangles);
  WriteVtp(surface, options.Out, vtkXMLWriterBase::NONE);
}

//------------------------------------------------------------------------------
// Files

/** Writes a .obj file with all digits: points, and normals and texture coordinates if there are
 * any. */
void WriteObj(vtkPolyData* surface, const std::string& file)
{
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(file.c_str(), "w"), std::fclose);
  if (!out)
  {
    throw Failure(file + " cannot be written");
  }
  const auto writeAll = [&](vtkDataArray* array, const char* name, int components)
  {
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      std::fputs(name, out.get());
      for (int c = 0; c < components; ++c)
      {
        std::fprintf(out.get(), " %.9g", array->GetComponent(i, c));
      }
      std::fputc('\n', out.get());
    }
  };
  vtkDataArray* const coordinates = surface->GetPointData()->GetTCoords();
  vtkDataArray* const normals = surface->GetPointData()->GetNormals();
  writeAll(surface->GetPoints()->GetData(), "v", 3);
  writeAll(coordinates, "vt", 2);
  writeAll(normals, "vn", 3);
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    surface->GetCellPoints(i, size, ids);
    std::fputc('f', out.get());
    for (vtkIdType k = 0; k < size; ++k)
    {
      const auto id = static_cast<long long>(ids[k] + 1);
      std::fprintf(out.get(), " %lld", id);
      if (coordinates && normals)
      {
        std::fprintf(out.get(), "/%lld/%lld", id, id);
      }
    }
    std::fputc('\n', out.get());
  }
}

/** What meshoptimizer and zstd make of the triangles and all float arrays on their points. */
struct Optimized
{
  std::vector<unsigned char> Indices, Vertices;
  std::size_t IndexBytes = 0;
  std::size_t VertexBytes = 0;
  std::size_t Corners = 0;
  std::size_t Points = 0;
  std::size_t Floats = 0; ///< of a point
};

#if BENCH_HAS_MESHOPTIMIZER
std::vector<unsigned char> Compress(const std::vector<unsigned char>& data)
{
  constexpr int level = 19;
  std::vector<unsigned char> result(ZSTD_compressBound(data.size()));
  result.resize(ZSTD_compress(result.data(), result.size(), data.data(), data.size(), level));
  return result;
}

std::vector<unsigned char> Decompress(const std::vector<unsigned char>& data, std::size_t bytes)
{
  std::vector<unsigned char> result(bytes);
  if (ZSTD_decompress(result.data(), bytes, data.data(), data.size()) != bytes)
  {
    throw Failure("zstd does not give its input back");
  }
  return result;
}

Optimized Optimize(vtkPolyData* surface)
{
  Optimized result;
  std::vector<unsigned int> indices;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    surface->GetCellPoints(i, size, ids);
    indices.insert(indices.end(), ids, ids + size);
  }
  result.Corners = indices.size();
  result.Points = static_cast<std::size_t>(surface->GetNumberOfPoints());
  std::vector<vtkDataArray*> arrays{ surface->GetPoints()->GetData() };
  for (int i = 0; i < surface->GetPointData()->GetNumberOfArrays(); ++i)
  {
    arrays.push_back(surface->GetPointData()->GetArray(i));
  }
  for (vtkDataArray* array : arrays)
  {
    result.Floats += static_cast<std::size_t>(array->GetNumberOfComponents());
  }
  std::vector<float> vertices;
  vertices.reserve(result.Points * result.Floats);
  for (std::size_t i = 0; i < result.Points; ++i)
  {
    for (vtkDataArray* array : arrays)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        vertices.push_back(static_cast<float>(array->GetComponent(static_cast<vtkIdType>(i), c)));
      }
    }
  }
  const std::size_t stride = result.Floats * sizeof(float);
  meshopt_optimizeVertexCacheStrip(indices.data(), indices.data(), indices.size(), result.Points);
  meshopt_optimizeVertexFetch(
    vertices.data(), indices.data(), indices.size(), vertices.data(), result.Points, stride);
  std::vector<unsigned char> coded(meshopt_encodeIndexBufferBound(indices.size(), result.Points));
  coded.resize(
    meshopt_encodeIndexBuffer(coded.data(), coded.size(), indices.data(), indices.size()));
  result.IndexBytes = coded.size();
  result.Indices = Compress(coded);
  coded.resize(meshopt_encodeVertexBufferBound(result.Points, stride));
  coded.resize(
    meshopt_encodeVertexBuffer(coded.data(), coded.size(), vertices.data(), result.Points, stride));
  result.VertexBytes = coded.size();
  result.Vertices = Compress(coded);
  return result;
}

void Restore(const Optimized& from)
{
  const auto indices = Decompress(from.Indices, from.IndexBytes);
  std::vector<unsigned int> corners(from.Corners);
  const auto vertices = Decompress(from.Vertices, from.VertexBytes);
  std::vector<float> values(from.Points * from.Floats);
  if (meshopt_decodeIndexBuffer(corners.data(), corners.size(), sizeof(unsigned int),
        indices.data(), indices.size()) != 0 ||
    meshopt_decodeVertexBuffer(values.data(), from.Points, from.Floats * sizeof(float),
      vertices.data(), vertices.size()) != 0)
  {
    throw Failure("meshoptimizer does not give its input back");
  }
}
#endif

void Run(const SurfaceFilesOptions& options)
{
  vtkNew<vtkXMLPolyDataReader> input;
  input->SetFileName(options.In.c_str());
  input->Update();
  vtkPolyData* const surface = input->GetOutput();
  if (surface->GetNumberOfPolys() == 0 || surface->GetPolys()->GetMaxCellSize() != 3 ||
    surface->GetNumberOfPolys() != surface->GetNumberOfCells())
  {
    throw Failure(options.In + " has other cells than triangles, or none");
  }
  const std::string zlib = options.Out + "/zlib.vtp";
  const std::string lzma = options.Out + "/lzma.vtp";
  WriteVtp(surface, zlib, vtkXMLWriterBase::ZLIB);
  WriteVtp(surface, lzma, vtkXMLWriterBase::LZMA);
  WriteObj(surface, options.Out + "/peers.obj");
  const auto read = [](auto&& reader, const std::string& file)
  {
    reader->SetFileName(file.c_str());
    reader->Update();
    if (reader->GetOutput()->GetNumberOfCells() == 0)
    {
      throw Failure(file + " cannot be read");
    }
  };
  std::vector<Operation> operations{
    { "gtn", [&] { read(vtkNew<vtkGatunSurfaceReader>(), options.Packed); } },
    { "vtp-zlib", [&] { read(vtkNew<vtkXMLPolyDataReader>(), zlib); } },
    { "vtp-lzma", [&] { read(vtkNew<vtkXMLPolyDataReader>(), lzma); } },
  };
#if BENCH_HAS_MESHOPTIMIZER
  const Optimized optimized = Optimize(surface);
  operations.push_back({ "meshopt", [&] { Restore(optimized); } });
#endif
  WarmUpAndRunInterleaved(operations, options.Rounds);
  PrintJson(
    [&](Json::Value& json)
    {
      json["triangles"] = static_cast<std::uint64_t>(surface->GetNumberOfCells());
      json["points"] = static_cast<std::uint64_t>(surface->GetNumberOfPoints());
      json["bytes"]["gtn"] = FileSize(options.Packed);
      json["bytes"]["vtp-zlib"] = FileSize(zlib);
      json["bytes"]["vtp-lzma"] = FileSize(lzma);
#if BENCH_HAS_MESHOPTIMIZER
      json["bytes"]["meshopt"] =
        static_cast<std::uint64_t>(optimized.Indices.size() + optimized.Vertices.size());
      json["meshoptIndices"] = static_cast<std::uint64_t>(optimized.Indices.size());
#endif
      for (const Operation& operation : operations)
      {
        AddList(json["seconds"], operation.Name.c_str(), operation.Seconds);
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddMakeSurface(CLI::App& app)
{
  auto options = std::make_shared<SurfaceFilesOptions>();
  CLI::App* command =
    app.add_subcommand("make-surface", "Make a surface of triangles, as a raw .vtp file");
  command
    ->add_option("KIND", options->Kind,
      "scan (noise), textured (normals and texture coordinates), boundary (of a .vtu file, or a "
      ".vtp file without its arrays), or one "
      "of simplify-surface")
    ->required();
  command->add_option("OUT", options->Out)->required();
  command->add_option("--triangles", options->Triangles, "About how many")
    ->check(CLI::Range(10, 100000000));
  command->add_option("--mesh", options->In, "The .vtu or .vtp file of a boundary");
  command->callback([options] { Make(*options); });
}

//------------------------------------------------------------------------------
void AddSurfaceFiles(CLI::App& app)
{
  auto options = std::make_shared<SurfaceFilesOptions>();
  CLI::App* command = app.add_subcommand("surface-files",
    "Sizes and times of loading of triangles as .gtn and .vtp, and by meshoptimizer with zstd. "
    "Leaves peers.obj in the folder.");
  command->add_option("IN", options->In, "A .vtp file of triangles")->required();
  command->add_option("PACKED", options->Packed, "The same one as a .gtn file")->required();
  command->add_option("FOLDER", options->Out, "For scratch files")->required();
  command->add_option("--rounds", options->Rounds)->check(CLI::Range(1, 1000));
  command->callback([options] { Run(*options); });
}
}
