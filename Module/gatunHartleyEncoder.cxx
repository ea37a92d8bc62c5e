// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyEncoder.h"

#include "gatunError.h"
#include "gatunHartleyTransform.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace gatun
{
namespace
{
// Coefficients of volumes of up to this many voxels are kept; of others they are made anew.
constexpr std::size_t KeptVoxels = std::size_t{ 1 } << 27;

constexpr std::size_t SampleChunks = 12;

// Steps of lossless volumes: of integers, whose error is corrected, in their unit; of floating
// point, in ranges.
constexpr double StepOfIntegers = 1;
constexpr double StepOfFloat32 = 1.0 / (1 << 24);
constexpr double StepOfFloat64 = 1.0 / (std::uint64_t{ 1 } << 46);

// How much smaller than asked for an error may come out.
constexpr double ErrorTolerance = 0.98;
constexpr int MostAttempts = 12;

/** Blocks of a chunk, with their place in it. */
template <typename Visit>
void ForEachBlock(const HartleyLayout& layout, std::size_t chunk, Visit&& visit)
{
  const auto box = layout.GetBlocksOfChunk(chunk);
  std::size_t block = 0;
  for (auto z = box.First[2]; z < box.End[2]; ++z)
  {
    for (auto y = box.First[1]; y < box.End[1]; ++y)
    {
      for (auto x = box.First[0]; x < box.End[0]; ++x)
      {
        visit(block, HartleyLayout::Triple{ x, y, z });
        ++block;
      }
    }
  }
}

std::size_t CountBlocks(const HartleyLayout& layout, std::size_t chunk)
{
  const auto box = layout.GetBlocksOfChunk(chunk);
  std::size_t count = 1;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    count *= box.End[axis] - box.First[axis];
  }
  return count;
}

/** A part of the progress of the whole. */
HartleyEncoder::Progress GetPart(
  const HartleyEncoder::Progress& progress, double first, double last)
{
  if (!progress)
  {
    return {};
  }
  return [=](double done) { return progress(first + done * (last - first)); };
}
}

//--------------------------------------------------------------------------------------------------
HartleyEncoder::HartleyEncoder(const VolumeInput& input, std::uint32_t blockSize,
  const HartleyQuality& quality, const Progress& progress)
  : Input(input)
  , Quality(quality)
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
  switch (quality.Kind)
  {
    case HartleyQuality::Goal::Quality:
      this->SetStep(range * std::exp2(-quality.Value / 10));
      break;
    case HartleyQuality::Goal::Error:
      if (!this->IsLossless())
      {
        this->FindStepOfError(quality.Value, GetPart(progress, 0.3, 1));
      }
      else if (!IsFloating(input.Type))
      {
        this->SetStep(StepOfIntegers);
      }
      else
      {
        this->SetStep(range * (input.Type == ScalarType::Float32 ? StepOfFloat32 : StepOfFloat64));
      }
      break;
    case HartleyQuality::Goal::PSNR:
      this->FindStepOfError(range * std::pow(10.0, -quality.Value / 20), GetPart(progress, 0.3, 1));
      break;
    case HartleyQuality::Goal::Rate:
      ThrowInvalid("not yet");
  }
}

//--------------------------------------------------------------------------------------------------
void HartleyEncoder::CheckQuality() const
{
  const auto check = [](const char* what, double value, double least, double most)
  {
    if (!(value >= least && value <= most))
    {
      ThrowInvalid(std::string(what) + " is " + std::to_string(value) + ", but has to be from " +
        std::to_string(least) + " to " + std::to_string(most));
    }
  };
  const auto value = this->Quality.Value;
  switch (this->Quality.Kind)
  {
    case HartleyQuality::Goal::Quality:
      check("the quality", value, 1, 100);
      break;
    case HartleyQuality::Goal::Error:
      check("the error", value, 0, 1e300);
      break;
    case HartleyQuality::Goal::PSNR:
      check("the signal-to-noise ratio in dB", value, 1, 200);
      break;
    case HartleyQuality::Goal::Rate:
      check("the rate in bits a voxel", value, 1e-6, 64);
      break;
    default:
      ThrowInvalid("there is no such kind of quality");
  }
  check("the weight of frequencies", this->Quality.FrequencyWeight, 0, 4);
}

//--------------------------------------------------------------------------------------------------
bool HartleyEncoder::IsLossless() const
{
  return this->Quality.Kind == HartleyQuality::Goal::Error && this->Quality.Value == 0;
}

//--------------------------------------------------------------------------------------------------
double HartleyEncoder::GetNumberOfVoxels() const
{
  const auto& size = this->Layout.Size;
  return static_cast<double>(size[0]) * size[1] * size[2];
}

//--------------------------------------------------------------------------------------------------
void HartleyEncoder::Transform(const Progress& progress)
{
  // Of a volume that is one block, too, as each time takes as long.
  const auto count = this->Layout.GetNumberOfChunks();
  if (count > 1 && this->GetNumberOfVoxels() > static_cast<double>(KeptVoxels))
  {
    return;
  }
  std::vector<std::vector<double>> kept(count);
  ParallelFor(
    count, [&](std::size_t chunk) { kept[chunk] = this->GetCoefficients(chunk); }, progress);
  this->Kept = std::move(kept);
}

//--------------------------------------------------------------------------------------------------
std::vector<double> HartleyEncoder::GetCoefficients(std::size_t chunk) const
{
  const auto voxels = this->Layout.GetVoxelsPerBlock();
  std::vector<double> values(CountBlocks(this->Layout, chunk) * voxels);
  HartleyTransform transform(this->Layout.Block);
  ForEachBlock(this->Layout, chunk,
    [&](std::size_t block, const HartleyLayout::Triple& place)
    {
      const auto own = std::span(values).subspan(block * voxels, voxels);
      LoadBlock(this->Input, this->Layout, place, this->GetBase(), own);
      transform.Forward(own);
    });
  return values;
}

//--------------------------------------------------------------------------------------------------
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

//--------------------------------------------------------------------------------------------------
/** Also measures the shifts that belong to the step. */
void HartleyEncoder::SetStep(double step)
{
  HartleySteps steps;
  steps.Step = step;
  steps.Weight = this->Quality.FrequencyWeight;
  steps.Nearest = this->IsLossless();
  if (steps.Nearest)
  {
    steps.Weight = 0;
  }
  auto quantiser = std::make_unique<const HartleyQuantiser>(this->Layout.Block, steps);
  if (!steps.Nearest)
  {
    const auto voxels = this->Layout.GetVoxelsPerBlock();
    std::vector<HartleyShiftSums> sums(this->Sample.size());
    ParallelFor(sums.size(),
      [&](std::size_t i)
      {
        const auto& coefficients =
          this->Kept.empty() ? this->SampleCoefficients[i] : this->Kept[this->Sample[i]];
        HartleyIntegers integers(voxels);
        for (std::size_t at = 0; at < coefficients.size(); at += voxels)
        {
          const auto own = std::span(coefficients).subspan(at, voxels);
          quantiser->Quantise(own, integers);
          sums[i].Add(*quantiser, own, integers);
        }
      });
    HartleyShiftSums all;
    for (const auto& sum : sums)
    {
      all.Add(sum);
    }
    steps.Shifts = all.Get();
    quantiser = std::make_unique<const HartleyQuantiser>(this->Layout.Block, steps);
  }
  this->Quantiser = std::move(quantiser);
}

//--------------------------------------------------------------------------------------------------
/** Root mean square error of the sample's coefficients, which is that of its voxels before they are
 * rounded. */
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
      HartleyIntegers integers(voxels);
      for (std::size_t at = 0; at < coefficients.size(); at += voxels)
      {
        const auto own = std::span(coefficients).subspan(at, voxels);
        this->Quantiser->Quantise(own, integers);
        for (std::size_t k = 0; k < voxels; ++k)
        {
          const double error = own[k] - this->Quantiser->Restore(k, integers[k]);
          squares[i] += error * error;
        }
      }
      ForEachBlock(this->Layout, this->Sample[i],
        [&](std::size_t, const HartleyLayout::Triple& place)
        {
          const auto filled = this->Layout.GetFilled(place);
          counts[i] += static_cast<double>(filled[0]) * filled[1] * filled[2];
        });
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

//--------------------------------------------------------------------------------------------------
double HartleyEncoder::GetError(const Progress& progress) const
{
  std::vector<VoxelErrors> errors(this->Layout.GetNumberOfChunks());
  ParallelFor(
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

//--------------------------------------------------------------------------------------------------
/** The largest step, nearly, with which the error is not larger than asked for. */
void HartleyEncoder::FindStepOfError(double target, const Progress& progress)
{
  // With this step all coefficients are 0.
  const double largest = 4 * (this->Values.Max - this->Values.Min) *
    std::sqrt(static_cast<double>(this->Layout.GetVoxelsPerBlock()));
  double step = std::min(target * std::sqrt(12.0), largest);

  // The error before rounding, of the sample.
  for (int i = 0; i < MostAttempts; ++i)
  {
    this->SetStep(step);
    const double error = this->GetSampleError();
    if (error > ErrorTolerance * target && error <= target)
    {
      break;
    }
    const double factor = error > 0 ? target * (1 + ErrorTolerance) / (2 * error) : 2;
    // Few coefficients are left where steps are coarse, so that the error hardly grows with them.
    step = std::min(largest, step * std::clamp(factor > 1 ? factor * factor : factor, 0.25, 4.0));
  }

  // That of all voxels as they come back. Steps known to be good and bad close in on each other.
  double good = 0;
  double bad = 0;
  double errorOfGood = 0;
  double errorOfBad = 0;
  for (int i = 0; i < MostAttempts || good == 0; ++i)
  {
    this->SetStep(step);
    const double part = 1.0 / (MostAttempts + 1);
    const double error =
      this->GetError(GetPart(progress, std::min(1.0, i * part), std::min(1.0, (i + 1) * part)));
    if (error <= target)
    {
      good = step;
      errorOfGood = error;
      if (error >= ErrorTolerance * target || step >= largest)
      {
        return;
      }
    }
    else
    {
      bad = step;
      errorOfBad = error;
    }
    const double aim = target * (1 + ErrorTolerance) / 2;
    if (good == 0)
    {
      step = bad * std::clamp(aim / errorOfBad, 0.25, 0.995);
    }
    else if (bad == 0)
    {
      step = std::min(
        largest, good * (errorOfGood > 0 ? std::clamp(aim / errorOfGood, 1.005, 4.0) : 2.0));
    }
    else
    {
      // Between the two by their errors, but never next to one of them.
      const double place =
        errorOfBad > errorOfGood ? (aim - errorOfGood) / (errorOfBad - errorOfGood) : 0.5;
      step = good * std::pow(bad / good, std::clamp(place, 0.1, 0.9));
    }
  }
  this->SetStep(good);
}

//--------------------------------------------------------------------------------------------------
HartleyIntegers HartleyEncoder::GetIntegers(std::size_t chunk) const
{
  std::vector<double> made;
  if (this->Kept.empty())
  {
    made = this->GetCoefficients(chunk);
  }
  const auto& coefficients = this->Kept.empty() ? made : this->Kept[chunk];
  const auto voxels = this->Layout.GetVoxelsPerBlock();
  HartleyIntegers integers(coefficients.size());
  for (std::size_t at = 0; at < integers.size(); at += voxels)
  {
    this->Quantiser->Quantise(
      std::span(coefficients).subspan(at, voxels), std::span(integers).subspan(at, voxels));
  }
  return integers;
}

//--------------------------------------------------------------------------------------------------
VoxelErrors HartleyEncoder::GetErrors(std::size_t chunk, const HartleyIntegers& integers) const
{
  const auto voxels = this->Layout.GetVoxelsPerBlock();
  HartleyTransform transform(this->Layout.Block);
  std::vector<double> values(voxels);
  VoxelErrors errors;
  ForEachBlock(this->Layout, chunk,
    [&](std::size_t block, const HartleyLayout::Triple& place)
    {
      const auto own = std::span(integers).subspan(block * voxels, voxels);
      for (std::size_t k = 0; k < voxels; ++k)
      {
        values[k] = this->Quantiser->Restore(k, own[k]);
      }
      transform.Inverse(values);
      errors.Add(
        CompareBlock(values, this->Input, this->Layout, place, this->GetBase(), this->Values));
    });
  return errors;
}

//--------------------------------------------------------------------------------------------------
std::shared_ptr<const HartleyChunk> HartleyEncoder::MakeTerms(
  const HartleyQuantiser& quantiser, std::size_t voxelsPerBlock, const HartleyIntegers& integers)
{
  auto chunk = std::make_shared<HartleyChunk>();
  const auto count =
    integers.size() - static_cast<std::size_t>(std::count(integers.begin(), integers.end(), 0));
  chunk->Terms.reserve(count);
  chunk->Starts.reserve(integers.size() / voxelsPerBlock + 1);
  for (std::size_t at = 0; at < integers.size(); at += voxelsPerBlock)
  {
    chunk->Starts.push_back(chunk->Terms.size());
    for (std::size_t k = 0; k < voxelsPerBlock; ++k)
    {
      if (integers[at + k] != 0)
      {
        chunk->Terms.push_back({ static_cast<std::uint32_t>(k),
          static_cast<float>(quantiser.Restore(k, integers[at + k])) });
      }
    }
  }
  chunk->Starts.push_back(chunk->Terms.size());
  return chunk;
}
}
