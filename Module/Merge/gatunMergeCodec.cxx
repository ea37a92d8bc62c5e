// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeCodec.h"

#include "gatunEntropy.h"
#include "gatunResidual.h"

#include <bit>
#include <numeric>
#include <vector>

namespace gatun
{
namespace
{
/** The points that have not been merged yet, each at a place below their number. */
class PointsLeft
{
public:
  explicit PointsLeft(std::uint32_t points)
    : Points(points)
  {
    std::iota(this->Points.begin(), this->Points.end(), 0u);
  }

  std::uint32_t GetCount() const { return static_cast<std::uint32_t>(this->Points.size()); }

  /** Takes the point at a place out; the last one gets its place. */
  std::uint32_t Take(std::uint32_t place)
  {
    const auto point = this->Points[place];
    this->Points[place] = this->Points.back();
    this->Points.pop_back();
    return point;
  }

  std::uint32_t GetLast() const { return this->Points.back(); }

private:
  std::vector<std::uint32_t> Points;
};

/** A number below count, all of which are as likely: truncated binary. */
template <typename Coder>
std::uint32_t CodeUniform(Coder& coder, std::uint32_t count, std::uint32_t number)
{
  const unsigned bits = static_cast<unsigned>(std::bit_width(count)) - 1;
  const auto shorter = static_cast<std::uint32_t>((std::uint64_t{ 2 } << bits) - count);
  const std::uint64_t longer = std::uint64_t{ number } + shorter;
  const bool isShort = number < shorter;
  const auto first =
    static_cast<std::uint32_t>(coder.Raw(isShort ? std::uint64_t{ number } : longer >> 1, bits));
  if (first < shorter)
  {
    return first;
  }
  const auto last = static_cast<std::uint32_t>(coder.Raw(longer & 1, 1));
  return 2 * first + last - shorter;
}

/** How residuals are coded that are as large as those before them. */
class RunningResidual
{
public:
  template <typename Coder>
  std::int64_t Code(Coder& coder, std::int64_t residual)
  {
    residual = this->Model.Code(coder, this->Spread.Get(), residual);
    this->Spread.Add(residual);
    return residual;
  }

private:
  ResidualModel Model;
  RunningSpread Spread;
};

/** What is coded of an error that is a number and not negative: half of its bits. */
std::int64_t ToKey(float error)
{
  return std::bit_cast<std::uint32_t>(error) >> 16;
}

constexpr std::int64_t InfinityKey = 0x7f80;
}

//------------------------------------------------------------------------------
Bytes EncodeMerges(const MergeTree& tree, std::uint32_t points, MergeKind kind)
{
  const auto& isBound = tree.GetBonds();
  PointsLeft left(points);
  std::vector<std::uint32_t> placeOf(points);
  std::iota(placeOf.begin(), placeOf.end(), 0u);
  EntropyEncoder coder;
  RunningResidual distances, growths;
  BitModel bonds;
  std::int64_t last = 0;
  for (std::size_t i = 0; i < tree.GetMerges().size(); ++i)
  {
    const Merge& merge = tree.GetMerges()[i];
    const auto place = placeOf[merge.Point];
    CodeUniform(coder, left.GetCount(), place);
    placeOf[left.GetLast()] = place;
    left.Take(place);
    distances.Code(coder, static_cast<std::int64_t>(merge.Into) - merge.Point);
    const auto key = ToKey(merge.Error);
    growths.Code(coder, key - last);
    last = key;
    if (kind == MergeKind::Surface)
    {
      coder.Bit(bonds, !isBound.empty() && isBound[i]);
    }
  }
  return coder.Finish();
}

//------------------------------------------------------------------------------
MergeTree DecodeMerges(
  std::span<const std::uint8_t> stream, std::uint32_t points, std::uint32_t merges, MergeKind kind)
{
  if (merges > points)
  {
    ThrowCorrupt("there are more merges than points");
  }
  if (merges / 8 > stream.size()) // each takes a raw bit at least
  {
    ThrowCorrupt("there are more merges than their stream can hold");
  }
  PointsLeft left(points);
  std::vector<Merge> list;
  list.reserve(merges);
  std::vector<bool> isBound;
  isBound.reserve(kind == MergeKind::Surface ? merges : 0);
  bool hasBonds = false;
  EntropyDecoder coder(stream);
  RunningResidual distances, growths;
  BitModel bonds;
  std::int64_t key = 0;
  for (std::uint32_t i = 0; i < merges; ++i)
  {
    const auto point = left.Take(CodeUniform(coder, left.GetCount(), 0));
    const auto distance = distances.Code(coder, 0);
    const auto growth = growths.Code(coder, 0);
    // Unsigned, as a damaged stream may say anything.
    const auto into = static_cast<std::uint64_t>(distance) + point;
    if (into >= points)
    {
      ThrowCorrupt("a point is merged into one that does not exist");
    }
    if (growth < 0 || growth > InfinityKey - key)
    {
      ThrowCorrupt("the errors of merges do not ascend");
    }
    key += growth;
    const auto bits = static_cast<std::uint32_t>(key) << 16;
    list.push_back({ point, static_cast<std::uint32_t>(into), std::bit_cast<float>(bits) });
    if (kind == MergeKind::Surface)
    {
      isBound.push_back(coder.Bit(bonds, false) != 0);
      hasBonds = hasBonds || isBound.back();
    }
  }
  try
  {
    return { points, std::move(list), hasBonds ? std::move(isBound) : std::vector<bool>() };
  }
  catch (const Error& error)
  {
    ThrowCorrupt(error.what());
  }
}
}
