// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyEncoder.h"

#include "gatunError.h"
#include "gatunHartleyBlocks.h"
#include "gatunHartleyCodec.h"
#include "gatunHartleyCorrections.h"
#include "gatunHartleyTransform.h"
#include "gatunParallel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>

namespace gatun
{
namespace
{
// Coefficients of volumes of up to this many voxels are kept. Others are recomputed when needed.
constexpr std::size_t KeptVoxels = std::size_t{ 1 } << 27;

constexpr std::size_t SampleChunks = 12;

// Steps of lossless volumes: of integers, whose errors are corrected, in their unit; of
// floating-point numbers relative to the range.
constexpr double StepOfIntegers = 1;
constexpr double StepOfFloat32 = 1.0 / (1 << 24);
constexpr double StepOfFloat64 = 1.0 / (std::uint64_t{ 1 } << 46);

// The accepted errors relative to their bound, and relative deviations of the rate.
constexpr double ErrorTolerance = 0.98;
constexpr double RateTolerance = 0.01;
constexpr int MostAttempts = 12;

/** The upper 24 bits of a step. Measures, and functions of the standard library, differ in the last
 * bits between systems; the bytes of files should not. */
double Shorten(double step)
{
  constexpr std::uint64_t rest = (1u << 29) - 1;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(step) & ~rest);
}

/**
 * Finds a step for which a monotonically increasing measure is between two bounds, by bracketing.
 */
class StepSearch
{
public:
  StepSearch(double low, double high, double smallest, double largest)
    : Low(low)
    , High(high)
    , Smallest(smallest)
    , Largest(largest)
  {
  }

  /** Searches from first. The measure of the result is within the bounds or, if no such step is
   * found, below them. Calls measure(step, number of the attempt). */
  template <typename Measure>
  double Find(double first, Measure&& measure) const
  {
    const double aim = (this->Low + this->High) / 2;
    double step = std::clamp(Shorten(first), this->Smallest, this->Largest);
    double good = 0;
    double bad = 0;
    double ofGood = 0;
    double ofBad = 0;
    for (int i = 0; i < MostAttempts || good == 0; ++i)
    {
      const double measured = measure(step, i);
      if (measured <= this->High)
      {
        good = step;
        ofGood = measured;
        if (measured >= this->Low || step >= this->Largest)
        {
          return good;
        }
      }
      else if (step <= this->Smallest)
      {
        return step;
      }
      else
      {
        bad = step;
        ofBad = measured;
      }
      if (good == 0)
      {
        step = std::max(this->Smallest, Shorten(bad * std::clamp(aim / ofBad, 0.1, 0.99)));
      }
      else if (bad == 0)
      {
        step = std::min(
          this->Largest, Shorten(good * (ofGood > 0 ? std::clamp(aim / ofGood, 1.01, 4.0) : 4.0)));
      }
      else
      {
        // Interpolates, but keeps a distance from both ends.
        const double place = ofGood > 0 ? std::log(aim / ofGood) / std::log(ofBad / ofGood) : 0.5;
        step = Shorten(good * std::pow(bad / good, std::clamp(place, 0.05, 0.95)));
      }
    }
    return good;
  }

private:
  double Low;
  double High;
  double Smallest;
  double Largest;
};

double CountFilled(const HartleyLayout& layout, const HartleyLayout::Triple& place)
{
  const auto filled = layout.GetFilled(place);
  return static_cast<double>(filled[0]) * filled[1] * filled[2];
}

/** Maps the progress of a part to that of the whole. */
HartleyEncoder::Progress GetPart(
  const HartleyEncoder::Progress& progress, double first, double last)
{
  if (!progress)
  {
    return {};
  }
  return [=](double done) { return progress(first + done * (last - first)); };
}

/** Maps the progress of one attempt of a search; few attempts are expected. */
HartleyEncoder::Progress GetAttempt(const HartleyEncoder::Progress& progress, int count)
{
  const auto begin = [](int i) { return 1 - std::exp2(-0.5 * i); };
  return GetPart(progress, begin(count), begin(count + 1));
}
}

//------------------------------------------------------------------------------
HartleyEncoder::HartleyEncoder(const VolumeInput& input, std::uint32_t blockSize,
  const HartleyRateControl& control, const Progress& progress)
  : Input(input)
  , RateControl(control)
  , Layout(HartleyLayout::Make(input.Size, blockSize))
{
  this->CheckQuality();
  if (!input.Values)
  {
    ThrowInvalid("the volume has no values");
  }
  this->Values = GetVoxelRange(input, GetPart(progress, 0, 0.05));
  this->Transform(GetPart(progress, 0.05, 0.3));
  this->ChooseSample();
  const double range = this->Values.Max - this->Values.Min;
  if (range == 0)
  {
    this->SetStep(1);
    return;
  }
  switch (control.Mode)
  {
    case HartleyRateMode::Quality:
      this->SetStep(Shorten(range * std::exp2(-control.Value / 10)));
      break;
    case HartleyRateMode::RMSError:
      if (!this->IsLossless())
      {
        this->FindStepOfError(control.Value, GetPart(progress, 0.3, 1));
      }
      else if (!IsFloating(input.Type))
      {
        if (range > LargestLosslessRange)
        {
          ThrowInvalid("the range of the voxels exceeds 2^40, the limit of lossless volumes");
        }
        this->SetStep(StepOfIntegers);
      }
      else
      {
        this->SetStep(range * (input.Type == ScalarType::Float32 ? StepOfFloat32 : StepOfFloat64));
      }
      break;
    case HartleyRateMode::PSNR:
      this->FindStepOfError(range * std::pow(10.0, -control.Value / 20), GetPart(progress, 0.3, 1));
      break;
    case HartleyRateMode::BitsPerVoxel:
      this->FindStepOfRate(control.Value, GetPart(progress, 0.3, 1));
      break;
  }
}

//------------------------------------------------------------------------------
void HartleyEncoder::CheckQuality() const
{
  const auto check = [](const char* what, double value, double least, double most)
  {
    if (!(value >= least && value <= most))
    {
      ThrowInvalid(std::string(what) + " is " + std::to_string(value) + ", but must be from " +
        std::to_string(least) + " to " + std::to_string(most));
    }
  };
  const auto value = this->RateControl.Value;
  switch (this->RateControl.Mode)
  {
    case HartleyRateMode::Quality:
      check("the quality", value, 1, 100);
      break;
    case HartleyRateMode::RMSError:
      check("the RMS error", value, 0, 1e300);
      break;
    case HartleyRateMode::PSNR:
      check("the peak signal-to-noise ratio in dB", value, 1, 200);
      break;
    case HartleyRateMode::BitsPerVoxel:
      check("the number of bits per voxel", value, 1e-6, 64);
      break;
    default:
      ThrowInvalid("the rate control mode is unknown");
  }
  check("the frequency weight", this->RateControl.FrequencyWeight, 0, 4);
}

//------------------------------------------------------------------------------
bool HartleyEncoder::IsLossless() const
{
  return this->RateControl.Mode == HartleyRateMode::RMSError && this->RateControl.Value == 0;
}

//------------------------------------------------------------------------------
double HartleyEncoder::GetNumberOfVoxels() const
{
  const auto& size = this->Layout.Size;
  return static_cast<double>(size[0]) * size[1] * size[2];
}

//------------------------------------------------------------------------------
void HartleyEncoder::Transform(const Progress& progress)
{
  // A volume of one block is always kept: the search would transform it in each attempt.
  const auto count = this->Layout.GetNumberOfChunks();
  if (count > 1 && this->GetNumberOfVoxels() > static_cast<double>(KeptVoxels))
  {
    return;
  }
  std::vector<std::vector<double>> kept(count);
  ForEachHartleyChunk(
    count, [&](std::size_t chunk) { kept[chunk] = this->GetCoefficients(chunk); }, progress);
  this->Kept = std::move(kept);
}

//------------------------------------------------------------------------------
std::vector<double> HartleyEncoder::GetCoefficients(std::size_t chunk) const
{
  const auto voxels = this->Layout.GetVoxelsPerBlock();
  std::vector<double> values(CountHartleyBlocks(this->Layout, chunk) * voxels);
  HartleyTransform transform(this->Layout.Block);
  ForEachHartleyBlock(this->Layout, chunk,
    [&](std::size_t block, const HartleyLayout::Triple& place)
    {
      const auto own = std::span(values).subspan(block * voxels, voxels);
      LoadBlock(this->Input, this->Layout, place, this->GetBase(), own);
      transform.Forward(own);
    });
  return values;
}

//------------------------------------------------------------------------------
void HartleyEncoder::ChooseSample()
{
  const auto chunks = this->Layout.GetNumberOfChunks();
  const auto count = std::min(chunks, SampleChunks);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Sample.push_back((2 * i + 1) * chunks / (2 * count));
  }
  if (this->Kept.empty())
  {
    this->SampleCoefficients.resize(count);
    ParallelFor(count,
      [&](std::size_t i) { this->SampleCoefficients[i] = this->GetCoefficients(this->Sample[i]); });
  }
}

//------------------------------------------------------------------------------
/** Sets the step and measures its shifts. */
void HartleyEncoder::SetStep(double step)
{
  HartleySteps steps;
  steps.Step = step;
  steps.Weight = this->RateControl.FrequencyWeight;
  steps.Nearest = this->IsLossless();
  if (steps.Nearest)
  {
    steps.Weight = 0;
  }
  auto quantizer = std::make_unique<const HartleyQuantizer>(this->Layout.Block, steps);
  if (!steps.Nearest)
  {
    const auto voxels = this->Layout.GetVoxelsPerBlock();
    std::vector<HartleyShiftSums> sums(this->Sample.size());
    ParallelFor(sums.size(),
      [&](std::size_t i)
      {
        const auto& coefficients =
          this->Kept.empty() ? this->SampleCoefficients[i] : this->Kept[this->Sample[i]];
        HartleyIntegers integers(voxels, 0);
        for (std::size_t at = 0; at < coefficients.size(); at += voxels)
        {
          const auto own = std::span(coefficients).subspan(at, voxels);
          quantizer->Quantize(own, integers);
          sums[i].Add(*quantizer, own, integers);
        }
      });
    HartleyShiftSums all;
    for (const auto& sum : sums)
    {
      all.Add(sum);
    }
    steps.Shifts = all.Get();
    quantizer = std::make_unique<const HartleyQuantizer>(this->Layout.Block, steps);
  }
  this->Quantizer = std::move(quantizer);
}

//------------------------------------------------------------------------------
/** Root mean square error of the sample's coefficients, which equals that of its voxels before
 * rounding. */
double HartleyEncoder::GetSampleError() const
{
  const auto voxels = this->Layout.GetVoxelsPerBlock();
  std::vector<double> squares(this->Sample.size());
  std::vector<double> counts(this->Sample.size());
  ParallelFor(squares.size(),
    [&](std::size_t i)
    {
      const auto& coefficients =
        this->Kept.empty() ? this->SampleCoefficients[i] : this->Kept[this->Sample[i]];
      HartleyIntegers integers(voxels, 0);
      for (std::size_t at = 0; at < coefficients.size(); at += voxels)
      {
        const auto own = std::span(coefficients).subspan(at, voxels);
        this->Quantizer->Quantize(own, integers);
        for (std::size_t k = 0; k < voxels; ++k)
        {
          const double error = own[k] - this->Quantizer->Restore(k, integers[k]);
          squares[i] += error * error;
        }
      }
      ForEachHartleyBlock(this->Layout, this->Sample[i],
        [&](std::size_t, const HartleyLayout::Triple& place)
        { counts[i] += CountFilled(this->Layout, place); });
    });
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    sum += squares[i];
    count += counts[i];
  }
  return std::sqrt(sum / count);
}

//------------------------------------------------------------------------------
double HartleyEncoder::GetError(const Progress& progress) const
{
  std::vector<VoxelErrors> errors(this->Layout.GetNumberOfChunks());
  ForEachHartleyChunk(
    errors.size(),
    [&](std::size_t chunk) { errors[chunk] = this->GetErrors(chunk, this->GetIntegers(chunk)); },
    progress);
  VoxelErrors all;
  for (const auto& error : errors)
  {
    all.Add(error);
  }
  return std::sqrt(all.Squares / this->GetNumberOfVoxels());
}

//------------------------------------------------------------------------------
/** A step for which all coefficients are quantized to 0. */
double HartleyEncoder::GetLargestStep() const
{
  return 4 * (this->Values.Max - this->Values.Min) *
    std::sqrt(static_cast<double>(this->Layout.GetVoxelsPerBlock()));
}

//------------------------------------------------------------------------------
/** Approximates the largest step whose error is at most target. */
void HartleyEncoder::FindStepOfError(double target, const Progress& progress)
{
  const double largest = this->GetLargestStep();
  const double smallest = StepOfFloat64 * (this->Values.Max - this->Values.Min);
  StepSearch search(ErrorTolerance * target, target, smallest, largest);
  // The sample's error before rounding is a first estimate.
  double step = search.Find(std::min(target * std::sqrt(12.0), largest),
    [&](double attempt, int)
    {
      this->SetStep(attempt);
      return this->GetSampleError();
    });
  step = search.Find(step,
    [&](double attempt, int count)
    {
      this->SetStep(attempt);
      return this->GetError(GetAttempt(progress, count));
    });
  if (step <= smallest)
  {
    ThrowInvalid("the requested error is too small for these voxels; 0 is lossless");
  }
  this->SetStep(step);
}

//------------------------------------------------------------------------------
/** Approximates the step for which the file has target bits per voxel. */
void HartleyEncoder::FindStepOfRate(double target, const Progress& progress)
{
  const double range = this->Values.Max - this->Values.Min;
  StepSearch search((1 - RateTolerance) / target, (1 + RateTolerance) / target,
    StepOfFloat64 * range, this->GetLargestStep());
  std::vector<std::size_t> all(this->Layout.GetNumberOfChunks());
  std::iota(all.begin(), all.end(), std::size_t{ 0 });
  double step = search.Find(range / 64,
    [&](double attempt, int)
    {
      this->SetStep(attempt);
      return 1 / this->GetRate(this->Sample, {});
    });
  if (this->Sample.size() < all.size())
  {
    step = search.Find(step,
      [&](double attempt, int count)
      {
        this->SetStep(attempt);
        return 1 / this->GetRate(all, GetAttempt(progress, count));
      });
  }
  this->SetStep(step);
}

//------------------------------------------------------------------------------
/** Estimates the bits per voxel of a file from some of its chunks. */
double HartleyEncoder::GetRate(
  const std::vector<std::size_t>& chunks, const Progress& progress) const
{
  std::vector<std::uint64_t> bytes(chunks.size());
  std::vector<double> voxels(chunks.size());
  ForEachHartleyChunk(
    chunks.size(),
    [&](std::size_t i)
    {
      bytes[i] = this->Encode(chunks[i], this->GetIntegers(chunks[i])).GetBytes();
      ForEachHartleyBlock(this->Layout, chunks[i],
        [&](std::size_t, const HartleyLayout::Triple& place)
        { voxels[i] += CountFilled(this->Layout, place); });
    },
    progress);
  const double sum =
    static_cast<double>(std::accumulate(bytes.begin(), bytes.end(), std::uint64_t{ 0 }));
  return 8 * sum / std::accumulate(voxels.begin(), voxels.end(), 0.0) +
    8 * static_cast<double>(BytesOfFile) / this->GetNumberOfVoxels();
}

//------------------------------------------------------------------------------
HartleyIntegers HartleyEncoder::GetIntegers(std::size_t chunk) const
{
  std::vector<double> made;
  if (this->Kept.empty())
  {
    made = this->GetCoefficients(chunk);
  }
  const auto& coefficients = this->Kept.empty() ? made : this->Kept[chunk];
  const auto voxels = this->Layout.GetVoxelsPerBlock();
  HartleyIntegers integers(coefficients.size(), 0);
  for (std::size_t at = 0; at < integers.size(); at += voxels)
  {
    this->Quantizer->Quantize(
      std::span(coefficients).subspan(at, voxels), std::span(integers).subspan(at, voxels));
  }
  return integers;
}

//------------------------------------------------------------------------------
VoxelErrors HartleyEncoder::GetErrors(std::size_t chunk, const HartleyIntegers& integers) const
{
  if (this->IsLossless() && !IsFloating(this->Input.Type))
  {
    return {};
  }
  const auto voxels = this->Layout.GetVoxelsPerBlock();
  HartleyTransform transform(this->Layout.Block);
  std::vector<double> values(voxels);
  VoxelErrors errors;
  ForEachHartleyBlock(this->Layout, chunk,
    [&](std::size_t block, const HartleyLayout::Triple& place)
    {
      this->Quantizer->Restore(std::span(integers).subspan(block * voxels, voxels), values);
      transform.Inverse(values);
      errors.Add(
        CompareBlock(values, this->Input, this->Layout, place, this->GetBase(), this->Values));
    });
  return errors;
}

//------------------------------------------------------------------------------
const HartleyOrder& HartleyEncoder::GetOrder() const
{
  std::call_once(this->OrderIsMade,
    [&] { this->Order = std::make_unique<const HartleyOrder>(this->Layout.Block); });
  return *this->Order;
}

//------------------------------------------------------------------------------
EncodedHartleyChunk HartleyEncoder::Encode(std::size_t chunk, const HartleyIntegers& integers) const
{
  const auto& order = this->GetOrder();
  EncodedHartleyChunk encoded;
  encoded.Terms =
    integers.size() - static_cast<std::uint64_t>(std::count(integers.begin(), integers.end(), 0));
  encoded.Streams.resize(order.GetNumberOfSegments());
  if (encoded.Streams.size() == 1)
  {
    encoded.Streams[0] = EncodeHartleyBlocks(order, GetHartleyGrid(this->Layout, chunk), integers);
  }
  else
  {
    ParallelFor(encoded.Streams.size(),
      [&](std::size_t segment)
      {
        auto& stream = encoded.Streams[segment];
        stream = EncodeHartleySegment(order, segment, integers);
        stream.resize(
          std::max(stream.size(), GetLeastHartleySegmentBytes(integers.size(), segment)));
      });
  }
  if (this->IsLossless() && !IsFloating(this->Input.Type))
  {
    encoded.Corrections = EncodeHartleyCorrections(
      this->Input, this->Layout, chunk, *this->Quantizer, this->Values, integers);
  }
  return encoded;
}

//------------------------------------------------------------------------------
std::uint64_t EncodedHartleyChunk::GetBytes() const
{
  std::uint64_t bytes = this->Corrections.size() + HartleyEncoder::BytesOfStream;
  for (const auto& stream : this->Streams)
  {
    bytes += stream.size() + HartleyEncoder::BytesOfStream;
  }
  return bytes;
}

//------------------------------------------------------------------------------
std::shared_ptr<const HartleyChunk> HartleyEncoder::MakeTerms(
  const HartleyQuantizer& quantizer, std::size_t voxelsPerBlock, const HartleyIntegers& integers)
{
  // Large blocks are divided, so that all threads have a part.
  constexpr std::size_t length = std::size_t{ 1 } << 18;
  const std::size_t parts = (integers.size() + length - 1) / length;
  const auto getEnd = [&](std::size_t part)
  { return std::min(integers.size(), (part + 1) * length); };
  std::vector<std::size_t> starts(parts + 1);
  ParallelFor(parts,
    [&](std::size_t part)
    {
      const auto begin = integers.begin() + static_cast<std::ptrdiff_t>(part * length);
      const auto end = integers.begin() + static_cast<std::ptrdiff_t>(getEnd(part));
      starts[part + 1] = static_cast<std::size_t>(end - begin - std::count(begin, end, 0));
    });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  auto chunk = std::make_shared<HartleyChunk>();
  chunk->Terms.resize(starts.back());
  chunk->Starts.resize(integers.size() / voxelsPerBlock + 1, starts.back());
  ParallelFor(parts,
    [&](std::size_t part)
    {
      std::size_t to = starts[part];
      std::size_t k = (part * length + voxelsPerBlock - 1) % voxelsPerBlock;
      for (std::size_t at = part * length; at < getEnd(part); ++at)
      {
        k = k + 1 < voxelsPerBlock ? k + 1 : 0;
        if (k == 0)
        {
          chunk->Starts[at / voxelsPerBlock] = to;
        }
        if (integers[at] != 0)
        {
          const double value = quantizer.Restore(k, integers[at]);
          if (std::abs(value) > std::numeric_limits<float>::max())
          {
            ThrowCorrupt("a coefficient is beyond single precision");
          }
          chunk->Terms[to++] = { static_cast<std::uint32_t>(k), static_cast<float>(value) };
        }
      }
    });
  return chunk;
}
}
