// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Fingerprints of arrays: equal for equal arrays, and different for a change of any bit, for other
// lengths, and for the same bytes in other arrays.

#include "gatunFingerprint.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace
{
using namespace gatun;

using Array = std::vector<std::uint8_t>;

Fingerprint Of(const std::vector<Array>& arrays)
{
  const std::vector<std::span<const std::uint8_t>> spans(arrays.begin(), arrays.end());
  return MakeFingerprint(spans);
}

std::pair<std::uint64_t, std::uint64_t> PairOf(const Fingerprint& print)
{
  return { print.Low, print.High };
}

TEST(Fingerprint, EqualArraysHaveTheSame)
{
  Array bytes(1000);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{ 3 });
  const Array copy = bytes;
  EXPECT_EQ(Of({ bytes, {} }), Of({ copy, {} }));
  EXPECT_EQ(Of({}), Of({}));
}

TEST(Fingerprint, EachBitCounts)
{
  // Each half alone must tell all of them apart, too: it has 64 bits.
  Array bytes(1000);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{ 3 });
  std::set<std::uint64_t> low{ Of({ bytes, bytes }).Low };
  std::set<std::uint64_t> high{ Of({ bytes, bytes }).High };
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit)
  {
    Array changed = bytes;
    changed[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
    for (const auto& print : { Of({ changed, bytes }), Of({ bytes, changed }) })
    {
      low.insert(print.Low);
      high.insert(print.High);
    }
  }
  EXPECT_EQ(low.size(), 1 + 16 * bytes.size());
  EXPECT_EQ(high.size(), 1 + 16 * bytes.size());
}

TEST(Fingerprint, LengthsCount)
{
  // Zeros and nothing, and the same bytes divided in another way.
  std::set<std::pair<std::uint64_t, std::uint64_t>> prints;
  for (std::size_t length = 0; length < 300; ++length)
  {
    prints.insert(PairOf(Of({ Array(length), Array(300 - length) })));
  }
  prints.insert(PairOf(Of({ Array(300) })));
  prints.insert(PairOf(Of({ Array(300), {}, {} })));
  EXPECT_EQ(prints.size(), 302u);
}
}
