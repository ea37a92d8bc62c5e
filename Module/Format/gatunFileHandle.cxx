// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileHandle.h"

#include <cerrno>
#include <cstddef>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gatun
{
//------------------------------------------------------------------------------
FileHandle::~FileHandle()
{
  this->Close();
}

//------------------------------------------------------------------------------
int FileHandle::Open(const std::string& path, int flags, ::mode_t mode)
{
  this->Close();
  do
  {
    this->Descriptor = ::open(path.c_str(), flags | O_CLOEXEC, mode);
  } while (this->Descriptor < 0 && errno == EINTR);
  return this->IsOpen() ? 0 : errno;
}

//------------------------------------------------------------------------------
int FileHandle::OpenToRead(const std::string& path, Kind& kind, std::uint64_t& size)
{
  // Without O_NONBLOCK, opening a pipe would block.
  if (const int error = this->Open(path, O_RDONLY | O_NONBLOCK))
  {
    return error;
  }
  struct stat status
  {
  };
  if (::fstat(this->Descriptor, &status) != 0)
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
int FileHandle::ReadAt(std::uint64_t offset, std::span<std::uint8_t>& bytes) const
{
  while (!bytes.empty())
  {
    const auto got =
      ::pread(this->Descriptor, bytes.data(), bytes.size(), static_cast<::off_t>(offset));
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
    const auto written =
      ::pwrite(this->Descriptor, bytes.data(), bytes.size(), static_cast<::off_t>(offset));
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
int FileHandle::Close()
{
  if (!this->IsOpen())
  {
    return 0;
  }
  // Linux releases the descriptor even if close fails; a second call could close another file.
  const int result = ::close(this->Descriptor);
  this->Descriptor = -1;
  return result == 0 ? 0 : errno;
}
}
