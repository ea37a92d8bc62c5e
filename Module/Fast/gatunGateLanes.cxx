// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunGateLanes.h"

#include "gatunGateRule.h"
#include "gatunLanes.h"
#include "gatunNumberStream.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
/** As Float32Domain::FromNumber in each lane. */
GATUN_INLINE Int4 GetKeys(Float4 numbers)
{
  constexpr float largest = std::numeric_limits<float>::max();
  // NaN and infinity become 0.
  const Int4 isFinite = (numbers <= largest) & (numbers >= -largest);
  const Int4 bits = std::bit_cast<Int4>(numbers) & isFinite;
  return bits ^ ((bits >> 31) | std::numeric_limits<std::int32_t>::min());
}

/** As Float32Domain::ToNumber in each lane. */
GATUN_INLINE Float4 GetNumbers(Int4 keys)
{
  return std::bit_cast<Float4>(keys ^ ((~keys >> 31) | std::numeric_limits<std::int32_t>::min()));
}

/** Decodes Count components. */
template <std::size_t Count>
class LaneDecoder
{
public:
  LaneDecoder(ByteReader& in, const GateVertices& vertices, std::span<const KeyColumn> columns)
    : Vertices(vertices)
    , Columns(columns)
    , Own(FindOwn(vertices.Sources))
    , Numbers(vertices.Sources.size())
  {
    for (std::size_t c = 0; c < Count; ++c)
    {
      const auto rule = VertexRule::Read(in);
      const auto weights = ScaleWeights<float>(rule.Weights);
      for (std::size_t k = 0; k < GateSize; ++k)
      {
        this->Weights[k][c] = weights[k];
      }
      this->HasCopies = this->HasCopies || rule.Copies;
      this->Residuals[c].emplace(in, this->Own.size(), Bits, Bits + (rule.Copies ? GateSize : 0));
    }
  }

  void Decode()
  {
    if (this->Columns[0].Before)
    {
      this->TakeShared<true>();
      this->HasCopies ? this->DecodeOwn<true, true>() : this->DecodeOwn<false, true>();
    }
    else
    {
      this->TakeShared<false>();
      this->HasCopies ? this->DecodeOwn<true, false>() : this->DecodeOwn<false, false>();
    }
  }

private:
  static constexpr unsigned Bits = 32;

  template <bool Change>
  void TakeShared()
  {
    for (std::size_t v = 0; v < this->Numbers.size(); ++v)
    {
      if (IsOwn(this->Vertices.Sources[v]))
      {
        continue;
      }
      Int4 keys{};
      for (std::size_t c = 0; c < Count; ++c)
      {
        keys[c] = static_cast<std::int32_t>(this->Columns[c].First[v * this->Columns[c].Stride]);
      }
      this->Numbers[v] = GetNumbers(keys);
      if constexpr (Change)
      {
        this->Numbers[v] -= this->GetBefore(v);
      }
    }
  }

  GATUN_INLINE Float4 GetBefore(std::size_t v) const
  {
    Int4 keys{};
    for (std::size_t c = 0; c < Count; ++c)
    {
      keys[c] = static_cast<std::int32_t>(this->Columns[c].Before[v]);
    }
    return GetNumbers(keys);
  }

  /** Where a component's residuals are read. On the stack, because what is stored in keys could
   * otherwise change it for all that the compiler knows. */
  struct Cursor
  {
    const std::uint8_t* Length;
    BitReader Stored;

    template <bool Copies>
    GATUN_INLINE std::int32_t Get()
    {
      const unsigned length = *this->Length++;
      const unsigned stored = Copies ? length & (0u - (length <= Bits ? 1u : 0u)) : length;
      return static_cast<std::int32_t>(ToSigned(this->Stored.template GetNumber<Bits>(stored)));
    }
  };
  using Cursors = std::array<Cursor, Count>;

  template <std::size_t... Lane>
  Cursors GetCursors(std::index_sequence<Lane...>) const
  {
    return { Cursor{
      this->Residuals[Lane]->GetLengths(), this->Residuals[Lane]->GetBitReader() }... };
  }

  template <bool Copies, std::size_t... Lane>
  GATUN_INLINE static Int4 GetResiduals(Cursors& cursors, std::index_sequence<Lane...>)
  {
    return Int4{ cursors[Lane].template Get<Copies>()... };
  }

  /** Replaces keys by those of vertices of the gate, without branches, which are unpredictable
   * here. */
  template <std::size_t... Lane>
  GATUN_INLINE static Int4 Copy(Int4 keys, PackedTet gate, const Cursors& cursors,
    const std::array<KeyColumn, Count>& columns, std::index_sequence<Lane...>)
  {
    // The lengths that were read.
    const Int4 isCopy{ -static_cast<std::int32_t>(cursors[Lane].Length[-1] > Bits)... };
    const auto from = [gate](unsigned length)
    { return GetCorner(gate, (length - Bits - 1) % GateSize); };
    const Int4 others{ static_cast<std::int32_t>(
      columns[Lane].First[from(cursors[Lane].Length[-1]) * columns[Lane].Stride])... };
    return (others & isCopy) | (keys & ~isCopy);
  }

  template <bool Copies, bool Change>
  void DecodeOwn()
  {
    constexpr auto lanes = std::make_index_sequence<Count>();
    auto cursors = this->GetCursors(lanes);
    const auto weights = this->Weights;
    std::array<KeyColumn, Count> columns;
    std::copy(this->Columns.begin(), this->Columns.end(), columns.begin());
    Float4* const numbers = this->Numbers.data();
    for (const std::size_t v : this->Own)
    {
      const auto gate = this->Vertices.Gates[v];
      const Float4 before = Change ? this->GetBefore(v) : Float4{};
      Float4 number =
        ((weights[0] * numbers[GetCorner(gate, 0)] + weights[1] * numbers[GetCorner(gate, 1)]) +
          weights[2] * numbers[GetCorner(gate, 2)]) +
        weights[3] * numbers[GetCorner(gate, 3)];
      if constexpr (Change)
      {
        number = before + number;
      }
      // Unsigned, as keys wrap around.
      Int4 keys = std::bit_cast<Int4>(std::bit_cast<UInt4>(GetKeys(number)) +
        std::bit_cast<UInt4>(GetResiduals<Copies>(cursors, lanes)));
      if constexpr (Copies)
      {
        keys = Copy(keys, gate, cursors, columns, lanes);
      }
      numbers[v] = GetNumbers(keys);
      if constexpr (Change)
      {
        numbers[v] -= before;
      }
      for (std::size_t c = 0; c < Count; ++c)
      {
        columns[c].First[v * columns[c].Stride] = static_cast<std::uint32_t>(keys[c]);
      }
    }
  }

  const GateVertices& Vertices;
  const std::span<const KeyColumn> Columns;
  const std::vector<std::uint32_t> Own;
  std::array<Float4, GateSize> Weights{};
  std::array<std::optional<NumberReader>, Count> Residuals;
  bool HasCopies = false;
  std::vector<Float4> Numbers; // of all vertices, or changes; 0 of own ones that come later
};
}

//------------------------------------------------------------------------------
void GetVertexLanes(
  ByteReader& in, const GateVertices& vertices, std::span<const KeyColumn> columns)
{
  switch (columns.size())
  {
    case 1:
      LaneDecoder<1>(in, vertices, columns).Decode();
      break;
    case 2:
      LaneDecoder<2>(in, vertices, columns).Decode();
      break;
    case 3:
      LaneDecoder<3>(in, vertices, columns).Decode();
      break;
    case MostGateLanes:
      LaneDecoder<MostGateLanes>(in, vertices, columns).Decode();
      break;
    default:
      break;
  }
}
}
