// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Arrays in pages of their own keep what is put into them, of any size.

#include "gatunPageArray.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <utility>

namespace
{
using namespace gatun;

TEST(PageArray, KeepsItsValuesWhileItGrows)
{
  PageArray<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < 100000; ++i) // small on the heap at first, then in pages
  {
    numbers.push_back(i);
  }
  numbers.shrink_to_fit();
  const PageArray<std::uint32_t> copy = numbers;
  const PageArray<std::uint32_t> moved = std::move(numbers);
  PageArray<std::uint32_t> expected(100000);
  std::iota(expected.begin(), expected.end(), 0u);
  EXPECT_EQ(copy, expected);
  EXPECT_EQ(moved, expected);
}

TEST(PageArray, IsClearedWhenItIsMade)
{
  for (const std::size_t size : { 0, 1, 16383, 16384, 1000000 })
  {
    const PageArray<std::uint8_t> bytes(size);
    EXPECT_EQ(std::accumulate(bytes.begin(), bytes.end(), 0), 0);
  }
}

TEST(PageArray, RefusesWhatNoMemoryHolds)
{
  PageArray<double> numbers;
  EXPECT_ANY_THROW(numbers.reserve(numbers.max_size()));
  PageAllocator<double> allocator;
  EXPECT_THROW((void)allocator.allocate(SIZE_MAX / 8), std::bad_alloc);
}
}
