// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn simplify: writes a mesh or a surface with fewer points.

#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnMergeOptions.h"
#include "gtnMessages.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnStep.h"
#include "gtnSurfaceWriter.h"
#include "gtnTarget.h"
#include "gtnText.h"
#include "gtnWriteMesh.h"

#include "vtkGatunMeshReader.h"
#include "vtkGatunSimplify.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace gtn
{
namespace
{
struct SimplifyOptions
{
  std::string In;
  std::string Out;
  bool Overwrite = false;
  StepOptions Step;
  InputOptions Input;
  TargetOptions Target;
  MergeOptions Merges;
};

bool IsSurfaceName(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  return extension == ".vtp" || extension == ".stl" || extension == ".ply" || extension == ".obj";
}

/** Returns the reader if the file has a hierarchy and no option asks for another one. */
vtkGatunMeshReader* FindHierarchy(const Input& input, const SimplifyOptions& options)
{
  auto* const reader = vtkGatunMeshReader::SafeDownCast(input.GetSource());
  const bool isOther = options.Merges.AreGiven;
  return reader && reader->GetHasHierarchy() && !isOther ? reader : nullptr;
}

void RunSimplifier(vtkGatunSimplify* simplifier, vtkPointSet* mesh, const SimplifyOptions& options,
  const Settings& settings)
{
  Progress progress("simplifying", settings.ShowProgress);
  simplifier->SetInputData(mesh);
  progress.Watch(simplifier);
  simplifier->Update();
  CheckInterrupt();
  CheckMessages(options.In, settings.Quiet);
}

void PrintError(vtkPointSet* mesh, vtkGatunSimplify* simplifier, const Settings& settings)
{
  if (!settings.Quiet)
  {
    fmt::print("  of {} points, error {:.3g}\n", GroupDigits(mesh->GetNumberOfPoints()),
      simplifier->GetOutputRMSError());
  }
}

void WriteTriangles(vtkPolyData* surface, const SimplifyOptions& options, const Settings& settings)
{
  {
    Progress progress("writing", settings.ShowProgress);
    WriteSurface(surface, options.Out, progress);
  }
  if (!settings.Quiet)
  {
    fmt::print("{}: {} triangles, {} points, {}\n", options.Out,
      GroupDigits(surface->GetNumberOfPolys()), GroupDigits(surface->GetNumberOfPoints()),
      DescribeByteSize(std::filesystem::file_size(options.Out)));
  }
}

void SimplifySurface(vtkPolyData* surface, const SimplifyOptions& options, const Settings& settings)
{
  vtkNew<vtkGatunSimplify> simplifier;
  options.Target.Apply(simplifier.Get());
  options.Merges.Apply(simplifier.Get());
  RunSimplifier(simplifier, surface, options, settings);
  WriteTriangles(simplifier->GetPolyDataOutput(), options, settings);
  PrintError(surface, simplifier, settings);
}

void SimplifyGrid(
  vtkUnstructuredGrid* grid, const SimplifyOptions& options, const Settings& settings)
{
  vtkNew<vtkGatunSimplify> simplifier;
  options.Target.Apply(simplifier.Get());
  options.Merges.Apply(simplifier.Get());
  RunSimplifier(simplifier, grid, options, settings);
  WriteMesh(simplifier->GetUnstructuredGridOutput(), options.Out, settings);
  PrintError(grid, simplifier, settings);
}

void SimplifyMesh(const SimplifyOptions& options, const Settings& settings)
{
  const bool isOfSurfaces = IsSurfaceName(options.Out);
  if (!isOfSurfaces)
  {
    CheckMeshName(options.Out);
  }
  Input input({ options.In }, options.Input);
  CheckWritable(options.Out, options.Overwrite);
  vtkGatunMeshReader* const reader = FindHierarchy(input, options);
  if (reader)
  {
    options.Target.Apply(reader);
  }
  const vtkSmartPointer<vtkDataObject> mesh = ReadStep(input, options.Step, settings);
  auto* const surface = vtkPolyData::SafeDownCast(mesh);
  if (surface && ExtensionOf(options.Out) == ".vtu")
  {
    throw Failure(options.In, "is a surface, for a .gtn, .vtp, .vtk, .stl, .ply or .obj file");
  }
  if (!surface && isOfSurfaces)
  {
    throw Failure(options.In, "is no surface; it can be written to a .gtn, .vtu or .vtk file");
  }
  if (surface && reader)
  {
    WriteTriangles(surface, options, settings);
  }
  else if (surface)
  {
    SimplifySurface(surface, options, settings);
  }
  else if (reader)
  {
    WriteMesh(vtkUnstructuredGrid::SafeDownCast(mesh), options.Out, settings);
  }
  else
  {
    SimplifyGrid(vtkUnstructuredGrid::SafeDownCast(mesh), options, settings);
  }
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSimplify(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<SimplifyOptions>();
  CLI::App* command = AddCommand(app, settings, "simplify",
    "Simplify a mesh by edge collapses that change the data and the boundary as little as "
    "possible.\n"
    "A .gtn file that was packed with --hierarchy or --levels stores the collapses and is "
    "simplified\n"
    "fast; --weight, --metric, --boundary-weight and --feature-angle compute new ones.\n"
    "Surfaces are simplified, too.",
    "  gtn simplify --ratio 0.9 mesh.gtn coarse.gtn\n"
    "  gtn simplify --points 10000 --weight pressure=2 --weight velocity mesh.vtu coarse.vtu\n"
    "  gtn simplify --rms-error 1e-3 mesh.gtn coarse.gtn\n"
    "  gtn simplify --ratio 0.9 surface.vtp coarse.vtp");
  AddForce(command, options->Overwrite);
  AddTarget(command, options->Target, "0.5");
  AddMergeOptions(command, options->Merges);
  AddStep(command, options->Step);
  command
    ->add_option("IN", options->In,
      std::string("The mesh: ") + InputFormats + "; or a surface: " + SurfaceInputFormats)
    ->required();
  command
    ->add_option("OUT", options->Out,
      std::string("The mesh to write: ") + MeshFormats + "; or a surface: " + SurfaceFormats)
    ->required();
  command->callback(
    [=, &settings]
    {
      options->Input.Quiet = settings.Quiet;
      options->Input.VolumesOnly = true;
      options->Input.SurfacesToo = true;
      SimplifyMesh(*options, settings);
    });
}
}
