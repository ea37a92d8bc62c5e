// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunDependencyCheck.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace gatun
{
namespace
{
constexpr unsigned Rounds = 8;

/** 64 choices of merges: which of them have each merge when all have what they depend on. */
class Choices
{
public:
  explicit Choices(const MergeDependencies& dependencies)
    : Dependencies(dependencies)
    , Done(dependencies.GetNumberOfMerges())
  {
  }

  /** Merges must be added from the first one on. */
  std::uint64_t Add(std::size_t merge, std::uint64_t wanted)
  {
    for (const auto earlier : this->Dependencies.Get(merge))
    {
      wanted &= this->Done[earlier];
    }
    return this->Done[merge] = wanted;
  }

private:
  const MergeDependencies& Dependencies;
  std::vector<std::uint64_t> Done; // a bit for each choice
};
}

//------------------------------------------------------------------------------
bool AreEquivalent(const MergeDependencies& a, const MergeDependencies& b)
{
  const auto merges = a.GetNumberOfMerges();
  if (b.GetNumberOfMerges() != merges)
  {
    return false;
  }
  std::mt19937_64 random(1);
  const unsigned most = std::bit_width(merges); // so that about one merge is left out
  for (unsigned round = 1; round <= Rounds; ++round)
  {
    Choices ofA(a), ofB(b);
    for (std::size_t merge = 0; merge < merges; ++merge)
    {
      auto unwanted = ~std::uint64_t{ 0 };
      for (unsigned i = 0; i < (most * round + Rounds - 1) / Rounds; ++i)
      {
        unwanted &= random(); // half of them
      }
      if (ofA.Add(merge, ~unwanted) != ofB.Add(merge, ~unwanted))
      {
        return false;
      }
    }
  }
  return true;
}
}
