// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn volume info: what is in a .ghv file, from its directory alone.

#include "gtnDescription.h"
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

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace gtn
{
namespace
{

struct VolumeInfoOptions
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

Entry Text(std::string text)
{
  return { {}, std::move(text) };
}

/** Numbers, as an array in JSON. */
template <typename Numbers>
Entry List(const Numbers& numbers)
{
  return { JsonArray(numbers), ListOf(numbers) };
}

void DescribeGrid(const gatun::HartleyFile& file, Description& description)
{
  const gatun::VolumeInput& volume = file.GetVolume();
  const gatun::HartleyLayout& layout = file.GetLayout();
  const gatun::Range& range = file.GetRange();
  description.Add("size", "voxels", { JsonArray(layout.Size), SizeOf(layout.Size) });
  description.Add(
    nullptr, "array", Text(fmt::format("'{}', {}", Printable(volume.Name), NameOf(volume.Type))));
  description.Add("array", nullptr, Entry(volume.Name));
  description.Add("type", nullptr, Entry(NameOf(volume.Type)));
  description.Add("range", "values",
    { JsonArray(std::array{ range.Min, range.Max }),
      fmt::format("{:.7g} to {:.7g}", range.Min, range.Max) });
  description.Add("firstIndex", "first index", List(volume.FirstIndex));
  description.Add("origin", "origin", List(volume.Origin));
  description.Add("spacing", "spacing", List(volume.Spacing));
  description.Add("direction", "direction", List(volume.Direction));
  description.Add(nullptr, "blocks", Text(DescribeBlocks(layout)));
  description.Add("block", nullptr, { JsonArray(layout.Block), {} });
  description.Add("whole", nullptr, { layout.IsWhole(), {} });
  description.Add("blocks", nullptr, Entry(layout.GetNumberOfBlocks()));
  description.Add("chunks", "chunks", Entry(layout.GetNumberOfChunks()));
}

void DescribeCoding(const gatun::HartleyFile& file, Description& description)
{
  const gatun::HartleyRateControl& rate = file.GetRateControl();
  const double bits = BitsPerVoxel(file);
  const double ratio = RawBits(file) / bits;
  const double psnr = PeakSignalToNoise(file.GetRange(), file.GetRMSError());
  description.Add("lossless", nullptr, { file.IsLossless(), {} });
  description.Add("rateControl", "rate control",
    { NameOf(rate.Mode), file.IsLossless() ? "lossless" : Describe(rate) });
  description.Add("rateControlValue", nullptr, { rate.Value, {} });
  description.Add("frequencyWeight", nullptr, { rate.FrequencyWeight, {} });
  description.Add(
    "bytes", "size", { Json::UInt64{ file.GetFileBytes() }, ByteSize(file.GetFileBytes()) });
  description.Add(
    "bitsPerVoxel", "bits per voxel", { bits, fmt::format("{:.3f}, 1 : {:.4g}", bits, ratio) });
  description.Add("ratio", nullptr, { ratio, {} });
  description.Add(nullptr, "error",
    Text(fmt::format("root mean square {:.4g}, largest {:.4g}{}", file.GetRMSError(),
      file.GetMaximumError(), std::isfinite(psnr) ? fmt::format(", {:.1f} dB", psnr) : "")));
  description.Add("rootMeanSquareError", nullptr, { file.GetRMSError(), {} });
  description.Add("largestError", nullptr, { file.GetMaximumError(), {} });
  description.Add("psnr", nullptr, { psnr, {} });
  description.Add("terms", "coefficients",
    { Json::UInt64{ file.GetNumberOfTerms() },
      fmt::format("{} nonzero, {:.1f} % of the voxels", Grouped(file.GetNumberOfTerms()),
        100 * static_cast<double>(file.GetNumberOfTerms()) / CountVoxels(file)) });
}

void DescribeChunks(const gatun::HartleyFile& file, Description& description)
{
  Json::Value bytes(Json::arrayValue);
  Table table{ nullptr, "chunks", { { nullptr, "number" }, { nullptr, "bytes" } } };
  for (std::size_t chunk = 0; chunk < file.GetLayout().GetNumberOfChunks(); ++chunk)
  {
    const std::uint64_t size = file.GetChunkBytes(chunk);
    bytes.append(Json::UInt64{ size });
    table.Rows.push_back({ Entry(chunk), Entry(size) });
  }
  description.Add("chunkBytes", nullptr, { std::move(bytes), {} });
  description.Add(std::move(table));
}

Description Describe(const gatun::HartleyFile& file, bool isVerified, bool verbose)
{
  const auto version = file.GetFormatVersion();
  Description description(fmt::format("{}: format {}, written by Gatun {}", file.GetPath(), version,
    Printable(file.GetWriterVersion())));
  description.Add("file", nullptr, Entry(file.GetPath()));
  description.Add("formatVersion", nullptr, Entry(std::uint64_t{ version }));
  description.Add("writerVersion", nullptr, Entry(file.GetWriterVersion()));
  DescribeGrid(file, description);
  DescribeCoding(file, description);
  if (isVerified)
  {
    description.Add(
      "verified", "verified", { true, "all checksums are right, and all chunks can be decoded" });
  }
  if (verbose)
  {
    DescribeChunks(file, description);
  }
  return description;
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumeInfo(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<VolumeInfoOptions>();
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
      const Description description = Describe(file, options->Verify, settings.Verbose);
      fmt::print("{}", options->Json ? JsonText(description.GetJson()) : description.GetText());
    });
}
}
