// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyOrder_h
#define gatunHartleyOrder_h

#include "gatunHartleyLayout.h"
#include "gatunLargeArray.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * The order in which the coefficients of a block are coded: by the length of the frequency, grouped
 * into shells; within a shell by index, each followed by its opposite frequency. Immutable.
 */
class HartleyOrder
{
public:
  static constexpr unsigned Bands = 16; ///< at most; groups of shells. The first is frequency 0
  static constexpr std::uint32_t SegmentLength = 1u << 18; ///< of long blocks; coded independently

  struct Position
  {
    std::uint32_t Index;              ///< as in HartleyTransform
    std::uint32_t Partner;            ///< index of the opposite frequency
    std::array<std::int16_t, 3> Wave; ///< the frequency, in periods of the block
    std::uint8_t Band;
    std::uint8_t Flags;
  };

  // Flags: the values that precede this one in the same segment. KnowsInner << axis: that of the
  // next lower frequency along an axis; KnowsInnerPartner << axis: the partner of that.
  static constexpr unsigned KnowsInner = 1;
  static constexpr std::uint8_t KnowsPartner = 8;
  static constexpr unsigned KnowsInnerPartner = 16;

  /** Parallel. */
  explicit HartleyOrder(const HartleyLayout::Triple& block);

  std::span<const Position> GetPositions() const { return this->Positions; }

  /** The first position of each band; the last entry is the end. */
  const std::vector<std::uint32_t>& GetBandStarts() const { return this->BandStarts; }

  std::size_t GetNumberOfSegments() const
  {
    return (this->Positions.size() + SegmentLength - 1) / SegmentLength;
  }

  /** The offset from an index to that of the next lower frequency along an axis. */
  std::ptrdiff_t GetStepInwards(unsigned axis, std::int32_t wave) const
  {
    return wave > 0 ? -this->Strides[axis] : wave < -1 ? this->Strides[axis] : this->Wraps[axis];
  }

  /** Fetches the values of a block that belong to the coding of a position. Neighbors in a shell
   * are far from each other in the memory of a large block. */
  template <typename Value>
  void Prefetch(const Value* block, std::size_t rank) const
  {
    const Position& position = this->Positions[rank];
    const Value* const own = block + position.Index;
    const Value* const partner = block + position.Partner;
    __builtin_prefetch(own);
    __builtin_prefetch(partner);
    for (unsigned axis = 1; axis < 3; ++axis) // along x they are close
    {
      if (position.Flags & (KnowsInner << axis))
      {
        __builtin_prefetch(own + this->GetStepInwards(axis, position.Wave[axis]));
        __builtin_prefetch(partner + this->GetStepInwards(axis, -position.Wave[axis]));
      }
    }
  }

private:
  class Builder;

  std::uint32_t GetCount() const { return static_cast<std::uint32_t>(this->Positions.size()); }

  LargeArray<Position> Positions;
  std::vector<std::uint32_t> BandStarts;
  std::array<std::ptrdiff_t, 3> Strides{};
  std::array<std::ptrdiff_t, 3> Wraps{}; ///< from the last index along an axis to the first
};
}

#endif
