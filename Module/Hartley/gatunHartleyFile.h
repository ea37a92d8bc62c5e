// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyFile_h
#define gatunHartleyFile_h

#include "gatunHartleySource.h"
#include "gatunHartleyVolume.h"
#include "vtkGatunCoreModule.h"

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace gatun
{
struct HartleyWriterOptions
{
  std::uint32_t BlockSize = 8; ///< HartleyLayout::Make
  HartleyQuality Quality;
  bool ReplaceReadOnly = false; ///< as WriterOptions has it
};

/** What came of writing. */
struct HartleyWritten
{
  std::uint64_t FileBytes = 0;
  double RootMeanSquareError = 0; ///< of the voxels that the file gives back
  double LargestError = 0;
};

/** Writes a volume as a .ghv file, which appears under its name only when it is complete. */
VTKGATUNCORE_EXPORT HartleyWritten WriteHartleyFile(const std::string& path,
  const VolumeInput& volume, const HartleyWriterOptions& options,
  const std::function<bool(double)>& progress = {});

/**
 * An open .ghv file. Safe on hostile input, immutable and thread safe once made, as FileReader.
 * Chunks are decoded when they are asked for and not kept.
 */
class VTKGATUNCORE_EXPORT HartleyFile : public HartleySource
{
public:
  /** Whether the file begins as a .ghv file does. Never throws. */
  static bool CanRead(const std::string& path) noexcept;

  explicit HartleyFile(const std::string& path);
  ~HartleyFile() override;
  HartleyFile(const HartleyFile&) = delete;
  HartleyFile& operator=(const HartleyFile&) = delete;

  const std::string& GetPath() const;
  const VolumeInput& GetVolume() const; ///< without values
  const HartleyQuality& GetQuality() const;
  bool IsLossless() const;
  const std::string& GetWriterVersion() const;
  std::pair<int, int> GetFormatVersion() const;
  std::uint64_t GetFileBytes() const;
  std::uint64_t GetNumberOfTerms() const; ///< coefficients that are not 0

  /** Errors of the voxels that it gives back, measured when it was written. */
  double GetRootMeanSquareError() const;
  double GetLargestError() const;

  std::uint64_t GetChunkBytes(std::size_t chunk) const;
  std::uint64_t GetBytesRead() const; ///< since it was opened

  const HartleyLayout& GetLayout() const override;
  double GetBase() const override;
  Range GetRange() const override;
  std::shared_ptr<const HartleyChunk> GetChunk(std::size_t chunk) const override;

  /** Writes voxels from first up to, not including, end, x fastest, in the volume's type: rounded
   * to the nearest and clamped to the volume's range. Decodes only the chunks that are needed. */
  void GetVoxels(const HartleyLayout::Triple& first, const HartleyLayout::Triple& end, void* values,
    const std::function<bool(double)>& progress = {}) const;

  /** Checks all sums and decodes everything. Throws at what is wrong. */
  void Verify(const std::function<bool(double)>& progress = {}) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}

#endif
