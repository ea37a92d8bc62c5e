// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSharedSequence_h
#define gatunSharedSequence_h

#include "gatunEntropy.h"
#include "gatunNumberModel.h"

#include <cstdint>

namespace gatun
{
/** Names shared vertices by their distances from one another. */
class SharedSequence
{
public:
  template <typename Coder>
  std::uint32_t Code(Coder& coder, std::uint32_t target)
  {
    const auto expected = this->Last + 1;
    std::uint32_t index = expected;
    if (!coder.Bit(this->Follows, target == expected))
    {
      const bool back = coder.Bit(this->Back, target < expected);
      const auto distance =
        this->Distance.Code(coder, back ? expected - target : target - expected);
      index = back ? expected - distance : expected + distance;
    }
    this->Last = index;
    return index;
  }

private:
  BitModel Follows, Back;
  NumberModel Distance;
  std::uint32_t Last = 0xffffffff;
};
}

#endif
