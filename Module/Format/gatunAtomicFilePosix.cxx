// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// AtomicFile: what POSIX does.

#include "gatunAtomicFile.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gatun
{
namespace
{
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

/** The name by which the kernel links a file that has none. */
std::string GetDescriptorName(const FileHandle& handle)
{
  return "/proc/self/fd/" + std::to_string(handle.GetDescriptor());
}
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
  if (!S_ISREG(status.st_mode))
  {
    this->Refuse(S_ISDIR(status.st_mode) ? "is a directory" : "is not a regular file");
  }
  // Root could write a read-only file, but the mark is respected.
  if ((status.st_mode & 0222) == 0)
  {
    this->Refuse("is read-only");
  }
  FileHandle probe;
  if (const int error = probe.OpenToWrite(this->Path))
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
void AtomicFile::Create(Naming naming)
{
  // The kernel applies the umask. Until the permissions of an existing file are copied, nobody else
  // may read the new one.
  const auto use =
    naming != Naming::Never && !this->Replaces ? FileHandle::Use::Public : FileHandle::Use::Private;
  if (naming == Naming::Always || this->CreateUnnamed(use) != 0)
  {
    this->CreateNamed(use);
    if (naming == Naming::Never)
    {
      this->RemoveTemporary();
    }
  }
  if (this->Replaces &&
    ::fchmod(static_cast<int>(this->Handle.GetDescriptor()), this->Permissions) != 0)
  {
    // The content matters more than the permissions.
  }
}

//------------------------------------------------------------------------------
int AtomicFile::CreateUnnamed(FileHandle::Use use)
{
  const auto folder = std::filesystem::path(this->Target).parent_path().string();
  if (const int error = this->Handle.CreateUnnamed(folder, use))
  {
    return error;
  }
  // Without /proc, the file could not be given a name later.
  return ::access(GetDescriptorName(this->Handle).c_str(), F_OK) == 0 ? 0 : errno;
}

//------------------------------------------------------------------------------
void AtomicFile::RemoveTemporary()
{
  ::unlink(this->Temporary.c_str());
  this->Temporary.clear();
}

//------------------------------------------------------------------------------
/** Gives an unnamed file the name of the target, or a temporary one if there is a file already. */
int AtomicFile::Link()
{
  const auto source = GetDescriptorName(this->Handle);
  const auto link = [&](const std::string& name)
  {
    return ::linkat(AT_FDCWD, source.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0
      ? 0
      : errno;
  };
  const int error = this->Replaces ? EEXIST : link(this->Target);
  return error == EEXIST ? this->TakeName(link) : error;
}

//------------------------------------------------------------------------------
void AtomicFile::MoveToTarget()
{
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
}
}
