// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunLevelsOfDetail_h
#define gatunLevelsOfDetail_h

#include "gatunRaySource.h"
#include "vtkGatunCoreModule.h"

#include <cstdint>
#include <memory>

namespace gatun
{
/**
 * A mesh that can be drawn with any number of points, from all of them to the fewest.
 *
 * MakeSource is called by one thread at a time; the other methods may be called meanwhile.
 */
class VTKGATUNCORE_EXPORT LevelsOfDetail
{
public:
  virtual ~LevelsOfDetail() = default;

  virtual std::uint64_t GetNumberOfPoints() const = 0; ///< of the whole mesh
  virtual std::uint64_t GetFewestPoints() const = 0;   ///< it cannot be simpler

  /**
   * What is drawn with so many points, or as near to that as can be. Making it costs little against
   * its blocks, which are made when they are asked for, and kept up to a number of bytes. A source
   * must not be used by two threads at once; two sources may be used by a thread each.
   */
  virtual std::shared_ptr<RaySource> MakeSource(std::uint64_t points, std::uint64_t budget) = 0;

  /** About how many tetrahedra that has. */
  virtual std::uint64_t EstimateTets(std::uint64_t points) const = 0;
};
}

#endif
