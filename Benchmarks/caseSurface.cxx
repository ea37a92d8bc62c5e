// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// make-surface: surfaces to be compressed. surface: their sizes and times of decoding as .vtp and
// by meshoptimizer with zstd beside .gtn. Draco and OpenCTM are programs of their own, which
// report.py starts on the file that surface leaves for them.

#include "benchCases.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGatunSurfaceReader.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"
#include "vtkXMLGenericDataObjectReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <zstd.h>

#if BENCH_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <numbers>
#include <random>

namespace bench
{
namespace
{
using Triangles = vtkSmartPointer<vtkPolyData>;

struct SurfaceOptions
{
  std::size_t Triangles = 0;
  std::string In, Out;
  std::vector<std::string> Packed;
  int Rounds = 1;
};

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

/** Rows of a scanner: places moved at random, noise along the ray, the shorter diagonals. */
Triangles MakeScan(std::size_t count)
{
  const auto rows = static_cast<vtkIdType>(std::sqrt(static_cast<double>(count) / 4)) + 2;
  const vtkIdType columns = 2 * rows;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> move(-0.3, 0.3);
  std::normal_distribution<double> noise(0, 0.02);
  vtkNew<vtkPoints> points;
  for (vtkIdType row = 0; row < rows; ++row)
  {
    for (vtkIdType column = 0; column < columns; ++column)
    {
      const double u = (static_cast<double>(column) + move(random)) / static_cast<double>(columns);
      const double v = (static_cast<double>(row) + move(random)) / static_cast<double>(rows);
      points->InsertNextPoint(ToPlace(u, v, noise(random)).data());
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

/** A .vtp file or the boundary of a .vtu file as triangles without arrays, which not all peers can
 * store. */
Triangles LoadBoundary(const std::string& file)
{
  vtkNew<vtkXMLGenericDataObjectReader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkDataSetSurfaceFilter> boundary;
  boundary->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(boundary->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  Triangles result = Triangles::New();
  result->CopyStructure(triangles->GetOutput());
  return result;
}

void MakeSurface(const SurfaceOptions& options)
{
  const Triangles surface =
    options.In.empty() ? MakeScan(options.Triangles) : LoadBoundary(options.In);
  WriteVtp(surface, options.Out, vtkXMLWriterBase::NONE);
}

/** Writes points with all digits, and triangles. */
void WriteObj(vtkPolyData* surface, const std::string& file)
{
  std::ofstream out(file);
  out.precision(9);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* const p = surface->GetPoint(i);
    out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    surface->GetCellPoints(i, size, ids);
    out << "f " << ids[0] + 1 << ' ' << ids[1] + 1 << ' ' << ids[2] + 1 << '\n';
  }
  if (!out.flush())
  {
    throw Failure(file + " cannot be written");
  }
}

/** What meshoptimizer and zstd make of triangles. */
struct Optimized
{
  std::vector<unsigned char> Indices, Vertices;
  std::size_t IndexBytes = 0;
  std::size_t VertexBytes = 0;
  std::size_t Corners = 0;
  std::size_t Points = 0;
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
  std::vector<float> vertices;
  for (std::size_t i = 0; i < result.Points; ++i)
  {
    const double* const p = surface->GetPoint(static_cast<vtkIdType>(i));
    std::transform(
      p, p + 3, std::back_inserter(vertices), [](double x) { return static_cast<float>(x); });
  }
  constexpr std::size_t stride = 3 * sizeof(float);
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
  std::vector<float> values(3 * from.Points);
  if (meshopt_decodeIndexBuffer(corners.data(), corners.size(), sizeof(unsigned int),
        indices.data(), indices.size()) != 0 ||
    meshopt_decodeVertexBuffer(
      values.data(), from.Points, 3 * sizeof(float), vertices.data(), vertices.size()) != 0)
  {
    throw Failure("meshoptimizer does not give its input back");
  }
}
#endif

void MeasureSurface(const SurfaceOptions& options)
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
  if (!std::filesystem::exists(lzma))
  {
    WriteVtp(surface, zlib, vtkXMLWriterBase::ZLIB);
    WriteVtp(surface, lzma, vtkXMLWriterBase::LZMA);
    WriteObj(surface, options.Out + "/peers.obj");
  }
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
    { "gtn", [&] { read(vtkNew<vtkGatunSurfaceReader>(), options.Packed[0]); } },
    { "gtn-small", [&] { read(vtkNew<vtkGatunSurfaceReader>(), options.Packed[1]); } },
    { "vtp-zlib", [&] { read(vtkNew<vtkXMLPolyDataReader>(), zlib); } },
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
      json["bytes"]["gtn"] = FileSize(options.Packed[0]);
      json["bytes"]["gtn-small"] = FileSize(options.Packed[1]);
      json["bytes"]["vtp-zlib"] = FileSize(zlib);
      json["bytes"]["vtp-lzma"] = FileSize(lzma);
#if BENCH_HAS_MESHOPTIMIZER
      json["bytes"]["meshopt"] =
        static_cast<std::uint64_t>(optimized.Indices.size() + optimized.Vertices.size());
#endif
      for (const Operation& operation : operations)
      {
        AddList(json["seconds"], operation.Name.c_str(), operation.Seconds);
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSurface(CLI::App& app)
{
  auto options = std::make_shared<SurfaceOptions>();
  CLI::App* make =
    app.add_subcommand("make-surface", "Make the scan of a head, as a raw .vtp file");
  make->add_option("OUT", options->Out)->required();
  make->add_option("--triangles", options->Triangles, "About how many")
    ->check(CLI::Range(10, 100000000));
  make->add_option("--mesh", options->In,
    "The triangles of this .vtp file or of the boundary of this .vtu file instead, without arrays");
  make->callback([options] { MakeSurface(*options); });

  CLI::App* surface = app.add_subcommand("surface",
    "Sizes and times of loading of triangles as .gtn and .vtp, and by meshoptimizer with zstd. "
    "Leaves peers.obj in the folder, where later runs find what they need.");
  surface->add_option("IN", options->In, "A .vtp file of triangles")->required();
  surface->add_option("FOLDER", options->Out, "For scratch files")->required();
  surface->add_option("PACKED", options->Packed, "The same one as .gtn files: fast, small")
    ->required()
    ->expected(2);
  surface->add_option("--rounds", options->Rounds)->check(CLI::Range(1, 1000));
  surface->callback([options] { MeasureSurface(*options); });
}
}
