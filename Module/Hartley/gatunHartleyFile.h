// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyFile_h
#define gatunHartleyFile_h

#include "gatunByteSource.h"
#include "gatunExport.h"
#include "gatunHartleySource.h"
#include "gatunHartleyVolume.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
/** Parameters of WriteHartleyFile. */
struct HartleyWriterOptions
{
  std::uint32_t BlockSize = 8; ///< HartleyLayout::Make
  HartleyRateControl RateControl;
};

/** Statistics of a written file. */
struct HartleyWritten
{
  std::uint64_t FileBytes = 0;
  double RMSError = 0;     ///< root mean square error of the decoded voxels
  double MaximumError = 0; ///< largest error of a decoded voxel
};

/** Writes a volume as a .ghv file. The file appears under its name when it is complete. Throws the
 * errors of HartleyVolume::Make and Error(CannotWrite). */
GATUN_EXPORT HartleyWritten WriteHartleyFile(const std::string& path, const VolumeInput& volume,
  const HartleyWriterOptions& options, const std::function<bool(double)>& progress = {});

/**
 * An open .ghv file. Safe on hostile input; immutable and thread safe. Chunks are decoded on
 * request and not kept.
 */
class GATUN_EXPORT HartleyFile : public HartleySource
{
public:
  /** Whether the file has the signature of a .ghv file. Never throws. */
  static bool CanRead(const std::string& path) noexcept;

  explicit HartleyFile(const std::string& path);

  /** Bytes from elsewhere than a file on disk. name: that of the source in messages. */
  HartleyFile(std::shared_ptr<const ByteSource> source, const std::string& name);
  ~HartleyFile() override;
  HartleyFile(const HartleyFile&) = delete;
  HartleyFile& operator=(const HartleyFile&) = delete;

  const std::string& GetPath() const;
  const VolumeInput& GetVolume() const; ///< without values
  const HartleyRateControl& GetRateControl() const;
  bool IsLossless() const;
  const std::string& GetWriterVersion() const;
  std::uint32_t GetFormatVersion() const;
  std::uint64_t GetFileBytes() const;
  std::uint64_t GetNumberOfTerms() const; ///< nonzero coefficients

  /** Errors of the decoded voxels, measured by the writer. */
  double GetRMSError() const;
  double GetMaximumError() const;

  std::uint64_t GetChunkBytes(std::size_t chunk) const;
  std::uint64_t GetBytesRead() const; ///< since the file was opened

  const HartleyLayout& GetLayout() const override;
  double GetBase() const override;
  Range GetRange() const override;
  std::shared_ptr<const HartleyChunk> GetChunk(std::size_t chunk) const override;

  /** Writes the voxels [first, end), x fastest, in the volume's type. They are rounded to the
   * nearest value and clamped to the volume's range. Decodes the required chunks only. */
  void GetVoxels(const HartleyLayout::Triple& first, const HartleyLayout::Triple& end, void* values,
    const std::function<bool(double)>& progress = {}) const;

  /** The bytes of the file that GetVoxels reads for some voxels. */
  std::vector<ByteRange> GetByteRanges(
    const HartleyLayout::Triple& first, const HartleyLayout::Triple& end) const;

  /** Verifies all checksums and decodes all chunks. Throws if something is wrong. */
  void Verify(const std::function<bool(double)>& progress = {}) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}

#endif
