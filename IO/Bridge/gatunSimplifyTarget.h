// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSimplifyTarget_h
#define gatunSimplifyTarget_h

#include "vtkGatunIOModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <functional>

namespace gatun
{
class MergeTree;

/** How simple a mesh is to be, as vtkGatunSimplify and vtkGatunReader ask for it. */
struct SimplifyTarget
{
  enum KindType
  {
    Ratio = 0,
    Percent = 1,
    NumberOfPoints = 2,
    MaximumError = 3
  };

  int Kind = Ratio;
  double Value = 0; ///< of whatever kind
};

/**
 * How many merges lead there, of a mesh with so many points and so many merges at most. The tree is
 * asked for only where the kind needs it. Throws gatun::Error (InvalidInput) for values that make
 * no sense. Exported for the filters.
 */
VTKGATUNIO_EXPORT std::size_t CountMerges(const SimplifyTarget& target, std::uint64_t points,
  std::size_t most, const std::function<const MergeTree&()>& getTree);
}

#endif
