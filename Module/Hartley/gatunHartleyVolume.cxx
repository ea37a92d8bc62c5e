// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyVolume.h"

#include "gatunHartleyEncoder.h"
#include "gatunParallel.h"

namespace gatun
{
//------------------------------------------------------------------------------
std::shared_ptr<const HartleyVolume> HartleyVolume::Make(const VolumeInput& input,
  std::uint32_t blockSize, const HartleyRateControl& control,
  const std::function<bool(double)>& progress)
{
  constexpr double encoded = 0.8;
  const auto getPart = [&](double first, double last) -> std::function<bool(double)>
  {
    if (!progress)
    {
      return {};
    }
    return [=, &progress](double done) { return progress(first + done * (last - first)); };
  };
  const HartleyEncoder encoder(input, blockSize, control, getPart(0, encoded));
  auto volume = std::make_shared<HartleyVolume>();
  volume->Layout = encoder.GetLayout();
  volume->Base = encoder.GetBase();
  volume->Values = encoder.GetRange();
  volume->Chunks.resize(volume->Layout.GetNumberOfChunks());
  ParallelFor(
    volume->Chunks.size(),
    [&](std::size_t chunk)
    {
      volume->Chunks[chunk] = HartleyEncoder::MakeTerms(
        encoder.GetQuantizer(), volume->Layout.GetVoxelsPerBlock(), encoder.GetIntegers(chunk));
    },
    getPart(encoded, 1));
  return volume;
}

//------------------------------------------------------------------------------
std::uint64_t HartleyVolume::GetNumberOfTerms() const
{
  std::uint64_t terms = 0;
  for (const auto& chunk : this->Chunks)
  {
    terms += chunk->Terms.size();
  }
  return terms;
}
}
