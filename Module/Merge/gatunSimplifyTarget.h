// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSimplifyTarget_h
#define gatunSimplifyTarget_h

#include "gatunExport.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace gatun
{
class MergeTree;

/** A simplification target. */
struct SimplifyTarget
{
  enum KindType
  {
    Ratio,
    NumberOfPoints,
    RMSError
  };

  KindType Kind = Ratio;
  double Value = 0; ///< of this kind

  /** Whether the target is the whole mesh. */
  bool IsWholeMesh() const { return this->Kind == Ratio && this->Value == 0; }
};

/**
 * Number of merges that reach the target, for a mesh with a given number of points and of merges.
 * Calls getTree only if the kind of target needs it. Throws Error (InvalidInput) for a value
 * that is out of range or NaN.
 */
GATUN_EXPORT std::size_t CountMerges(const SimplifyTarget& target, std::uint64_t points,
  std::size_t most, const std::function<const MergeTree&()>& getTree);
}

#endif
