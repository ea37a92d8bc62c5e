// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSharedNames_h
#define gatunSharedNames_h

#include "gatunEntropy.h"
#include "gatunNumberModel.h"
#include "gatunSharedSearch.h"

#include <array>
#include <cstdint>

namespace gatun
{
/** Names shared vertices by their ranks around a place. */
class SharedNames
{
public:
  /** limit: of the squared distance. Returns the index of the shared vertex. */
  template <typename Coder>
  std::uint32_t Code(Coder& coder, SharedSearch& search, const LatticePoint& place, float limit,
    std::uint32_t target)
  {
    const auto rank = [](const Vec3x4&, Float4 distances) { return distances; };
    search.Begin(ToVector(place), limit, rank);
    for (auto& model : this->Ranks)
    {
      const auto index = search.TakeNext();
      if (index == NoVertex)
      {
        break;
      }
      if (coder.Bit(model, index == target))
      {
        return index;
      }
    }
    return CodeIndex(coder, target, search.GetSize());
  }

private:
  std::array<BitModel, SharedSearch::Most> Ranks;
};
}

#endif
