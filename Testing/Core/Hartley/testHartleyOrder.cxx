// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunHartleyOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gatun::test
{
namespace
{
using Triple = HartleyLayout::Triple;
using Waves = std::array<std::int32_t, 3>;

struct Frequency
{
  Waves Wave{};
  std::uint32_t Index = 0;
  std::uint32_t Partner = 0;
  std::uint32_t Shell = 0;
};

/** The index of a frequency, which may be given with the wrong sign. */
std::uint32_t GetIndex(const Waves& wave, const Triple& block)
{
  std::uint32_t index = 0;
  for (unsigned axis = 3; axis-- > 0;)
  {
    const auto size = static_cast<std::int32_t>(block[axis]);
    index = index * block[axis] + static_cast<std::uint32_t>((wave[axis] % size + size) % size);
  }
  return index;
}

/** All frequencies in the order of ghv-format.md. */
std::vector<Frequency> Sort(const Triple& block)
{
  std::vector<Frequency> found;
  const double longest = std::max({ block[0], block[1], block[2] });
  for (std::uint32_t index = 0; index < block[0] * block[1] * block[2]; ++index)
  {
    const Triple place{ index % block[0], index / block[0] % block[1],
      index / block[0] / block[1] };
    Frequency one;
    one.Index = index;
    double square = 0;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const auto at = static_cast<std::int32_t>(place[axis]);
      const auto size = static_cast<std::int32_t>(block[axis]);
      one.Wave[axis] = 2 * at <= size ? at : at - size;
      const double wave = one.Wave[axis] * longest / size;
      square += wave * wave;
    }
    one.Partner = GetIndex({ -one.Wave[0], -one.Wave[1], -one.Wave[2] }, block);
    one.Shell = static_cast<std::uint32_t>(std::sqrt(square));
    found.push_back(one);
  }
  std::sort(found.begin(), found.end(),
    [](const Frequency& a, const Frequency& b)
    {
      return std::tuple(a.Shell, std::min(a.Index, a.Partner), a.Index) <
        std::tuple(b.Shell, std::min(b.Index, b.Partner), b.Index);
    });
  return found;
}
}

//------------------------------------------------------------------------------
// The last block has two segments, and more slices than parts.
TEST(HartleyOrder, IsThatOfTheFormat)
{
  for (const Triple& block : { Triple{ 1, 1, 1 }, Triple{ 2, 3, 4 }, Triple{ 5, 4, 3 },
         Triple{ 16, 16, 16 }, Triple{ 61, 60, 80 } })
  {
    const auto expected = Sort(block);
    const HartleyOrder order(block);
    const auto positions = order.GetPositions();
    ASSERT_EQ(positions.size(), expected.size());
    std::vector<std::size_t> ranks(expected.size());
    for (std::size_t rank = 0; rank < expected.size(); ++rank)
    {
      ranks[expected[rank].Index] = rank;
    }
    for (std::size_t rank = 0; rank < expected.size(); ++rank)
    {
      const Frequency& one = expected[rank];
      const auto isKnown = [&](std::uint32_t index)
      {
        return ranks[index] < rank &&
          ranks[index] / HartleyOrder::SegmentLength == rank / HartleyOrder::SegmentLength;
      };
      unsigned flags = isKnown(one.Partner) ? HartleyOrder::KnowsPartner : 0;
      for (unsigned axis = 0; axis < 3; ++axis)
      {
        Waves inner = one.Wave;
        inner[axis] -= inner[axis] > 0 ? 1 : -1;
        if (one.Wave[axis] != 0 && isKnown(GetIndex(inner, block)))
        {
          flags |= HartleyOrder::KnowsInner << axis;
          flags |= isKnown(GetIndex({ -inner[0], -inner[1], -inner[2] }, block))
            ? HartleyOrder::KnowsInnerPartner << axis
            : 0;
        }
      }
      const auto& found = positions[rank];
      ASSERT_EQ(found.Index, one.Index) << rank;
      ASSERT_EQ(found.Partner, one.Partner) << rank;
      ASSERT_EQ(Waves({ found.Wave[0], found.Wave[1], found.Wave[2] }), one.Wave) << rank;
      ASSERT_EQ(found.Flags, flags) << rank;
    }
    const auto& bands = order.GetBandStarts();
    EXPECT_EQ(bands.front(), 0u);
    EXPECT_EQ(bands.back(), expected.size());
    EXPECT_LE(bands.size(), HartleyOrder::Bands + 1);
    for (std::size_t band = 0; band + 1 < bands.size(); ++band)
    {
      // Bands begin with a shell.
      EXPECT_TRUE(band == 0 || expected[bands[band]].Shell > expected[bands[band] - 1].Shell);
      for (std::uint32_t rank = bands[band]; rank < bands[band + 1]; ++rank)
      {
        ASSERT_EQ(positions[rank].Band, band);
      }
    }
  }
}
}
