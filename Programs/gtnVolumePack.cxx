// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn volume pack: any regular volume as a .ghv file.

#include "gtnFailure.h"
#include "gtnHelp.h"
#include "gtnJson.h"
#include "gtnMessages.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnText.h"
#include "gtnVolume.h"
#include "gtnVolumeInput.h"
#include "gtnVolumeOptions.h"
#include "gtnWriteGatun.h"

#include "vtkGatunHartleyWriter.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <memory>

namespace gtn
{
namespace
{

struct VolumePackOptions
{
  VolumeInputOptions Input;
  std::string Out;
  bool Overwrite = false;
  CompressionOptions Compression;
  bool Json = false;
};

void Print(const VolumePackOptions& options, vtkImageData* volume, vtkGatunHartleyWriter* writer,
  double seconds)
{
  const int* const size = volume->GetDimensions();
  vtkDataArray* const array = volume->GetPointData()->GetScalars();
  const auto voxels = static_cast<double>(volume->GetNumberOfPoints());
  const double raw = 8. * array->GetDataTypeSize();
  vtkTable* const table = writer->GetStatistics();
  const auto get = [table](const char* name) { return table->GetValueByName(0, name); };
  const auto bytes = static_cast<std::uint64_t>(get("FileBytes").ToTypeUInt64());
  const double bits = 8 * static_cast<double>(bytes) / voxels;
  double range[2];
  array->GetRange(range);
  const double error = get("RMSError").ToDouble();
  const double psnr = PeakSignalToNoise({ range[0], range[1] }, error);
  const std::string name = array->GetName() ? array->GetName() : "";
  if (options.Json)
  {
    Json::Value json;
    json["file"] = options.Out;
    json["size"] = Json::arrayValue;
    for (int axis = 0; axis < 3; ++axis)
    {
      json["size"].append(size[axis]);
    }
    json["array"] = name;
    json["bytes"] = Json::UInt64{ bytes };
    json["bitsPerVoxel"] = bits;
    json["ratio"] = raw / bits;
    json["rootMeanSquareError"] = error;
    json["largestError"] = get("MaximumError").ToDouble();
    json["psnr"] = psnr;
    json["seconds"] = seconds;
    fmt::print("{}", WriteJson(json));
    return;
  }
  fmt::print("{}: {} x {} x {} voxels, '{}', {}\n", options.Out, size[0], size[1], size[2],
    MakePrintableLine(name), DescribeByteSize(bytes));
  fmt::print("  {:.3f} bits a voxel, 1 : {:.4g}\n", bits, raw / bits);
  fmt::print("  root mean square error {:.4g}, largest error {:.4g}{}\n", error,
    get("MaximumError").ToDouble(), std::isfinite(psnr) ? fmt::format(", {:.1f} dB", psnr) : "");
  const bool isExact = options.Compression.RateControl.Mode == gatun::HartleyRateMode::RMSError &&
    options.Compression.RateControl.Value == 0;
  if (isExact && error > 0)
  {
    fmt::print("  floating-point values are rounded; only integers are lossless\n");
  }
}

void Pack(const VolumePackOptions& options, const Settings& settings)
{
  if (ExtensionOf(options.Out) != ".ghv")
  {
    throw UsageError(options.Out + ": the name must end in .ghv");
  }
  CheckWritable(options.Out, options.Overwrite);
  const vtkSmartPointer<vtkImageData> volume = ReadVolume(options.Input, settings);
  vtkNew<vtkGatunHartleyWriter> writer;
  options.Compression.Apply(writer->GetEncoding());
  const auto start = std::chrono::steady_clock::now();
  {
    Progress progress("packing", settings.ShowProgress);
    writer->SetInputData(volume);
    writer->SetFileName(options.Out.c_str());
    RunWriter(writer.Get(), options.Input.Files.front(), progress);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  CheckMessages(options.Out, settings.Quiet);
  if (!settings.Quiet || options.Json)
  {
    Print(options, volume, writer, seconds.count());
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumePack(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<VolumePackOptions>();
  CLI::App* command = AddCommand(app, settings, "pack",
    "Write a regular volume as Hartley coefficients (.ghv). Slices are ordered by the numbers in\n"
    "their names.",
    "  gtn volume pack head.nii.gz head.ghv\n"
    "  gtn volume pack --block 16 --psnr 45 head.vti head.ghv\n"
    "  gtn volume pack --rms-error 0 head.mha head.ghv          lossless for integers\n"
    "  gtn volume pack --bits-per-voxel 1 --spacing 0.5,0.5,2 slices/ head.ghv\n"
    "  gtn volume pack slice_*.png head.ghv");
  AddForce(command, options->Overwrite);
  AddVolumeInput(command, options->Input);
  AddCompression(command, options->Compression, "Compression");
  command->add_flag("--json", options->Json, "Print JSON");
  command
    ->add_option(FilesArgument, options->Input.Files,
      std::string("A volume or slices, then the .ghv file. Volumes: ") + VolumeFormats)
    ->required();
  command->callback(
    [options, &settings]
    {
      if (options->Input.Files.size() < 2)
      {
        throw UsageError("pack takes a volume, followed by the name of a .ghv file");
      }
      options->Out = options->Input.Files.back();
      options->Input.Files.pop_back();
      Pack(*options, settings);
    });
}
}
