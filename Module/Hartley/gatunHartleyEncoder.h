// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyEncoder_h
#define gatunHartleyEncoder_h

#include "gatunBytes.h"
#include "gatunHartleyInput.h"
#include "gatunHartleyOrder.h"
#include "gatunHartleyQuantizer.h"
#include "gatunHartleySource.h"
#include "gatunHartleyVoxels.h"
#include "gatunLargeArray.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace gatun
{
/** The quantized coefficients of a chunk: its blocks one after the other, index by index. */
using HartleyIntegers = LargeArray<std::int64_t>;

/** A chunk as it is stored in a file. */
struct EncodedHartleyChunk
{
  std::vector<Bytes> Streams; ///< one, or one for each segment
  Bytes Corrections;          ///< of lossless volumes of integers
  std::uint64_t Terms = 0;    ///< nonzero coefficients

  std::uint64_t GetBytes() const;
};

/**
 * Transforms a volume, chooses the quantizer's step by a rate control and quantizes the
 * coefficients, for files as well as for volumes in memory. The values of the volume must outlive
 * the encoder.
 */
class HartleyEncoder
{
public:
  using Progress = std::function<bool(double)>;

  /** Throws the errors of HartleyVolume::Make. */
  HartleyEncoder(const VolumeInput& input, std::uint32_t blockSize,
    const HartleyRateControl& control, const Progress& progress);

  const HartleyLayout& GetLayout() const { return this->Layout; }
  double GetBase() const { return this->Values.Min; }
  const Range& GetRange() const { return this->Values; }
  const HartleyQuantizer& GetQuantizer() const { return *this->Quantizer; }

  /** Whether voxels are restored exactly (integers) or up to rounding (floating point). */
  bool IsLossless() const;

  /** Thread safe. */
  HartleyIntegers GetIntegers(std::size_t chunk) const;

  /** Encodes a chunk. Thread safe. */
  EncodedHartleyChunk Encode(std::size_t chunk, const HartleyIntegers& integers) const;

  /** Errors of the voxels that the integers of a chunk restore. Thread safe. */
  VoxelErrors GetErrors(std::size_t chunk, const HartleyIntegers& integers) const;

  /** Estimates of the size of a file without its streams, and of the overhead of a stream. */
  static constexpr std::uint64_t BytesOfFile = 420;
  static constexpr std::uint64_t BytesOfStream = 14;

  /** The nonzero coefficients of a chunk. */
  static std::shared_ptr<const HartleyChunk> MakeTerms(
    const HartleyQuantizer& quantizer, std::size_t voxelsPerBlock, const HartleyIntegers& integers);

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
  HartleyRateControl RateControl;
  HartleyLayout Layout;
  Range Values;
  std::vector<std::vector<double>> Kept; ///< coefficients of chunks; empty if the volume is large
  std::vector<std::size_t> Sample;       ///< chunks from which steps are estimated
  std::vector<std::vector<double>> SampleCoefficients; ///< if Kept is empty
  std::unique_ptr<const HartleyQuantizer> Quantizer;
  mutable std::once_flag OrderIsMade; ///< made when it is used first
  mutable std::unique_ptr<const HartleyOrder> Order;
};
}

#endif
