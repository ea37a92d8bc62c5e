// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunByteSource_h
#define gatunByteSource_h

#include "gatunExport.h" // For export macro

#include <cerrno>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
/** A range of bytes of a file. */
struct ByteRange
{
  std::uint64_t Offset = 0;
  std::uint64_t Length = 0;
  bool operator==(const ByteRange&) const = default;
};

/** Sorts ranges and joins those that overlap or have no more than a number of bytes between them.
 */
GATUN_EXPORT std::vector<ByteRange> JoinRanges(std::vector<ByteRange> ranges, std::uint64_t gap);

/**
 * The bytes of a file, from wherever they come. Thread safe: any number of threads read at once.
 *
 * A source that gets its bytes from elsewhere may not have them yet. It returns NotHere; the
 * operation that needs them then throws Error(NotHere) with the first range that is missing, and
 * can be repeated when the bytes have come. FileReader::GetByteRanges tells what an operation
 * needs.
 */
class GATUN_EXPORT ByteSource
{
public:
  static constexpr int NotHere = EAGAIN;

  virtual ~ByteSource() = default;

  virtual std::uint64_t GetSize() const = 0;

  /** Reads at an offset and removes the bytes read from the span. Bytes remain only if the file
   * ends before. Returns 0, NotHere or another value of errno. May throw Error with a message of
   * its own. */
  virtual int ReadAt(std::uint64_t offset, std::span<std::uint8_t>& bytes) const = 0;

  /** Whether each read costs a request over a network. Decoders then call Fetch before they read.
   */
  virtual bool IsRemote() const { return false; }

  /** Ranges that will be read soon, sorted and apart, so that few requests bring them. */
  virtual void Fetch(const std::vector<ByteRange>& ranges) const { static_cast<void>(ranges); }
};

/** A file on disk. Throws Error(CannotOpen) unless it is a regular file that can be read. */
GATUN_EXPORT std::shared_ptr<const ByteSource> OpenFile(const std::string& path);

/** Opens a name that stands for no file on disk, such as an address; null for other names. */
using SourceOpener = std::shared_ptr<const ByteSource> (*)(const std::string& name);

/** Sets what OpenFile tries first. Default: null. Thread safe. */
GATUN_EXPORT void SetSourceOpener(SourceOpener opener);

/** A file in memory that the caller keeps and does not change. */
class GATUN_EXPORT MemorySource : public ByteSource
{
public:
  explicit MemorySource(std::span<const std::uint8_t> bytes)
    : Data(bytes)
  {
  }

  std::uint64_t GetSize() const override { return this->Data.size(); }
  int ReadAt(std::uint64_t offset, std::span<std::uint8_t>& bytes) const override;

private:
  std::span<const std::uint8_t> Data;
};
}

#endif
