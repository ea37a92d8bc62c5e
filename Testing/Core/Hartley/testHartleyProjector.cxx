// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunHartleyProjector.h"

#include "gatunError.h"
#include "gatunExactSource.h"
#include "gatunHartleyKernel.h"
#include "gatunHartleyPixels.h"
#include "gatunVolumePhantoms.h"
#include "gatunVolumeReference.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>

namespace gatun::test
{
namespace
{
using Triple = HartleyLayout::Triple;

/** How far images of blocks are from integrals along the same rays, in parts of the largest. */
PixelDifference CompareBlocks(const Phantom<std::uint8_t>& volume, std::uint32_t blockSize,
  const Vector& turns, const HartleyOptions& options)
{
  const auto source = MakeSource(volume.Values, volume.Size, blockSize);
  HartleyProjector projector(source, options);
  const auto view = MakeTurnedView(volume.Size, turns, 16, 1);
  const auto& layout = source->GetLayout();
  double most = 0;
  std::vector<std::pair<double, double>> pixels;
  for (std::size_t chunk = 0; chunk < layout.GetNumberOfChunks(); ++chunk)
  {
    const auto images = projector.DrawBlocks(view, chunk);
    const auto box = layout.GetBlocksOfChunk(chunk);
    std::size_t number = 0;
    for (std::uint32_t z = box.First[2]; z < box.End[2]; ++z)
    {
      for (std::uint32_t y = box.First[1]; y < box.End[1]; ++y)
      {
        for (std::uint32_t x = box.First[0]; x < box.End[0]; ++x)
        {
          const Triple filled = layout.GetFilled({ x, y, z });
          const Triple first{ x * layout.Block[0], y * layout.Block[1], z * layout.Block[2] };
          const ReferenceVolume reference(volume.Values.data(), volume.Size, source->GetBase(),
            first, { first[0] + filled[0], first[1] + filled[1], first[2] + filled[2] });
          const auto& image = images[number++];
          for (unsigned row = 0; row < image.Height; ++row)
          {
            for (unsigned column = 0; column < image.Width; ++column)
            {
              const double expected =
                reference.Integrate(GetPixel(image.View, column, row), image.View.Step);
              most = std::max(most, expected);
              pixels.emplace_back(image.Sums[std::size_t{ row } * image.Width + column], expected);
            }
          }
        }
      }
    }
    EXPECT_EQ(number, images.size());
  }
  PixelDifference difference;
  for (const auto& [found, expected] : pixels)
  {
    difference.Add(found / most, expected / most);
  }
  return difference;
}
}

//------------------------------------------------------------------------------
TEST(HartleyProjector, BlocksByBasisFunctionsAreExact)
{
  const auto volume = MakeHead({ 21, 18, 17 });
  for (const std::uint32_t block : { 2u, 3u, 4u, 7u, 8u, 16u })
  {
    for (const Vector& turns : GetTurns())
    {
      SCOPED_TRACE(testing::Message()
        << "block " << block << " turns " << turns[0] << " " << turns[1] << " " << turns[2]);
      const auto difference = CompareBlocks(volume, block, turns, { HartleyMethod::Basis });
      // Single precision.
      EXPECT_LT(difference.Largest, 1e-5);
    }
  }
}

//------------------------------------------------------------------------------
// Frequencies of hats above the lattice's third band are not where they should be, which shows
// where rays are nearly along an axis. There is nothing of them where rays are at equal angles to
// all axes, and along an axis it makes no difference where they are.
TEST(HartleyProjector, BlocksBySlicesAreNearlyExact)
{
  const auto volume = MakeHead({ 37, 33, 35 });
  for (const std::uint32_t block : { 2u, 5u, 8u, 16u, 32u, 0u })
  {
    for (const Vector& turns : GetTurns())
    {
      SCOPED_TRACE(testing::Message()
        << "block " << block << " turns " << turns[0] << " " << turns[1] << " " << turns[2]);
      const auto difference = CompareBlocks(volume, block, turns, { HartleyMethod::Slice });
      EXPECT_LT(difference.Mean, block >= 32 || block == 0 ? 1.5e-3 : 4e-3);
      if (turns == Vector{ 0.25, 0.25, 0.25 } || turns == Vector{ 0, 0, 0 } ||
        turns == Vector{ 0.5, 0, 1 })
      {
        EXPECT_LT(difference.Largest, 4e-4); // hats below 1e-4 are left out
      }
    }
  }
}

//------------------------------------------------------------------------------
// As Automatic draws them.
TEST(HartleyProjector, BlocksByVoxelsAreExact)
{
  const auto volume = MakeHead({ 37, 33, 35 });
  for (const std::uint32_t block : { 2u, 3u, 5u, 8u, 16u, 20u, 32u, 64u })
  {
    for (const Vector& turns : GetTurns())
    {
      SCOPED_TRACE(testing::Message()
        << "block " << block << " turns " << turns[0] << " " << turns[1] << " " << turns[2]);
      // Single precision.
      EXPECT_LT(CompareBlocks(volume, block, turns, { HartleyMethod::Voxels }).Largest, 1e-5);
    }
  }
}

//------------------------------------------------------------------------------
// The dissertation's interpolation leaves far more: that it is there is to compare with.
TEST(HartleyProjector, TrilinearSlicesAreWorse)
{
  const auto volume = MakeHead({ 32, 32, 32 });
  const Vector turns{ 0.25, 0.25, 0.25 };
  HartleyOptions paper{ HartleyMethod::Slice, HartleyKernel::Trilinear };
  const auto padded = CompareBlocks(volume, 16, turns, paper);
  paper.Padding = 1;
  const auto bare = CompareBlocks(volume, 16, turns, paper);
  paper.Padding = 4;
  const auto more = CompareBlocks(volume, 16, turns, paper);
  EXPECT_LT(padded.Mean, bare.Mean);
  EXPECT_LT(more.Mean, padded.Mean);
  EXPECT_LT(padded.Mean, 0.1); // an image of the block all the same
  EXPECT_GT(padded.Mean, 10 * CompareBlocks(volume, 16, turns, { HartleyMethod::Slice }).Mean);
}

//------------------------------------------------------------------------------
// From the lattice to pixels there is cubic convolution, which has to follow the kinks of hats at
// the border of the volume.
void CompareXRays(HartleyMethod method, const std::vector<std::uint32_t>& blocks)
{
  const auto volume = MakeHead({ 37, 33, 35 });
  const ReferenceVolume reference(volume.Values.data(), volume.Size, 0);
  for (const std::uint32_t block : blocks)
  {
    HartleyProjector projector(MakeSource(volume.Values, volume.Size, block), { method });
    for (const Vector& turns : GetTurns())
    {
      SCOPED_TRACE(testing::Message()
        << "block " << block << " turns " << turns[0] << " " << turns[1] << " " << turns[2]);
      const auto view = MakeTurnedView(volume.Size, turns, 71, 1.1);
      const auto image = projector.Draw(view, {});
      PixelDifference sums, samples;
      double most = 0;
      ForEachPixel(view,
        [&](std::size_t i, const Vector& point)
        {
          const double expected = reference.Integrate(point, view.Step);
          most = std::max(most, expected);
          sums.Add(static_cast<double>(image.Sums[i]), expected);
          samples.Add(
            static_cast<double>(image.Samples[i]), reference.IntegrateWeight(point, view.Step));
        });
      EXPECT_LT(sums.Mean, 1.6e-3 * most);
      EXPECT_LT(sums.Largest, 1.5e-2 * most);
      EXPECT_LT(samples.Mean, 6e-3 * 37);
    }
  }
}

TEST(HartleyProjector, XRay)
{
  CompareXRays(HartleyMethod::Automatic, { 2, 5, 8, 16, 32, 0 });
}

TEST(HartleyProjector, XRayByBasisFunctions)
{
  CompareXRays(HartleyMethod::Basis, { 2, 5, 8, 16 });
}

TEST(HartleyProjector, XRayByVoxels)
{
  CompareXRays(HartleyMethod::Voxels, { 2, 5, 8, 16, 32 });
}

TEST(HartleyProjector, XRayBySlices)
{
  CompareXRays(HartleyMethod::Slice, { 16, 32, 0 });
}

//------------------------------------------------------------------------------
// Columns, rows and rays at no right angles and of different lengths, as volumes with spacing and
// orientation have them.
TEST(HartleyProjector, AnyParallelView)
{
  const auto volume = MakeSmooth({ 24, 20, 22 });
  const ReferenceVolume reference(volume.Values.data(), volume.Size, 0);
  HartleyView view;
  view.Width = 40;
  view.Height = 30;
  view.ColumnStep = { 0.7, 0.2, -0.1 };
  view.RowStep = { -0.3, 0.6, 0.5 };
  view.Step = { 0.4, 0.3, -1.7 };
  const Vector middle = reference.GetCenter();
  view.Origin = AddTimes(AddTimes(middle, -20, view.ColumnStep), -15, view.RowStep);
  for (const std::uint32_t block : { 4u, 0u })
  {
    HartleyProjector projector(MakeSource(volume.Values, volume.Size, block));
    const auto image = projector.Draw(view, {});
    PixelDifference sums;
    double most = 0;
    ForEachPixel(view,
      [&](std::size_t i, const Vector& point)
      {
        const double expected = reference.Integrate(point, view.Step);
        most = std::max(most, expected);
        sums.Add(static_cast<double>(image.Sums[i]), expected);
      });
    EXPECT_GT(most, 1);
    EXPECT_LT(sums.Largest, 5e-3 * most);

    // A part of the image by itself.
    HartleyView part = view;
    part.Origin = GetPixel(view, 13, 11);
    part.Width = 9;
    part.Height = 7;
    const auto cut = projector.Draw(part, {});
    for (unsigned row = 0; row < part.Height; ++row)
    {
      for (unsigned column = 0; column < part.Width; ++column)
      {
        EXPECT_NEAR(cut.Sums[row * part.Width + column],
          image.Sums[(row + 11) * view.Width + column + 13], 1e-4 * most);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(HartleyProjector, SmallAndConstantVolumes)
{
  for (const Triple& size : { Triple{ 1, 1, 1 }, Triple{ 1, 9, 1 }, Triple{ 5, 1, 3 } })
  {
    const std::vector<float> values(std::size_t{ size[0] } * size[1] * size[2], -7.5f);
    const ReferenceVolume ones(values.data(), size, 0);
    for (const std::uint32_t block : { 2u, 8u, 0u })
    {
      HartleyProjector projector(MakeSource(values, size, block));
      const auto view = MakeTurnedView(size, { 0.25, 0.25, 0.25 }, 15, 1.3);
      const auto image = projector.Draw(view, {});
      ForEachPixel(view,
        [&](std::size_t i, const Vector& point)
        {
          const double expected = ones.IntegrateWeight(point, view.Step);
          // A voxel by itself is the sharpest thing that there is to interpolate.
          EXPECT_NEAR(image.Samples[i], expected, 0.05);
          EXPECT_NEAR(image.Sums[i], -7.5f * image.Samples[i], 1e-4);
        });
    }
  }
}

//------------------------------------------------------------------------------
TEST(HartleyProjector, BadInput)
{
  const auto volume = MakeSmooth({ 20, 20, 20 });
  const auto source = MakeSource(volume.Values, volume.Size, 0);
  const auto expectInvalid = [](const auto& act, const std::string& part)
  {
    try
    {
      act();
      ADD_FAILURE() << "no error: " << part;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidInput);
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  const auto view = MakeTurnedView(volume.Size, { 0.1, 0.2, 0.3 }, 8, 1);
  const auto draw = [&](HartleyView bad, const HartleyShading& shading = {})
  { HartleyProjector(source).Draw(bad, shading); };

  auto bad = view;
  bad.Width = 0;
  expectInvalid([&] { draw(bad); }, "no pixels");
  bad = view;
  bad.Step = {};
  expectInvalid([&] { draw(bad); }, "linearly dependent");
  bad.Step = view.RowStep;
  expectInvalid([&] { draw(bad); }, "linearly dependent");
  bad = view;
  bad.Origin[1] = std::nan("");
  expectInvalid([&] { draw(bad); }, "not finite");
  HartleyShading shading;
  shading.OpacityModel = HartleyOpacityModel::TransferFunction;
  expectInvalid([&] { draw(view, shading); }, "transfer function");
  shading = MakeGray(HartleyOpacityModel::Exponential);
  shading.Extinction = -1;
  expectInvalid([&] { draw(view, shading); }, "extinction");
  expectInvalid(
    [&] {
      HartleyProjector(source, { HartleyMethod::Slice, HartleyKernel::KaiserBessel, 0.5 });
    },
    "padding");
  const auto large = MakeSmooth({ 60, 60, 60 });
  expectInvalid(
    [&]
    {
      HartleyProjector(MakeSource(large.Values, large.Size, 0), { HartleyMethod::Basis })
        .Draw(view, {});
    },
    "Slice");
  const auto lengthy = MakeSmooth({ 70, 4, 4 });
  expectInvalid(
    [&]
    {
      HartleyProjector(MakeSource(lengthy.Values, lengthy.Size, 0), { HartleyMethod::Voxels })
        .Draw(view, {});
    },
    "Slice");

  // An image that is given up leaves the projector as it was.
  HartleyProjector projector(MakeSource(volume.Values, volume.Size, 4));
  const auto whole = projector.Draw(view, {});
  int calls = 0;
  EXPECT_THROW(projector.Draw(view, {}, [&](double) { return ++calls < 3; }), Error);
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(projector.Draw(view, {}).Sums, whole.Sums);
}

//------------------------------------------------------------------------------
/** Counts the chunks that are read from another source. */
class CountingVolume : public HartleySource
{
public:
  explicit CountingVolume(std::shared_ptr<const HartleySource> source)
    : Source(std::move(source))
  {
  }
  const HartleyLayout& GetLayout() const override { return this->Source->GetLayout(); }
  double GetBase() const override { return this->Source->GetBase(); }
  Range GetRange() const override { return this->Source->GetRange(); }
  std::shared_ptr<const HartleyChunk> GetChunk(std::size_t chunk) const override
  {
    ++this->Reads;
    return this->Source->GetChunk(chunk);
  }

  mutable std::atomic<int> Reads = 0;

private:
  std::shared_ptr<const HartleySource> Source;
};

//------------------------------------------------------------------------------
// A file is not decoded again for the next view, also along another axis.
TEST(HartleyProjector, KeptVoxelsNeedNoChunks)
{
  const auto volume = MakeHead({ 36, 40, 140 });
  const auto source = std::make_shared<CountingVolume>(MakeSource(volume.Values, volume.Size, 32));
  const auto count = static_cast<int>(source->GetLayout().GetNumberOfChunks());
  const auto shading = MakeGray(HartleyOpacityModel::TransferFunction);
  const auto view = MakeTurnedView(volume.Size, { 0.1, 0.2, 0.3 }, 40, 0.6);
  const auto other = MakeTurnedView(volume.Size, { 0.62, 0.18, 0.3 }, 40, 0.6);
  HartleyProjector keeps(source);
  const auto image = keeps.Draw(view, shading);
  EXPECT_GE(source->Reads, count);
  source->Reads = 0;
  EXPECT_EQ(keeps.Draw(view, shading).Colors, image.Colors);
  const auto second = keeps.Draw(other, shading);
  EXPECT_EQ(source->Reads, 0);
  EXPECT_GT(second.Terms, 0u);

  // What does not fit is read again, and drawn the same.
  HartleyOptions options;
  options.CacheBytes = 0;
  HartleyProjector keepsNothing(source, options);
  EXPECT_EQ(keepsNothing.Draw(view, shading).Colors, image.Colors);
  source->Reads = 0;
  EXPECT_EQ(keepsNothing.Draw(other, shading).Colors, second.Colors);
  EXPECT_GT(source->Reads, 0);
}

//------------------------------------------------------------------------------
// All that is compiled more than once gives the same, but for rounding.
TEST(HartleyKernel, SetsOfInstructionsAgree)
{
  const auto& portable = GetPortableHartleyKernel();
  const auto& best = GetBestHartleyKernel();
  std::mt19937 random(3);
  std::uniform_real_distribution<float> number(-1, 1);
  std::vector<float> values(4096);
  std::generate(values.begin(), values.end(), [&] { return number(random); });

  std::vector<HartleyShare> shares;
  for (std::uint32_t i = 0; i < 50; ++i)
  {
    shares.push_back({ i * 37, number(random) });
  }
  std::array<float, HartleySegment> one, two;
  portable.Combine(values.data(), shares.data(), shares.size(), one.data());
  best.Combine(values.data(), shares.data(), shares.size(), two.data());
  for (std::size_t k = 0; k < HartleySegment; ++k)
  {
    double expected = 0;
    for (const HartleyShare& share : shares)
    {
      expected += static_cast<double>(share.Scale) * static_cast<double>(values[share.First + k]);
    }
    EXPECT_NEAR(one[k], expected, 1e-5);
    EXPECT_NEAR(two[k], expected, 1e-5);
  }
}
}
