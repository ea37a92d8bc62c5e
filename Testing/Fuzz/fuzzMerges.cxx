// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A stream of merges. What is decoded is a tree; encoded and decoded again it is the same. The
// stream is also one of the dependencies of these merges.

#include "fuzzInput.h"
#include "gatunDependencyCheck.h"
#include "gatunDependencyCodec.h"
#include "gatunMergeCodec.h"

#include <algorithm>
#include <cstdlib>
#include <span>

namespace
{
bool IsSame(const gatun::Merge& a, const gatun::Merge& b)
{
  return a.Point == b.Point && a.Into == b.Into && a.Error == b.Error;
}

void DecodeTheirDependencies(std::span<const std::uint8_t> stream, const gatun::MergeTree& tree)
{
  using namespace gatun;
  const auto dependencies = DecodeDependencies(stream, tree);
  const auto again = EncodeDependencies(tree, dependencies);
  const auto merges = tree.GetMerges().size();
  if (dependencies.GetNumberOfMerges() != merges ||
    (merges > 0 && !AreEquivalent(DecodeDependencies(again, tree), dependencies)))
  {
    std::abort();
  }
}

void Decode(std::span<const std::uint8_t> stream, std::uint32_t points, std::uint32_t merges,
  gatun::MergeKind kind)
{
  using namespace gatun;
  const auto tree = DecodeMerges(stream, points, merges, kind);
  const auto again = DecodeMerges(EncodeMerges(tree, points, merges, kind), points, merges, kind);
  const auto& all = tree.GetMerges();
  if (all.size() != merges || tree.GetBonds() != again.GetBonds() ||
    !std::equal(all.begin(), all.end(), again.GetMerges().begin(), again.GetMerges().end(), IsSame))
  {
    std::abort();
  }
  for (const auto count : { merges / 2, merges })
  {
    const auto ancestors = tree.FindAncestors(count);
    std::size_t left = 0;
    for (std::uint32_t point = 0; point < points; ++point)
    {
      const auto ancestor = ancestors[point];
      left += ancestor == point;
      if (ancestor >= points || ancestors[ancestor] != ancestor)
      {
        std::abort();
      }
    }
    if (left != points - count || tree.CountWholeMerges(count) > count)
    {
      std::abort();
    }
  }
  fuzz::Accepts([&] { DecodeTheirDependencies(stream, tree); });
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace gatun;
  fuzz::Input in(data, size);
  const auto points = in.TakeBool() ? in.TakeUpTo(40) : in.TakeUpTo(3000);
  const auto merges = in.TakeUpTo(points + 1);
  const auto stream = fuzz::Copy(in.TakeRest());
  for (const auto kind : { MergeKind::Tetrahedra, MergeKind::Surface })
  {
    fuzz::Accepts([&] { Decode(stream, points, merges, kind); });
  }
  return 0;
}
