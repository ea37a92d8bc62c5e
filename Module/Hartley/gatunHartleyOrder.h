// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyOrder_h
#define gatunHartleyOrder_h

#include "gatunHartleyLayout.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * The order in which the coefficients of a block are coded: by shells of the frequency's length, in
 * a shell by index, but for the opposite frequency, which comes right behind. Immutable.
 */
class HartleyOrder
{
public:
  static constexpr unsigned Bands = 16; ///< at most; groups of shells, the first with frequency 0
  static constexpr std::uint32_t SegmentLength = 1u << 18; ///< of long blocks; coded by themselves

  struct Position
  {
    std::uint32_t Index = 0;            ///< as HartleyTransform has it
    std::uint32_t Partner = 0;          ///< index of the opposite frequency
    std::array<std::int32_t, 3> Wave{}; ///< the frequency, in periods of the block
    std::uint8_t Band = 0;
    std::uint8_t Flags = 0;
  };

  // Flags: which other values have been coded before, in the same segment. Bits 0 to 2: that at the
  // frequency one lower along each axis; bits 4 to 6: the partner of that.
  static constexpr std::uint8_t KnowsPartner = 8;

  explicit HartleyOrder(const HartleyLayout::Triple& block);

  const std::vector<Position>& GetPositions() const { return this->Positions; }

  /** Where a band begins; one more for the end. */
  const std::vector<std::uint32_t>& GetBandStarts() const { return this->BandStarts; }

  std::size_t GetNumberOfSegments() const
  {
    return (this->Positions.size() + SegmentLength - 1) / SegmentLength;
  }

  /** How far it is from an index to that of the frequency that is one lower along an axis. */
  std::ptrdiff_t GetStepInwards(unsigned axis, std::int32_t wave) const
  {
    return wave > 0 ? -this->Strides[axis] : wave < -1 ? this->Strides[axis] : this->Wraps[axis];
  }

private:
  std::vector<Position> Positions;
  std::vector<std::uint32_t> BandStarts;
  std::array<std::ptrdiff_t, 3> Strides{};
  std::array<std::ptrdiff_t, 3> Wraps{}; ///< from the last index along an axis to the first
};
}

#endif
