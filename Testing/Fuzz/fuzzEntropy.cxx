// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Decisions and raw bits from any stream, and then the same from an encoder and back.

#include "fuzzInput.h"
#include "gatunEntropy.h"

#include <array>
#include <cstdlib>
#include <vector>

namespace
{
using namespace gatun;

/** A decision of a model, or count raw bits. */
struct Symbol
{
  bool IsRaw;
  unsigned Number; // of the model, or of bits
  std::uint64_t Value;
};

using Models = std::array<BitModel, 4>;

std::vector<Symbol> Decode(
  std::span<const std::uint8_t> plan, std::size_t count, std::span<const std::uint8_t> stream)
{
  std::vector<Symbol> symbols;
  fuzz::Accepts(
    [&]
    {
      EntropyDecoder decoder(stream);
      Models models;
      for (std::size_t i = 0; i < count; ++i)
      {
        const unsigned step = plan.empty() ? 0 : plan[i % plan.size()];
        Symbol symbol{ (step & 3) == 3, (step & 3) == 3 ? (step >> 2) % 65 : (step >> 2) % 4, 0 };
        symbol.Value =
          symbol.IsRaw ? decoder.Raw(0, symbol.Number) : decoder.Bit(models[symbol.Number]);
        symbols.push_back(symbol);
      }
    });
  return symbols;
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input in(data, size);
  const auto count = in.TakeUpTo(2000);
  const auto plan = in.TakeBytes(in.TakeUpTo(40));
  const auto symbols = Decode(plan, count, fuzz::Copy(in.TakeRest()));

  EntropyEncoder encoder;
  Models models;
  for (const auto& symbol : symbols)
  {
    if (symbol.IsRaw)
    {
      encoder.Raw(symbol.Value, symbol.Number);
    }
    else
    {
      encoder.Bit(models[symbol.Number], symbol.Value != 0);
    }
  }
  const auto again = Decode(plan, symbols.size(), fuzz::Copy(encoder.Finish()));
  if (again.size() != symbols.size())
  {
    std::abort();
  }
  for (std::size_t i = 0; i < symbols.size(); ++i)
  {
    if (again[i].Value != symbols[i].Value)
    {
      std::abort();
    }
  }
  return 0;
}
