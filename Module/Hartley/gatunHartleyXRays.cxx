// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyXRays.h"

#include "gatunHartleyBox.h"
#include "gatunHartleyDensities.h"
#include "gatunParallel.h"

#include <algorithm>
#include <array>
#include <vector>

namespace gatun
{
namespace
{
// Upper bound of the mean square error of X-rays by one spectrum of the whole volume, of 255
// squared, over the area of the volume, where 255 is the largest sum.
constexpr double XRayError = 0.01 / (255.0 * 255.0);

// Along each axis. Of smaller volumes the border is so large a part that the error is larger.
constexpr std::uint32_t LeastVoxels = 64;
}

//------------------------------------------------------------------------------
bool HartleyXRays::Make(
  const HartleySource& source, std::uint64_t bytes, const std::function<bool(double)>& progress)
{
  // Estimates of the parts of the work.
  constexpr double decoding = 0.5;
  if (this->XRay || this->Unfit)
  {
    return !this->Unfit;
  }
  const auto& size = source.GetLayout().Size;
  const std::uint64_t voxels = std::uint64_t{ size[0] } * size[1] * size[2];
  if (*std::min_element(size.begin(), size.end()) < LeastVoxels || voxels * sizeof(float) > bytes)
  {
    this->Unfit = true;
    return false;
  }
  const auto getPart = [&](double begin, double end) -> std::function<bool(double)>
  {
    return [=, &progress](double done)
    { return !progress || progress(begin + done * (end - begin)); };
  };
  LargeArray<float> densities = DecodeHartleyDensities(source, getPart(0, decoding));
  const auto detail = HartleyDetail::Take(size, densities, XRayError);
  const auto plan = VolumeSpectrumPlan::Make(size, detail.Cut);
  if (plan.GetBytes() > std::min(bytes, HartleyVolumeSpectrum::MostBytes))
  {
    this->Unfit = true;
    return false;
  }
  this->Size = size;
  this->Border = source.GetBase() + detail.Border;
  this->XRay = std::make_unique<HartleyXRay>(
    std::make_shared<HartleyVolumeSpectrum>(plan, densities, getPart(decoding, 1)), detail.Largest,
    XRayError);
  return true;
}

//------------------------------------------------------------------------------
HartleyImage HartleyXRays::Draw(const HartleyView& view, const HartleyShading& shading) const
{
  HartleyImage image;
  image.Width = view.Width;
  image.Height = view.Height;
  image.Method = HartleyMethod::Slice;
  image.Blocks = 1;
  image.Sums.resize(std::size_t{ view.Width } * view.Height);
  image.Samples.resize(image.Sums.size());
  this->XRay->Draw(view, image.Sums);
  MeasureHartleyBox(this->Size, view, image.Samples);
  for (std::size_t i = 0; i < image.Sums.size(); ++i)
  {
    // A band-limited image does not end at the border.
    image.Sums[i] = image.Samples[i] > 0 ? image.Sums[i] : 0;
  }
  FinishHartleyXRay(shading, this->Border, image);
  return image;
}

//------------------------------------------------------------------------------
void FinishHartleyXRay(const HartleyShading& shading, double base, HartleyImage& image)
{
  const auto offset = static_cast<float>(base);
  const std::size_t width = image.Width;
  std::vector<std::array<float, 2>> ranges(image.Height, { 1, 0 });
  image.Colors.resize(image.Sums.size());
  ParallelFor(image.Height,
    [&](std::size_t row)
    {
      auto& [least, most] = ranges[row];
      for (std::size_t i = row * width; i < (row + 1) * width; ++i)
      {
        const float samples = std::max(0.0f, image.Samples[i]);
        const float sum = image.Sums[i] + offset * samples;
        image.Samples[i] = samples;
        image.Sums[i] = sum;
        if (samples > 0)
        {
          const bool any = least <= most;
          least = any ? std::min(least, sum) : sum;
          most = any ? std::max(most, sum) : sum;
        }
      }
    });
  std::array<float, 2> range{ 0, 0 };
  bool any = false;
  for (const auto& [least, most] : ranges)
  {
    if (least <= most)
    {
      range = any ? std::array{ std::min(range[0], least), std::max(range[1], most) }
                  : std::array{ least, most };
      any = true;
    }
  }
  const bool given = shading.Black != shading.White;
  const float black = given ? static_cast<float>(shading.Black) : range[0];
  const float white = given ? static_cast<float>(shading.White) : range[1];
  ParallelFor(image.Height,
    [&](std::size_t row)
    {
      for (std::size_t i = row * width; i < (row + 1) * width; ++i)
      {
        const float opacity = std::min(1.0f, image.Samples[i]);
        const float gray =
          white != black ? std::clamp((image.Sums[i] - black) / (white - black), 0.0f, 1.0f) : 0.0f;
        image.Colors[i] = { gray * opacity, gray * opacity, gray * opacity, opacity };
      }
    });
}
}
