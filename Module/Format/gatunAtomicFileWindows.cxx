// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// AtomicFile: what Windows does.

#include "gatunAtomicFile.h"

#include "gatunWindowsNames.h"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <vector>

namespace gatun
{
namespace
{
/** The name of an open file without links. */
std::wstring GetFinalName(const FileHandle& file)
{
  std::wstring name(32768, L'\0');
  const DWORD size = GetFinalPathNameByHandleW(reinterpret_cast<HANDLE>(file.GetDescriptor()),
    name.data(), static_cast<DWORD>(name.size()), FILE_NAME_NORMALIZED | VOLUME_NAME_DOS);
  name.resize(size < name.size() ? size : 0);
  return name;
}

/** Renames an open file. The one of that name is replaced even if others have it open, who keep the
 * old one: only Windows 10 and later can do that, and not on every file system. */
bool RenameOpenFile(const FileHandle& file, const std::wstring& name)
{
  // FILE_RENAME_FLAG_REPLACE_IF_EXISTS, FILE_RENAME_FLAG_POSIX_SEMANTICS and FileRenameInfoEx are
  // not in the headers for older systems.
  constexpr DWORD replacesOpenFiles = 1 | 2;
  constexpr auto renameEx = static_cast<FILE_INFO_BY_HANDLE_CLASS>(22);
  struct Information
  {
    DWORD Flags;
    HANDLE Folder;
    DWORD Length; // in bytes
    WCHAR Name[1];
  };
  const std::size_t length = name.size() * sizeof(wchar_t);
  const std::size_t size = offsetof(Information, Name) + length + sizeof(wchar_t);
  std::vector<std::max_align_t> memory(size / sizeof(std::max_align_t) + 1);
  Information head{ replacesOpenFiles, nullptr, static_cast<DWORD>(length), {} };
  std::memcpy(memory.data(), &head, sizeof(head));
  std::memcpy(
    reinterpret_cast<char*>(memory.data()) + offsetof(Information, Name), name.data(), length);
  return SetFileInformationByHandle(reinterpret_cast<HANDLE>(file.GetDescriptor()), renameEx,
           memory.data(), static_cast<DWORD>(size)) != 0;
}
}

//------------------------------------------------------------------------------
void AtomicFile::CheckTarget()
{
  std::wstring name;
  if (const int error = WidenName(this->Path, name))
  {
    this->Fail(error);
  }
  const DWORD attributes = GetFileAttributesW(name.c_str());
  this->Replaces = attributes != INVALID_FILE_ATTRIBUTES;
  if (!this->Replaces)
  {
    return;
  }
  if ((attributes & FILE_ATTRIBUTE_DIRECTORY) != 0)
  {
    this->Refuse("is a directory");
  }
  if ((attributes & FILE_ATTRIBUTE_READONLY) != 0)
  {
    this->Refuse("is read-only");
  }
  FileHandle probe;
  if (const int error = probe.OpenToWrite(this->Path))
  {
    if (error == EBUSY)
    {
      this->Refuse("another program has the file open and does not let it be replaced");
    }
    this->Fail(error);
  }
  if (GetFileType(reinterpret_cast<HANDLE>(probe.GetDescriptor())) != FILE_TYPE_DISK)
  {
    this->Refuse("is not a regular file");
  }
  if (const auto target = GetFinalName(probe); !target.empty())
  {
    this->Target = NarrowName(target);
  }
}

//------------------------------------------------------------------------------
void AtomicFile::Create(Naming naming)
{
  if (naming != Naming::Never)
  {
    this->CreateNamed(FileHandle::Use::Public);
    return;
  }
  this->CreateNamed(FileHandle::Use::Scratch);
  this->Temporary.clear(); // it vanishes with the handle, also if the process is killed
}

//------------------------------------------------------------------------------
void AtomicFile::RemoveTemporary()
{
  this->Handle.Close();
  std::wstring name;
  if (WidenName(this->Temporary, name) == 0)
  {
    DeleteFileW(name.c_str());
  }
  this->Temporary.clear();
}

//------------------------------------------------------------------------------
void AtomicFile::MoveToTarget()
{
  std::wstring from;
  std::wstring to;
  int error = WidenName(this->Temporary, from);
  error = error == 0 ? WidenName(this->Target, to) : error;
  if (error == 0 && !RenameOpenFile(this->Handle, to))
  {
    error = this->Handle.Close();
    if (error == 0 &&
      !MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH))
    {
      error = GetSystemError();
      if (this->Replaces && (error == EACCES || error == EBUSY))
      {
        this->Refuse("another program has the file open and does not let it be replaced");
      }
    }
  }
  error = error == 0 ? this->Handle.Close() : error;
  if (error != 0)
  {
    this->Fail(error);
  }
}
}
