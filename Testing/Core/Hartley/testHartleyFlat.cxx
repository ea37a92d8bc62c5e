// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Images of constant volumes: no seams between blocks and no gaps, from any side. What each ray
// should come to is known: the part of it in the volume, times the constant.

#include "gatunHartleyTransform.h"
#include "gatunVolumePhantoms.h"
#include "gatunVolumeReference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace
{
using namespace gatun;
using namespace gatun::test;

constexpr float Constant = 100;

/** A constant in all of a volume's voxels and a base of 0, so that all is in the coefficients and
 * nothing in the base, as HartleyVolume would have it. */
class ConstantSource : public HartleySource
{
public:
  ConstantSource(const HartleyLayout::Triple& size, std::uint32_t block)
    : Layout(HartleyLayout::Make(size, block))
  {
    HartleyTransform transform(this->Layout.Block);
    std::vector<double> values(this->Layout.GetVoxelsPerBlock());
    for (std::size_t chunk = 0; chunk < this->Layout.GetNumberOfChunks(); ++chunk)
    {
      const HartleyLayout::Box box = this->Layout.GetBlocksOfChunk(chunk);
      auto made = std::make_shared<HartleyChunk>();
      made->Starts.push_back(0);
      for (std::uint32_t k = box.First[2]; k < box.End[2]; ++k)
      {
        for (std::uint32_t j = box.First[1]; j < box.End[1]; ++j)
        {
          for (std::uint32_t i = box.First[0]; i < box.End[0]; ++i)
          {
            this->Fill(values, this->Layout.GetFilled({ i, j, k }));
            transform.Forward(values);
            for (std::size_t term = 0; term < values.size(); ++term)
            {
              if (std::abs(values[term]) > 1e-9)
              {
                made->Terms.push_back(
                  { static_cast<std::uint32_t>(term), static_cast<float>(values[term]) });
              }
            }
            made->Starts.push_back(made->Terms.size());
          }
        }
      }
      this->Chunks.push_back(made);
    }
  }

  const HartleyLayout& GetLayout() const override { return this->Layout; }
  double GetBase() const override { return 0; }
  Range GetRange() const override { return { Constant, Constant }; }
  std::shared_ptr<const HartleyChunk> GetChunk(std::size_t chunk) const override
  {
    return this->Chunks[chunk];
  }

private:
  void Fill(std::vector<double>& values, const HartleyLayout::Triple& filled) const
  {
    std::size_t next = 0;
    for (std::uint32_t z = 0; z < this->Layout.Block[2]; ++z)
    {
      for (std::uint32_t y = 0; y < this->Layout.Block[1]; ++y)
      {
        for (std::uint32_t x = 0; x < this->Layout.Block[0]; ++x)
        {
          const bool inside = x < filled[0] && y < filled[1] && z < filled[2];
          values[next++] = inside ? static_cast<double>(Constant) : 0;
        }
      }
    }
  }

  HartleyLayout Layout;
  std::vector<std::shared_ptr<const HartleyChunk>> Chunks;
};

/** Twenty: along axes and diagonals, a little beside them, and anywhere. */
std::vector<Vector> MakeTurns()
{
  const double degree = 1.0 / 180;
  std::vector<Vector> turns{ { 0, 0, 0 }, { 0.5, 0, 0 }, { 0, 0.5, 0.25 }, { 0.5 * degree, 0, 0 },
    { 0, 0.5 * degree, 0 }, { 0.5, 0.5 * degree, 0 }, { degree, 2 * degree, 0.1 }, { 0.25, 0, 0 },
    { 0.25 + 0.1 * degree, 0, 0 }, { 0.25, 0.25, 0.25 }, { 0.48, 0.1, 0.95 } };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  while (turns.size() < 20)
  {
    const double x = uniform(random);
    const double y = uniform(random);
    turns.push_back({ x, y, uniform(random) });
  }
  return turns;
}

/** The largest differences between images and what they should be, as parts of the largest value
 * that an image should have. Rays count that meet what is more than two voxels from the border:
 * at the silhouette an image falls to nothing within a voxel, and interpolation shows. */
struct Unevenness
{
  double Sums = 0;
  double Samples = 0;
  double Exponential = 0;
  double Function = 0;
  double Density = 0; ///< means over the samples, as parts of the constant
  double Color = 0;   ///< of full color
  std::size_t Pixels = 0;
};

void Measure(HartleyProjector& projector, const HartleyLayout::Triple& size, const Vector& turns,
  Unevenness& worst)
{
  const std::vector<std::uint8_t> ones(std::size_t{ size[0] } * size[1] * size[2], 1);
  const ReferenceVolume volume(ones.data(), size, 0);
  const ReferenceVolume inner(
    ones.data(), size, 0, { 2, 2, 2 }, { size[0] - 2, size[1] - 2, size[2] - 2 });
  const double length =
    std::sqrt(static_cast<double>(size[0] * size[0] + size[1] * size[1] + size[2] * size[2]));
  const HartleyView view = MakeTurnedView(size, turns, 73, 73 / (length + 3));
  HartleyShading shading;
  const HartleyImage xray = projector.Draw(view, shading);
  shading.First = 0;
  shading.Last = 200;
  shading.Table = { { 0, 0.2f, 0.9f, 0 }, { 1, 0.6f, 0.1f, 0.06f } };
  shading.OpacityModel = HartleyOpacityModel::Exponential;
  shading.Extinction = 0.0003;
  const HartleyImage exponential = projector.Draw(view, shading);
  shading.OpacityModel = HartleyOpacityModel::TransferFunction;
  const HartleyImage function = projector.Draw(view, shading);
  std::vector<std::pair<std::size_t, double>> seen;
  double most = 0;
  for (unsigned row = 0; row < view.Height; ++row)
  {
    for (unsigned column = 0; column < view.Width; ++column)
    {
      const Vector point = GetPixel(view, column, row);
      const RayPart part = inner.Clip(point, view.Step);
      if (part.Begin < part.End)
      {
        seen.emplace_back(row * view.Width + column, volume.IntegrateWeight(point, view.Step));
        most = std::max(most, seen.back().second);
      }
    }
  }
  const auto compare = [](double& largest, double found, double expected, double whole)
  { largest = std::max(largest, std::abs(found - expected) / whole); };
  // Of so many samples.
  const auto getExponential = [](double n) { return 1 - std::exp(-0.0003 * Constant * n); };
  const auto getFunction = [](double n) { return 1 - std::pow(1 - 0.03, n); };
  for (const auto& [i, samples] : seen)
  {
    compare(worst.Sums, xray.Sums[i] / static_cast<double>(Constant), samples, most);
    compare(worst.Samples, xray.Samples[i], samples, most);
    compare(worst.Density, xray.Sums[i] / xray.Samples[i] / Constant, 1, 1);
    compare(
      worst.Exponential, exponential.Colors[i][3], getExponential(samples), getExponential(most));
    compare(worst.Function, function.Colors[i][3], getFunction(samples), getFunction(most));
    for (const auto* image : { &exponential, &function })
    {
      const auto& color = image->Colors[i];
      compare(worst.Color, color[0] / color[3], 0.5, 1);
      compare(worst.Color, color[1] / color[3], 0.4, 1);
      compare(worst.Color, color[2] / color[3], 0.5, 1);
    }
  }
  worst.Pixels = seen.size();
}

/** Size of blocks; and whether all is in the base. */
using Case = std::tuple<std::uint32_t, bool>;

class HartleyFlat : public testing::TestWithParam<Case>
{
};

TEST_P(HartleyFlat, FromTwentySides)
{
  const auto [block, isBase] = this->GetParam();
  // No multiples of a block, but for those of two voxels along one axis; at least two blocks.
  const HartleyLayout::Triple size =
    block == 64 ? HartleyLayout::Triple{ 77, 65, 9 } : HartleyLayout::Triple{ 37, 45, 34 };
  std::shared_ptr<const HartleySource> source;
  const auto constant = MakeConstant(size, Constant);
  if (isBase)
  {
    source = HartleyVolume::Make(constant.GetInput(), block, { HartleyRateMode::RMSError, 0, 0 });
  }
  else
  {
    source = std::make_shared<ConstantSource>(size, block);
  }
  HartleyProjector projector(source);
  for (const Vector& turns : MakeTurns())
  {
    Unevenness worst;
    Measure(projector, size, turns, worst);
    SCOPED_TRACE(testing::Message() << turns[0] << ' ' << turns[1] << ' ' << turns[2]);
    EXPECT_LT(worst.Sums, 0.01);
    EXPECT_LT(worst.Density, 0.01);
    EXPECT_LT(worst.Samples, 0.01);
    EXPECT_LT(worst.Exponential, 0.01);
    EXPECT_LT(worst.Function, 0.01);
    EXPECT_LT(worst.Color, 0.01);
    EXPECT_GT(worst.Pixels, 100u);
  }
}

INSTANTIATE_TEST_SUITE_P(Blocks, HartleyFlat,
  testing::Combine(testing::Values(2u, 4u, 8u, 16u, 32u, 64u, 0u), testing::Bool()),
  [](const auto& made)
  {
    return std::to_string(std::get<0>(made.param)) +
      (std::get<1>(made.param) ? "InTheBase" : "InTheCoefficients");
  });
}
