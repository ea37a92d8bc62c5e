// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunAtomicFile.h"

#include "gatunError.h"
#include "gatunPaths.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <vector>

#include <unistd.h>

namespace gatun
{
namespace
{
/** A name next to the target that is probably free. */
std::string MakeTemporaryName(const std::filesystem::path& target)
{
  // Names may have 255 bytes. They end between the characters of UTF-8.
  std::string name = ToText(target.filename());
  std::size_t length = std::min<std::size_t>(name.size(), 240);
  while (length < name.size() && length > 0 && (name[length] & 0xc0) == 0x80)
  {
    --length;
  }
  name.resize(length);
  name += ".part-";
  constexpr char digits[] = "0123456789abcdefghijklmnopqrstuvwxyz";
  static std::atomic<std::uint64_t> count{ 0 };
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  auto bits = static_cast<std::uint64_t>(now) + (static_cast<std::uint64_t>(::getpid()) << 40) +
    0x9e3779b97f4a7c15u * ++count;
  bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9u;
  bits ^= bits >> 31;
  for (int i = 0; i < 6; ++i, bits /= 36)
  {
    name += digits[bits % 36];
  }
  return ToText(target.parent_path() / ToPath(name));
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
  if (const int error = replaced.GetStamp(this->Replaced))
  {
    this->Fail(error);
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
  return { folder, ToText(ToPath(folder) / "scratch") };
}

//------------------------------------------------------------------------------
AtomicFile::~AtomicFile()
{
  if (!this->Temporary.empty())
  {
    this->RemoveTemporary();
  }
}

//------------------------------------------------------------------------------
void AtomicFile::Fail(int systemError) const
{
  throw Error(ErrorCode::CannotWrite,
    ErrorDetails{ .Path = this->Path, .What = "cannot write", .SystemError = systemError });
}

//------------------------------------------------------------------------------
void AtomicFile::Refuse(const char* what) const
{
  throw Error(ErrorCode::CannotWrite, { .Path = this->Path, .What = what });
}

//------------------------------------------------------------------------------
void AtomicFile::CheckReplaced() const
{
  FileStamp now;
  if (this->Replaced && (FileHandle::GetStamp(this->Target, now) != 0 || now != *this->Replaced))
  {
    this->Refuse("another program has changed the file meanwhile; it is kept");
  }
}

//------------------------------------------------------------------------------
int AtomicFile::TakeName(const std::function<int(const std::string&)>& take)
{
  constexpr int maximumAttempts = 100;
  int error = EEXIST;
  for (int i = 0; i < maximumAttempts && error == EEXIST; ++i)
  {
    const auto name = MakeTemporaryName(ToPath(this->Target));
    error = take(name);
    if (error == 0)
    {
      this->Temporary = name;
    }
  }
  return error;
}

//------------------------------------------------------------------------------
void AtomicFile::CreateNamed(FileHandle::Use use)
{
  const int error =
    this->TakeName([&](const std::string& name) { return this->Handle.Create(name, use); });
  if (error != 0)
  {
    this->Fail(error);
  }
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
        ErrorDetails{ .Path = temporary, .What = "cannot write", .SystemError = error });
    }
  };
  check(file.OpenToWrite(temporary));
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
  check(file.Synchronize());
  check(file.Close());
}

//------------------------------------------------------------------------------
void AtomicFile::Commit()
{
  if (const int error = this->Handle.Synchronize())
  {
    this->Fail(error);
  }
  this->CheckReplaced();
  this->MoveToTarget();
  this->Temporary.clear();
}
}
