// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn unpack: a .gtn file, or one of its time steps, as a file of VTK's own formats.

#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnGridWriter.h"
#include "gtnInput.h"
#include "gtnMessages.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnStep.h"
#include "gtnStepChooser.h"
#include "gtnSurfaceWriter.h"
#include "gtnText.h"
#include "gtnUnpackHDF.h"
#include "gtnWriteMesh.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace gtn
{
namespace
{

struct UnpackOptions
{
  std::string In;
  std::string Out;
  bool All = false;
  bool Overwrite = false;
  StepOptions Step;
  InputOptions Input;
  std::string How = "zlib";
};

Compressor CompressorOf(const std::string& name)
{
  return name == "none" ? Compressor::None
    : name == "lz4"     ? Compressor::LZ4
    : name == "lzma"    ? Compressor::LZMA
                        : Compressor::ZLib;
}

bool IsOneOfSurfaces(const std::string& extension)
{
  return extension == ".vtp" || extension == ".stl" || extension == ".ply" || extension == ".obj";
}

void UnpackSurface(vtkPolyData* surface, const UnpackOptions& options, const Settings& settings)
{
  const std::string lost = ListLost(surface, options.Out);
  if (!lost.empty() && !settings.Quiet)
  {
    Say(fmt::format("{}: a {} file does not hold all of the surface: {} left out", options.In,
      ExtensionOf(options.Out), lost));
  }
  {
    Progress progress("writing", settings.ShowProgress);
    WriteSurface(surface, options.Out, progress, CompressorOf(options.How));
  }
  if (!settings.Quiet)
  {
    fmt::print("{}: {} cells, {} points, {}\n", options.Out,
      GroupDigits(static_cast<std::uint64_t>(surface->GetNumberOfCells())),
      GroupDigits(static_cast<std::uint64_t>(surface->GetNumberOfPoints())),
      DescribeByteSize(std::filesystem::file_size(options.Out)));
  }
}

// "run_007.vtu" for step 7 of run.pvd, with as many digits as the last step has.
std::string NameOfStep(
  const UnpackOptions& options, std::size_t step, std::size_t steps, const std::string& extension)
{
  return fmt::format(
    "{}_{:0{}}{}", StemOf(options.Out), step, std::to_string(steps - 1).size(), extension);
}

// Writes a file for each step, and the list of them at last.
void UnpackToCollection(Input& input, const UnpackOptions& options, const Settings& settings)
{
  const std::vector<double>& times = input.GetTimes();
  std::vector<std::string> files;
  for (std::size_t step = 0; step < times.size(); ++step)
  {
    Progress progress(
      fmt::format("writing step {} of {}", step + 1, times.size()), settings.ShowProgress);
    vtkDataObject* const data = input.Read(step, progress);
    auto* const surface = vtkPolyData::SafeDownCast(data);
    if (step == 0)
    {
      for (std::size_t i = 0; i < times.size(); ++i)
      {
        files.push_back(NameOfStep(options, i, times.size(), surface ? ".vtp" : ".vtu"));
        CheckWritable(files.back(), options.Overwrite);
      }
    }
    if (surface)
    {
      WriteSurface(surface, files[step], progress, CompressorOf(options.How));
    }
    else
    {
      WriteGrid(
        vtkUnstructuredGrid::SafeDownCast(data), files[step], CompressorOf(options.How), progress);
    }
  }
  WriteCollection(options.Out, files, times);
  if (!settings.Quiet)
  {
    fmt::print("{}: {} time steps, {} to {}\n", options.Out, files.size(), files.front(),
      FileOf(files.back()));
  }
}

void UnpackToHDF(Input& input, const UnpackOptions& options, const Settings& settings)
{
  const std::string lost = WriteHDF(input, options.Out, options.How != "none", settings);
  if (settings.Quiet)
  {
    return;
  }
  if (!lost.empty())
  {
    Say(fmt::format(
      "{}: a .vtkhdf file does not hold all of the mesh: {} left out", options.In, lost));
  }
  fmt::print("{}: {} time steps, {}\n", options.Out, input.GetTimes().size(),
    DescribeByteSize(std::filesystem::file_size(options.Out)));
}

void UnpackAll(const UnpackOptions& options, const Settings& settings)
{
  const bool isHDF = ExtensionOf(options.Out) == ".vtkhdf";
  if (!isHDF && ExtensionOf(options.Out) != ".pvd")
  {
    throw UsageError(options.Out + ": with --all, the name must end in .pvd or .vtkhdf");
  }
  if (isHDF && options.How != "zlib" && options.How != "none")
  {
    throw UsageError("--compressor: a .vtkhdf file takes none or zlib");
  }
  Input input({ options.In }, options.Input);
  if (input.GetTimes().empty())
  {
    throw Failure(options.In, "has no time steps; without --all it becomes one .vtu or .vtp file");
  }
  CheckWritable(options.Out, options.Overwrite);
  (isHDF ? UnpackToHDF : UnpackToCollection)(input, options, settings);
}

void Unpack(const UnpackOptions& options, const Settings& settings)
{
  if (options.All)
  {
    UnpackAll(options, settings);
    return;
  }
  const std::string extension = ExtensionOf(options.Out);
  if (extension == ".pvd" || extension == ".vtkhdf")
  {
    throw UsageError(
      fmt::format("{}: a {} file has all time steps, which --all writes", options.Out, extension));
  }
  const bool isOfGrids = extension == ".vtu" || extension == ".vtk";
  const bool isOfSurfaces = extension == ".vtk" || IsOneOfSurfaces(extension);
  if (!isOfGrids && !IsOneOfSurfaces(extension))
  {
    throw UsageError(options.Out +
      ": the name must end in .vtu or .vtk, or for a surface in .vtp, .vtk, .stl, .ply or .obj");
  }
  Input input({ options.In }, options.Input);
  CheckWritable(options.Out, options.Overwrite);
  const vtkSmartPointer<vtkDataObject> data = ReadStep(input, options.Step, settings);
  if (data->GetFieldData()->HasArray("TimeValue"))
  {
    // VTK's writer would put the time of the step in the place of the array.
    data->GetInformation()->Remove(vtkDataObject::DATA_TIME_STEP());
  }
  auto* const surface = vtkPolyData::SafeDownCast(data);
  if (surface ? !isOfSurfaces : !isOfGrids)
  {
    throw Failure(options.In,
      surface ? "is a surface, for a .vtp, .vtk, .stl, .ply or .obj file"
              : "is no surface; it can be written to a .vtu or .vtk file");
  }
  if (surface)
  {
    UnpackSurface(surface, options, settings);
  }
  else
  {
    WriteMesh(
      vtkUnstructuredGrid::SafeDownCast(data), options.Out, settings, CompressorOf(options.How));
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddUnpack(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<UnpackOptions>();
  CLI::App* command = AddCommand(app, settings, "unpack",
    "Write a .gtn file, or one of its time steps, to a .vtu or .vtk file. A surface is written to "
    "a\n"
    ".vtp, .vtk, .stl, .ply or .obj file; what the last three cannot hold is left out, with a "
    "warning.\n"
    "With --all, each time step is written to a .vtu or .vtp file beside OUT, a .pvd file that\n"
    "lists them with their times: run_0.vtu, run_1.vtu and so on of run.pvd. Or all go to one\n"
    ".vtkhdf file, if gtn was built with VTK 9.4 or later.",
    "  gtn unpack mesh.gtn mesh.vtu\n"
    "  gtn unpack surface.gtn surface.vtp\n"
    "  gtn unpack --arrays pressure,velocity --step 10 run.gtn step10.vtu\n"
    "  gtn unpack --all run.gtn run.pvd\n"
    "  gtn unpack --all run.gtn run.vtkhdf\n"
    "  gtn unpack -f --compressor none mesh.gtn mesh.vtu");
  AddForce(command, options->Overwrite);
  auto* const all = command->add_flag("--all", options->All, "Write all time steps");
  for (CLI::Option* const one : AddStep(command, options->Step))
  {
    one->excludes(all);
  }
  AddSteps(command, options->Input.Steps)->needs(all);
  AddArrays(command, options->Input);
  AddSets(command, options->Input);
  command
    ->add_option("--compressor", options->How,
      "Compressor of a .vtu or .vtp file: none, zlib, lz4 or lzma; of a .vtkhdf file: none or zlib "
      "(default: zlib)")
    ->check(CLI::IsMember({ "none", "zlib", "lz4", "lzma" }))
    ->option_text("NAME");
  command->add_option("IN", options->In, "The .gtn file, or any other file that pack reads")
    ->required();
  command
    ->add_option("OUT", options->Out,
      "The .vtu or .vtk file, or the .vtp, .vtk, .stl, .ply or .obj file of a surface; with --all "
      "the .pvd or .vtkhdf file")
    ->required();
  command->callback(
    [=, &settings]
    {
      options->Input.Quiet = settings.Quiet;
      options->Input.NamesSets = true;
      Unpack(*options, settings);
    });
}
}
