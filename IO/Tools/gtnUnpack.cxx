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
#include "gtnText.h"

#include "vtkUnstructuredGrid.h"

#include <fmt/core.h>

#include <filesystem>
#include <memory>

namespace gtn
{
namespace
{

struct Options
{
  std::string In;
  std::string Out;
  bool Overwrite = false;
  bool HasTime = false;
  double Time = 0;
  bool HasStep = false;
  std::size_t Step = 0;
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

std::size_t StepOf(const Options& options, const Input& input)
{
  const std::vector<double>& times = input.GetTimes();
  if (times.empty())
  {
    if (options.HasTime || (options.HasStep && options.Step > 0))
    {
      throw Failure(options.In, "has no time steps");
    }
    return 0;
  }
  if (options.HasTime)
  {
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      if (times[i] == options.Time)
      {
        return i;
      }
    }
    throw Failure(options.In,
      fmt::format("has no step at time {}; there are {} from {} to {}, see gtn info -v",
        Number(options.Time), times.size(), Number(times.front()), Number(times.back())));
  }
  if (options.Step >= times.size())
  {
    throw Failure(options.In,
      fmt::format("has no step {}; they are numbered 0 to {}", options.Step, times.size() - 1));
  }
  return options.Step;
}

void Unpack(const Options& options, const Settings& settings)
{
  if (ExtensionOf(options.Out) != ".vtu" && ExtensionOf(options.Out) != ".vtk")
  {
    throw UsageError(options.Out + ": the name must end in .vtu or .vtk");
  }
  Input input({ options.In }, options.Input);
  CheckWritable(options.Out, options.Overwrite);

  const std::size_t step = StepOf(options, input);
  if (input.GetTimes().size() > 1 && !options.HasTime && !options.HasStep && !settings.Quiet)
  {
    Say(fmt::format(
      "{}: has {} time steps, of which the first is taken", options.In, input.GetTimes().size()));
  }
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  {
    Progress progress("reading", settings.ShowProgress);
    grid = input.Read(step, progress);
  }
  {
    Progress progress("writing", settings.ShowProgress);
    WriteGrid(grid, options.Out, CompressorOf(options.How), progress);
  }
  if (!settings.Quiet)
  {
    fmt::print("{}: {} tetrahedra, {} points, {}\n", options.Out, Grouped(grid->GetNumberOfCells()),
      Grouped(grid->GetNumberOfPoints()), ByteSize(std::filesystem::file_size(options.Out)));
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddUnpack(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = AddCommand(app, settings, "unpack",
    "Write a .gtn file, or one of its time steps, as .vtu or .vtk.",
    "  gtn unpack mesh.gtn mesh.vtu\n"
    "  gtn unpack --arrays pressure,velocity --step 10 run.gtn step10.vtu\n"
    "  gtn unpack -f --compressor none mesh.gtn mesh.vtu");
  AddForce(command, options->Overwrite);
  auto* time =
    command->add_option("--time", options->Time, "The step at exactly this time")->option_text("T");
  auto* step = command
                 ->add_option("--step", options->Step,
                   "The step of this number, from 0 (default: the first step)")
                 ->option_text("N")
                 ->excludes(time);
  AddArrays(command, options->Input);
  command
    ->add_option(
      "--compressor", options->How, "Of a .vtu file: none, zlib, lz4 or lzma (default: zlib)")
    ->check(CLI::IsMember({ "none", "zlib", "lz4", "lzma" }))
    ->option_text("NAME");
  command->add_option("IN", options->In, "The .gtn file (or any that pack takes)")->required();
  command->add_option("OUT", options->Out, "The .vtu or .vtk file")->required();
  command->callback(
    [=, &settings]
    {
      options->HasTime = time->count() > 0;
      options->HasStep = step->count() > 0;
      options->Input.Quiet = settings.Quiet;
      Unpack(*options, settings);
    });
}
}
