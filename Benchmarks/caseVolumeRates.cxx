// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// volume-rates: bits a voxel against the error of the voxels, of .ghv files, of zfp, and of
// lossless files.

#include "benchCases.h"
#include "benchVolume.h"
#include "benchZfp.h"

#include "gatunHartleyFile.h"

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
struct VolumeRatesOptions
{
  std::string File;
  std::string Scratch;
  std::vector<std::uint32_t> Blocks{ 4, 8, 16, 32, 64 };
  std::vector<double> Errors{ 25, 30, 35, 40, 45, 50, 0 }; ///< PSNR; 0: lossless
  std::vector<double> Weights{ 0 };
};

void AddPoint(
  Json::Value& json, const Volume& volume, double bytes, double meanSquareError, double worst)
{
  json["bits"] = 8 * bytes / static_cast<double>(volume.GetNumberOfVoxels());
  // No error makes no number, and JSON has no other.
  json["psnr"] = GetPSNR(volume.GetRange(), meanSquareError);
  json["worst"] = worst;
}

void AddGatun(Json::Value& json, const Volume& volume, const VolumeRatesOptions& options)
{
  json["gatun"] = Json::arrayValue;
  for (const std::uint32_t block : options.Blocks)
  {
    for (const double weight : options.Weights)
    {
      Json::Value settingJson;
      settingJson["block"] = static_cast<std::uint64_t>(block);
      settingJson["weight"] = weight;
      settingJson["points"] = Json::arrayValue;
      for (const double wanted : options.Errors)
      {
        gatun::HartleyWriterOptions writing;
        writing.BlockSize = block;
        if (wanted > 0)
        {
          writing.RateControl.Mode = gatun::HartleyRateMode::PSNR;
          writing.RateControl.Value = wanted;
        }
        else
        {
          writing.RateControl = MakeQuality(0);
        }
        writing.RateControl.FrequencyWeight = weight;
        gatun::HartleyWritten written;
        const double packing = SecondsOf(
          [&] { written = gatun::WriteHartleyFile(options.Scratch, volume.GetInput(), writing); });
        std::vector<double> voxels(volume.GetNumberOfVoxels());
        const double unpacking = SecondsOf(
          [&]
          {
            const gatun::HartleyFile file(options.Scratch);
            file.GetVoxels({}, volume.GetSize(), voxels.data());
          });
        Json::Value pointJson;
        pointJson["wanted"] = wanted;
        AddPoint(pointJson, volume, static_cast<double>(written.FileBytes),
          written.RMSError * written.RMSError, written.MaximumError);
        pointJson["packing"] = packing;
        pointJson["unpacking"] = unpacking;
        settingJson["points"].append(pointJson);
      }
      json["gatun"].append(settingJson);
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
  const int bits = volume.GetImage()->GetScalarSize() == 1 ? 8 : 16;
  const auto run = [&](const char* name, ZfpMode mode, double value)
  {
    AddPeer(json["zfp"][name], volume, value,
      RunZfp(volume.GetVoxels(), volume.GetSize(), mode, value, bits));
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
    for (const int planes : { 2, 4, 6, 8, 10, 12, 14, 16, 18 })
    {
      run("integers", ZfpMode::Integers, planes);
    }
    run("reversible", ZfpMode::Reversible, 0);
  }
}

void PrintRates(const VolumeRatesOptions& options)
{
  const Volume volume(options.File);
  PrintJson(
    [&](Json::Value& json)
    {
      json["voxels"] = static_cast<std::uint64_t>(volume.GetNumberOfVoxels());
      json["type"] = volume.GetImage()->GetScalarTypeAsString();
      json["lowest"] = volume.GetLowest();
      json["highest"] = volume.GetHighest();
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
      json["vti"] =
        8 * static_cast<double>(FileSize(file)) / static_cast<double>(volume.GetNumberOfVoxels());
      std::remove(file.c_str());
      std::remove(options.Scratch.c_str());
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumeRates(CLI::App& app)
{
  auto options = std::make_shared<VolumeRatesOptions>();
  CLI::App* const command =
    app.add_subcommand("volume-rates", "Bits a voxel against errors, next to zfp");
  command->add_option("VOLUME", options->File, "A .vti or NIfTI file; head:SIZE, smooth:SIZE")
    ->required();
  command->add_option("SCRATCH", options->Scratch, "A .ghv file that may be written")->required();
  command->add_option("--blocks", options->Blocks, "Voxels of a block");
  command->add_option("--psnr", options->Errors, "Errors that are wanted, in dB; 0: lossless");
  command->add_option("--weights", options->Weights, "FrequencyWeight of the quantizer");
  command->callback([options] { PrintRates(*options); });
}
}
