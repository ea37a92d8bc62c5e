// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileHandle_h
#define gatunFileHandle_h

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace gatun
{
/** Tells a file from others, and from itself before a change. */
struct FileStamp
{
  std::uint64_t Volume = 0;
  std::uint64_t File = 0; // its number on the volume
  std::uint64_t Size = 0;
  std::int64_t Seconds = 0; // of the last change, and the rest of them in units of the system
  std::int64_t Rest = 0;

  bool operator==(const FileStamp&) const = default;
};

/**
 * Owner of an open file. The only class that reads and writes files by system calls, with a source
 * for POSIX and one for Windows; AtomicFile gives files their names. Names are UTF-8 on Windows and
 * any bytes elsewhere.
 *
 * Methods repeat calls that a signal interrupts. They return 0 on success and a value of errno on
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

  /** What a new file is for. */
  enum class Use
  {
    Public, // others may read it, as far as the system's usual permissions go
    Private,
    Scratch // private; Windows removes it with its handle
  };

  /** Opens whatever there is for reading, and tells what it is and how many bytes a file has. */
  int OpenToRead(const std::string& path, Kind& kind, std::uint64_t& size);

  /** Opens an existing file for writing. */
  int OpenToWrite(const std::string& path);

  /** Makes a file for reading and writing. EEXIST if there is one of that name. */
  int Create(const std::string& path, Use use);

  /** Makes a file without a name in a folder, where the system allows that. */
  int CreateUnnamed(const std::string& folder, Use use);

  /** Reads at an offset and removes the bytes read from the span. Bytes remain only if the file
   * ends before. Thread safe. */
  int ReadAt(std::uint64_t offset, std::span<std::uint8_t>& bytes) const;

  /** Writes all bytes at an offset, which may lie behind the end of the file. */
  int WriteAt(std::uint64_t offset, std::span<const std::uint8_t> bytes);

  /** Moves what was written to the disk. */
  int Synchronize();

  /** Closes the file. Reports write errors that the system had deferred. */
  int Close();

  /** The stamp of the file; none if its name is gone. */
  int GetStamp(std::optional<FileStamp>& stamp) const;

  /** The stamp of the file of a name. */
  static int GetStamp(const std::string& path, FileStamp& stamp);

  bool IsOpen() const { return this->Descriptor >= 0; }

  /** The descriptor of POSIX, or the HANDLE of Windows. */
  std::intptr_t GetDescriptor() const { return this->Descriptor; }

private:
  std::intptr_t Descriptor = -1; // which stands for none on both
};
}

#endif
