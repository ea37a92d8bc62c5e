// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileHandle.h"

#include "gatunWindowsNames.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>

namespace gatun
{
namespace
{
constexpr std::size_t MostAtOnce = std::size_t{ 1 } << 30; // calls count in 32 bits

HANDLE ToHandle(std::intptr_t descriptor)
{
  return reinterpret_cast<HANDLE>(descriptor);
}

/** Opens or makes a file that others may read, write, rename and remove meanwhile, as on POSIX. */
int Open(std::intptr_t& descriptor, const std::string& path, DWORD access, DWORD disposition,
  DWORD attributes)
{
  std::wstring name;
  if (const int error = WidenName(path, name))
  {
    return error;
  }
  const HANDLE handle =
    CreateFileW(name.c_str(), access, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
      nullptr, disposition, attributes, nullptr);
  if (handle == INVALID_HANDLE_VALUE)
  {
    return GetSystemError();
  }
  descriptor = reinterpret_cast<std::intptr_t>(handle);
  return 0;
}

/** Where a call reads or writes. */
OVERLAPPED MakePlace(std::uint64_t offset)
{
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(offset);
  place.OffsetHigh = static_cast<DWORD>(offset >> 32);
  return place;
}

std::uint64_t Join(DWORD high, DWORD low)
{
  return std::uint64_t{ high } << 32 | low;
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
  // The flag is for folders.
  if (const int error =
        Open(this->Descriptor, path, GENERIC_READ, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS))
  {
    return error;
  }
  kind = Kind::Other;
  size = 0;
  if (GetFileType(ToHandle(this->Descriptor)) != FILE_TYPE_DISK)
  {
    return 0;
  }
  BY_HANDLE_FILE_INFORMATION status{};
  if (!GetFileInformationByHandle(ToHandle(this->Descriptor), &status))
  {
    return GetSystemError();
  }
  kind = (status.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? Kind::Folder : Kind::Regular;
  size = Join(status.nFileSizeHigh, status.nFileSizeLow);
  return 0;
}

//------------------------------------------------------------------------------
int FileHandle::OpenToWrite(const std::string& path)
{
  this->Close();
  return Open(this->Descriptor, path, GENERIC_WRITE, OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL);
}

//------------------------------------------------------------------------------
int FileHandle::Create(const std::string& path, Use use)
{
  this->Close();
  // AtomicFile renames it by its handle.
  return Open(this->Descriptor, path, GENERIC_READ | GENERIC_WRITE | DELETE, CREATE_NEW,
    use == Use::Scratch ? FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE
                        : FILE_ATTRIBUTE_NORMAL);
}

//------------------------------------------------------------------------------
int FileHandle::CreateUnnamed(const std::string&, Use)
{
  return ENOTSUP;
}

//------------------------------------------------------------------------------
int FileHandle::ReadAt(std::uint64_t offset, std::span<std::uint8_t>& bytes) const
{
  while (!bytes.empty())
  {
    auto place = MakePlace(offset);
    DWORD got = 0;
    if (!ReadFile(ToHandle(this->Descriptor), bytes.data(),
          static_cast<DWORD>(std::min(bytes.size(), MostAtOnce)), &got, &place))
    {
      return GetLastError() == ERROR_HANDLE_EOF ? 0 : GetSystemError();
    }
    if (got == 0)
    {
      return 0;
    }
    offset += got;
    bytes = bytes.subspan(got);
  }
  return 0;
}

//------------------------------------------------------------------------------
int FileHandle::WriteAt(std::uint64_t offset, std::span<const std::uint8_t> bytes)
{
  while (!bytes.empty())
  {
    auto place = MakePlace(offset);
    DWORD written = 0;
    if (!WriteFile(ToHandle(this->Descriptor), bytes.data(),
          static_cast<DWORD>(std::min(bytes.size(), MostAtOnce)), &written, &place))
    {
      return GetSystemError();
    }
    if (written == 0)
    {
      return ENOSPC;
    }
    offset += written;
    bytes = bytes.subspan(written);
  }
  return 0;
}

//------------------------------------------------------------------------------
int FileHandle::Synchronize()
{
  return FlushFileBuffers(ToHandle(this->Descriptor)) ? 0 : GetSystemError();
}

//------------------------------------------------------------------------------
int FileHandle::Close()
{
  if (!this->IsOpen())
  {
    return 0;
  }
  const bool isClosed = CloseHandle(ToHandle(this->Descriptor)) != 0;
  this->Descriptor = -1;
  return isClosed ? 0 : GetSystemError();
}

//------------------------------------------------------------------------------
int FileHandle::GetStamp(std::optional<FileStamp>& stamp) const
{
  BY_HANDLE_FILE_INFORMATION status{};
  if (!GetFileInformationByHandle(ToHandle(this->Descriptor), &status))
  {
    return GetSystemError();
  }
  stamp.reset();
  if (status.nNumberOfLinks > 0)
  {
    const auto& time = status.ftLastWriteTime;
    stamp = { status.dwVolumeSerialNumber, Join(status.nFileIndexHigh, status.nFileIndexLow),
      Join(status.nFileSizeHigh, status.nFileSizeLow), time.dwHighDateTime, time.dwLowDateTime };
  }
  return 0;
}

//------------------------------------------------------------------------------
int FileHandle::GetStamp(const std::string& path, FileStamp& stamp)
{
  FileHandle file;
  std::optional<FileStamp> found;
  if (const int error = Open(file.Descriptor, path, 0, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS))
  {
    return error;
  }
  const int error = file.GetStamp(found);
  stamp = found.value_or(FileStamp{});
  return error;
}
}
