// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyTables_h
#define gatunHartleyTables_h

// What a .ghv file tells about itself. See Documentation/ghv-format.md.

#include "gatunContainer.h"
#include "gatunHartleyLayout.h"
#include "gatunHartleyQuantiser.h"
#include "gatunHartleyVolume.h"

#include <string>
#include <vector>

namespace gatun
{
/** The section META. */
struct HartleyMeta
{
  std::string WriterVersion;
  VolumeInput Volume; ///< without values
  std::uint32_t BlockSize = 0;
  Range Values;
  HartleySteps Steps;
  bool Lossless = false;
  HartleyQuality Quality;
  double RootMeanSquareError = 0;
  double LargestError = 0;

  HartleyLayout Layout; ///< follows from the sizes

  /** Whether there are streams that correct voxels. */
  bool HasCorrections() const { return this->Lossless && !IsFloating(this->Volume.Type); }

  Bytes Write() const;
  static HartleyMeta Read(std::span<const std::uint8_t> bytes);
};

/** Where a chunk is. */
struct HartleyChunkEntry
{
  std::uint64_t Terms = 0;
  std::vector<StreamRef> Streams; ///< one, or one for each segment
  StreamRef Corrections;          ///< of no length where there are none

  std::uint64_t GetBytes() const;
};

/** The section TABL. */
struct HartleyTable
{
  std::vector<HartleyChunkEntry> Chunks;

  Bytes Write(const HartleyMeta& meta) const;
  static HartleyTable Read(std::span<const std::uint8_t> bytes, const HartleyMeta& meta);
};

/** How many streams the blocks of a chunk have. */
std::size_t CountHartleyStreams(const HartleyLayout& layout);
}

#endif
