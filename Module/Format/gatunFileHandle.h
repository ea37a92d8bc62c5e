// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileHandle_h
#define gatunFileHandle_h

#include <cstdint>
#include <span>
#include <string>

#include <sys/types.h>

namespace gatun
{
/**
 * Owner of a POSIX file descriptor. The only class that reads and writes files by system calls;
 * AtomicFile gives them their names.
 *
 * Methods repeat calls that a signal interrupts. They return 0 on success and the value of errno on
 * failure; callers turn it into an Error that names file and purpose.
 */
class FileHandle
{
public:
  FileHandle() = default;
  ~FileHandle();
  FileHandle(const FileHandle&) = delete;
  FileHandle& operator=(const FileHandle&) = delete;

  /** What a name of the file system can be. */
  enum class Kind
  {
    Regular,
    Folder,
    Other // a pipe or a device
  };

  /** Opens whatever there is for reading, and tells what it is and how many bytes a file has. */
  int OpenToRead(const std::string& path, Kind& kind, std::uint64_t& size);

  /** Opens a file; O_CLOEXEC is added to the flags. The umask applies to mode. */
  int Open(const std::string& path, int flags, ::mode_t mode = 0);

  /** Reads at an offset and removes the bytes read from the span. Bytes remain only if the file
   * ends before. Thread safe. */
  int ReadAt(std::uint64_t offset, std::span<std::uint8_t>& bytes) const;

  /** Writes all bytes at an offset, which may lie behind the end of the file. */
  int WriteAt(std::uint64_t offset, std::span<const std::uint8_t> bytes);

  /** Closes the file. Reports write errors that the system had deferred. */
  int Close();

  bool IsOpen() const { return this->Descriptor >= 0; }
  int GetDescriptor() const { return this->Descriptor; }

private:
  int Descriptor = -1;
};
}

#endif
