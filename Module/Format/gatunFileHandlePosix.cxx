// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileHandle.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gatun
{
namespace
{
constexpr std::size_t MostAtOnce = std::size_t{ 1 } << 30; // macOS refuses 2 GiB

/** Opens a file. The umask applies to mode. */
int Open(std::intptr_t& descriptor, const std::string& path, int flags, ::mode_t mode = 0)
{
  do
  {
    descriptor = ::open(path.c_str(), flags | O_CLOEXEC, mode);
  } while (descriptor < 0 && errno == EINTR);
  return descriptor < 0 ? errno : 0;
}

::mode_t GetMode(FileHandle::Use use)
{
  return use == FileHandle::Use::Public ? 0666 : 0600;
}

int ToInt(std::intptr_t descriptor)
{
  return static_cast<int>(descriptor);
}

FileStamp MakeStamp(const struct stat& status)
{
#if defined(__APPLE__)
  const auto& time = status.st_mtimespec;
#else
  const auto& time = status.st_mtim;
#endif
  return { static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino),
    static_cast<std::uint64_t>(status.st_size), time.tv_sec, time.tv_nsec };
}
}

//------------------------------------------------------------------------------
FileHandle::~FileHandle()
{
  this->Close();
}

//------------------------------------------------------------------------------
int FileHandle::OpenToRead(const std::string& path, Kind& kind, std::uint64_t& size)
{
  this->Close();
  // Without O_NONBLOCK, opening a pipe would block.
  if (const int error = Open(this->Descriptor, path, O_RDONLY | O_NONBLOCK))
  {
    return error;
  }
  struct stat status
  {
  };
  if (::fstat(ToInt(this->Descriptor), &status) != 0)
  {
    return errno;
  }
  kind = S_ISREG(status.st_mode) ? Kind::Regular
    : S_ISDIR(status.st_mode)    ? Kind::Folder
                                 : Kind::Other;
  size = static_cast<std::uint64_t>(status.st_size);
  return 0;
}

//------------------------------------------------------------------------------
int FileHandle::OpenToWrite(const std::string& path)
{
  this->Close();
  return Open(this->Descriptor, path, O_WRONLY);
}

//------------------------------------------------------------------------------
int FileHandle::Create(const std::string& path, Use use)
{
  this->Close();
  return Open(this->Descriptor, path, O_CREAT | O_EXCL | O_RDWR, GetMode(use));
}

//------------------------------------------------------------------------------
int FileHandle::CreateUnnamed([[maybe_unused]] const std::string& folder, [[maybe_unused]] Use use)
{
  this->Close();
#if defined(O_TMPFILE)
  return Open(this->Descriptor, folder.empty() ? "." : folder, O_TMPFILE | O_RDWR, GetMode(use));
#else
  return ENOTSUP;
#endif
}

//------------------------------------------------------------------------------
int FileHandle::ReadAt(std::uint64_t offset, std::span<std::uint8_t>& bytes) const
{
  while (!bytes.empty())
  {
    const auto got = ::pread(ToInt(this->Descriptor), bytes.data(),
      std::min(bytes.size(), MostAtOnce), static_cast<::off_t>(offset));
    if (got == 0)
    {
      return 0;
    }
    if (got > 0)
    {
      offset += static_cast<std::uint64_t>(got);
      bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
    else if (errno != EINTR)
    {
      return errno;
    }
  }
  return 0;
}

//------------------------------------------------------------------------------
int FileHandle::WriteAt(std::uint64_t offset, std::span<const std::uint8_t> bytes)
{
  while (!bytes.empty())
  {
    const auto written = ::pwrite(ToInt(this->Descriptor), bytes.data(),
      std::min(bytes.size(), MostAtOnce), static_cast<::off_t>(offset));
    if (written == 0)
    {
      return ENOSPC;
    }
    if (written > 0)
    {
      offset += static_cast<std::uint64_t>(written);
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    else if (errno != EINTR)
    {
      return errno;
    }
  }
  return 0;
}

//------------------------------------------------------------------------------
int FileHandle::Synchronize()
{
#if defined(F_FULLFSYNC)
  // On macOS, fsync does not reach the disk. Not all file systems know better.
  if (::fcntl(ToInt(this->Descriptor), F_FULLFSYNC) == 0)
  {
    return 0;
  }
#endif
  return ::fsync(ToInt(this->Descriptor)) == 0 ? 0 : errno;
}

//------------------------------------------------------------------------------
int FileHandle::Close()
{
  if (!this->IsOpen())
  {
    return 0;
  }
  // Linux releases the descriptor even if close fails; a second call could close another file.
  const int result = ::close(ToInt(this->Descriptor));
  this->Descriptor = -1;
  return result == 0 ? 0 : errno;
}

//------------------------------------------------------------------------------
int FileHandle::GetStamp(std::optional<FileStamp>& stamp) const
{
  struct stat status
  {
  };
  if (::fstat(ToInt(this->Descriptor), &status) != 0)
  {
    return errno;
  }
  stamp.reset();
  if (status.st_nlink > 0)
  {
    stamp = MakeStamp(status);
  }
  return 0;
}

//------------------------------------------------------------------------------
int FileHandle::GetStamp(const std::string& path, FileStamp& stamp)
{
  struct stat status
  {
  };
  if (::stat(path.c_str(), &status) != 0)
  {
    return errno;
  }
  stamp = MakeStamp(status);
  return 0;
}
}
