// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Caches that share a budget: together they never hold more than it, and the parts that have not
// been used for the longest time are removed, whichever cache they are in.

#include "gatunCache.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <latch>
#include <string>
#include <thread>
#include <vector>

namespace
{
using namespace gatun;

using Numbers = Cache<int, int>;
using Words = Cache<std::string, std::string>;

constexpr std::uint64_t NumberBytes = 1000 + Numbers::Overhead;
constexpr std::uint64_t WordBytes = 1000 + Words::Overhead;

void Keep(Numbers& cache, int key)
{
  cache.Keep(key, std::make_shared<const int>(key), 1000);
}

void Keep(Words& cache, const std::string& key)
{
  cache.Keep(key, std::make_shared<const std::string>(key), 1000);
}

TEST(Cache, FindsWhatItKeeps)
{
  Numbers cache(std::make_shared<CacheBudget>(10 * NumberBytes));
  EXPECT_EQ(cache.Find(1), nullptr);
  Keep(cache, 1);
  const auto first = cache.Find(1);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(*first, 1);
  cache.Keep(1, std::make_shared<const int>(2), 1000); // the one before stays
  EXPECT_EQ(cache.Find(1), first);
  const auto now = cache.GetStatistics();
  EXPECT_EQ(now.Bytes, NumberBytes);
  EXPECT_EQ(now.Entries, 1u);
  EXPECT_EQ(now.Found, 2u);
  EXPECT_EQ(now.Made, 2u);
  cache.Clear();
  EXPECT_EQ(cache.Find(1), nullptr);
  EXPECT_EQ(cache.GetStatistics().Bytes, 0u);
  EXPECT_EQ(cache.GetStatistics().PeakBytes, NumberBytes);
}

TEST(Cache, FindsTheLastKeyOfARange)
{
  Numbers cache(std::make_shared<CacheBudget>(10 * NumberBytes));
  for (const int key : { 2, 4, 8 })
  {
    Keep(cache, key);
  }
  EXPECT_FALSE(cache.FindLast(0, 1));
  EXPECT_FALSE(cache.FindLast(5, 7));
  EXPECT_FALSE(cache.FindLast(9, 100));
  for (const std::array<int, 3> one : { std::array{ 0, 2, 2 }, { 2, 3, 2 }, { 3, 7, 4 } })
  {
    const auto found = cache.FindLast(one[0], one[1]);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->first, one[2]);
    EXPECT_EQ(*found->second, one[2]);
  }
}

TEST(Cache, RemovesTheLeastRecentlyUsedOfAllCachesOfABudget)
{
  const auto budget = std::make_shared<CacheBudget>(2 * NumberBytes + 2 * WordBytes);
  Numbers numbers(budget);
  Words words(budget);
  Keep(numbers, 1);
  Keep(words, "one");
  Keep(numbers, 2);
  Keep(words, "two");
  EXPECT_EQ(budget->GetStatistics().Entries, 4u);
  EXPECT_NE(numbers.Find(1), nullptr); // "one" is now the oldest
  Keep(words, "three");
  EXPECT_EQ(words.Find("one"), nullptr);
  EXPECT_NE(numbers.Find(1), nullptr);
  EXPECT_NE(words.Find("two"), nullptr);
  Keep(words, "four");
  Keep(words, "five");
  EXPECT_EQ(numbers.Find(2), nullptr);
  EXPECT_EQ(numbers.Find(1), nullptr);
  EXPECT_EQ(numbers.GetStatistics().Bytes, 0u);
  EXPECT_EQ(budget->GetStatistics().Bytes, words.GetStatistics().Bytes);
  EXPECT_LE(budget->GetStatistics().PeakBytes, budget->GetBytes());
}

TEST(Cache, LeavesNothingInTheBudgetWhenItIsDestroyed)
{
  const auto budget = std::make_shared<CacheBudget>(10 * WordBytes);
  Words words(budget);
  {
    Numbers numbers(budget);
    Keep(numbers, 1);
    Keep(words, "one");
  }
  EXPECT_EQ(budget->GetStatistics().Bytes, WordBytes);
  EXPECT_EQ(budget->GetStatistics().Made, 2u);
  budget->SetBytes(0); // reaches the caches that are left
  EXPECT_EQ(words.Find("one"), nullptr);
}

TEST(Cache, WithoutBudgetKeepsNothing)
{
  Numbers cache(std::make_shared<CacheBudget>(0));
  Keep(cache, 1);
  cache.Keep(2, std::make_shared<const int>(2), 0);
  EXPECT_EQ(cache.Find(1), nullptr);
  EXPECT_EQ(cache.Find(2), nullptr);
  EXPECT_EQ(cache.GetStatistics().PeakBytes, 0u);
  EXPECT_EQ(cache.GetStatistics().Made, 2u);
}

TEST(Cache, APartLargerThanTheBudgetRemovesNothing)
{
  Numbers cache(std::make_shared<CacheBudget>(3 * NumberBytes));
  Keep(cache, 1);
  Keep(cache, 2);
  for (const std::uint64_t bytes : { 3 * NumberBytes, ~std::uint64_t{ 0 } })
  {
    cache.Keep(3, std::make_shared<const int>(3), bytes);
    EXPECT_EQ(cache.Find(3), nullptr);
    EXPECT_EQ(cache.GetStatistics().Entries, 2u);
  }
  cache.Keep(3, std::make_shared<const int>(3), 3 * NumberBytes - Numbers::Overhead);
  EXPECT_NE(cache.Find(3), nullptr);
  EXPECT_EQ(cache.GetStatistics().Entries, 1u);
}

TEST(Cache, ASmallerBudgetRemovesTheOldestAtOnce)
{
  const auto budget = std::make_shared<CacheBudget>(8 * NumberBytes);
  Numbers numbers(budget);
  Numbers others(budget);
  for (int i = 0; i < 8; ++i)
  {
    Keep(i % 2 == 0 ? numbers : others, i);
  }
  budget->SetBytes(3 * NumberBytes + 1);
  for (int i = 0; i < 8; ++i)
  {
    EXPECT_EQ((i % 2 == 0 ? numbers : others).Find(i) != nullptr, i >= 5) << i;
  }
  EXPECT_EQ(budget->GetStatistics().PeakBytes, 3 * NumberBytes);
  EXPECT_EQ(numbers.GetStatistics().PeakBytes, NumberBytes);
  EXPECT_EQ(others.GetStatistics().PeakBytes, 2 * NumberBytes);
}

TEST(Cache, KeepFirstRemovesNothing)
{
  Numbers cache(std::make_shared<CacheBudget>(3 * NumberBytes), CachePolicy::KeepFirst);
  for (int round = 0; round < 2; ++round)
  {
    for (int i = 0; i < 6; ++i)
    {
      EXPECT_EQ(cache.Find(i) != nullptr, round > 0 && i < 3) << i;
      Keep(cache, i);
    }
  }
}

TEST(Cache, KeepLastKeepsWhateverWasUsedLast)
{
  Numbers cache(std::make_shared<CacheBudget>(3 * NumberBytes), CachePolicy::KeepLast);
  Keep(cache, 1);
  Keep(cache, 2);
  for (const std::uint64_t bytes : { 3 * NumberBytes, ~std::uint64_t{ 0 } })
  {
    cache.Keep(3, std::make_shared<const int>(3), bytes);
    EXPECT_NE(cache.Find(3), nullptr);
    EXPECT_EQ(cache.GetStatistics().Entries, 1u);
    Keep(cache, 4); // there is no room for both
    EXPECT_EQ(cache.Find(3), nullptr);
    EXPECT_NE(cache.Find(4), nullptr);
    EXPECT_EQ(cache.GetStatistics().Bytes, NumberBytes);
  }
}

TEST(Cache, MakesOnceWhatItKeeps)
{
  struct Text
  {
    std::string Value;
    std::uint64_t GetBytes() const { return this->Value.size(); }
  };
  Cache<int, void> cache(std::make_shared<CacheBudget>(1000));
  unsigned made = 0;
  const auto get = [&](int key, std::size_t size)
  {
    return cache.FindOrMake<Text>(key,
      [&]
      {
        ++made;
        return Text{ std::string(size, 'a') };
      });
  };
  const auto first = get(1, 10);
  EXPECT_EQ(get(1, 20), first);
  EXPECT_EQ(first->Value.size(), 10u);
  EXPECT_EQ(made, 1u);
  EXPECT_EQ(cache.GetStatistics().Bytes, 10 + decltype(cache)::Overhead);
  EXPECT_EQ(get(2, 2000)->Value.size(), 2000u); // too large to be kept
  EXPECT_EQ(get(2, 2000)->Value.size(), 2000u);
  EXPECT_EQ(made, 3u);
}

TEST(Cache, DestroysPartsWithoutTheLock)
{
  // A part that uses its cache while it is destroyed would wait forever.
  struct Part
  {
    std::shared_ptr<CacheBudget> Budget;
    int* Destroyed;
    Part(std::shared_ptr<CacheBudget> budget, int* destroyed)
      : Budget(std::move(budget))
      , Destroyed(destroyed)
    {
    }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;
    ~Part()
    {
      this->Budget->GetBytes();
      ++*this->Destroyed;
    }
  };
  int destroyed = 0;
  const auto budget = std::make_shared<CacheBudget>(1000);
  Cache<int, Part> cache(budget);
  const auto keep = [&](int key)
  { cache.Keep(key, std::make_shared<const Part>(budget, &destroyed), 600); };
  keep(1);
  keep(1); // not kept
  EXPECT_EQ(destroyed, 1);
  keep(2); // removes the first
  EXPECT_EQ(destroyed, 2);
  cache.Clear();
  EXPECT_EQ(destroyed, 3);
  keep(3);
  budget->SetBytes(0);
  EXPECT_EQ(destroyed, 4);
}

TEST(Cache, ServesSeveralThreads)
{
  constexpr int threads = 4;
  constexpr int rounds = 5000;
  constexpr std::uint64_t most = 40 * NumberBytes;
  const auto budget = std::make_shared<CacheBudget>(most);
  Numbers numbers(budget);
  Words words(budget);
  std::atomic<int> wrong{ 0 };
  std::latch start(threads);
  std::vector<std::thread> all;
  for (int t = 0; t < threads; ++t)
  {
    all.emplace_back(
      [&, t]
      {
        Numbers own(budget); // comes and goes while others remove entries
        start.arrive_and_wait();
        for (int i = 0; i < rounds; ++i)
        {
          const int key = (i * (2 * t + 7)) % 60;
          const auto word = std::to_string(key);
          const auto number = numbers.Find(key);
          const auto text = words.Find(word);
          wrong += number && *number != key;
          wrong += text && *text != word;
          if (!number)
          {
            Keep(numbers, key);
          }
          if (!text)
          {
            Keep(words, word);
          }
          Keep(own, key);
          if (i % 100 == 0)
          {
            own.Clear();
            budget->SetBytes(most - static_cast<std::uint64_t>(i));
          }
          wrong += budget->GetStatistics().Bytes > most;
        }
      });
  }
  for (auto& one : all)
  {
    one.join();
  }
  EXPECT_EQ(wrong, 0);
  const auto sum = budget->GetStatistics();
  EXPECT_LE(sum.PeakBytes, most);
  EXPECT_GT(sum.Found, 0u);
  EXPECT_EQ(sum.Bytes, numbers.GetStatistics().Bytes + words.GetStatistics().Bytes);
  EXPECT_EQ(sum.Entries, numbers.GetStatistics().Entries + words.GetStatistics().Entries);
}
}
