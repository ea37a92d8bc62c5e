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

// Weights of the neighbors in the expected size.
constexpr unsigned WeightOfPartner = 4;
constexpr unsigned WeightOfInner = 6;
constexpr unsigned WeightOfBlock = 1;
constexpr unsigned WeightOfRamp = 6;
constexpr unsigned LargestWeight =
  WeightOfPartner + 3 * 2 * (WeightOfInner + WeightOfBlock) + WeightOfRamp;

// Means of sizes are fixed-point numbers in sixteenths.
constexpr unsigned MeanBits = 4;
constexpr std::uint64_t MeanUnit = 1u << MeanBits;

// The running mean of a position over the previous blocks: its weight in the expected size, in
// sixteenths, and the number of blocks that it averages.
constexpr std::uint64_t PartOfRunning = 2;
constexpr std::int64_t BlocksOfRunning = 16;

// A running mean that differs from the expected size by more than a factor of two and this, in
// sixteenths, selects other models.
constexpr std::uint64_t TrendMargin = 4;

// The lowest coefficient of a ramp divided by the difference of the means two blocks apart, in
// sixteenths: about 4 / pi.
constexpr std::int64_t RampNumerator = 163;
constexpr std::int64_t RampDenominator = 128;

// Classes of the size of a predicted value, for its sign.
constexpr unsigned SignStrengths = 8;

// Blocks of this many values or more store the exact position of their last nonzero value.
constexpr std::size_t LongBlock = 1u << 15;

std::uint64_t GetSize(std::int64_t value)
{
  return value < 0 ? ~static_cast<std::uint64_t>(value) + 1 : static_cast<std::uint64_t>(value);
}

std::uint64_t Count(std::int64_t value)
{
  return std::min(GetSize(value), LargestCounted);
}

/** The class of a mean in sixteenths; four classes per octave. */
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

/** Models of sizes from 1, for each expected mean. */
struct SizeModels
{
  std::array<SymbolModel, Levels> Symbols;
  std::array<BitModel, Escapes> Escape;
};

/** A size from 1 to 2^62. */
template <typename Coder>
std::uint64_t CodeSize(Coder& coder, SizeModels& models, std::uint64_t mean, std::uint64_t size)
{
  const auto width = static_cast<unsigned>(std::bit_width(mean >> MeanBits));
  const unsigned shift = width > 3 ? width - 3 : 0;
  const std::uint64_t rest = size - 1;
  const std::uint64_t part = rest >> shift;
  const auto symbol = coder.Symbol(models.Symbols[GetLevel(mean)],
    static_cast<unsigned>(std::min<std::uint64_t>(part, LastSymbol)));
  std::uint64_t coded = symbol;
  if (symbol == LastSymbol)
  {
    // The number of binary digits of the excess, and the digits.
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

// 1 / n in units of 2^-ReciprocalBits.
constexpr unsigned ReciprocalBits = 16;
constexpr auto Reciprocals = []
{
  constexpr std::uint32_t one = 1u << ReciprocalBits;
  std::array<std::uint32_t, LargestWeight + 1> values{};
  for (std::uint32_t n = 1; n < values.size(); ++n)
  {
    values[n] = (one + n / 2) / n;
  }
  return values;
}();

/** Codes blocks, or a segment of one block. One class for the encoder and the decoder. */
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
      this->Order.Prefetch(this->Block, std::min(rank + PrefetchedAhead, last - 1));
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

  //----------------------------------------------------------------------------
  /** Codes the values of frequency 0, predicted from those of the previous block along each axis.
   */
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

  //----------------------------------------------------------------------------
  /** Codes the position after which all values of a block are 0, for each block. */
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
    const auto positions = this->Order.GetPositions();
    std::size_t rank = this->BlockLength - 1;
    for (; rank > 0 && values[positions[rank].Index] == 0; --rank)
    {
    }
    return positions[rank].Band;
  }

  /** One more than the last position in [begin, end) with a nonzero value. */
  std::size_t CodeLast(std::span<Integer> values, std::size_t begin, std::size_t end)
  {
    std::size_t last = end;
    if constexpr (Coder::Encoding)
    {
      const auto positions = this->Order.GetPositions();
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

  //----------------------------------------------------------------------------
  void SetBlock(const Triple& place, std::size_t block)
  {
    this->Block = this->GetBlock(block).data();
    const std::array<std::size_t, 3> distances{ 1, this->Grid[0],
      std::size_t{ this->Grid[0] } * this->Grid[1] };
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const auto distance = distances[axis];
      this->Before[axis] = place[axis] > 0 ? this->Block - distance * this->BlockLength : nullptr;
      // The change of the mean along the axis, over two blocks.
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
    const Expectation expected = this->Expect(position, own, partner, rank);

    auto& models = *this->Models;
    const auto value = Coder::Encoding ? static_cast<std::int64_t>(*own) : 0;
    const auto level = GetLevel(expected.Mean);
    const bool second = position.Flags & HartleyOrder::KnowsPartner;
    std::int64_t coded = 0;
    if (this->Code.Bit(
          models.Zero[4 * expected.Trend + 2 * second + (expected.Axes > 1)][level], value != 0))
    {
      const auto other = second ? static_cast<std::int64_t>(*partner) : 0;
      const bool negative = this->CodeSign(expected, other, value < 0);
      const auto size =
        static_cast<std::int64_t>(CodeSize(this->Code, models.Size, expected.Mean, GetSize(value)));
      coded = negative ? -size : size;
      if constexpr (!Coder::Encoding)
      {
        this->Block[position.Index] = coded;
      }
    }
    if (!this->Running.empty())
    {
      auto& running = this->Running[rank];
      const auto size = static_cast<std::int64_t>(MeanUnit * Count(coded));
      running = static_cast<std::uint64_t>(static_cast<std::int64_t>(running) +
        (size - static_cast<std::int64_t>(running)) / BlocksOfRunning);
    }
  }

  /** The prediction of a value from those that are coded already. */
  struct Expectation
  {
    std::uint64_t Mean = 0;     ///< of the size, in sixteenths
    std::int64_t Predicted = 0; ///< the value if the block were a ramp, in sixteenths
    unsigned Axes = 0;          ///< along which the frequency is not 0
    unsigned Trend = 0;         ///< whether sizes at this position were smaller (1) or larger (2)
  };

  /** A weighted sum of sizes. */
  struct WeightedSum
  {
    std::uint64_t Sum = 0;
    unsigned Weight = 0;

    void Add(unsigned weight, std::uint64_t size)
    {
      this->Sum += weight * size;
      this->Weight += weight;
    }
  };

  Expectation Expect(
    const Position& position, const Integer* own, const Integer* partner, std::size_t rank) const
  {
    Expectation expected;
    WeightedSum sizes;
    if (position.Flags & HartleyOrder::KnowsPartner)
    {
      sizes.Add(WeightOfPartner, Count(*partner));
    }
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      expected.Axes += position.Wave[axis] != 0;
      if (position.Flags & (HartleyOrder::KnowsInner << axis))
      {
        this->AddInner(position, axis, own, partner, sizes, expected);
      }
      if (const Integer* const before = this->Before[axis])
      {
        sizes.Add(WeightOfBlock, Count(before[position.Index]));
        sizes.Add(WeightOfBlock, Count(before[position.Partner]));
      }
    }
    if (expected.Axes == 1)
    {
      expected.Predicted += this->PredictRamp(position);
      sizes.Add(WeightOfRamp, GetSize(expected.Predicted) / MeanUnit);
    }
    expected.Mean = (sizes.Sum * Reciprocals[sizes.Weight]) >> (ReciprocalBits - MeanBits);
    if (!this->Running.empty())
    {
      const auto running = this->Running[rank];
      expected.Mean =
        ((MeanUnit - PartOfRunning) * expected.Mean + PartOfRunning * running) / MeanUnit;
      expected.Trend = running > 2 * expected.Mean + TrendMargin ? 2
        : 2 * running + TrendMargin < expected.Mean              ? 1
                                                                 : 0;
    }
    return expected;
  }

  /** Adds the next lower frequencies along an axis. */
  void AddInner(const Position& position, unsigned axis, const Integer* own, const Integer* partner,
    WeightedSum& sizes, Expectation& expected) const
  {
    const auto wave = position.Wave[axis];
    const auto inner = static_cast<std::int64_t>(own[this->Order.GetStepInwards(axis, wave)]);
    const std::int64_t length = wave < 0 ? -wave : wave;
    if (length <= 1)
    {
      return;
    }
    sizes.Add(WeightOfInner, Count(inner));
    expected.Predicted -= std::clamp<std::int64_t>(inner, -MostPredicted, MostPredicted) *
      static_cast<std::int64_t>(MeanUnit) * (length - 1) / length;
    if (position.Flags & (HartleyOrder::KnowsInnerPartner << axis))
    {
      sizes.Add(WeightOfInner, Count(partner[this->Order.GetStepInwards(axis, -wave)]));
    }
  }

  /** The value at a frequency along one axis, in sixteenths, if the block were a ramp with the
   * slope of the neighboring means. */
  std::int64_t PredictRamp(const Position& position) const
  {
    std::int64_t predicted = 0;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const auto wave = position.Wave[axis];
      if (wave != 0)
      {
        const std::int64_t length = wave < 0 ? -wave : wave;
        const auto slope =
          std::clamp<std::int64_t>(this->Slopes[axis], -MostPredicted, MostPredicted) *
          RampNumerator / (RampDenominator * length);
        predicted += (length % 2 != 0) == (wave > 0) ? slope : -slope;
      }
    }
    return predicted;
  }

  /** Partner: the value at the opposite frequency, or 0. Returns whether the value is negative. */
  bool CodeSign(const Expectation& expected, std::int64_t partner, bool isNegative)
  {
    const unsigned strength = std::min<unsigned>(
      SignStrengths - 1, static_cast<unsigned>(std::bit_width(GetSize(expected.Predicted) >> 1)));
    const bool down = expected.Predicted < 0;
    // Opposite frequencies of a ramp have opposite signs.
    const unsigned relation = partner == 0 ? 0 : (partner < 0) == down ? 1 : 2;
    auto& model = this->Models->Sign[4 * expected.Axes + relation][strength];
    return this->Code.Bit(model, isNegative != down) != down;
  }

  static constexpr std::size_t PrefetchedAhead = 16;
  static constexpr std::int64_t MostPredicted = std::int64_t{ 1 } << 40;

  Coder& Code;
  const HartleyOrder& Order;
  Triple Grid;
  std::span<Integer> Integers;
  std::size_t BlockLength;
  std::size_t Blocks;
  std::unique_ptr<ModelSet> Models;
  std::vector<std::size_t> Ends;
  std::vector<std::uint64_t> Running; ///< running means of each position, in sixteenths
  Integer* Block = nullptr;
  std::array<const Integer*, 3> Before{};
  std::array<std::int64_t, 3> Slopes{};
};
}

//------------------------------------------------------------------------------
Bytes EncodeHartleyBlocks(
  const HartleyOrder& order, const Triple& grid, std::span<const std::int64_t> integers)
{
  EntropyEncoder coder;
  Walk<EntropyEncoder, const std::int64_t>(coder, order, grid, integers).CodeBlocks();
  return coder.Finish();
}

//------------------------------------------------------------------------------
void DecodeHartleyBlocks(const HartleyOrder& order, const Triple& grid,
  std::span<const std::uint8_t> stream, std::span<std::int64_t> integers)
{
  EntropyDecoder coder(stream);
  Walk<EntropyDecoder, std::int64_t>(coder, order, grid, integers).CodeBlocks();
}

//------------------------------------------------------------------------------
std::size_t GetLeastHartleySegmentBytes(std::size_t blockLength, std::size_t segment)
{
  constexpr std::size_t positionsPerByte = 1024;
  const auto rest = blockLength - segment * std::size_t{ HartleyOrder::SegmentLength };
  return std::min<std::size_t>(rest, HartleyOrder::SegmentLength) / positionsPerByte;
}

//------------------------------------------------------------------------------
Bytes EncodeHartleySegment(
  const HartleyOrder& order, std::size_t segment, std::span<const std::int64_t> integers)
{
  EntropyEncoder coder;
  Walk<EntropyEncoder, const std::int64_t>(coder, order, { 1, 1, 1 }, integers)
    .CodeSegment(segment);
  return coder.Finish();
}

//------------------------------------------------------------------------------
void DecodeHartleySegment(const HartleyOrder& order, std::size_t segment,
  std::span<const std::uint8_t> stream, std::span<std::int64_t> integers)
{
  EntropyDecoder coder(stream);
  Walk<EntropyDecoder, std::int64_t>(coder, order, { 1, 1, 1 }, integers).CodeSegment(segment);
}
}
