// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunVolumeDescription.h"

#include "gatunDescriptionText.h"
#include "gatunHartleyFile.h"

#include <array>
#include <cmath>
#include <limits>

namespace gatun
{
namespace
{
double CountVoxels(const HartleyFile& file)
{
  const auto& size = file.GetLayout().Size;
  return static_cast<double>(size[0]) * size[1] * size[2];
}

double BitsPerVoxel(const HartleyFile& file)
{
  return 8 * static_cast<double>(file.GetFileBytes()) / CountVoxels(file);
}

double RawBits(const HartleyFile& file)
{
  return 8 * static_cast<double>(SizeOf(file.GetVolume().Type));
}

template <typename Number, std::size_t Count>
std::string ListOf(const std::array<Number, Count>& numbers)
{
  std::vector<std::string> texts;
  for (const Number number : numbers)
  {
    texts.push_back(DescribeNumber(static_cast<double>(number), 7));
  }
  return Join(texts, " ");
}

Entry EntryOfText(std::string text)
{
  return { {}, std::move(text) };
}

/** Numbers, as an array in JSON. */
template <typename Numbers>
Entry EntryOfList(const Numbers& numbers)
{
  return { MakeJsonArray(numbers), ListOf(numbers) };
}

void DescribeGrid(const HartleyFile& file, Description& description)
{
  const VolumeInput& volume = file.GetVolume();
  const HartleyLayout& layout = file.GetLayout();
  const Range& range = file.GetRange();
  description.Add("size", "voxels", { MakeJsonArray(layout.Size), DescribeVoxels(layout.Size) });
  description.Add(nullptr, "array",
    EntryOfText(MakePrintableLine(volume.Name)
                  .insert(0, 1, '\'')
                  .append("', ")
                  .append(NameOfType(volume.Type))));
  description.Add("array", nullptr, Entry(volume.Name));
  description.Add("type", nullptr, Entry(NameOfType(volume.Type)));
  description.Add("range", "values",
    { MakeJsonArray(std::array{ range.Min, range.Max }),
      DescribeNumber(range.Min, 7) + " to " + DescribeNumber(range.Max, 7) });
  description.Add("firstIndex", "first index", EntryOfList(volume.FirstIndex));
  description.Add("origin", "origin", EntryOfList(volume.Origin));
  description.Add("spacing", "spacing", EntryOfList(volume.Spacing));
  description.Add("direction", "direction", EntryOfList(volume.Direction));
  description.Add(nullptr, "blocks", EntryOfText(DescribeVolumeBlocks(layout)));
  description.Add("block", nullptr, { MakeJsonArray(layout.Block), {} });
  description.Add("whole", nullptr, { layout.IsWhole(), {} });
  description.Add("blocks", nullptr, Entry(layout.GetNumberOfBlocks()));
  description.Add("chunks", "chunks", Entry(layout.GetNumberOfChunks()));
}

void DescribeCoding(const HartleyFile& file, Description& description)
{
  const HartleyRateControl& rate = file.GetRateControl();
  const double bits = BitsPerVoxel(file);
  const double ratio = RawBits(file) / bits;
  const double psnr = ComputePeakSignalToNoise(file.GetRange(), file.GetRMSError());
  description.Add("lossless", nullptr, { file.IsLossless(), {} });
  description.Add("rateControl", "rate control",
    { NameOfRateMode(rate.Mode), file.IsLossless() ? "lossless" : DescribeRate(rate) });
  description.Add("rateControlValue", nullptr, { rate.Value, {} });
  description.Add("frequencyWeight", nullptr, { rate.FrequencyWeight, {} });
  description.Add("bytes", "size",
    { Json::UInt64{ file.GetFileBytes() }, DescribeByteSize(file.GetFileBytes()) });
  description.Add("bitsPerVoxel", "bits per voxel",
    { bits, DescribeFixed(bits, 3) + ", 1 : " + DescribeNumber(ratio, 4) });
  description.Add("ratio", nullptr, { ratio, {} });
  description.Add(nullptr, "error",
    EntryOfText("root mean square " + DescribeNumber(file.GetRMSError(), 4) + ", largest " +
      DescribeNumber(file.GetMaximumError(), 4) +
      (std::isfinite(psnr) ? ", " + DescribeFixed(psnr, 1) + " dB" : "")));
  description.Add("rootMeanSquareError", nullptr, { file.GetRMSError(), {} });
  description.Add("largestError", nullptr, { file.GetMaximumError(), {} });
  description.Add("psnr", nullptr, { psnr, {} });
  description.Add("terms", "coefficients",
    { Json::UInt64{ file.GetNumberOfTerms() },
      GroupDigits(file.GetNumberOfTerms()) + " nonzero, " +
        DescribeFixed(100 * static_cast<double>(file.GetNumberOfTerms()) / CountVoxels(file), 1) +
        " % of the voxels" });
}

void DescribeVolumeChunks(const HartleyFile& file, Description& description)
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

} // anonymous namespace

//------------------------------------------------------------------------------
std::string DescribeVoxels(const std::array<std::uint32_t, 3>& size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
    std::to_string(size[2]);
}

//------------------------------------------------------------------------------
const char* NameOfRateMode(HartleyRateMode mode)
{
  constexpr std::array<const char*, 4> names{ "quality", "rmsError", "psnr", "bitsPerVoxel" };
  return names.at(static_cast<std::size_t>(mode));
}

//------------------------------------------------------------------------------
std::string DescribeRate(const HartleyRateControl& control)
{
  const std::string weight = control.FrequencyWeight > 0
    ? ", frequency weight " + DescribeNumber(control.FrequencyWeight, 4)
    : "";
  const std::string value = DescribeNumber(control.Value, 4);
  switch (control.Mode)
  {
    case HartleyRateMode::RMSError:
      return "RMS error up to " + value + weight;
    case HartleyRateMode::PSNR:
      return "PSNR of at least " + value + " dB" + weight;
    case HartleyRateMode::BitsPerVoxel:
      return value + " bits per voxel" + weight;
    case HartleyRateMode::Quality:
      break;
  }
  return "quality " + value + weight;
}

//------------------------------------------------------------------------------
std::string DescribeVolumeBlocks(const HartleyLayout& layout)
{
  const auto& block = layout.Block;
  const std::string size = DescribeVoxels({ block[0], block[1], block[2] });
  return layout.IsWhole()
    ? "one block of " + size + " voxels"
    : GroupDigits(layout.GetNumberOfBlocks()) + " blocks of " + size + " voxels";
}

//------------------------------------------------------------------------------
double ComputePeakSignalToNoise(const Range& range, double rootMeanSquareError)
{
  return rootMeanSquareError > 0 ? 20 * std::log10((range.Max - range.Min) / rootMeanSquareError)
                                 : std::numeric_limits<double>::infinity();
}

//------------------------------------------------------------------------------
Description DescribeVolume(const HartleyFile& file, bool isVerified, bool verbose)
{
  const auto version = file.GetFormatVersion();
  Description description(file.GetPath() + ": format " + std::to_string(version) +
    ", written by Gatun " + MakePrintableLine(file.GetWriterVersion()));
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
    DescribeVolumeChunks(file, description);
  }
  return description;
}
}
