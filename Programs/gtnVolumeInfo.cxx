// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn volume info: what is in a .ghv file, from its directory alone.

#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnJson.h"
#include "gtnNames.h"
#include "gtnProgress.h"
#include "gtnReadable.h"
#include "gtnText.h"
#include "gtnVolume.h"
#include "gtnVolumeInput.h"
#include "gtnVolumeOptions.h"

#include "gatunHartleyFile.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace gtn
{
namespace
{

struct Options
{
  std::string File;
  bool Json = false;
  bool Verify = false;
};

double CountVoxels(const gatun::HartleyFile& file)
{
  const auto& size = file.GetLayout().Size;
  return static_cast<double>(size[0]) * size[1] * size[2];
}

double BitsPerVoxel(const gatun::HartleyFile& file)
{
  return 8 * static_cast<double>(file.GetFileBytes()) / CountVoxels(file);
}

double RawBits(const gatun::HartleyFile& file)
{
  return 8 * static_cast<double>(gatun::SizeOf(file.GetVolume().Type));
}

std::string Version(const gatun::HartleyFile& file)
{
  const auto [major, minor] = file.GetFormatVersion();
  return fmt::format("{}.{}", major, minor);
}

template <typename Number, std::size_t Count>
std::string ListOf(const std::array<Number, Count>& numbers)
{
  std::vector<std::string> texts;
  for (const Number number : numbers)
  {
    texts.push_back(fmt::format("{:.7g}", static_cast<double>(number)));
  }
  return Joined(texts, " ");
}

void PrintRow(const char* title, const std::string& value)
{
  fmt::print("  {:<16} {}\n", title, value);
}

void PrintText(const gatun::HartleyFile& file, const Options& options, bool verbose)
{
  const gatun::VolumeInput& volume = file.GetVolume();
  const gatun::HartleyLayout& layout = file.GetLayout();
  fmt::print("{}: format {}, written by Gatun {}\n", file.GetPath(), Version(file),
    Printable(file.GetWriterVersion()));
  PrintRow("voxels", SizeOf(layout.Size));
  PrintRow("array", fmt::format("'{}', {}", Printable(volume.Name), NameOf(volume.Type)));
  PrintRow("values", fmt::format("{:.7g} to {:.7g}", file.GetRange().Min, file.GetRange().Max));
  PrintRow("first index", ListOf(volume.FirstIndex));
  PrintRow("origin", ListOf(volume.Origin));
  PrintRow("spacing", ListOf(volume.Spacing));
  PrintRow("direction", ListOf(volume.Direction));
  PrintRow("blocks", DescribeBlocks(layout));
  PrintRow("chunks", Grouped(layout.GetNumberOfChunks()));
  PrintRow("rate control", file.IsLossless() ? "lossless" : Describe(file.GetRateControl()));
  PrintRow("size", ByteSize(file.GetFileBytes()));
  PrintRow("bits per voxel",
    fmt::format("{:.3f}, 1 : {:.4g}", BitsPerVoxel(file), RawBits(file) / BitsPerVoxel(file)));
  const double psnr = PeakSignalToNoise(file.GetRange(), file.GetRMSError());
  PrintRow("error",
    fmt::format("root mean square {:.4g}, largest {:.4g}{}", file.GetRMSError(),
      file.GetMaximumError(), std::isfinite(psnr) ? fmt::format(", {:.1f} dB", psnr) : ""));
  PrintRow("coefficients",
    fmt::format("{} nonzero, {:.1f} % of the voxels", Grouped(file.GetNumberOfTerms()),
      100 * static_cast<double>(file.GetNumberOfTerms()) / CountVoxels(file)));
  if (options.Verify)
  {
    PrintRow("verified", "all checksums are right, and all chunks can be decoded");
  }
  if (verbose)
  {
    fmt::print("\nchunks\n  {:>8} {:>14}\n", "number", "bytes");
    for (std::size_t chunk = 0; chunk < layout.GetNumberOfChunks(); ++chunk)
    {
      fmt::print("  {:>8} {:>14}\n", chunk, Grouped(file.GetChunkBytes(chunk)));
    }
  }
}

void PrintJson(const gatun::HartleyFile& file, const Options& options, bool verbose)
{
  const gatun::VolumeInput& volume = file.GetVolume();
  const gatun::HartleyLayout& layout = file.GetLayout();
  Json::Value json;
  json["file"] = file.GetPath();
  json["formatVersion"] = Version(file);
  json["writerVersion"] = file.GetWriterVersion();
  json["size"] = JsonArray(layout.Size);
  json["array"] = volume.Name;
  json["type"] = NameOf(volume.Type);
  json["range"] = JsonArray(std::array{ file.GetRange().Min, file.GetRange().Max });
  json["firstIndex"] = JsonArray(volume.FirstIndex);
  json["origin"] = JsonArray(volume.Origin);
  json["spacing"] = JsonArray(volume.Spacing);
  json["direction"] = JsonArray(volume.Direction);
  json["block"] = JsonArray(layout.Block);
  json["whole"] = layout.IsWhole();
  json["blocks"] = static_cast<std::uint64_t>(layout.GetNumberOfBlocks());
  json["chunks"] = static_cast<std::uint64_t>(layout.GetNumberOfChunks());
  json["lossless"] = file.IsLossless();
  json["rateControl"] = NameOf(file.GetRateControl().Mode);
  json["rateControlValue"] = file.GetRateControl().Value;
  json["frequencyWeight"] = file.GetRateControl().FrequencyWeight;
  json["rootMeanSquareError"] = file.GetRMSError();
  json["largestError"] = file.GetMaximumError();
  json["psnr"] = PeakSignalToNoise(file.GetRange(), file.GetRMSError());
  json["terms"] = file.GetNumberOfTerms();
  json["bytes"] = file.GetFileBytes();
  json["bitsPerVoxel"] = BitsPerVoxel(file);
  json["ratio"] = RawBits(file) / BitsPerVoxel(file);
  if (options.Verify)
  {
    json["verified"] = true;
  }
  if (verbose)
  {
    json["chunkBytes"] = Json::arrayValue;
    for (std::size_t chunk = 0; chunk < layout.GetNumberOfChunks(); ++chunk)
    {
      json["chunkBytes"].append(file.GetChunkBytes(chunk));
    }
  }
  fmt::print("{}", JsonText(json));
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumeInfo(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = AddCommand(app, settings, "info",
    "Tell what a .ghv file holds. Only its directory is read, unless it is to be verified.",
    "  gtn volume info head.ghv\n"
    "  gtn volume info -v head.ghv          also the chunks\n"
    "  gtn volume info --verify head.ghv\n"
    "  gtn volume info --json head.ghv | jq .bitsPerVoxel");
  command->add_flag("--json", options->Json, "Print JSON");
  command->add_flag(
    "--verify", options->Verify, "Check all checksums, and decode everything without keeping it");
  command->add_option("IN", options->File, "The .ghv file")->required();
  command->callback(
    [options, &settings]
    {
      CheckReadable(options->File);
      const gatun::HartleyFile file(options->File);
      if (options->Verify)
      {
        Progress progress("verifying", settings.ShowProgress);
        file.Verify([&progress](double fraction) { return progress(fraction); });
        CheckInterrupt();
      }
      options->Json ? PrintJson(file, *options, settings.Verbose)
                    : PrintText(file, *options, settings.Verbose);
    });
}
}
