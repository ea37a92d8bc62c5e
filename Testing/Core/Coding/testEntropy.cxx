// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunEntropy.h"
#include "gatunResidual.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
using namespace gatun;

TEST(Entropy, ReturnsWhatWasPutIn)
{
  std::mt19937_64 random(1);
  std::array<BitModel, 3> models;
  EntropyEncoder encoder;
  std::vector<std::uint64_t> wanted;
  const auto bitOf = [](std::uint64_t r) { return (r >> 8) % 1000 < 3 + 400 * (r % 3); };
  for (int i = 0; i < 50000; ++i)
  {
    const auto r = random();
    wanted.push_back(r);
    encoder.Bit(models[r % 3], bitOf(r));
    encoder.Raw(r, static_cast<unsigned>(i % 65));
  }
  const auto stream = encoder.Finish();
  models = {};
  EntropyDecoder decoder(stream);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const auto r = wanted[i];
    ASSERT_EQ(decoder.Bit(models[r % 3]), bitOf(r));
    const auto width = i % 65;
    const auto mask = width == 64 ? ~std::uint64_t{ 0 } : (std::uint64_t{ 1 } << width) - 1;
    ASSERT_EQ(decoder.Raw(0, static_cast<unsigned>(width)), r & mask);
  }
}

TEST(Entropy, SpendsLittleOnWhatIsSure)
{
  BitModel model;
  EntropyEncoder encoder;
  for (int i = 0; i < 100000; ++i)
  {
    encoder.Bit(model, i % 10000 == 9999);
  }
  EXPECT_LT(encoder.Finish().size(), 150u);
  EXPECT_GE(model.GetProbability(), 1u);
  EXPECT_LE(model.GetProbability(), 65535u);
}

TEST(Entropy, MixesSymbolsDecisionsAndRawBits)
{
  std::mt19937_64 random(2);
  SymbolModel symbols;
  BitModel decisions;
  EntropyEncoder encoder;
  std::vector<std::uint64_t> wanted;
  for (int i = 0; i < 50000; ++i)
  {
    // All symbols at first, then few, then others: the model must adapt each time.
    const auto r = random();
    const auto most = i < 10000 ? 16u : 3u;
    const auto symbol = static_cast<unsigned>(r % most + (i > 30000 ? 13 : 0)) % 16;
    wanted.push_back(symbol | (r >> 60) << 4 | (r >> 40 & 1) << 8);
    encoder.Symbol(symbols, symbol);
    encoder.Raw(r >> 60, 4);
    encoder.Bit(decisions, (r >> 40 & 1) != 0);
  }
  const auto stream = encoder.Finish();
  symbols = {};
  decisions = {};
  EntropyDecoder decoder(stream);
  for (const auto value : wanted)
  {
    ASSERT_EQ(decoder.Symbol(symbols), value & 15);
    ASSERT_EQ(decoder.Raw(0, 4), value >> 4 & 15);
    ASSERT_EQ(decoder.Bit(decisions), (value >> 8) != 0);
  }
}

TEST(Entropy, EverySymbolKeepsAPlace)
{
  SymbolModel model;
  for (unsigned round = 0; round < 64; ++round)
  {
    for (unsigned i = 0; i < 500; ++i)
    {
      model.Update(round * 7 % SymbolModel::Symbols);
    }
    std::uint32_t sum = 0;
    for (unsigned s = 0; s < SymbolModel::Symbols; ++s)
    {
      ASSERT_EQ(model.GetStart(s), sum);
      ASSERT_GE(model.GetWidth(s), 1u);
      ASSERT_EQ(model.Find(sum), s);
      sum += model.GetWidth(s);
      ASSERT_EQ(model.Find(sum - 1), s);
    }
    ASSERT_EQ(sum, 1u << SymbolModel::Bits);
  }
}

TEST(Entropy, SymbolsTakeNearlyWhatTheirFrequenciesSay)
{
  // 1 / 2, 1 / 4, 1 / 8 and 1 / 8: 1.75 bits each.
  std::mt19937_64 random(3);
  SymbolModel model;
  EntropyEncoder encoder;
  constexpr unsigned count = 100000;
  for (unsigned i = 0; i < count; ++i)
  {
    const auto r = random() % 8;
    encoder.Symbol(model, r < 4 ? 9u : r < 6 ? 3u : r < 7 ? 0u : 15u);
  }
  EXPECT_LT(8.0 * static_cast<double>(encoder.Finish().size()), 1.80 * count);
}

TEST(ResidualModel, KeepsExtremeResidualsOfAllWidths)
{
  for (unsigned bits = 1; bits <= 64; ++bits)
  {
    std::vector<std::int64_t> residuals;
    const auto add = [&](std::uint64_t value) { // as signed numbers of so many bits
      residuals.push_back(static_cast<std::int64_t>(value << (64 - bits)) >> (64 - bits));
    };
    for (unsigned shift = 0; shift < bits; ++shift)
    {
      const std::uint64_t power = std::uint64_t{ 1 } << shift;
      for (const auto value : { power, power - 1, power + 1, ~power, 0 - power })
      {
        add(value);
      }
    }
    for (const unsigned spread : { 0u, bits / 2, bits, 64u })
    {
      ResidualModel model;
      EntropyEncoder encoder;
      for (const auto residual : residuals)
      {
        EXPECT_EQ(model.Code(encoder, spread, residual), residual);
      }
      const auto stream = encoder.Finish();
      model = {};
      EntropyDecoder decoder(stream);
      for (const auto residual : residuals)
      {
        ASSERT_EQ(model.Code(decoder, spread, 0), residual) << bits << " bits";
      }
    }
  }
}
}
