// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// volume: bits a voxel and errors of .ghv files and of zfp. volume-views: time for a view of a
// volume, each from another side, by Gatun from its file and by VTK's mapper from voxels.

#include "benchCases.h"
#include "benchVolume.h"
#include "benchVolumeWindow.h"
#include "benchZfp.h"

#include "gatunHartleyFile.h"
#include "gatunParallel.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkXMLImageDataWriter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace bench
{
namespace
{
struct VolumeOptions
{
  std::string File;
  std::string Scratch;
  std::vector<std::uint32_t> Blocks{ 8 };
  std::vector<double> Errors{ 30, 40, 50, 0 }; ///< PSNR; 0: lossless
  unsigned Pixels = 512;
  int Rounds = 3;
};

void AddPoint(
  Json::Value& json, const Volume& volume, double bytes, double meanSquareError, double worst)
{
  json["bits"] = 8 * bytes / static_cast<double>(volume.GetNumberOfVoxels());
  // No error makes no number, and JSON has no other.
  json["psnr"] = GetPSNR(volume.GetRange(), meanSquareError);
  json["worst"] = worst;
}

void AddGatun(Json::Value& json, const Volume& volume, const VolumeOptions& options)
{
  json["gatun"] = Json::arrayValue;
  for (const std::uint32_t block : options.Blocks)
  {
    for (const double wanted : options.Errors)
    {
      gatun::HartleyWriterOptions writing;
      writing.BlockSize = block;
      writing.RateControl = MakeQuality(0);
      if (wanted > 0)
      {
        writing.RateControl.Mode = gatun::HartleyRateMode::PSNR;
        writing.RateControl.Value = wanted;
      }
      gatun::HartleyWritten written;
      Json::Value point;
      point["packSeconds"] = SecondsOf(
        [&] { written = gatun::WriteHartleyFile(options.Scratch, volume.GetInput(), writing); });
      std::vector<double> voxels(volume.GetNumberOfVoxels());
      point["unpackSeconds"] = SecondsOf(
        [&]
        {
          const gatun::HartleyFile file(options.Scratch);
          file.GetVoxels({}, volume.GetSize(), voxels.data());
        });
      point["block"] = static_cast<std::uint64_t>(block);
      point["wanted"] = wanted;
      AddPoint(point, volume, static_cast<double>(written.FileBytes),
        written.RMSError * written.RMSError, written.MaximumError);
      json["gatun"].append(point);
    }
  }
}

/** Voxels as a reader would give them back: integers, within the range. */
void AddPeer(Json::Value& json, const Volume& volume, double value, ZfpResult result)
{
  double squares = 0;
  double worst = 0;
  for (std::size_t i = 0; i < result.Voxels.size(); ++i)
  {
    double voxel = result.Voxels[i];
    if (volume.IsInteger())
    {
      voxel = std::clamp(std::round(voxel), volume.GetLowest(), volume.GetHighest());
    }
    const double error = voxel - volume.GetVoxels()[i];
    squares += error * error;
    worst = std::max(worst, std::abs(error));
  }
  Json::Value entry;
  entry["value"] = value;
  AddPoint(entry, volume, static_cast<double>(result.Bytes),
    squares / static_cast<double>(result.Voxels.size()), worst);
  json.append(entry);
}

void AddZfp(Json::Value& json, const Volume& volume)
{
  if (!HasZfp())
  {
    return;
  }
  const auto run = [&](const char* name, ZfpMode mode, double value)
  {
    AddPeer(
      json["zfp"][name], volume, value, RunZfp(volume.GetVoxels(), volume.GetSize(), mode, value));
  };
  for (int part = 1; part <= 11; ++part)
  {
    run("accuracy", ZfpMode::Accuracy, volume.GetRange() * std::pow(2, -part));
  }
  for (const int planes : { 2, 4, 6, 8, 10, 12, 14, 16 })
  {
    run("precision", ZfpMode::Precision, planes);
  }
  if (volume.IsInteger())
  {
    run("reversible", ZfpMode::Reversible, 0);
  }
}

void MeasureRates(const VolumeOptions& options)
{
  const Volume volume(options.File);
  PrintJson(
    [&](Json::Value& json)
    {
      json["voxels"] = static_cast<std::uint64_t>(volume.GetNumberOfVoxels());
      AddGatun(json, volume, options);
      AddZfp(json, volume);
      const std::string file = options.Scratch + ".vti";
      vtkNew<vtkXMLImageDataWriter> writer;
      writer->SetInputData(volume.GetImage());
      writer->SetFileName(file.c_str());
      writer->EncodeAppendedDataOff();
      if (!writer->Write())
      {
        throw Failure(file, "cannot be written");
      }
      json["vtiBits"] =
        8 * static_cast<double>(FileSize(file)) / static_cast<double>(volume.GetNumberOfVoxels());
      std::remove(file.c_str());
      std::remove(options.Scratch.c_str());
    });
}

/** The same views for all, none twice. */
gatun::HartleyView GetView(const Volume& volume, unsigned pixels, int number)
{
  return volume.MakeView({ 0.13 + 0.07 * number, 0.21 + 0.05 * number, 0.03 }, pixels,
    pixels / static_cast<double>(volume.GetPixels(1)));
}

void MeasureViews(const VolumeOptions& options)
{
  using gatun::HartleyOpacityModel;
  const Volume volume(options.File);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["pixels"] = static_cast<std::uint64_t>(options.Pixels);
      json["ways"] = Json::arrayValue;
      for (const auto model : { HartleyOpacityModel::XRay, HartleyOpacityModel::Exponential })
      {
        const gatun::HartleyShading shading = MakeGray(volume, model, 0.1);
        FixedPointWindow window(volume, options.Pixels, shading);
        std::vector<std::unique_ptr<gatun::HartleyProjector>> projectors;
        std::vector<Operation> operations;
        std::vector<int> views(options.Blocks.size() + 1);
        operations.push_back(
          { "voxels", [&] { window.Render(GetView(volume, options.Pixels, views.back()++)); } });
        for (std::size_t i = 0; i < options.Blocks.size(); ++i)
        {
          const std::uint32_t block = options.Blocks[i];
          const std::string file = options.Scratch + std::to_string(block) + ".ghv";
          gatun::WriteHartleyFile(file, volume.GetInput(), { block, MakeQuality(1) });
          projectors.push_back(std::make_unique<gatun::HartleyProjector>(
            std::make_shared<const gatun::HartleyFile>(file)));
          std::remove(file.c_str()); // it is open
          operations.push_back({ std::to_string(block),
            [&, i]
            { projectors[i]->Draw(GetView(volume, options.Pixels, views[i]++), shading); } });
        }
        WarmUpAndRunInterleaved(operations, options.Rounds);
        if (window.GetMean() <= 0)
        {
          throw Failure("an image is empty");
        }
        for (const Operation& operation : operations)
        {
          Json::Value way;
          way["way"] = operation.Name;
          way["model"] = model == HartleyOpacityModel::XRay ? "xray" : "exponential";
          way["first"] = operation.First;
          AddList(way, "seconds", operation.Seconds);
          json["ways"].append(way);
        }
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolume(CLI::App& app)
{
  auto options = std::make_shared<VolumeOptions>();
  const auto add = [&](const char* name, const char* about, void (*measure)(const VolumeOptions&))
  {
    CLI::App* const command = app.add_subcommand(name, about);
    command->add_option("VOLUME", options->File, "A .vti or NIfTI file; or head:SIZE")->required();
    command->add_option("SCRATCH", options->Scratch, "A file that may be written")->required();
    command->add_option("--blocks", options->Blocks, "Voxels of a block")->delimiter(',');
    command->callback([options, measure] { measure(*options); });
    return command;
  };
  add("volume", "Bits a voxel against errors, next to zfp", MeasureRates)
    ->add_option("--psnr", options->Errors, "Errors that are wanted, in dB; 0: lossless")
    ->delimiter(',');
  CLI::App* const views = add("volume-views",
    "Time for each view of a volume, next to vtkFixedPointVolumeRayCastMapper; needs a display",
    MeasureViews);
  views->add_option("--pixels", options->Pixels, "Width and height of an image")
    ->check(CLI::Range(16, 8192));
  views->add_option("--rounds", options->Rounds, "Views beyond the first")
    ->check(CLI::Range(1, 1000));
}
}
