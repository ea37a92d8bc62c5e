// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyEncoder_h
#define gatunHartleyEncoder_h

#include "gatunBytes.h"
#include "gatunHartleyInput.h"
#include "gatunHartleyOrder.h"
#include "gatunHartleyQuantiser.h"
#include "gatunHartleySource.h"
#include "gatunHartleyVoxels.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace gatun
{
/** The quantised coefficients of a chunk: its blocks one after the other, index by index. */
using HartleyIntegers = std::vector<std::int64_t>;

/** A chunk as a file has it. */
struct EncodedHartleyChunk
{
  std::vector<Bytes> Streams; ///< one, or one for each segment
  Bytes Corrections;          ///< of lossless integers
  std::uint64_t Terms = 0;    ///< coefficients that are not 0

  std::uint64_t GetBytes() const;
};

/**
 * From a volume to quantised coefficients: transforms, and finds the step that a quality asks for.
 * What a file has and what a volume in memory has both come from here. The volume's values must
 * live as long as this.
 */
class HartleyEncoder
{
public:
  using Progress = std::function<bool(double)>;

  /** Throws Error(InvalidInput), as HartleyVolume::Make does. */
  HartleyEncoder(const VolumeInput& input, std::uint32_t blockSize, const HartleyQuality& quality,
    const Progress& progress);

  const HartleyLayout& GetLayout() const { return this->Layout; }
  double GetBase() const { return this->Values.Min; }
  const Range& GetRange() const { return this->Values; }
  const HartleyQuantiser& GetQuantiser() const { return *this->Quantiser; }

  /** Whether voxels come back exactly (integers), or but for rounding (floating point). */
  bool IsLossless() const;

  /** Thread safe. */
  HartleyIntegers GetIntegers(std::size_t chunk) const;

  /** A chunk's streams. Thread safe. */
  EncodedHartleyChunk Encode(std::size_t chunk, const HartleyIntegers& integers) const;

  /** Errors of the voxels of a chunk that come of its integers. Thread safe. */
  VoxelErrors GetErrors(std::size_t chunk, const HartleyIntegers& integers) const;

  /** Bytes of a file beside its streams, nearly. */
  static constexpr std::uint64_t BytesOfFile = 420;
  static constexpr std::uint64_t BytesOfStream = 14;

  /** The terms of a chunk. */
  static std::shared_ptr<const HartleyChunk> MakeTerms(
    const HartleyQuantiser& quantiser, std::size_t voxelsPerBlock, const HartleyIntegers& integers);

private:
  void CheckQuality() const;
  void Transform(const Progress& progress);
  std::vector<double> GetCoefficients(std::size_t chunk) const;
  void ChooseSample();
  void SetStep(double step);
  void FindStepOfError(double target, const Progress& progress);
  void FindStepOfRate(double target, const Progress& progress);
  double GetLargestStep() const;
  double GetSampleError() const;
  double GetError(const Progress& progress) const;
  double GetRate(const std::vector<std::size_t>& chunks, const Progress& progress) const;
  double GetNumberOfVoxels() const;
  const HartleyOrder& GetOrder() const;

  VolumeInput Input;
  HartleyQuality Quality;
  HartleyLayout Layout;
  Range Values;
  std::vector<std::vector<double>> Kept; ///< coefficients of chunks, unless the volume is large
  std::vector<std::size_t> Sample;       ///< chunks of which steps are estimated
  std::vector<std::vector<double>> SampleCoefficients; ///< if none are kept
  std::unique_ptr<const HartleyQuantiser> Quantiser;
  mutable std::once_flag OrderIsMade; ///< takes memory, and not all need it
  mutable std::unique_ptr<const HartleyOrder> Order;
};
}

#endif
