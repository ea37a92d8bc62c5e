// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunError.h"
#include "gatunHartleyBlocks.h"
#include "gatunHartleyEncoder.h"
#include "gatunHartleyFile.h"
#include "gatunHartleyTables.h"
#include "gatunOutputFile.h"
#include "gatunVersion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace gatun
{
namespace
{
constexpr std::size_t ChunksPerBatch = 64;

// The encoder's share of the progress.
constexpr double PartOfEncoder = 0.6;

void CheckPlace(const VolumeInput& volume)
{
  const auto isFinite = [](double value) { return std::isfinite(value); };
  const auto check = [&](const auto& values, const char* what)
  {
    if (!std::all_of(values.begin(), values.end(), isFinite))
    {
      ThrowInvalid(std::string("the volume's ") + what + " is not finite");
    }
  };
  check(volume.Origin, "origin");
  check(volume.Spacing, "spacing");
  check(volume.Direction, "direction");
}

/** The streams of several chunks, which form a section. */
class Batch
{
public:
  void Add(const Bytes& stream, StreamRef& where)
  {
    where = { this->Data.size(), stream.size(), Checksum(stream) };
    this->Data.insert(this->Data.end(), stream.begin(), stream.end());
    this->Places.push_back(&where);
  }

  void Write(OutputFile& file)
  {
    const auto offset = file.AddSection(SectionBlocks, this->Data);
    for (auto* where : this->Places)
    {
      where->Offset += offset;
    }
  }

private:
  Bytes Data;
  std::vector<StreamRef*> Places;
};
}

//------------------------------------------------------------------------------
HartleyWritten WriteHartleyFile(const std::string& path, const VolumeInput& volume,
  const HartleyWriterOptions& options, const std::function<bool(double)>& progress)
{
  const auto getPart = [&](double first, double last) -> std::function<bool(double)>
  {
    if (!progress)
    {
      return {};
    }
    return [=, &progress](double done) { return progress(first + done * (last - first)); };
  };
  CheckPlace(volume);
  // Opened first, so that an error is found before the volume is encoded.
  OutputFile file(path, VolumeContainer);
  const HartleyEncoder encoder(
    volume, options.BlockSize, options.RateControl, getPart(0, PartOfEncoder));
  HartleyMeta meta;
  meta.WriterVersion = PackageVersion();
  meta.Volume = volume;
  meta.BlockSize = options.BlockSize;
  meta.Layout = encoder.GetLayout();
  meta.Values = encoder.GetRange();
  meta.Steps = encoder.GetQuantizer().GetSteps();
  meta.Lossless = encoder.IsLossless();
  meta.RateControl = options.RateControl;

  HartleyTable table;
  const auto chunks = meta.Layout.GetNumberOfChunks();
  table.Chunks.resize(chunks);
  VoxelErrors errors;
  for (std::size_t first = 0; first < chunks; first += ChunksPerBatch)
  {
    const auto count = std::min(ChunksPerBatch, chunks - first);
    std::vector<EncodedHartleyChunk> encoded(count);
    std::vector<VoxelErrors> encodedErrors(count);
    const auto at = [&](std::size_t chunk)
    {
      return PartOfEncoder +
        (1 - PartOfEncoder) * static_cast<double>(chunk) / static_cast<double>(chunks);
    };
    ForEachHartleyChunk(
      count,
      [&](std::size_t i)
      {
        const auto integers = encoder.GetIntegers(first + i);
        encoded[i] = encoder.Encode(first + i, integers);
        encodedErrors[i] = encoder.GetErrors(first + i, integers);
      },
      getPart(at(first), at(first + count)));
    Batch batch;
    for (std::size_t i = 0; i < count; ++i)
    {
      errors.Add(encodedErrors[i]);
      auto& entry = table.Chunks[first + i];
      entry.Terms = encoded[i].Terms;
      entry.Streams.resize(encoded[i].Streams.size());
      for (std::size_t s = 0; s < entry.Streams.size(); ++s)
      {
        batch.Add(encoded[i].Streams[s], entry.Streams[s]);
      }
      if (meta.HasCorrections())
      {
        batch.Add(encoded[i].Corrections, entry.Corrections);
      }
    }
    batch.Write(file);
  }
  const auto& size = volume.Size;
  meta.RMSError = std::sqrt(errors.Squares / (static_cast<double>(size[0]) * size[1] * size[2]));
  meta.MaximumError = errors.Largest;
  file.AddSection(SectionTable, table.Write(meta));
  file.AddSection(SectionMeta, meta.Write());
  return { file.Commit(), meta.RMSError, meta.MaximumError };
}
}
