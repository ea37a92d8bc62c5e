// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// make, prepare: the inputs of the other cases. machine: where all this runs.

#include "benchCases.h"
#include "benchFiles.h"
#include "benchMeshes.h"

#include "gtnThreads.h"

#include "gatunParallel.h"
#include "gatunVersion.h"

#include "vtkUnstructuredGrid.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace bench
{
namespace
{

struct MakeOptions
{
  std::string Kind;
  int Cells = 0;
  std::string In;
  std::string Out;
  bool Permute = false;
  bool Sort = false;
  std::string Array;
  std::string Format = "vtu-raw";
};

void WriteOrdered(vtkUnstructuredGrid* grid, const MakeOptions& options)
{
  Grid ordered;
  if (options.Permute || options.Sort)
  {
    ordered = options.Permute ? Permute(grid) : SortAlongCurve(grid);
    grid = ordered;
  }
  Write({ options.Format }, grid, options.Out);
}

void MakeMesh(const MakeOptions& options)
{
  const bool isOfTets = options.Kind != "hexahedra" && options.Kind != "mixed";
  const double hexahedra = options.Cells / (isOfTets ? 5.0 : 1.0);
  // A block as long as 4 when it is 3 wide and high.
  const int width = std::max(2, static_cast<int>(std::lround(std::cbrt(hexahedra * 9 / 12))));
  const int length = std::max(2, static_cast<int>(std::lround(hexahedra / width / width)));
  if (options.Kind == "delaunay")
  {
    WriteOrdered(MakeDelaunay(options.Cells), options);
  }
  else if (options.Kind == "lattice")
  {
    const int cells = std::max(2, static_cast<int>(std::lround(std::cbrt(options.Cells / 12.0))));
    WriteOrdered(MakeLattice(cells, false), options);
  }
  else if (!isOfTets)
  {
    const std::array<int, 3> size{ length, width, width };
    WriteOrdered(options.Kind == "mixed" ? MakeMixed(size) : MakeHexahedra(size), options);
  }
  else
  {
    WriteOrdered(MakeFlow({ length, width, width }, options.Kind == "flow"), options);
  }
}

void Prepare(const MakeOptions& options)
{
  Grid grid = Triangulate(Load(options.In));
  if (!options.Array.empty())
  {
    grid = KeepPointArray(grid, options.Array);
  }
  WriteOrdered(grid, options);
}

void PrintMachine()
{
  PrintJson(
    [](Json::Value& json)
    {
      json["gatun"] = gatun::PackageVersion();
      json["vtk"] = vtkVersion::GetVTKVersion();
      json["backend"] = gtn::ThreadBackend();
      json["threads"] = gatun::GetNumberOfThreads();
#if defined(__clang__)
      json["compiler"] = "clang " __clang_version__;
#elif defined(__GNUC__)
      json["compiler"] = "GCC " __VERSION__;
#else
      json["compiler"] = "unknown";
#endif
      json["build"] = BENCH_BUILD_TYPE;
      json["tetgen"] = HasDelaunay();
    });
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddMake(CLI::App& app)
{
  app.add_subcommand("machine", "Compiler, versions and threads")->callback(PrintMachine);

  auto made = std::make_shared<MakeOptions>();
  CLI::App* make = app.add_subcommand("make", "Make a mesh, as a raw .vtu file");
  make
    ->add_option(
      "KIND", made->Kind, "flow (four arrays), flow1 (one), lattice, delaunay, hexahedra, mixed")
    ->required()
    ->check(CLI::IsMember({ "flow", "flow1", "lattice", "delaunay", "hexahedra", "mixed" }));
  make->add_option("CELLS", made->Cells, "About how many")
    ->required()
    ->check(CLI::Range(100, 1000000000));
  make->add_option("OUT", made->Out)->required();
  make->callback([made] { MakeMesh(*made); });

  auto options = std::make_shared<MakeOptions>();
  CLI::App* prepare =
    app.add_subcommand("prepare", "Make tetrahedra of the cells of a .vtu or .gtn file");
  prepare->add_option("IN", options->In)->required();
  prepare->add_option("OUT", options->Out)->required();
  CLI::Option* permute =
    prepare->add_flag("--permute", options->Permute, "Points and tetrahedra in random order");
  prepare->add_flag("--morton", options->Sort, "Points and tetrahedra along a Morton curve")
    ->excludes(permute);
  prepare->add_option("--array", options->Array, "Keep this point array only");
  prepare->add_option("--format", options->Format, "How OUT is written, in place of vtu-raw");
  prepare->callback([options] { Prepare(*options); });
}
}
