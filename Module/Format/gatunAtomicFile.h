// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunAtomicFile_h
#define gatunAtomicFile_h

#include "gatunExport.h" // For export macro
#include "gatunFileHandle.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace gatun
{
/**
 * A file that appears at its path only when it is complete.
 *
 * Until Commit, the data are in a temporary file in the folder of the target. The temporary file
 * has no name where the file system allows that (O_TMPFILE), so that nothing remains if the process
 * is killed. On other file systems it is named "<target>.part-XXXXXX", and the destructor removes
 * it.
 *
 * Commit links an unnamed file to its path. A link cannot replace a file; therefore an existing
 * target is replaced in two steps, a link to "<target>.part-XXXXXX" and a rename. A process that is
 * killed in between leaves that name behind, but the file is complete.
 *
 * Symbolic links are followed. A file that this user may not write is not replaced. A file that is
 * replaced passes on its permissions; the permissions
 * of a new file follow the umask. On Windows, a file has the permissions of its folder, and the
 * temporary file always has a name, but that of a scratch file vanishes with it. Methods throw
 * Error(CannotWrite). Exported for the gtn program.
 */
class GATUN_EXPORT AtomicFile
{
public:
  explicit AtomicFile(const std::string& path);

  /** A file that replaces one that is open. Commit fails if another program has changed or replaced
   * that file since. */
  AtomicFile(const std::string& path, const FileHandle& replaced);

  /** A file that other processes write, too: the temporary file always has a name. */
  static AtomicFile MakeCommon(const std::string& path);

  /** A scratch file in the folder of another one. It has no name and cannot be committed. */
  static AtomicFile MakeScratch(const AtomicFile& neighbor);

  /** The same in a given folder. */
  static AtomicFile MakeScratch(const std::string& folder);

  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /** The path as given. */
  const std::string& GetPath() const { return this->Path; }

  /** The number of bytes written. */
  std::uint64_t GetSize() const { return this->Size; }

  void Write(std::span<const std::uint8_t> bytes);

  /** Replaces bytes that have been written. */
  void Overwrite(std::uint64_t offset, std::span<const std::uint8_t> bytes);

  /** Reads bytes that have been written. */
  void ReadAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const;

  /** The name of the temporary file, if it has one. */
  const std::string& GetTemporary() const { return this->Temporary; }

  /** Leaves out the next bytes, which another process writes. Returns their offset. */
  std::uint64_t Skip(std::uint64_t bytes);

  /** Writes bytes into the temporary file of another process. */
  void CopyTo(
    const std::string& temporary, std::uint64_t from, std::uint64_t to, std::uint64_t bytes) const;

  /** Moves the data to the disk and the file to its path. */
  void Commit();

private:
  enum class Naming
  {
    Never,    // a scratch file
    AtCommit, // where the file system allows that
    Always
  };

  AtomicFile(const std::string& path, const std::string& target);
  AtomicFile(const std::string& path, Naming naming);

  void CheckReplaced() const;
  void CreateNamed(FileHandle::Use use);
  int TakeName(const std::function<int(const std::string&)>& take);
  [[noreturn]] void Fail(int systemError) const;
  [[noreturn]] void Refuse(const char* what) const;

  // In a source for each system:
  void CheckTarget();
  void Create(Naming naming);
  int CreateUnnamed(FileHandle::Use use);
  int Link();
  void MoveToTarget();
  void RemoveTemporary();

  std::string Path;
  std::string Target;                // the path without symbolic links
  std::string Temporary;             // the current name, if any
  bool Replaces = false;             // whether the target exists
  std::optional<FileStamp> Replaced; // if it must be a certain file
  unsigned Permissions = 0;          // of the existing target, on POSIX
  FileHandle Handle;
  std::uint64_t Size = 0;
};
}

#endif
