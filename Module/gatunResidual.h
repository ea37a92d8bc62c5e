// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunResidual_h
#define gatunResidual_h

#include "gatunEntropy.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace gatun
{
/** How large residuals are, relative to the spread of the values around, in one context. */
class ResidualModel
{
public:
  static constexpr int Classes = 32;
  static constexpr int ClassOfSpread = 20; // of a residual as long as the spread

  /**
   * Codes a residual: whether it is 0, its sign, its length in bits relative to spread (the length
   * of a typical difference), its second bit, and the rest as it is. Returns the residual.
   */
  template <typename Coder>
  std::int64_t Code(Coder& coder, unsigned spread, std::int64_t residual)
  {
    if (coder.Bit(this->Zero, residual == 0))
    {
      this->LastClass = -1;
      return 0;
    }
    const bool negative = coder.Bit(this->Sign, residual < 0);
    std::uint64_t magnitude = static_cast<std::uint64_t>(residual);
    if (Coder::Encoding && negative)
    {
      magnitude = 0 - magnitude;
    }
    auto length = static_cast<unsigned>(std::bit_width(magnitude));
    const auto relative = static_cast<int>(length) - static_cast<int>(spread) + ClassOfSpread;
    const auto wanted = static_cast<unsigned>(std::clamp(relative, 0, Classes - 1));
    unsigned node = 1;
    for (int level = 4; level >= 0; --level)
    {
      node = 2 * node + coder.Bit(this->Tree[node], (wanted >> level) & 1);
    }
    const unsigned size = node - Classes;
    if (size == 0 || size == Classes - 1)
    {
      length = static_cast<unsigned>(coder.Raw(length, 7));
    }
    else if (!Coder::Encoding)
    {
      length = size + spread - ClassOfSpread;
    }
    if (!Coder::Encoding && (length < 1 || length > 64))
    {
      ThrowCorrupt("a residual has an impossible length");
    }
    this->LastClass = static_cast<int>(size);
    if (length >= 2)
    {
      const unsigned low = length - 2;
      const std::uint64_t second =
        coder.Bit(this->Second[size], (magnitude >> low) & 1) ? std::uint64_t{ 1 } << low : 0;
      const std::uint64_t rest = coder.Raw(magnitude & ((std::uint64_t{ 1 } << low) - 1), low);
      magnitude = (std::uint64_t{ 1 } << (length - 1)) | second | rest;
    }
    else
    {
      magnitude = 1;
    }
    return static_cast<std::int64_t>(negative ? 0 - magnitude : magnitude);
  }

  /** Class of the residual last coded, -1 if it was 0. */
  int LastClass = -1;

private:
  BitModel Zero;
  BitModel Sign;
  std::array<BitModel, Classes> Tree;
  std::array<BitModel, Classes> Second;
};

/** Four grades of LastClass, which tell how well the next component may be predicted. */
inline unsigned GradeOf(int lastClass)
{
  return lastClass < 0 ? 0 : lastClass < 13 ? 1 : lastClass < 17 ? 2 : 3;
}
}

#endif
