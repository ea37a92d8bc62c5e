// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSpool_h
#define gtnSpool_h

// Many streams of bytes in one temporary file.

#include "gatunAtomicFile.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gtn
{
/**
 * Streams that are written side by side in bounded memory, and read afterwards. They are in one
 * file without a name, which the system removes when it is closed, also if the process is killed.
 *
 * Methods throw gatun::Error(CannotWrite).
 */
class Spool
{
public:
  /** The least number of bytes that the buffer of a stream takes while it is written. */
  static constexpr std::size_t LeastBuffer = 4096;

  explicit Spool(const std::string& folder);

  /** Adds streams, which are numbered on, and returns the number of the first one. They are to be
   * written until the next call of Close. memory: for all of them, in bytes. */
  std::size_t Open(std::size_t streams, std::size_t memory);

  /** Appends bytes to a stream. */
  void Append(std::size_t stream, std::span<const std::uint8_t> bytes);

  template <typename T>
  void Append(std::size_t stream, const std::vector<T>& values)
  {
    this->Append(
      stream, { reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T) });
  }

  /** Ends the streams that were opened last. */
  void Close();

  /** The number of bytes of a stream. */
  std::uint64_t GetSize(std::size_t stream) const { return this->Streams[stream].Size; }

  /** The number of values of a stream. */
  template <typename T>
  std::size_t Count(std::size_t stream) const
  {
    return static_cast<std::size_t>(this->Streams[stream].Size / sizeof(T));
  }

  /** Reads bytes of a stream that has been closed. */
  void Read(std::size_t stream, std::uint64_t begin, std::span<std::uint8_t> bytes) const;

  /** All values of a stream. */
  template <typename T>
  std::vector<T> ReadAll(std::size_t stream) const
  {
    std::vector<T> values(this->Count<T>(stream));
    this->Read(
      stream, 0, { reinterpret_cast<std::uint8_t*>(values.data()), values.size() * sizeof(T) });
    return values;
  }

  /** Replaces all values of a stream that has been closed by as many others. */
  template <typename T>
  void Replace(std::size_t stream, const std::vector<T>& values)
  {
    this->Replace(stream,
      std::span(reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)));
  }

  /** The number of bytes of the file. */
  std::uint64_t GetFileSize() const { return this->File.GetSize(); }

private:
  /** Extents have the same size, but the last one of a stream. */
  struct Stream
  {
    std::uint64_t Size = 0;
    std::size_t Extent = 0;             // the size of an extent
    std::vector<std::uint64_t> Extents; // their offsets in the file
    std::vector<std::uint8_t> Buffer;   // what was not written yet
  };

  void Flush(Stream& stream);
  void Replace(std::size_t stream, std::span<const std::uint8_t> bytes);

  /** Calls use(offset in the file, offset in the range, size) for each piece of a range. */
  template <typename Use>
  static void ForEachExtent(const Stream& stream, std::uint64_t begin, std::size_t size, Use&& use);

  gatun::AtomicFile File;
  std::vector<Stream> Streams;
  std::size_t FirstOpen = 0;
};
}

#endif
