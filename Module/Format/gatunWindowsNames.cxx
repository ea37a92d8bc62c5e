// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunWindowsNames.h"

#include <cerrno>
#include <cstddef>

namespace gatun
{
namespace
{
constexpr std::size_t MostCharacters = 32767; // of any name
constexpr std::size_t MostOfUsual = 247;      // of a folder without the prefix
constexpr const wchar_t* Prefix = LR"(\\?\)"; // lifts the limit of usual names
}

//------------------------------------------------------------------------------
int WidenName(const std::string& name, std::wstring& wide)
{
  if (name.empty() || name.find('\0') != std::string::npos)
  {
    return ENOENT;
  }
  if (name.size() > 3 * MostCharacters)
  {
    return ENAMETOOLONG;
  }
  const auto bytes = static_cast<int>(name.size());
  const auto convert = [&](wchar_t* out, int size)
  { return MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, name.data(), bytes, out, size); };
  const int length = convert(nullptr, 0);
  if (length <= 0)
  {
    return EILSEQ;
  }
  wide.resize(static_cast<std::size_t>(length));
  convert(wide.data(), length);
  if (wide.starts_with(Prefix))
  {
    return 0;
  }
  // Only an absolute name may have the prefix.
  std::wstring full(MostCharacters + 1, L'\0');
  const DWORD size =
    GetFullPathNameW(wide.c_str(), static_cast<DWORD>(full.size()), full.data(), nullptr);
  if (size == 0 || size >= full.size())
  {
    return size == 0 ? GetSystemError() : ENAMETOOLONG;
  }
  full.resize(size);
  wide = full.size() <= MostOfUsual ? full
    : full.starts_with(LR"(\\)")    ? Prefix + (LR"(UNC\)" + full.substr(2))
                                    : Prefix + full;
  return 0;
}

//------------------------------------------------------------------------------
std::string NarrowName(const std::wstring& wide)
{
  const auto length = static_cast<int>(wide.size());
  const auto convert = [&](char* out, int size)
  { return WideCharToMultiByte(CP_UTF8, 0, wide.data(), length, out, size, nullptr, nullptr); };
  std::string name(static_cast<std::size_t>(convert(nullptr, 0)), '\0');
  convert(name.data(), static_cast<int>(name.size()));
  return name;
}

//------------------------------------------------------------------------------
int GetSystemError()
{
  switch (GetLastError())
  {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
    case ERROR_BAD_PATHNAME:
    case ERROR_INVALID_DRIVE:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_NET_NAME:
      return ENOENT;
    case ERROR_ACCESS_DENIED:
    case ERROR_WRITE_PROTECT:
      return EACCES;
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_USER_MAPPED_FILE:
      return EBUSY;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      return EEXIST;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return ENOSPC;
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY:
      return ENOMEM;
    case ERROR_FILENAME_EXCED_RANGE:
      return ENAMETOOLONG;
    case ERROR_TOO_MANY_OPEN_FILES:
      return EMFILE;
    case ERROR_FILE_TOO_LARGE:
      return EFBIG;
    default:
      return EIO;
  }
}
}
