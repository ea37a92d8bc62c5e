// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn simplify: writes a mesh with fewer points.

#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnMergeOptions.h"
#include "gtnMessages.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnStep.h"
#include "gtnTarget.h"
#include "gtnText.h"
#include "gtnWriteMesh.h"

#include "vtkGatunReader.h"
#include "vtkGatunSimplify.h"

#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/core.h>

#include <memory>
#include <string>

namespace gtn
{
namespace
{
struct Options
{
  std::string In;
  std::string Out;
  bool Overwrite = false;
  StepOptions Step;
  InputOptions Input;
  TargetOptions Target;
  MergeOptions Merges;
};

/** Returns the reader if the file has a hierarchy and no option asks for another one. */
vtkGatunReader* FindHierarchy(const Input& input, const Options& options)
{
  auto* const reader = vtkGatunReader::SafeDownCast(input.GetSource());
  return reader && reader->GetHasHierarchy() && !options.Merges.AreGiven ? reader : nullptr;
}

void SimplifyMesh(const Options& options, const Settings& settings)
{
  CheckMeshName(options.Out);
  vtkNew<vtkGatunSimplify> simplifier;
  options.Target.Apply(simplifier.Get());
  options.Merges.Apply(simplifier.Get());

  Input input({ options.In }, options.Input);
  CheckWritable(options.Out, options.Overwrite);
  if (vtkGatunReader* const reader = FindHierarchy(input, options))
  {
    options.Target.Apply(reader);
    WriteMesh(ReadGridStep(input, options.Step, settings), options.Out, settings);
    return;
  }
  const auto grid = ReadGridStep(input, options.Step, settings);
  {
    Progress progress("simplifying", settings.ShowProgress);
    simplifier->SetInputData(grid);
    progress.Watch(simplifier);
    simplifier->Update();
    CheckInterrupt();
    CheckMessages(options.In, settings.Quiet);
  }
  vtkUnstructuredGrid* const output = simplifier->GetOutput();
  WriteMesh(output, options.Out, settings);
  if (!settings.Quiet)
  {
    fmt::print("  of {} points, error {:.3g}\n", Grouped(grid->GetNumberOfPoints()),
      simplifier->GetOutputRMSError());
  }
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSimplify(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = AddCommand(app, settings, "simplify",
    "Simplify a mesh by edge collapses that change the data and the boundary as little as "
    "possible.\n"
    "A .gtn file that was packed with --hierarchy or --levels stores the collapses and is "
    "simplified\n"
    "fast; --weight, --metric and --boundary-weight compute new ones.",
    "  gtn simplify --ratio 0.9 mesh.gtn coarse.gtn\n"
    "  gtn simplify --points 10000 --weight pressure=2 --weight velocity mesh.vtu coarse.vtu\n"
    "  gtn simplify --rms-error 1e-3 mesh.gtn coarse.gtn");
  AddForce(command, options->Overwrite);
  AddTarget(command, options->Target, "0.5");
  AddMergeOptions(command, options->Merges);
  AddStep(command, options->Step);
  command->add_option("IN", options->In, std::string("The mesh: ") + InputFormats)->required();
  command->add_option("OUT", options->Out, std::string("The mesh to write: ") + MeshFormats)
    ->required();
  command->callback(
    [=, &settings]
    {
      options->Input.Quiet = settings.Quiet;
      options->Input.VolumesOnly = true;
      SimplifyMesh(*options, settings);
    });
}
}
