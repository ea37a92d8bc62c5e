// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn unpack: a .gtn file, or one of its time steps, as a file of VTK's own formats.

#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnGridWriter.h"
#include "gtnInput.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnStep.h"
#include "gtnText.h"
#include "gtnWriteMesh.h"

#include "vtkUnstructuredGrid.h"

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

void Unpack(const Options& options, const Settings& settings)
{
  if (ExtensionOf(options.Out) != ".vtu" && ExtensionOf(options.Out) != ".vtk")
  {
    throw UsageError(options.Out + ": the name must end in .vtu or .vtk");
  }
  Input input({ options.In }, options.Input);
  CheckWritable(options.Out, options.Overwrite);
  WriteMesh(
    ReadStep(input, options.Step, settings), options.Out, settings, CompressorOf(options.How));
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddUnpack(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = AddCommand(app, settings, "unpack",
    "Write a .gtn file, or one of its time steps, to a .vtu or .vtk file.",
    "  gtn unpack mesh.gtn mesh.vtu\n"
    "  gtn unpack --arrays pressure,velocity --step 10 run.gtn step10.vtu\n"
    "  gtn unpack -f --compressor none mesh.gtn mesh.vtu");
  AddForce(command, options->Overwrite);
  AddStep(command, options->Step);
  AddArrays(command, options->Input);
  AddSets(command, options->Input);
  command
    ->add_option("--compressor", options->How,
      "Compressor of a .vtu file: none, zlib, lz4 or lzma (default: zlib)")
    ->check(CLI::IsMember({ "none", "zlib", "lz4", "lzma" }))
    ->option_text("NAME");
  command->add_option("IN", options->In, "The .gtn file, or any other file that pack reads")
    ->required();
  command->add_option("OUT", options->Out, "The .vtu or .vtk file")->required();
  command->callback(
    [=, &settings]
    {
      options->Input.Quiet = settings.Quiet;
      Unpack(*options, settings);
    });
}
}
