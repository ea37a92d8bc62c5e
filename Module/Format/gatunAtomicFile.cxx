// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunAtomicFile.h"

#include "gatunError.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gatun
{
namespace
{
constexpr int MaximumAttempts = 100; // to find a name that is free

/** Resolves symbolic links of which the last one leads to a file that does not exist. */
std::string FollowLinks(const std::string& path)
{
  namespace fs = std::filesystem;
  constexpr int maximumLinks = 40;
  std::error_code error;
  fs::path target = path;
  for (int i = 0; i < maximumLinks && fs::is_symlink(target, error); ++i)
  {
    // A relative link is relative to the folder that contains it.
    target = target.parent_path() / fs::read_symlink(target, error);
  }
  return target.string();
}

/** A name next to the target that is probably free. */
std::string MakeTemporaryName(const std::filesystem::path& target)
{
  // Names may have 255 bytes.
  constexpr std::size_t maximumStem = 240;
  constexpr char digits[] = "0123456789abcdefghijklmnopqrstuvwxyz";
  static std::atomic<std::uint64_t> count{ 0 };
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  auto bits = static_cast<std::uint64_t>(now) + (static_cast<std::uint64_t>(::getpid()) << 40) +
    0x9e3779b97f4a7c15u * ++count;
  bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9u;
  bits ^= bits >> 31;
  auto name = target.filename().string().substr(0, maximumStem) + ".part-";
  for (int i = 0; i < 6; ++i, bits /= 36)
  {
    name += digits[bits % 36];
  }
  return (target.parent_path() / name).string();
}

/** The name by which the kernel links a file that has none. */
std::string GetDescriptorName(const FileHandle& handle)
{
  return "/proc/self/fd/" + std::to_string(handle.GetDescriptor());
}
}

//------------------------------------------------------------------------------
AtomicFile::AtomicFile(const std::string& path)
  : AtomicFile(path, Naming::AtCommit)
{
}

//------------------------------------------------------------------------------
AtomicFile::AtomicFile(const std::string& path, const FileHandle& replaced)
  : AtomicFile(path, Naming::AtCommit)
{
  if (::fstat(replaced.GetDescriptor(), &this->Replaced) != 0)
  {
    this->Fail(errno);
  }
  this->CheckReplaced();
}

//------------------------------------------------------------------------------
AtomicFile::AtomicFile(const std::string& path, Naming naming)
  : Path(path)
  , Target(path)
{
  this->CheckTarget();
  this->Create(naming);
}

//------------------------------------------------------------------------------
AtomicFile::AtomicFile(const std::string& path, const std::string& target)
  : Path(path)
  , Target(target)
{
  this->Create(Naming::Never);
}

//------------------------------------------------------------------------------
AtomicFile AtomicFile::MakeCommon(const std::string& path)
{
  return { path, Naming::Always };
}

//------------------------------------------------------------------------------
AtomicFile AtomicFile::MakeScratch(const AtomicFile& neighbor)
{
  return { neighbor.Path, neighbor.Target };
}

//------------------------------------------------------------------------------
AtomicFile AtomicFile::MakeScratch(const std::string& folder)
{
  return { folder, (std::filesystem::path(folder) / "scratch").string() };
}

//------------------------------------------------------------------------------
AtomicFile::~AtomicFile()
{
  if (!this->Temporary.empty())
  {
    ::unlink(this->Temporary.c_str());
  }
}

//------------------------------------------------------------------------------
void AtomicFile::Fail(int systemError) const
{
  throw Error(ErrorCode::CannotWrite,
    { .Path = this->Path, .What = "cannot write", .SystemError = systemError });
}

//------------------------------------------------------------------------------
void AtomicFile::CheckTarget()
{
  struct stat status
  {
  };
  this->Replaces = ::stat(this->Path.c_str(), &status) == 0;
  if (!this->Replaces)
  {
    this->Target = FollowLinks(this->Path);
    return;
  }
  const auto refuse = [this](const char* what)
  { throw Error(ErrorCode::CannotWrite, { .Path = this->Path, .What = what }); };
  if (!S_ISREG(status.st_mode))
  {
    refuse(S_ISDIR(status.st_mode) ? "is a directory" : "is not a regular file");
  }
  // Root could write a read-only file, but the mark is respected.
  if ((status.st_mode & 0222) == 0)
  {
    refuse("is read-only");
  }
  FileHandle probe;
  if (const int error = probe.Open(this->Path, O_WRONLY))
  {
    this->Fail(error);
  }
  this->Permissions = status.st_mode & 07777;
  if (char* real = ::realpath(this->Path.c_str(), nullptr))
  {
    this->Target = real;
    std::free(real);
  }
}

//------------------------------------------------------------------------------
void AtomicFile::CheckReplaced() const
{
  struct stat now
  {
  };
  const struct stat& then = this->Replaced;
  if (then.st_nlink > 0 &&
    (::stat(this->Target.c_str(), &now) != 0 || now.st_dev != then.st_dev ||
      now.st_ino != then.st_ino || now.st_size != then.st_size ||
      now.st_mtim.tv_sec != then.st_mtim.tv_sec || now.st_mtim.tv_nsec != then.st_mtim.tv_nsec))
  {
    throw Error(ErrorCode::CannotWrite,
      { .Path = this->Path, .What = "another program has changed the file meanwhile; it is kept" });
  }
}

//------------------------------------------------------------------------------
void AtomicFile::Create(Naming naming)
{
  // The kernel applies the umask. Until the permissions of an existing file are copied, nobody else
  // may read the new one.
  const ::mode_t mode = naming != Naming::Never && !this->Replaces ? 0666 : 0600;
  if (naming == Naming::Always || this->CreateUnnamed(mode) != 0)
  {
    if (const int error = this->CreateNamed(mode))
    {
      this->Fail(error);
    }
    if (naming == Naming::Never)
    {
      ::unlink(this->Temporary.c_str());
      this->Temporary.clear();
    }
  }
  if (this->Replaces && ::fchmod(this->Handle.GetDescriptor(), this->Permissions) != 0)
  {
    // The content matters more than the permissions.
  }
}

//------------------------------------------------------------------------------
int AtomicFile::CreateUnnamed(::mode_t mode)
{
  const auto folder = std::filesystem::path(this->Target).parent_path().string();
  if (const int error = this->Handle.Open(folder.empty() ? "." : folder, O_TMPFILE | O_RDWR, mode))
  {
    return error;
  }
  // Without /proc, the file could not be given a name later.
  return ::access(GetDescriptorName(this->Handle).c_str(), F_OK) == 0 ? 0 : errno;
}

//------------------------------------------------------------------------------
int AtomicFile::CreateNamed(::mode_t mode)
{
  int error = EEXIST;
  for (int i = 0; i < MaximumAttempts && error == EEXIST; ++i)
  {
    const auto name = MakeTemporaryName(this->Target);
    error = this->Handle.Open(name, O_CREAT | O_EXCL | O_RDWR, mode);
    if (error == 0)
    {
      this->Temporary = name;
    }
  }
  return error;
}

//------------------------------------------------------------------------------
void AtomicFile::Write(std::span<const std::uint8_t> bytes)
{
  if (const int error = this->Handle.WriteAt(this->Size, bytes))
  {
    this->Fail(error);
  }
  this->Size += bytes.size();
}

//------------------------------------------------------------------------------
void AtomicFile::Overwrite(std::uint64_t offset, std::span<const std::uint8_t> bytes)
{
  if (const int error = this->Handle.WriteAt(offset, bytes))
  {
    this->Fail(error);
  }
}

//------------------------------------------------------------------------------
void AtomicFile::ReadAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const
{
  if (const int error = this->Handle.ReadAt(offset, bytes))
  {
    this->Fail(error);
  }
  if (!bytes.empty())
  {
    throw Error(ErrorCode::CannotWrite,
      { .Path = this->Path, .What = "cannot write: a temporary file became shorter" });
  }
}

//------------------------------------------------------------------------------
std::uint64_t AtomicFile::Skip(std::uint64_t bytes)
{
  const auto offset = this->Size;
  this->Size += bytes;
  return offset;
}

//------------------------------------------------------------------------------
void AtomicFile::CopyTo(
  const std::string& temporary, std::uint64_t from, std::uint64_t to, std::uint64_t bytes) const
{
  constexpr std::uint64_t mostAtOnce = 4u << 20;
  FileHandle file;
  const auto check = [&](int error)
  {
    if (error != 0)
    {
      throw Error(ErrorCode::CannotWrite,
        { .Path = temporary, .What = "cannot write", .SystemError = error });
    }
  };
  check(file.Open(temporary, O_WRONLY));
  std::vector<std::uint8_t> buffer(static_cast<std::size_t>(std::min(mostAtOnce, bytes)));
  while (bytes > 0)
  {
    const auto part =
      std::span(buffer).first(static_cast<std::size_t>(std::min(mostAtOnce, bytes)));
    this->ReadAt(from, part);
    check(file.WriteAt(to, part));
    from += part.size();
    to += part.size();
    bytes -= part.size();
  }
  check(::fsync(file.GetDescriptor()) == 0 ? 0 : errno);
  check(file.Close());
}

//------------------------------------------------------------------------------
/** Gives an unnamed file the name of the target, or a temporary one if there is a file already. */
int AtomicFile::Link()
{
  const auto source = GetDescriptorName(this->Handle);
  int error = EEXIST;
  for (int i = 0; i < MaximumAttempts && error == EEXIST; ++i)
  {
    const bool isFinal = i == 0 && !this->Replaces;
    const auto name = isFinal ? this->Target : MakeTemporaryName(this->Target);
    error = ::linkat(AT_FDCWD, source.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0
      ? 0
      : errno;
    if (error == 0 && !isFinal)
    {
      this->Temporary = name;
    }
  }
  return error;
}

//------------------------------------------------------------------------------
void AtomicFile::Commit()
{
  if (::fsync(this->Handle.GetDescriptor()) != 0)
  {
    this->Fail(errno);
  }
  this->CheckReplaced();
  if (this->Temporary.empty())
  {
    if (const int error = this->Link())
    {
      this->Fail(error);
    }
  }
  if (const int error = this->Handle.Close())
  {
    this->Fail(error);
  }
  if (!this->Temporary.empty() && ::rename(this->Temporary.c_str(), this->Target.c_str()) != 0)
  {
    this->Fail(errno);
  }
  this->Temporary.clear();
}
}
