// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// sizes: sizes of files of synthetic meshes, to the byte, so that each change of the codec shows.

#include "benchCases.h"
#include "benchMeshes.h"

#include "gtnThreads.h"

#include "gatunFileReader.h"
#include "vtkGatunWriter.h"

#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>

namespace bench
{
namespace
{

struct Sample
{
  std::string Name;
  Grid Mesh;
  int ChunkSize;
  int KeepOrder;
  int Profile = vtkGatunWriter::PROFILE_SMALL;
};

std::vector<Sample> MakeSizeSamples()
{
  const Grid flow = Permute(MakeFlow({ 20, 16, 14 }, true));
  const Grid lattice = Permute(MakeLattice(12, false));
  const Grid wide = Permute(MakeLattice(12, true));
  const Grid mixed = MakeMixed({ 24, 24, 24 });
  return {
    { "flow", flow, 0, vtkGatunWriter::KEEP_NONE },
    { "flow", flow, 4096, vtkGatunWriter::KEEP_NONE },
    { "flow", flow, 1024, vtkGatunWriter::KEEP_NONE },
    { "flow", flow, 4096, vtkGatunWriter::KEEP_ALL },
    { "lattice", lattice, 0, vtkGatunWriter::KEEP_NONE },
    { "lattice", lattice, 4096, vtkGatunWriter::KEEP_NONE },
    { "lattice", lattice, 64, vtkGatunWriter::KEEP_NONE },
    { "lattice", lattice, 4096, vtkGatunWriter::KEEP_ALL },
    { "lattice-double", wide, 0, vtkGatunWriter::KEEP_NONE },
    { "lattice-double", wide, 4096, vtkGatunWriter::KEEP_NONE },
    { "flow", flow, 4096, vtkGatunWriter::KEEP_NONE, vtkGatunWriter::PROFILE_FAST },
    { "flow", flow, 4096, vtkGatunWriter::KEEP_ALL, vtkGatunWriter::PROFILE_FAST },
    { "lattice", lattice, 4096, vtkGatunWriter::KEEP_NONE, vtkGatunWriter::PROFILE_FAST },
    { "lattice-double", wide, 4096, vtkGatunWriter::KEEP_NONE, vtkGatunWriter::PROFILE_FAST },
    { "mixed", mixed, 4096, vtkGatunWriter::KEEP_NONE, vtkGatunWriter::PROFILE_FAST },
    { "mixed", mixed, 4096, vtkGatunWriter::KEEP_NONE },
  };
}

void WriteSample(const Sample& sample, const std::string& file)
{
  vtkNew<vtkGatunWriter> writer;
  writer->SetInputData(sample.Mesh);
  writer->SetFileName(file.c_str());
  writer->SetChunkSize(sample.ChunkSize);
  writer->SetKeepOrder(sample.KeepOrder);
  writer->SetProfile(sample.Profile);
  if (!writer->Write())
  {
    throw Failure(file, "cannot be written");
  }
}

// Without the directory: zstd compresses it, and its versions differ by a few bytes.
std::string MakeTable(const std::string& scratch)
{
  std::ostringstream table;
  table << "mesh,cells,profile,chunkCells,keepOrder,streams,connectivity,geometry,sharedGeometry,"
           "arrays,order\n";
  for (const Sample& sample : MakeSizeSamples())
  {
    WriteSample(sample, scratch);
    const gatun::FileStatistics sizes = gatun::FileReader(scratch).GetStatistics();
    std::uint64_t arrays = 0;
    for (const std::uint64_t bytes : sizes.ArrayBytes)
    {
      arrays += bytes;
    }
    table << sample.Name << ',' << sample.Mesh->GetNumberOfCells() << ','
          << (sample.Profile == vtkGatunWriter::PROFILE_FAST ? "fast" : "small") << ','
          << sample.ChunkSize << ',' << sample.KeepOrder << ','
          << sizes.FileBytes - sizes.DirectoryBytes << ',' << sizes.ConnectivityBytes << ','
          << sizes.GeometryBytes << ',' << sizes.SharedGeometryBytes << ',' << arrays << ','
          << sizes.OrderBytes << '\n';
  }
  std::filesystem::remove(scratch);
  return table.str();
}

std::string ReadAll(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), {} };
}

void CheckTable(const std::string& table, const std::string& expectedFile)
{
  const std::string expected = ReadAll(expectedFile);
  if (table == expected)
  {
    return;
  }
  std::istringstream now(table);
  std::istringstream before(expected);
  std::string line;
  std::string other;
  while (std::getline(now, line))
  {
    if (!std::getline(before, other) || line != other)
    {
      std::printf("- %s\n+ %s\n", other.c_str(), line.c_str());
    }
    other.clear();
  }
  throw Failure(expectedFile,
    "sizes have changed; if they should, update it with gatunBenchmarks sizes SCRATCH.gtn");
}

/** Whether each mesh becomes the same bytes for each number of threads. */
void CheckThreads(const std::string& scratch)
{
  for (const Sample& sample : MakeSizeSamples())
  {
    std::string first;
    for (const int threads : { 1, 2, 4 })
    {
      gtn::WithThreads(threads, [&] { WriteSample(sample, scratch); });
      const std::string bytes = ReadAll(scratch);
      if (!first.empty() && bytes != first)
      {
        throw Failure(
          sample.Name, "becomes other bytes with more threads of " + gtn::ThreadBackend());
      }
      first = bytes;
    }
  }
  std::filesystem::remove(scratch);
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddSizes(CLI::App& app)
{
  auto scratch = std::make_shared<std::string>();
  auto expected = std::make_shared<std::string>();
  CLI::App* command =
    app.add_subcommand("sizes", "Print a table (CSV) of the sizes of made meshes, or check it");
  command->add_option("SCRATCH", *scratch, "A .gtn file to write")->required();
  command->add_option("--check", *expected,
    "Compare with this table in place of printing it, and check that threads make no difference");
  command->callback(
    [scratch, expected]
    {
      const std::string table = MakeTable(*scratch);
      if (expected->empty())
      {
        std::fputs(table.c_str(), stdout);
      }
      else
      {
        CheckTable(table, *expected);
        CheckThreads(*scratch);
      }
    });
}
}
