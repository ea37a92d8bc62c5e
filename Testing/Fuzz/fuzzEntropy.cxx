// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Decisions, symbols and raw bits from any stream, and then the same from an encoder and back.

#include "fuzzInput.h"
#include "gatunEntropy.h"

#include <array>
#include <cstdlib>
#include <vector>

namespace
{
using namespace gatun;

enum class Kind
{
  Decision,
  Symbol,
  Raw
};

/** A decision or a symbol of a model, or raw bits. */
struct Item
{
  Kind Of;
  unsigned Number; // of the model, or of bits
  std::uint64_t Value;
};

struct Models
{
  std::array<BitModel, 4> Decisions;
  std::array<SymbolModel, 4> Symbols;
};

template <typename Coder>
std::uint64_t Code(Coder& coder, Models& models, const Item& item)
{
  switch (item.Of)
  {
    case Kind::Decision:
      return coder.Bit(models.Decisions[item.Number], item.Value != 0);
    case Kind::Symbol:
      return coder.Symbol(models.Symbols[item.Number], static_cast<unsigned>(item.Value));
    default:
      return coder.Raw(item.Value, item.Number);
  }
}

std::vector<Item> Decode(
  std::span<const std::uint8_t> plan, std::size_t count, std::span<const std::uint8_t> stream)
{
  std::vector<Item> items;
  fuzz::Accepts(
    [&]
    {
      EntropyDecoder decoder(stream);
      Models models;
      for (std::size_t i = 0; i < count; ++i)
      {
        const unsigned step = plan.empty() ? 0 : plan[i % plan.size()];
        const auto kind = (step & 3) == 3 ? Kind::Raw
          : (step & 3) == 2               ? Kind::Symbol
                                          : Kind::Decision;
        Item item{ kind, (step >> 2) % (kind == Kind::Raw ? 65 : 4), 0 };
        item.Value = Code(decoder, models, item);
        items.push_back(item);
      }
    });
  return items;
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input in(data, size);
  const auto count = in.TakeUpTo(2000);
  const auto plan = in.TakeBytes(in.TakeUpTo(40));
  const auto items = Decode(plan, count, fuzz::Copy(in.TakeRest()));

  EntropyEncoder encoder;
  Models models;
  for (const auto& item : items)
  {
    Code(encoder, models, item);
  }
  const auto again = Decode(plan, items.size(), fuzz::Copy(encoder.Finish()));
  if (again.size() != items.size())
  {
    std::abort();
  }
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    if (again[i].Value != items[i].Value)
    {
      std::abort();
    }
  }
  return 0;
}
