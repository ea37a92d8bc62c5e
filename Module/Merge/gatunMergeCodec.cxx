// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeCodec.h"

#include "gatunEntropy.h"
#include "gatunNumberModel.h"
#include "gatunParallel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
constexpr std::uint32_t MergesPerBlock = 1u << 17;
constexpr std::uint32_t FewLeft = 1u << 12;
constexpr std::size_t MergesPerByte = 256; // at most; shorter streams are padded

/** Merges that are coded by themselves. */
struct Block
{
  std::uint32_t First;
  std::uint32_t Count;
  std::uint32_t Left; // points left when their section begins
};

/** Each section of merges leaves half of the points. */
std::vector<Block> MakeBlocks(std::uint32_t points, std::uint32_t merges)
{
  std::vector<Block> blocks;
  for (std::uint32_t done = 0; done < merges;)
  {
    const std::uint32_t left = points - done;
    const std::uint32_t most = left < FewLeft ? left : left - left / 2;
    const std::uint32_t end = done + std::min(most, merges - done);
    for (; done < end; done += blocks.back().Count)
    {
      blocks.push_back({ done, std::min(MergesPerBlock, end - done), left });
    }
  }
  return blocks;
}

/** A merge of points by their places among those that were left when its section began. */
struct PlacedMerge
{
  std::uint32_t Point = 0;
  std::uint32_t Into = 0;
  std::uint32_t Key = 0; // of the error
  bool BeginsRound = false;
  bool IsBound = false;
};

/** What is coded of an error that is a number and not negative: half of its bits. */
std::uint32_t ToKey(float error)
{
  return std::bit_cast<std::uint32_t>(error) >> 16;
}

constexpr std::uint32_t InfinityKey = 0x7f80;

/** Throws Error(Corrupt) if the merges do not follow from each other. */
MergeTree MakeTree(std::uint32_t points, std::vector<Merge> merges, std::vector<bool> isBound,
  std::vector<std::uint32_t> rounds)
{
  try
  {
    return { points, std::move(merges), std::move(isBound), std::move(rounds) };
  }
  catch (const Error& error)
  {
    ThrowCorrupt(error.what());
  }
}

/** Models numbers with a sign by their length, given that of the one before. */
class DistanceModel
{
public:
  /** At most 33 bits. */
  template <typename Coder>
  std::int64_t Code(Coder& coder, std::int64_t distance)
  {
    const auto magnitude = static_cast<std::uint64_t>(distance < 0 ? -distance : distance);
    const auto length =
      this->Lengths[this->Before / 4].Code(coder, static_cast<unsigned>(std::bit_width(magnitude)));
    if (length > MostBits)
    {
      ThrowCorrupt("a distance of points is longer than 33 bits");
    }
    this->Before = length;
    if (length == 0)
    {
      return 0;
    }
    const bool isNegative = coder.Bit(this->Signs[length], distance < 0) != 0;
    std::uint64_t value = 1;
    if (length > 1)
    {
      const auto rest = length - 2;
      value = 2 + coder.Bit(this->Seconds[length], (magnitude >> rest & 1) != 0);
      value = value << rest | coder.Raw(magnitude & ((std::uint64_t{ 1 } << rest) - 1), rest);
    }
    return isNegative ? -static_cast<std::int64_t>(value) : static_cast<std::int64_t>(value);
  }

private:
  static constexpr unsigned MostBits = 33;

  unsigned Before = 0;
  std::array<BitTree<6>, MostBits / 4 + 1> Lengths;
  std::array<BitModel, MostBits + 1> Signs, Seconds;
};

/** Codes the merges of a block in runs of one round and error whose points ascend. */
class BlockCoder
{
public:
  BlockCoder(std::uint32_t left, MergeKind kind)
    : Left(left)
    , Kind(kind)
  {
  }

  template <typename Coder>
  void Code(Coder& coder, std::span<PlacedMerge> merges)
  {
    for (std::uint32_t key = 0; !merges.empty();)
    {
      const auto more = this->Runs.Code(coder, CountRun(merges) - 1);
      merges.front().BeginsRound = coder.Bit(this->Rounds, merges.front().BeginsRound) != 0;
      const auto growth = this->Growths.Code(coder, merges.front().Key - key);
      if (more >= merges.size())
      {
        ThrowCorrupt("there are too many merges of one error");
      }
      if (growth > InfinityKey - key)
      {
        ThrowCorrupt("the errors of merges do not ascend");
      }
      key += growth;
      const auto run = merges.first(std::size_t{ more } + 1);
      merges = merges.subspan(run.size());
      this->CodeRun(coder, run, key);
    }
  }

private:
  static std::uint32_t CountRun(std::span<const PlacedMerge> merges)
  {
    const auto end = std::adjacent_find(merges.begin(), merges.end(),
      [](const PlacedMerge& a, const PlacedMerge& b)
      { return b.BeginsRound || a.Key != b.Key || a.Point >= b.Point; });
    return static_cast<std::uint32_t>(end - merges.begin()) + (end == merges.end() ? 0 : 1);
  }

  template <typename Coder>
  void CodeRun(Coder& coder, std::span<PlacedMerge> run, std::uint32_t key)
  {
    const auto apart = this->Left / static_cast<std::uint32_t>(run.size());
    NumberModel& skipped = this->Skipped[static_cast<std::size_t>(std::bit_width(apart))];
    std::uint32_t next = 0;
    for (PlacedMerge& merge : run)
    {
      merge.Key = key;
      const auto more = skipped.Code(coder, merge.Point - next);
      // Unsigned, as a damaged stream may say anything.
      const auto point = std::uint64_t{ next } + more;
      const auto distance =
        this->Distances.Code(coder, static_cast<std::int64_t>(merge.Into) - merge.Point);
      const auto into = point + static_cast<std::uint64_t>(distance);
      if (point >= this->Left || into >= this->Left)
      {
        ThrowCorrupt("a point is merged into one that does not exist");
      }
      merge.Point = static_cast<std::uint32_t>(point);
      merge.Into = static_cast<std::uint32_t>(into);
      next = merge.Point + 1;
      if (this->Kind == MergeKind::Surface)
      {
        merge.IsBound = coder.Bit(this->Bonds, merge.IsBound) != 0;
      }
    }
  }

  std::uint32_t Left;
  MergeKind Kind;
  NumberModel Runs, Growths;
  std::array<NumberModel, 33> Skipped;
  DistanceModel Distances;
  BitModel Rounds, Bonds;
};

/** The points that are left when a section begins, ascending. */
class PointsLeft
{
public:
  explicit PointsLeft(std::uint32_t points)
    : Points(points)
    , IsGone(points, false)
  {
    std::iota(this->Points.begin(), this->Points.end(), 0u);
  }

  /** Returns whether a section begins with a block. */
  bool Begin(const Block& block)
  {
    const bool begins = block.First + block.Left == this->IsGone.size();
    if (begins)
    {
      std::erase_if(this->Points, [this](std::uint32_t point) { return this->IsGone[point]; });
    }
    return begins;
  }

  void Remove(std::uint32_t point) { this->IsGone[point] = true; }

  const std::vector<std::uint32_t>& Get() const { return this->Points; }

private:
  std::vector<std::uint32_t> Points;
  std::vector<bool> IsGone;
};

/** The merges with the places of their points. */
std::vector<PlacedMerge> PlaceMerges(
  const MergeTree& tree, const std::vector<Block>& blocks, std::uint32_t points)
{
  std::vector<PlacedMerge> placed;
  PointsLeft left(points);
  std::vector<std::uint32_t> places(points);
  auto round = tree.GetRounds().begin();
  for (const Block& block : blocks)
  {
    if (left.Begin(block))
    {
      for (std::uint32_t i = 0; i < block.Left; ++i)
      {
        places[left.Get()[i]] = i;
      }
    }
    for (auto i = block.First; i < block.First + block.Count; ++i)
    {
      const Merge& merge = tree.GetMerges()[i];
      const bool isBound = !tree.GetBonds().empty() && tree.GetBonds()[i];
      const bool begins = round != tree.GetRounds().end() && *round == i;
      placed.push_back(
        { places[merge.Point], places[merge.Into], ToKey(merge.Error), begins, isBound });
      round += begins ? 1 : 0;
      left.Remove(merge.Point);
    }
  }
  return placed;
}

/** The part of the merges of a block. */
std::span<PlacedMerge> GetMerges(std::vector<PlacedMerge>& merges, const Block& block)
{
  return std::span(merges).subspan(block.First, block.Count);
}

/** The first merge of each round; none if the first merge begins none. */
std::vector<std::uint32_t> FindRounds(const std::vector<PlacedMerge>& merges)
{
  std::vector<std::uint32_t> rounds;
  for (std::uint32_t i = 0; i < merges.size() && merges.front().BeginsRound; ++i)
  {
    if (merges[i].BeginsRound)
    {
      rounds.push_back(i);
    }
  }
  return rounds;
}

/** The rounds of both; none if they are unknown. */
std::vector<std::uint32_t> JoinRounds(const MergeTree& first, const MergeTree& rest)
{
  const auto isUnknown = [](const MergeTree& tree)
  { return tree.GetRounds().empty() && !tree.GetMerges().empty(); };
  if (isUnknown(first) || isUnknown(rest))
  {
    return {};
  }
  auto rounds = first.GetRounds();
  for (const auto round : rest.GetRounds())
  {
    rounds.push_back(round + static_cast<std::uint32_t>(first.GetMerges().size()));
  }
  return rounds;
}

/** The streams of blocks, with their lengths before them. */
std::vector<std::span<const std::uint8_t>> FindStreams(
  std::span<const std::uint8_t> stream, std::size_t blocks)
{
  ByteReader in(stream);
  std::vector<std::span<const std::uint8_t>> streams(blocks);
  std::vector<std::uint64_t> lengths(blocks);
  for (auto& length : lengths)
  {
    length = in.GetVarint();
  }
  for (std::size_t i = 0; i < blocks; ++i)
  {
    streams[i] = in.GetBytes(lengths[i]);
  }
  return streams;
}
}

//------------------------------------------------------------------------------
Bytes EncodeMerges(const MergeTree& tree, std::uint32_t points, std::size_t merges, MergeKind kind)
{
  const auto blocks = MakeBlocks(points, static_cast<std::uint32_t>(merges));
  auto placed = PlaceMerges(tree, blocks, points);
  std::vector<Bytes> streams(blocks.size());
  ParallelFor(blocks.size(),
    [&](std::size_t i)
    {
      EntropyEncoder coder;
      BlockCoder(blocks[i].Left, kind).Code(coder, GetMerges(placed, blocks[i]));
      streams[i] = coder.Finish();
    });
  ByteWriter out;
  for (const Bytes& stream : streams)
  {
    out.PutVarint(stream.size());
  }
  for (const Bytes& stream : streams)
  {
    out.PutBytes(stream);
  }
  out.Data.resize(std::max(out.Data.size(), merges / MergesPerByte));
  return std::move(out.Data);
}

//------------------------------------------------------------------------------
MergeTree DecodeMerges(
  std::span<const std::uint8_t> stream, std::uint32_t points, std::uint32_t merges, MergeKind kind)
{
  if (merges > points)
  {
    ThrowCorrupt("there are more merges than points");
  }
  if (merges / MergesPerByte > stream.size())
  {
    ThrowCorrupt("there are more merges than their stream can hold");
  }
  const auto blocks = MakeBlocks(points, merges);
  const auto streams = FindStreams(stream, blocks.size());
  std::vector<PlacedMerge> placed(merges);
  ParallelFor(blocks.size(),
    [&](std::size_t i)
    {
      EntropyDecoder coder(streams[i]);
      BlockCoder(blocks[i].Left, kind).Code(coder, GetMerges(placed, blocks[i]));
    });
  std::vector<Merge> list;
  list.reserve(merges);
  std::vector<bool> isBound;
  PointsLeft left(points);
  std::uint32_t key = 0;
  for (const Block& block : blocks)
  {
    left.Begin(block);
    if (block.Left != left.Get().size())
    {
      ThrowCorrupt("a point is merged twice");
    }
    for (const PlacedMerge& merge : GetMerges(placed, block))
    {
      if (merge.Key < key)
      {
        ThrowCorrupt("the errors of merges do not ascend");
      }
      key = merge.Key;
      const auto point = left.Get()[merge.Point];
      list.push_back({ point, left.Get()[merge.Into], std::bit_cast<float>(merge.Key << 16) });
      left.Remove(point);
      isBound.push_back(merge.IsBound);
    }
  }
  const bool hasBonds = std::find(isBound.begin(), isBound.end(), true) != isBound.end();
  return MakeTree(points, std::move(list), hasBonds ? std::move(isBound) : std::vector<bool>(),
    FindRounds(placed));
}

//------------------------------------------------------------------------------
Bytes EncodePointMap(std::span<const std::uint32_t> numbers)
{
  EntropyEncoder coder;
  DistanceModel steps;
  std::int64_t next = 0;
  for (const auto number : numbers)
  {
    steps.Code(coder, number - next);
    next = std::int64_t{ number } + 1;
  }
  return coder.Finish();
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> DecodePointMap(
  std::span<const std::uint8_t> stream, std::uint32_t points)
{
  EntropyDecoder coder(stream);
  DistanceModel steps;
  std::vector<std::uint32_t> numbers;
  std::vector<bool> isThere(points, false);
  std::uint64_t next = 0; // unsigned, as a damaged stream may say anything
  for (std::uint32_t i = 0; i < points; ++i)
  {
    const auto number = next + static_cast<std::uint64_t>(steps.Code(coder, 0));
    if (number >= points || isThere[static_cast<std::size_t>(number)])
    {
      ThrowCorrupt("the numbers of points are not those of a base mesh");
    }
    isThere[static_cast<std::size_t>(number)] = true;
    numbers.push_back(static_cast<std::uint32_t>(number));
    next = number + 1;
  }
  return numbers;
}

//------------------------------------------------------------------------------
MergeTree JoinMerges(
  const MergeTree& first, const MergeTree& rest, std::span<const std::uint32_t> map)
{
  const auto points = first.GetNumberOfPoints();
  std::vector<bool> isGone(points, false);
  auto merges = first.GetMerges();
  for (const Merge& merge : merges)
  {
    isGone[merge.Point] = true;
  }
  std::vector<std::uint32_t> numbers(rest.GetNumberOfPoints()); // of the points of the rest
  auto number = map.begin();
  for (std::uint32_t point = 0; point < points; ++point)
  {
    if (!isGone[point])
    {
      numbers[*number++] = point;
    }
  }
  const auto last = merges.empty() ? 0.0f : merges.back().Error;
  merges.reserve(merges.size() + rest.GetMerges().size());
  for (const Merge& merge : rest.GetMerges())
  {
    merges.push_back({ numbers[merge.Point], numbers[merge.Into], merge.Error });
  }
  if (first.GetMerges().size() < merges.size() && merges[first.GetMerges().size()].Error < last)
  {
    ThrowCorrupt("the errors of merges do not ascend");
  }
  std::vector<bool> isBound;
  if (!first.GetBonds().empty() || !rest.GetBonds().empty())
  {
    isBound = first.GetBonds();
    isBound.resize(first.GetMerges().size(), false);
    isBound.insert(isBound.end(), rest.GetBonds().begin(), rest.GetBonds().end());
    isBound.resize(merges.size(), false);
  }
  return MakeTree(points, std::move(merges), std::move(isBound), JoinRounds(first, rest));
}
}
