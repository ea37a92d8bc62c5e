// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunHartleyProjector.h"

#include "gatunError.h"
#include "gatunHartleySample.h"
#include "gatunVolumePhantoms.h"
#include "gatunVolumeReference.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace gatun::test
{
namespace
{
using Triple = HartleyLayout::Triple;

/** The dissertation's, ones that are nearly along an axis, and others. */
std::vector<Vector> GetTurns()
{
  std::vector<Vector> turns{ { 0, 0, 0 }, { 0.5, 0, 1 }, { 0.25, 0.25, 0.25 }, { 0.48, 0.1, 0.95 },
    { 0.003, 0.002, 0 }, { 1, 0.501, 0.3 }, { 0.25, 0, 0 } };
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-1, 1);
  for (int i = 0; i < 3; ++i)
  {
    turns.push_back({ angle(random), angle(random), angle(random) });
  }
  return turns;
}

struct Difference
{
  double Largest = 0;
  double Mean = 0; // root of the mean square

  void Add(double a, double b)
  {
    this->Largest = std::max(this->Largest, std::abs(a - b));
    this->Squares += (a - b) * (a - b);
    this->Mean = std::sqrt(this->Squares / static_cast<double>(++this->Count));
  }

private:
  double Squares = 0;
  std::size_t Count = 0;
};

/** How far pictures of blocks are from integrals along the same rays, in parts of the largest. */
Difference CompareBlocks(
  const Phantom<std::uint8_t>& volume, std::uint32_t blockSize, const Vector& turns,
  const HartleyOptions& options)
{
  const auto source = MakeSource(volume.Values, volume.Size, blockSize);
  HartleyProjector projector(source, options);
  const auto view = MakeTurnedView(volume.Size, turns, 16, 1);
  const auto& layout = source->GetLayout();
  double most = 0;
  std::vector<std::pair<double, double>> pixels;
  for (std::size_t chunk = 0; chunk < layout.GetNumberOfChunks(); ++chunk)
  {
    const auto pictures = projector.DrawBlocks(view, chunk);
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
          const auto& picture = pictures[number++];
          for (unsigned row = 0; row < picture.Height; ++row)
          {
            for (unsigned column = 0; column < picture.Width; ++column)
            {
              const double expected = reference.Integrate(
                GetPixel(picture.View, column, row), picture.View.Step);
              most = std::max(most, expected);
              pixels.emplace_back(
                picture.Sums[std::size_t{ row } * picture.Width + column], expected);
            }
          }
        }
      }
    }
    EXPECT_EQ(number, pictures.size());
  }
  Difference difference;
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
      SCOPED_TRACE(testing::Message() << "block " << block << " turns " << turns[0] << " " << turns[1]
                                      << " " << turns[2]);
      const auto difference = CompareBlocks(volume, block, turns, { HartleyMethod::Basis });
      // Single precision.
      EXPECT_LT(difference.Largest, 1e-5);
    }
  }
}

//------------------------------------------------------------------------------
TEST(HartleyProjector, BlocksBySlicesAreNearlyExact)
{
  const auto volume = MakeHead({ 37, 33, 35 });
  for (const std::uint32_t block : { 2u, 5u, 8u, 16u, 32u, 0u })
  {
    for (const Vector& turns : GetTurns())
    {
      SCOPED_TRACE(testing::Message() << "block " << block << " turns " << turns[0] << " " << turns[1]
                                      << " " << turns[2]);
      const auto difference = CompareBlocks(volume, block, turns, { HartleyMethod::Slice });
      std::cout << block << " " << turns[0] << " " << turns[1] << " " << turns[2] << " "
                << difference.Largest << " " << difference.Mean << "\n";
      EXPECT_LT(difference.Mean, 1e-2);
    }
  }
}

//------------------------------------------------------------------------------
TEST(HartleyProjector, XRay)
{
  const auto volume = MakeHead({ 37, 33, 35 });
  const ReferenceVolume reference(volume.Values.data(), volume.Size, 0);
  for (const std::uint32_t block : { 2u, 5u, 8u, 16u, 32u, 0u })
  {
    const auto source = MakeSource(volume.Values, volume.Size, block);
    HartleyProjector projector(source);
    for (const Vector& turns : GetTurns())
    {
      const auto view = MakeTurnedView(volume.Size, turns, 71, 1.1);
      const auto picture = projector.Draw(view, {});
      Difference sums, samples;
      double most = 0;
      for (unsigned row = 0; row < view.Height; ++row)
      {
        for (unsigned column = 0; column < view.Width; ++column)
        {
          const std::size_t i = std::size_t{ row } * view.Width + column;
          const Vector point = GetPixel(view, column, row);
          const double expected = reference.Integrate(point, view.Step);
          most = std::max(most, expected);
          sums.Add(static_cast<double>(picture.Sums[i]), expected);
          samples.Add(static_cast<double>(picture.Samples[i]),
            reference.IntegrateWeight(point, view.Step));
        }
      }
      std::cout << block << " " << turns[0] << " " << turns[1] << " " << turns[2] << " sums "
                << sums.Largest / most << " " << sums.Mean / most << " samples " << samples.Largest
                << " " << samples.Mean << "\n";
    }
  }
}
}
