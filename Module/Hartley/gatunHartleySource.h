// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleySource_h
#define gatunHartleySource_h

#include "gatunExport.h"
#include "gatunHartleyLayout.h"
#include "gatunTypes.h"

#include <memory>
#include <span>
#include <vector>

namespace gatun
{
/** A nonzero coefficient of a block. */
struct HartleyTerm
{
  std::uint32_t Index = 0; ///< in the block, x fastest, as in HartleyTransform
  float Value = 0;

  bool operator==(const HartleyTerm&) const = default;
};

/** The coefficients of a chunk, block by block in the order of HartleyLayout. */
struct HartleyChunk
{
  std::vector<std::uint64_t> Starts; ///< of each block; the last entry is the end
  std::vector<HartleyTerm> Terms;    ///< in each block by ascending index

  std::span<const HartleyTerm> GetBlock(std::size_t blockOfChunk) const
  {
    return { this->Terms.data() + this->Starts[blockOfChunk],
      static_cast<std::size_t>(this->Starts[blockOfChunk + 1] - this->Starts[blockOfChunk]) };
  }
};

/**
 * A volume as Hartley coefficients, in memory or in a file. They are the transform of the voxels
 * minus a base value, the smallest voxel, so that the volume is zero at its borders.
 */
class GATUN_EXPORT HartleySource
{
public:
  virtual ~HartleySource() = default;

  virtual const HartleyLayout& GetLayout() const = 0;
  virtual double GetBase() const = 0;

  /** Smallest and largest voxel before compression. */
  virtual Range GetRange() const = 0;

  /** Thread safe. Throws Error if the file is damaged. */
  virtual std::shared_ptr<const HartleyChunk> GetChunk(std::size_t chunk) const = 0;
};
}

#endif
