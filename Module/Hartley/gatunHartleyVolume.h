// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyVolume_h
#define gatunHartleyVolume_h

#include "gatunExport.h"
#include "gatunHartleyInput.h"
#include "gatunHartleySource.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace gatun
{
/** The quantized coefficients of a volume, in memory. */
class GATUN_EXPORT HartleyVolume : public HartleySource
{
public:
  /** Transforms and quantizes a volume. Parallel. Throws Error(InvalidInput) for empty volumes,
   * values that are not finite and invalid parameters; Error(Aborted) if progress returns false. */
  static std::shared_ptr<const HartleyVolume> Make(const VolumeInput& input,
    std::uint32_t blockSize, const HartleyRateControl& control,
    const std::function<bool(double)>& progress = {});

  const HartleyLayout& GetLayout() const override { return this->Layout; }
  double GetBase() const override { return this->Base; }
  Range GetRange() const override { return this->Values; }
  std::uint64_t GetNumberOfTerms() const; ///< nonzero coefficients
  std::shared_ptr<const HartleyChunk> GetChunk(std::size_t chunk) const override
  {
    return this->Chunks[chunk];
  }

private:
  HartleyLayout Layout;
  double Base = 0;
  Range Values;
  std::vector<std::shared_ptr<const HartleyChunk>> Chunks;
};
}

#endif
