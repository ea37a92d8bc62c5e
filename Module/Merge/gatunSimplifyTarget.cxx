// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSimplifyTarget.h"

#include "gatunError.h"
#include "gatunMergeTree.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
//------------------------------------------------------------------------------
std::size_t CountMerges(const SimplifyTarget& target, std::uint64_t points, std::size_t most,
  const std::function<const MergeTree&()>& getTree)
{
  const auto all = static_cast<double>(points);
  const double value = target.Value;
  double left = all;
  switch (target.Kind)
  {
    case SimplifyTarget::Ratio:
      if (!(value >= 0 && value <= 1))
      {
        ThrowInvalid("the ratio must be from 0 to 1");
      }
      left = all - std::floor(all * value);
      break;
    case SimplifyTarget::NumberOfPoints:
      if (!(value >= 0))
      {
        ThrowInvalid("the number of points must be 0 or more");
      }
      left = std::min(value, all);
      break;
    default:
      if (!(value >= 0))
      {
        ThrowInvalid("the RMS error must be 0 or more");
      }
      return getTree().CountMergesForError(value);
  }
  return std::min(most, static_cast<std::size_t>(all - left));
}
}
