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
  int Tets = 0;
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
  Write({ options.Format, false, false }, grid, options.Out);
}

void Make(const MakeOptions& options)
{
  const double hexahedra = options.Tets / 5.0;
  // A block as long as 4 when it is 3 wide and high.
  const int width = std::max(2, static_cast<int>(std::lround(std::cbrt(hexahedra * 9 / 12))));
  const int length = std::max(2, static_cast<int>(std::lround(hexahedra / width / width)));
  if (options.Kind == "delaunay")
  {
    WriteOrdered(MakeDelaunay(options.Tets), options);
  }
  else if (options.Kind == "lattice")
  {
    const int cells = std::max(2, static_cast<int>(std::lround(std::cbrt(options.Tets / 12.0))));
    WriteOrdered(MakeLattice(cells, false), options);
  }
  else if (options.Kind == "hexes")
  {
    const int cells = std::max(2, static_cast<int>(std::lround(std::cbrt(options.Tets))));
    WriteOrdered(MakeHexahedra(cells), options);
  }
  else if (options.Kind == "block")
  {
    WriteOrdered(
      MakeBlock(std::max(2, static_cast<int>(std::lround(std::cbrt(hexahedra))))), options);
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
void AddMachine(CLI::App& app)
{
  app.add_subcommand("machine", "Compiler, versions and threads")->callback(PrintMachine);
}

//------------------------------------------------------------------------------
void AddMake(CLI::App& app)
{
  auto options = std::make_shared<MakeOptions>();
  CLI::App* command = app.add_subcommand("make", "Make a mesh, as a raw .vtu file");
  command
    ->add_option("KIND", options->Kind,
      "flow (four arrays), flow1 (one), block, lattice, delaunay, hexes (that many hexahedra)")
    ->required()
    ->check(CLI::IsMember({ "flow", "flow1", "block", "lattice", "delaunay", "hexes" }));
  command->add_option("TETS", options->Tets, "About how many tetrahedra")
    ->required()
    ->check(CLI::Range(100, 1000000000));
  command->add_option("OUT", options->Out)->required();
  command->add_flag("--permute", options->Permute, "Points and tetrahedra in random order");
  command->callback([options] { Make(*options); });
}

//------------------------------------------------------------------------------
void AddPrepare(CLI::App& app)
{
  auto options = std::make_shared<MakeOptions>();
  CLI::App* command =
    app.add_subcommand("prepare", "Make tetrahedra of the cells of a .vtu or .gtn file");
  command->add_option("IN", options->In)->required();
  command->add_option("OUT", options->Out)->required();
  CLI::Option* permute =
    command->add_flag("--permute", options->Permute, "Points and tetrahedra in random order");
  command->add_flag("--morton", options->Sort, "Points and tetrahedra along a Morton curve")
    ->excludes(permute);
  command->add_option("--array", options->Array, "Keep this point array only");
  std::vector<std::string> formats;
  for (const Format& format : GetFormats())
  {
    formats.push_back(format.Name);
  }
  command->add_option("--format", options->Format, "How OUT is written, in place of vtu-raw")
    ->check(CLI::IsMember(formats));
  command->callback([options] { Prepare(*options); });
}
}
