// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunDomainSurvey.h"

#include "gatunError.h"
#include "gatunProgression.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace
{
using namespace gatun;

/** Values at random places of a lattice, rounded to binary32. */
std::vector<float> MakePlaces(double origin, double step, unsigned places, std::size_t count)
{
  std::mt19937 random(3);
  std::vector<float> values{ static_cast<float>(origin) };
  while (values.size() < count)
  {
    values.push_back(static_cast<float>(origin + random() % places * step));
  }
  return values;
}

Palette GetKeys(const std::vector<float>& values)
{
  Palette keys;
  for (const auto& value : values)
  {
    keys.push_back(Domain::ReadPlain(ScalarType::Float32, &value));
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

std::shared_ptr<const Palette> Find(const std::vector<float>& values, PaletteUse use)
{
  return FindDomain(ScalarType::Float32, values.data(), values.size(), 1, 0, use).GetPalette();
}

TEST(Palette, FindsTheLatticeOfRoundedCoordinates)
{
  for (const double origin : { 0.0, -2.0, -106.89954, 8.419911, 1e-3 })
  {
    for (const double size : { 4.0, 217.3, 1e-2 })
    {
      const double step = size / 16383.0;
      if (std::abs(origin) > 100 * size)
      {
        continue; // the step is too small for binary32
      }
      const auto first = static_cast<double>(static_cast<float>(origin));
      const auto values = MakePlaces(first, step, 16384, 3000);
      const auto keys = GetKeys(values);
      const auto palette = Find(values, PaletteUse::Coordinates);
      ASSERT_TRUE(palette) << origin << " " << size;
      EXPECT_GT(palette->size(), 16000u);
      EXPECT_LE(palette->size(), 16384u);
      EXPECT_TRUE(std::includes(palette->begin(), palette->end(), keys.begin(), keys.end()));
      EXPECT_FALSE(Find(values, PaletteUse::Array));

      const auto stream = EncodePalette(ScalarType::Float32, *palette);
      EXPECT_LT(stream.size(), 80u);
      EXPECT_EQ(*DecodePalette(ScalarType::Float32, stream, palette->size()), *palette);
    }
  }
}

TEST(Palette, TakesNoLatticeWithAnExceptionOrTooManyPlaces)
{
  auto values = MakePlaces(-2, 1.0 / 4096, 16384, 3000);
  EXPECT_TRUE(Find(values, PaletteUse::Coordinates));
  values[100] = std::nextafter(values[100], 10.0F);
  EXPECT_FALSE(Find(values, PaletteUse::Coordinates));
  values = MakePlaces(0, 1.0, 16384, 3000);
  values.push_back(std::numeric_limits<float>::quiet_NaN());
  EXPECT_FALSE(Find(values, PaletteUse::Coordinates));
  EXPECT_FALSE(Find(MakePlaces(0, 1.0, 100000, 30000), PaletteUse::Coordinates));
}

TEST(Palette, TakesRareValuesThatAreOnNoLattice)
{
  std::mt19937 random(5);
  std::vector<float> some(100);
  for (auto& value : some)
  {
    value = static_cast<float>(random()) * 1e-9F;
  }
  const auto repeat = [&](std::size_t times)
  {
    std::vector<float> values;
    for (std::size_t i = 0; i < times; ++i)
    {
      values.insert(values.end(), some.begin(), some.end());
    }
    return values;
  };
  const auto count = GetKeys(some).size();
  for (const auto use : { PaletteUse::Coordinates, PaletteUse::Array })
  {
    const auto palette = Find(repeat(16), use);
    ASSERT_TRUE(palette);
    EXPECT_EQ(palette->size(), count);
    EXPECT_EQ(
      *DecodePalette(ScalarType::Float32, EncodePalette(ScalarType::Float32, *palette), count),
      *palette);
  }
  EXPECT_TRUE(Find(repeat(4), PaletteUse::Coordinates));
  EXPECT_FALSE(Find(repeat(3), PaletteUse::Coordinates));
  EXPECT_FALSE(Find(repeat(8), PaletteUse::Array));
}

TEST(Palette, RejectsProgressionsBeyondTheType)
{
  const auto decode = [](double origin, double step, std::size_t count)
  {
    ByteWriter out;
    out.Put(std::uint8_t{ 3 });
    out.Put(origin);
    out.Put(step);
    return DecodePalette(ScalarType::Float32, out.Data, count);
  };
  EXPECT_EQ(*decode(1, 0.5, 4), (GetKeys({ 1, 1.5F, 2, 2.5F })));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(decode(1, 0, 4), Error);
  EXPECT_THROW(decode(1, -1, 4), Error);
  EXPECT_THROW(decode(1, nan, 4), Error);
  EXPECT_THROW(decode(nan, 1, 4), Error);
  EXPECT_THROW(decode(-infinity, 1, 4), Error);
  EXPECT_THROW(decode(0, 1e39, 4), Error);
  EXPECT_THROW(decode(1, 1e-9, 4), Error); // all the same
  const Bytes cut{ 3, 0, 0 };
  EXPECT_THROW(DecodePalette(ScalarType::Float32, cut, 4), Error);
  // Integers have none.
  ByteWriter out;
  out.Put(std::uint8_t{ 3 });
  out.Put(1.0);
  out.Put(1.0);
  EXPECT_THROW(DecodePalette(ScalarType::Int32, out.Data, 4), Error);
}
}
