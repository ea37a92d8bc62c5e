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
struct Options
{
  std::string File;
  std::string Scratch;
  std::vector<std::uint32_t> Blocks{ 4, 8, 16, 32, 64 };
  std::vector<double> Errors{ 25, 30, 35, 40, 45, 50, 0 }; ///< PSNR; 0: lossless
  std::vector<double> Weights{ 0 };
};

void AddPoint(
  gtn::Json& json, const Volume& volume, double bytes, double meanSquareError, double worst)
{
  json.Add("bits", 8 * bytes / static_cast<double>(volume.GetNumberOfVoxels()));
  // No error makes no number, and JSON has no other.
  json.Add("psnr", GetPSNR(volume.GetRange(), meanSquareError));
  json.Add("worst", worst);
}

void AddGatun(gtn::Json& json, const Volume& volume, const Options& options)
{
  json.BeginArray("gatun");
  for (const std::uint32_t block : options.Blocks)
  {
    for (const double weight : options.Weights)
    {
      json.BeginObject();
      json.Add("block", static_cast<std::uint64_t>(block));
      json.Add("weight", weight);
      json.BeginArray("points");
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
        json.BeginObject();
        json.Add("wanted", wanted);
        AddPoint(json, volume, static_cast<double>(written.FileBytes),
          written.RMSError * written.RMSError, written.MaximumError);
        json.Add("packing", packing);
        json.Add("unpacking", unpacking);
        json.EndObject();
      }
      json.EndArray();
      json.EndObject();
    }
  }
  json.EndArray();
}

/** Voxels as a reader would give them back: integers, within the range. */
void AddPeer(gtn::Json& json, const Volume& volume, double value, ZfpResult result)
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
  json.BeginObject();
  json.Add("value", value);
  AddPoint(json, volume, static_cast<double>(result.Bytes),
    squares / static_cast<double>(result.Voxels.size()), worst);
  json.EndObject();
}

void AddZfp(gtn::Json& json, const Volume& volume)
{
  if (!HasZfp())
  {
    return;
  }
  const int bits = volume.GetImage()->GetScalarSize() == 1 ? 8 : 16;
  const auto run = [&](ZfpMode mode, double value) {
    AddPeer(json, volume, value, RunZfp(volume.GetVoxels(), volume.GetSize(), mode, value, bits));
  };
  json.BeginObject("zfp");
  json.BeginArray("accuracy");
  for (int part = 1; part <= 11; ++part)
  {
    run(ZfpMode::Accuracy, volume.GetRange() * std::pow(2, -part));
  }
  json.EndArray();
  json.BeginArray("precision");
  for (const int planes : { 2, 4, 6, 8, 10, 12, 14, 16 })
  {
    run(ZfpMode::Precision, planes);
  }
  json.EndArray();
  if (volume.IsInteger())
  {
    json.BeginArray("integers");
    for (const int planes : { 2, 4, 6, 8, 10, 12, 14, 16, 18 })
    {
      run(ZfpMode::Integers, planes);
    }
    json.EndArray();
    json.BeginArray("reversible");
    run(ZfpMode::Reversible, 0);
    json.EndArray();
  }
  json.EndObject();
}

void PrintRates(const Options& options)
{
  const Volume volume(options.File);
  PrintJson(
    [&](gtn::Json& json)
    {
      json.Add("voxels", static_cast<std::uint64_t>(volume.GetNumberOfVoxels()));
      json.Add("type", volume.GetImage()->GetScalarTypeAsString());
      json.Add("lowest", volume.GetLowest());
      json.Add("highest", volume.GetHighest());
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
      json.Add("vti",
        8 * static_cast<double>(FileSize(file)) / static_cast<double>(volume.GetNumberOfVoxels()));
      std::remove(file.c_str());
      std::remove(options.Scratch.c_str());
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumeRates(CLI::App& app)
{
  auto options = std::make_shared<Options>();
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
