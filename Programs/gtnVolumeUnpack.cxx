// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn volume unpack: a .ghv file as voxels.

#include "gtnFailure.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnSlices.h"
#include "gtnText.h"
#include "gtnVolume.h"
#include "gtnVolumeInput.h"
#include "gtnVolumeWriter.h"

#include "vtkImageData.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <filesystem>
#include <memory>

namespace gtn
{
namespace
{

struct VolumeUnpackOptions
{
  VolumeInputOptions Input;
  std::string In;
  std::string Out;
  bool Overwrite = false;
};

void Unpack(const VolumeUnpackOptions& options, const Settings& settings)
{
  const bool asSlices = HasNumber(options.Out);
  if (asSlices ? !IsSlice(options.Out) : !IsVolumeOutput(options.Out))
  {
    throw UsageError(fmt::format("{}: the name must end in {}", options.Out,
      asSlices
        ? std::string(SliceFormats)
        : fmt::format("one of {}; slices need a number, as slice_%04d.png", VolumeOutputFormats)));
  }
  if (!asSlices)
  {
    CheckWritable(options.Out, options.Overwrite);
  }
  const vtkSmartPointer<vtkImageData> volume = ReadVolume(options.Input, settings);
  const int* const size = volume->GetDimensions();
  std::vector<std::string> files{ options.Out };
  if (asSlices)
  {
    files = NameSlices(options.Out, size[2]);
    for (const std::string& file : files)
    {
      CheckWritable(file, options.Overwrite);
    }
  }
  {
    Progress progress("writing", settings.ShowProgress);
    asSlices ? WriteSlices(volume, files, progress) : WriteVolume(volume, options.Out, progress);
  }
  if (!settings.Quiet)
  {
    std::uintmax_t bytes = 0;
    for (const std::string& file : files)
    {
      bytes += std::filesystem::file_size(file);
    }
    fmt::print("{}{}: {} x {} x {} voxels, {}\n", files.front(),
      asSlices ? " to " + FileOf(files.back()) : std::string(), size[0], size[1], size[2],
      DescribeByteSize(bytes));
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumeUnpack(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<VolumeUnpackOptions>();
  CLI::App* command = AddCommand(app, settings, "unpack",
    "Write a .ghv file as voxels. Only .vti files keep all that is known of where the voxels are;\n"
    "slices keep nothing of it.",
    "  gtn volume unpack head.ghv head.vti\n"
    "  gtn volume unpack head.ghv head.nii.gz\n"
    "  gtn volume unpack head.ghv slices/head_%04d.tif");
  AddForce(command, options->Overwrite);
  command->add_option("IN", options->In, "The .ghv file (or any that pack takes)")->required();
  command
    ->add_option("OUT", options->Out,
      fmt::format("The volume: {}, or slices, numbered from 0: name_%04d{}", VolumeOutputFormats,
        " with .tif, .tiff or .png"))
    ->required();
  command->callback(
    [options, &settings]
    {
      options->Input.Files = { options->In };
      Unpack(*options, settings);
    });
}
}
