// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunNumberModel_h
#define gatunNumberModel_h

// Numbers as sequences of binary decisions.

#include "gatunEntropy.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace gatun
{
/** Models numbers of a few bits: a decision for each bit, highest first, given the higher ones. */
template <unsigned Bits>
class BitTree
{
public:
  template <typename Coder>
  unsigned Code(Coder& coder, unsigned value)
  {
    unsigned node = 1;
    for (unsigned bit = Bits; bit-- > 0;)
    {
      node = 2 * node + coder.Bit(this->Models[node], (value >> bit) & 1);
    }
    return node - (1u << Bits);
  }

private:
  std::array<BitModel, 1u << Bits> Models;
};

/** Models numbers of up to 32 bits by their length. */
class NumberModel
{
public:
  template <typename Coder>
  std::uint32_t Code(Coder& coder, std::uint32_t value)
  {
    const auto length = this->Length.Code(coder, static_cast<unsigned>(std::bit_width(value)));
    if (length > 32)
    {
      ThrowCorrupt("a number is longer than 32 bits");
    }
    if (length < 2)
    {
      return length;
    }
    const std::uint32_t top = std::uint32_t{ 1 } << (length - 1);
    return top | static_cast<std::uint32_t>(coder.Raw(value & (top - 1), length - 1));
  }

private:
  BitTree<6> Length;
};

/** Codes a number below count without modeling. */
template <typename Coder>
std::uint32_t CodeIndex(Coder& coder, std::uint32_t value, std::size_t count)
{
  const auto bits = static_cast<unsigned>(std::bit_width(count > 0 ? count - 1 : 0));
  const auto coded = static_cast<std::uint32_t>(coder.Raw(value, bits));
  if (coded >= count)
  {
    ThrowCorrupt("a chunk names an element that is not there");
  }
  return coded;
}
}

#endif
