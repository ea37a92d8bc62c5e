// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyTables_h
#define gatunHartleyTables_h

// The tables of a .ghv file. See Documentation/ghv-format.md.

#include "gatunContainer.h"
#include "gatunHartleyLayout.h"
#include "gatunHartleyQuantizer.h"
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
  HartleyRateControl RateControl;
  double RMSError = 0;
  double MaximumError = 0;

  HartleyLayout Layout; ///< computed from the sizes

  /** Whether the chunks have streams of corrections. */
  bool HasCorrections() const { return this->Lossless && !IsFloating(this->Volume.Type); }

  Bytes Write() const;
  static HartleyMeta Read(std::span<const std::uint8_t> bytes);
};

/** The position of a chunk in the file. */
struct HartleyChunkEntry
{
  std::uint64_t Terms = 0;
  std::vector<StreamRef> Streams; ///< one, or one for each segment
  StreamRef Corrections;          ///< empty if there are none

  std::uint64_t GetBytes() const;
};

/** The section TABL. */
struct HartleyTable
{
  std::vector<HartleyChunkEntry> Chunks;

  Bytes Write(const HartleyMeta& meta) const;
  static HartleyTable Read(std::span<const std::uint8_t> bytes, const HartleyMeta& meta);
};

/** The number of streams of a chunk's coefficients. */
std::size_t CountHartleyStreams(const HartleyLayout& layout);
}

#endif
