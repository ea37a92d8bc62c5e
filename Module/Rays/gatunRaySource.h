// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRaySource_h
#define gatunRaySource_h

#include "gatunExport.h"
#include "gatunRayBlock.h"
#include "gatunTypes.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace gatun
{
/** A mesh in blocks, which are made when they are requested. Not thread safe. */
class GATUN_EXPORT RaySource
{
public:
  /** Called with the fraction done; returns false to stop, and Error(Aborted) is thrown. */
  using Progress = std::function<bool(double)>;
  using Blocks = std::vector<std::shared_ptr<const RayBlock>>;

  virtual ~RaySource() = default;

  virtual std::size_t GetNumberOfBlocks() const = 0;
  virtual const Bounds& GetBounds(std::size_t block) const = 0;
  virtual Range GetRange(std::size_t block) const = 0; ///< of its values, without NaN

  /** Returns blocks that are ready for drawing, in the order of the request. */
  virtual Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) = 0;

  /** Seconds of merging points since the source was made, if the mesh is simplified. Concurrent
   * threads count once. */
  virtual double GetSimplifyTime() const { return 0; }
};
}

#endif
