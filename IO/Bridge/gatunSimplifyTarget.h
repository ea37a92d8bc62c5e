// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSimplifyTarget_h
#define gatunSimplifyTarget_h

#include "vtkGatunIOModule.h" // For export macro

#include "vtkIOStream.h"
#include "vtkIndent.h"
#include "vtkType.h"

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

/** The simplification properties of vtkGatunReader and vtkGatunSimplify. The target is the error
 * unless that is 0, then the number of points unless that is 0, then the ratio. */
struct VTKGATUNIO_EXPORT SimplifyProperties
{
  double Ratio;
  vtkIdType NumberOfPoints;
  double RMSError;

  SimplifyTarget GetTarget() const;

  /** For PrintSelf. */
  void Print(ostream& os, vtkIndent indent) const;
};

/**
 * Number of merges that reach the target, for a mesh with a given number of points and of merges.
 * Calls getTree only if the kind of target needs it. Throws gatun::Error (InvalidInput) for a value
 * that is out of range or NaN. Exported for the filters.
 */
VTKGATUNIO_EXPORT std::size_t CountMerges(const SimplifyTarget& target, std::uint64_t points,
  std::size_t most, const std::function<const MergeTree&()>& getTree);
}

#endif
