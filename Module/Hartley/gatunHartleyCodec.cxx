// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyCodec.h"

#include "gatunEntropy.h"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <vector>

namespace gatun
{
namespace
{
using Triple = HartleyLayout::Triple;
using Position = HartleyOrder::Position;

constexpr std::uint64_t LargestCounted = std::uint64_t{ 1 } << 36;
constexpr unsigned Levels = 4 + 4 * 38;
constexpr unsigned Escapes = 64;
constexpr unsigned LastSymbol = SymbolModel::Symbols - 1;

// How much each kind of neighbour counts for the size that is expected.
constexpr unsigned WeightOfPartner = 4;
constexpr unsigned WeightOfInner = 6;
constexpr unsigned WeightOfBlock = 1;
constexpr unsigned WeightOfRamp = 6;
constexpr unsigned LargestWeight =
  WeightOfPartner + 3 * 2 * (WeightOfInner + WeightOfBlock) + WeightOfRamp;

// The mean of a position in the blocks before: how much of it is in the size that is expected, in
// sixteenths, and how slowly it changes.
constexpr std::uint64_t PartOfRunning = 2;
constexpr std::int64_t BlocksOfRunning = 16;

// Blocks of this many values or more tell exactly where their last one is that is not 0.
constexpr std::size_t LongBlock = 1u << 15;

std::uint64_t GetSize(std::int64_t value)
{
  return value < 0 ? ~static_cast<std::uint64_t>(value) + 1 : static_cast<std::uint64_t>(value);
}

std::uint64_t Count(std::int64_t value)
{
  return std::min(GetSize(value), LargestCounted);
}

/** A class for a mean in sixteenths; four to an octave. */
unsigned GetLevel(std::uint64_t mean)
{
  if (mean < 4)
  {
    return static_cast<unsigned>(mean);
  }
  const auto width = static_cast<unsigned>(std::bit_width(mean));
  const auto level = 4 * (width - 2) + static_cast<unsigned>((mean >> (width - 3)) & 3);
  return std::min(level, Levels - 1);
}

/** How likely sizes from 1 on are where a mean was expected. */
struct SizeModels
{
  std::array<SymbolModel, Levels> Symbols;
  std::array<BitModel, Escapes> Escape;
};

/** A size from 1 to 2^62. */
template <typename Coder>
std::uint64_t CodeSize(Coder& coder, SizeModels& models, std::uint64_t mean, std::uint64_t size)
{
  const auto width = static_cast<unsigned>(std::bit_width(mean >> 4));
  const unsigned shift = width > 3 ? width - 3 : 0;
  const std::uint64_t rest = size - 1;
  const std::uint64_t part = rest >> shift;
  const auto symbol = coder.Symbol(models.Symbols[GetLevel(mean)],
    static_cast<unsigned>(std::min<std::uint64_t>(part, LastSymbol)));
  std::uint64_t coded = symbol;
  if (symbol == LastSymbol)
  {
    // How many binary digits there are beyond, and what they are.
    const std::uint64_t beyond = part - LastSymbol + 1;
    const auto digits = static_cast<unsigned>(std::bit_width(beyond));
    unsigned count = 1;
    while (coder.Bit(models.Escape[count], count < digits))
    {
      if (++count == Escapes)
      {
        ThrowCorrupt("a coefficient is too large");
      }
    }
    const std::uint64_t top = std::uint64_t{ 1 } << (count - 1);
    coded = LastSymbol - 1 + (top | coder.Raw(beyond & (top - 1), count - 1));
  }
  const auto low = coder.Raw(rest & ((std::uint64_t{ 1 } << shift) - 1), shift);
  if (coded > (static_cast<std::uint64_t>(LargestHartleyInteger) >> shift))
  {
    ThrowCorrupt("a coefficient is too large");
  }
  return ((coded << shift) | low) + 1;
}

// 1 / n in units of 2^-16.
constexpr auto Reciprocals = []
{
  std::array<std::uint32_t, LargestWeight + 1> values{};
  for (std::uint32_t n = 1; n < values.size(); ++n)
  {
    values[n] = (65536 + n / 2) / n;
  }
  return values;
}();

/** Codes blocks, or a segment of one; the encoder and the decoder in one. */
template <typename Coder, typename Integer>
class Walk
{
public:
  Walk(Coder& coder, const HartleyOrder& order, const Triple& grid, std::span<Integer> integers)
    : Code(coder)
    , Order(order)
    , Grid(grid)
    , Integers(integers)
    , BlockLength(order.GetPositions().size())
    , Blocks(std::size_t{ grid[0] } * grid[1] * grid[2])
    , Models(std::make_unique<ModelSet>())
  {
  }

  void CodeBlocks()
  {
    this->CodeMeans();
    this->CodeEnds();
    this->Running.assign(this->Blocks > 1 ? this->BlockLength : 0, 0);
    std::size_t block = 0;
    for (std::uint32_t z = 0; z < this->Grid[2]; ++z)
    {
      for (std::uint32_t y = 0; y < this->Grid[1]; ++y)
      {
        for (std::uint32_t x = 0; x < this->Grid[0]; ++x, ++block)
        {
          this->SetBlock({ x, y, z }, block);
          for (std::size_t rank = 1; rank < this->Ends[block]; ++rank)
          {
            this->CodeValue(rank);
          }
        }
      }
    }
  }

  void CodeSegment(std::size_t segment)
  {
    const std::size_t begin = segment * HartleyOrder::SegmentLength;
    const std::size_t end =
      std::min<std::size_t>(begin + HartleyOrder::SegmentLength, this->BlockLength);
    const auto last = this->CodeLast(this->Integers, begin, end);
    this->Block = this->Integers.data();
    for (auto rank = begin; rank < last; ++rank)
    {
      this->CodeValue(rank);
    }
  }

private:
  struct ModelSet
  {
    std::array<SymbolModel, 2 * (HartleyOrder::Bands + 1)> End;
    std::array<std::array<BitModel, Levels>, 12> Zero;
    SizeModels Size;
    std::array<std::array<BitModel, 16>, 16> Sign;
    std::array<BitModel, Levels> MeanZero;
    SizeModels MeanSize;
    std::array<BitModel, 3> MeanSign;
  };

  std::span<Integer> GetBlock(std::size_t block) const
  {
    return this->Integers.subspan(block * this->BlockLength, this->BlockLength);
  }

  Integer& GetMean(std::size_t block) const { return this->Integers[block * this->BlockLength]; }

  //------------------------------------------------------------------------------------------------
  /** The values of frequency 0, from those of the blocks before along each axis. */
  void CodeMeans()
  {
    const std::size_t row = this->Grid[0];
    const std::size_t layer = row * this->Grid[1];
    std::size_t block = 0;
    for (std::uint32_t z = 0; z < this->Grid[2]; ++z)
    {
      for (std::uint32_t y = 0; y < this->Grid[1]; ++y)
      {
        for (std::uint32_t x = 0; x < this->Grid[0]; ++x, ++block)
        {
          std::array<std::int64_t, 3> near{};
          unsigned count = 0;
          std::int64_t sum = 0;
          const auto add = [&](bool there, std::size_t distance)
          {
            if (there)
            {
              near[count] = this->GetMean(block - distance);
              sum += near[count];
              ++count;
            }
          };
          add(x > 0, 1);
          add(y > 0, row);
          add(z > 0, layer);
          std::int64_t guess = 0;
          std::uint64_t spread = 64;
          if (count > 0)
          {
            const auto [least, most] = std::minmax_element(near.begin(), near.begin() + count);
            spread = GetSize(*most - *least);
            guess = sum / count;
            if (count == 3)
            {
              const auto diagonal = this->GetMean(block - 1 - row) +
                this->GetMean(block - 1 - layer) + this->GetMean(block - row - layer);
              guess = std::clamp((2 * sum - diagonal) / 3, *least, *most);
            }
            else if (count == 2)
            {
              const auto diagonal = this->GetMean(x == 0 ? block - row - layer
                  : y == 0                               ? block - 1 - layer
                                                         : block - 1 - row);
              guess = std::clamp(sum - diagonal, *least, *most);
            }
            spread += GetSize(guess) >> 5;
          }
          this->CodeMean(block, guess, 8 * std::min(spread, LargestCounted));
        }
      }
    }
  }

  void CodeMean(std::size_t block, std::int64_t guess, std::uint64_t mean)
  {
    std::int64_t difference = Coder::Encoding ? this->GetMean(block) - guess : 0;
    auto& models = *this->Models;
    if (this->Code.Bit(models.MeanZero[GetLevel(mean)], difference != 0))
    {
      const bool negative = this->Code.Bit(models.MeanSign[guess > 0], difference < 0);
      const auto size =
        static_cast<std::int64_t>(CodeSize(this->Code, models.MeanSize, mean, GetSize(difference)));
      difference = negative ? -size : size;
    }
    if constexpr (!Coder::Encoding)
    {
      const auto value = static_cast<std::int64_t>(
        static_cast<std::uint64_t>(guess) + static_cast<std::uint64_t>(difference));
      if (GetSize(value) > static_cast<std::uint64_t>(LargestHartleyInteger) / 8)
      {
        ThrowCorrupt("a mean is too large");
      }
      this->GetMean(block) = value;
    }
  }

  //------------------------------------------------------------------------------------------------
  /** Behind which position all values of each block are 0. */
  void CodeEnds()
  {
    this->Ends.resize(this->Blocks);
    if (this->BlockLength >= LongBlock)
    {
      for (std::size_t block = 0; block < this->Blocks; ++block)
      {
        this->Ends[block] = this->CodeLast(this->GetBlock(block), 1, this->BlockLength);
      }
      return;
    }
    const std::size_t row = this->Grid[0];
    const std::size_t layer = row * this->Grid[1];
    std::vector<std::uint8_t> bands(this->Blocks);
    std::size_t block = 0;
    for (std::uint32_t z = 0; z < this->Grid[2]; ++z)
    {
      for (std::uint32_t y = 0; y < this->Grid[1]; ++y)
      {
        for (std::uint32_t x = 0; x < this->Grid[0]; ++x, ++block)
        {
          unsigned count = 0;
          unsigned sum = 0;
          const auto add = [&](bool there, std::size_t distance)
          {
            count += there;
            sum += there ? bands[block - distance] : 0;
          };
          add(x > 0, 1);
          add(y > 0, row);
          add(z > 0, layer);
          const unsigned near = count == 0 ? HartleyOrder::Bands : (2 * sum + count) / (2 * count);
          auto& model = this->Models->End[2 * near + (this->GetMean(block) == 0)];
          bands[block] = static_cast<std::uint8_t>(
            this->Code.Symbol(model, Coder::Encoding ? this->FindLastBand(block) : 0));
          const auto& starts = this->Order.GetBandStarts();
          if (bands[block] + 2u > starts.size())
          {
            ThrowCorrupt("a block has more bands than there are");
          }
          this->Ends[block] = starts[bands[block] + 1u];
        }
      }
    }
  }

  unsigned FindLastBand(std::size_t block) const
  {
    const auto values = this->GetBlock(block);
    const auto& positions = this->Order.GetPositions();
    std::size_t rank = this->BlockLength - 1;
    for (; rank > 0 && values[positions[rank].Index] == 0; --rank)
    {
    }
    return positions[rank].Band;
  }

  /** One more than the last position from begin to end that has a value. */
  std::size_t CodeLast(std::span<Integer> values, std::size_t begin, std::size_t end)
  {
    std::size_t last = end;
    if constexpr (Coder::Encoding)
    {
      const auto& positions = this->Order.GetPositions();
      for (; last > begin && values[positions[last - 1].Index] == 0; --last)
      {
      }
    }
    const auto digits = static_cast<unsigned>(std::bit_width(end - begin));
    const auto length = static_cast<std::size_t>(this->Code.Raw(last - begin, digits));
    if (length > end - begin)
    {
      ThrowCorrupt("a block is longer than it can be");
    }
    return begin + length;
  }

  //------------------------------------------------------------------------------------------------
  void SetBlock(const Triple& place, std::size_t block)
  {
    this->Block = this->GetBlock(block).data();
    const std::array<std::size_t, 3> distances{ 1, this->Grid[0],
      std::size_t{ this->Grid[0] } * this->Grid[1] };
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const auto distance = distances[axis];
      this->Before[axis] = place[axis] > 0 ? this->Block - distance * this->BlockLength : nullptr;
      // How the mean changes along the axis, over two blocks.
      const bool hasNext = place[axis] + 1 < this->Grid[axis];
      const std::int64_t own = this->GetMean(block);
      const std::int64_t before = place[axis] > 0 ? this->GetMean(block - distance) : own;
      const std::int64_t next = hasNext ? this->GetMean(block + distance) : own;
      this->Slopes[axis] = next - before;
      if (place[axis] == 0 || !hasNext)
      {
        this->Slopes[axis] *= 2;
      }
    }
  }

  void CodeValue(std::size_t rank)
  {
    const Position& position = this->Order.GetPositions()[rank];
    const Integer* const own = this->Block + position.Index;
    const Integer* const partner = this->Block + position.Partner;
    auto& models = *this->Models;

    // What size is to be expected, from what is known: a weighted mean.
    std::uint64_t sum = 0;
    unsigned weight = 0;
    // What the value itself would be if its block were a ramp, in sixteenths.
    std::int64_t foretold = 0;
    if (position.Flags & HartleyOrder::KnowsPartner)
    {
      sum += WeightOfPartner * Count(*partner);
      weight += WeightOfPartner;
    }
    unsigned axes = 0;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const auto wave = position.Wave[axis];
      axes += wave != 0;
      if (position.Flags & (1u << axis))
      {
        const auto step = this->Order.GetStepInwards(axis, wave);
        const auto inner = static_cast<std::int64_t>(own[step]);
        const std::int64_t length = wave < 0 ? -wave : wave;
        if (length > 1)
        {
          sum += WeightOfInner * Count(inner);
          weight += WeightOfInner;
          foretold -= std::clamp<std::int64_t>(inner, -MostForetold, MostForetold) * 16 *
            (length - 1) / length;
          if (position.Flags & (16u << axis))
          {
            sum += WeightOfInner * Count(partner[this->Order.GetStepInwards(axis, -wave)]);
            weight += WeightOfInner;
          }
        }
      }
      if (const Integer* const before = this->Before[axis])
      {
        sum += WeightOfBlock * (Count(before[position.Index]) + Count(before[position.Partner]));
        weight += 2 * WeightOfBlock;
      }
    }
    if (axes == 1)
    {
      for (unsigned axis = 0; axis < 3; ++axis)
      {
        const auto wave = position.Wave[axis];
        if (wave != 0)
        {
          const std::int64_t length = wave < 0 ? -wave : wave;
          const auto slope =
            std::clamp<std::int64_t>(this->Slopes[axis], -MostForetold, MostForetold) * 163 /
            (128 * length);
          foretold += (length % 2 != 0) == (wave > 0) ? slope : -slope;
        }
      }
      sum += WeightOfRamp * (GetSize(foretold) / 16);
      weight += WeightOfRamp;
    }
    std::uint64_t mean = (sum * Reciprocals[weight]) >> 12;
    unsigned trend = 0; // whether this position used to have smaller or larger values than that
    if (!this->Running.empty())
    {
      const auto running = this->Running[rank];
      mean = ((16 - PartOfRunning) * mean + PartOfRunning * running) / 16;
      trend = running > 2 * mean + 4 ? 2 : 2 * running + 4 < mean ? 1 : 0;
    }

    const auto value = Coder::Encoding ? static_cast<std::int64_t>(*own) : 0;
    const auto level = GetLevel(mean);
    const bool second = position.Flags & HartleyOrder::KnowsPartner;
    std::int64_t coded = 0;
    if (this->Code.Bit(models.Zero[4 * trend + 2 * second + (axes > 1)][level], value != 0))
    {
      const unsigned strength =
        std::min<unsigned>(7, static_cast<unsigned>(std::bit_width(GetSize(foretold) >> 1)));
      const bool down = foretold < 0;
      // Opposite frequencies of a ramp have opposite signs.
      const auto other = second ? static_cast<std::int64_t>(*partner) : 0;
      const unsigned relation = other == 0 ? 0 : (other < 0) == down ? 1 : 2;
      const bool negative =
        this->Code.Bit(models.Sign[4 * axes + relation][strength], (value < 0) != down) != down;
      const auto size =
        static_cast<std::int64_t>(CodeSize(this->Code, models.Size, mean, GetSize(value)));
      coded = negative ? -size : size;
      if constexpr (!Coder::Encoding)
      {
        this->Block[position.Index] = coded;
      }
    }
    if (!this->Running.empty())
    {
      auto& running = this->Running[rank];
      running = static_cast<std::uint64_t>(static_cast<std::int64_t>(running) +
        (static_cast<std::int64_t>(16 * Count(coded)) - static_cast<std::int64_t>(running)) /
          BlocksOfRunning);
    }
  }

  static constexpr std::int64_t MostForetold = std::int64_t{ 1 } << 40;

  Coder& Code;
  const HartleyOrder& Order;
  Triple Grid;
  std::span<Integer> Integers;
  std::size_t BlockLength;
  std::size_t Blocks;
  std::unique_ptr<ModelSet> Models;
  std::vector<std::size_t> Ends;
  std::vector<std::uint64_t> Running; ///< mean sizes of a position in the blocks so far, sixteenths
  Integer* Block = nullptr;
  std::array<const Integer*, 3> Before{};
  std::array<std::int64_t, 3> Slopes{};
};
}

//--------------------------------------------------------------------------------------------------
Bytes EncodeHartleyBlocks(
  const HartleyOrder& order, const Triple& grid, std::span<const std::int64_t> integers)
{
  EntropyEncoder coder;
  Walk<EntropyEncoder, const std::int64_t>(coder, order, grid, integers).CodeBlocks();
  return coder.Finish();
}

//--------------------------------------------------------------------------------------------------
void DecodeHartleyBlocks(const HartleyOrder& order, const Triple& grid,
  std::span<const std::uint8_t> stream, std::span<std::int64_t> integers)
{
  EntropyDecoder coder(stream);
  Walk<EntropyDecoder, std::int64_t>(coder, order, grid, integers).CodeBlocks();
}

//--------------------------------------------------------------------------------------------------
std::size_t GetLeastHartleySegmentBytes(std::size_t blockLength, std::size_t segment)
{
  constexpr std::size_t positionsPerByte = 1024;
  const auto rest = blockLength - segment * std::size_t{ HartleyOrder::SegmentLength };
  return std::min<std::size_t>(rest, HartleyOrder::SegmentLength) / positionsPerByte;
}

//--------------------------------------------------------------------------------------------------
Bytes EncodeHartleySegment(
  const HartleyOrder& order, std::size_t segment, std::span<const std::int64_t> integers)
{
  EntropyEncoder coder;
  Walk<EntropyEncoder, const std::int64_t>(coder, order, { 1, 1, 1 }, integers)
    .CodeSegment(segment);
  return coder.Finish();
}

//--------------------------------------------------------------------------------------------------
void DecodeHartleySegment(const HartleyOrder& order, std::size_t segment,
  std::span<const std::uint8_t> stream, std::span<std::int64_t> integers)
{
  EntropyDecoder coder(stream);
  Walk<EntropyDecoder, std::int64_t>(coder, order, { 1, 1, 1 }, integers).CodeSegment(segment);
}
}
