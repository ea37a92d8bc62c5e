// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn mesh: fills a closed surface with tetrahedra.

#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnMessages.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnWriteMesh.h"

#if GTN_HAS_TETGEN
#include "vtkGatunTetrahedralize.h"
#endif

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace gtn
{
namespace
{

struct MeshOptions
{
  std::string In;
  std::string Out;
  bool Overwrite = false;
  double Quality = 1.414;
  double MinDihedral = 0;
  double MaximumVolume = 0;
  bool PreserveSurface = false;
  std::string Switches;
};

#if GTN_HAS_TETGEN
vtkSmartPointer<vtkUnstructuredGrid> Fill(
  vtkPolyData* surface, const MeshOptions& options, const Settings& settings)
{
  const vtkNew<vtkGatunTetrahedralize> mesher;
  mesher->SetQuality(options.Quality);
  mesher->SetMinDihedral(options.MinDihedral);
  mesher->SetMaximumVolume(options.MaximumVolume);
  mesher->SetPreserveSurface(options.PreserveSurface);
  mesher->SetSwitches(options.Switches.c_str());
  mesher->SetInputDataObject(surface);
  Progress progress("meshing", settings.ShowProgress);
  progress.Watch(mesher);
  mesher->Update();
  CheckInterrupt();
  CheckMessages(options.In, settings.Quiet);
  return mesher->GetOutput();
}
#else
vtkSmartPointer<vtkUnstructuredGrid> Fill(vtkPolyData*, const MeshOptions& options, const Settings&)
{
  throw Failure(options.In, "cannot be filled: gtn was built without TetGen");
}
#endif

void Mesh(const MeshOptions& options, const Settings& settings)
{
  CheckMeshName(options.Out);
  vtkSmartPointer<vtkPolyData> surface;
  {
    Progress progress("reading", settings.ShowProgress);
    surface = ReadSurface(options.In, progress, settings.Quiet);
  }
  CheckWritable(options.Out, options.Overwrite);
  WriteMesh(Fill(surface, options, settings), options.Out, settings);
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddMesh(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<MeshOptions>();
  CLI::App* command = AddCommand(app, settings, "mesh",
    GTN_HAS_TETGEN
      ? "Fill a closed surface with tetrahedra by TetGen, in the program gatun-tetgen (GNU AGPL)."
      : "Fill a closed surface with tetrahedra (unavailable: built without TetGen).",
    "  gtn mesh part.stl part.gtn\n"
    "  gtn mesh --quality 1.2 --max-volume 0.5 part.stl part.vtu");
  AddForce(command, options->Overwrite);
  command
    ->add_option("--quality", options->Quality,
      "Maximum ratio of circumradius to shortest edge, 1 to 100, or 0 for no limit; TetGen may not "
      "terminate below 1.2 (default: 1.414)")
    ->check(CLI::Range(0., 100.))
    ->option_text("R");
  command
    ->add_option("--min-dihedral", options->MinDihedral,
      "Minimum dihedral angle to aim at, in degrees, 0 to 30; TetGen may not terminate above 18 "
      "(default: 0)")
    ->check(CLI::Range(0., 30.))
    ->option_text("A");
  command
    ->add_option("--max-volume", options->MaximumVolume,
      "Maximum volume of a tetrahedron, in cubic units of the coordinates, or 0 for no limit "
      "(default: 0)")
    ->check(CLI::NonNegativeNumber)
    ->option_text("V");
  command->add_flag(
    "--preserve-surface", options->PreserveSurface, "Do not split triangles of the surface");
  command
    ->add_option(
      "--switches", options->Switches, "Additional switches for TetGen, such as O4 (default: none)")
    ->option_text("S");
  command->add_option("SURFACE", options->In, "The closed surface: .stl .ply .obj .vtp .vtk .gtn")
    ->required();
  command->add_option("OUT", options->Out, std::string("The mesh to write: ") + MeshFormats)
    ->required();
  command->callback([options, &settings] { Mesh(*options, settings); });
}
}
