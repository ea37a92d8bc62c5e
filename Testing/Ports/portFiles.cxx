// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files as the core needs them on every system: names of any length and in any script, files that
// appear when they are complete, that replace others, and that leave nothing behind. Works in a
// new folder of the current one and prints what does not hold.

#include "gatunAtomicFile.h"
#include "gatunByteSource.h"
#include "gatunError.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#if defined(_WIN32)
#include "gatunWindowsNames.h"
#else
#include <filesystem>
#endif

namespace
{
using namespace gatun;
using Bytes = std::vector<std::uint8_t>;

int Failures = 0;

void Expect(bool holds, const std::string& what)
{
  if (!holds)
  {
    std::printf("portFiles: failed: %s\n", what.c_str());
    ++Failures;
  }
}

/** Whether a function throws an error of a kind whose message has a text. */
void ExpectError(ErrorCode code, const std::string& text, const std::function<void()>& run)
{
  try
  {
    run();
    Expect(false, "an error: " + text);
  }
  catch (const Error& error)
  {
    Expect(error.Code == code && std::string(error.what()).find(text) != std::string::npos,
      "the error '" + text + "' is '" + error.what() + "'");
  }
}

Bytes MakeBytes(std::size_t size, std::uint8_t first)
{
  Bytes bytes(size);
  std::iota(bytes.begin(), bytes.end(), first);
  return bytes;
}

Bytes Read(const ByteSource& source, std::uint64_t offset, std::size_t size)
{
  Bytes bytes(size);
  std::span<std::uint8_t> rest(bytes);
  const int error = source.ReadAt(offset, rest);
  bytes.resize(size - rest.size());
  Expect(error == 0, "reading");
  return bytes;
}

bool Has(const std::string& path, const Bytes& bytes)
{
  const auto source = OpenFile(path);
  return source->GetSize() == bytes.size() && Read(*source, 0, bytes.size() + 1) == bytes;
}

void Write(const std::string& path, const Bytes& bytes)
{
  AtomicFile file(path);
  file.Write(bytes);
  file.Commit();
}

#if defined(_WIN32)
// The standard library does not take long names.
std::wstring Widen(const std::string& path)
{
  std::wstring wide;
  Expect(WidenName(path, wide) == 0, "a name");
  return wide;
}

void MakeFolder(const std::string& path)
{
  CreateDirectoryW(Widen(path).c_str(), nullptr);
}

std::size_t CountFiles(const std::string& folder)
{
  WIN32_FIND_DATAW found{};
  const HANDLE search = FindFirstFileW((Widen(folder) + L"\\*").c_str(), &found);
  std::size_t count = 0;
  do
  {
    ++count;
  } while (FindNextFileW(search, &found));
  FindClose(search);
  return count - 2; // two are the folder and the one above
}

void SetReadOnly(const std::string& path, bool isReadOnly)
{
  SetFileAttributesW(
    Widen(path).c_str(), isReadOnly ? FILE_ATTRIBUTE_READONLY : FILE_ATTRIBUTE_NORMAL);
}

void Remove(const std::string& path)
{
  const auto name = Widen(path);
  Expect(DeleteFileW(name.c_str()) || RemoveDirectoryW(name.c_str()), "removing");
}
#else
void MakeFolder(const std::string& path)
{
  std::filesystem::create_directory(path);
}

std::size_t CountFiles(const std::string& folder)
{
  return static_cast<std::size_t>(std::distance(
    std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

void SetReadOnly(const std::string& path, bool isReadOnly)
{
  std::filesystem::permissions(path, std::filesystem::perms(isReadOnly ? 0444 : 0644));
}

void Remove(const std::string& path)
{
  Expect(std::filesystem::remove(path), "removing");
}
#endif

const Bytes Old = MakeBytes(1000, 1);
const Bytes New = MakeBytes(3000, 7);

/** Replaces a file that is open. Returns false if the system refuses and says so: Windows before
 * 10, and some file systems. */
bool ReplaceOpenFile(const std::function<void()>& commit)
{
#if defined(_WIN32)
  try
  {
    commit();
    return true;
  }
  catch (const Error& error)
  {
    Expect(std::string(error.what()).find("does not let it be replaced") != std::string::npos,
      error.what());
    return false;
  }
#else
  commit();
  return true;
#endif
}

void TestReplacing(const std::string& folder, const std::string& path)
{
  Write(path, Old);
  Expect(Has(path, Old), "a new file");
  {
    AtomicFile file(path);
    file.Write(New);
    Expect(Has(path, Old), "an incomplete file does not show");
  }
  Expect(CountFiles(folder) == 1 && Has(path, Old), "an incomplete file leaves nothing");
  {
    const auto reader = OpenFile(path);
    const bool isReplaced = ReplaceOpenFile([&] { Write(path, New); });
    Expect(Read(*reader, 0, 5000) == Old, "who reads a file keeps it when it is replaced");
    Expect(Has(path, isReplaced ? New : Old), "a file that others read is replaced or kept");
  }
  Expect(CountFiles(folder) == 1, "replacing leaves nothing");
  Write(path, New);
  Expect(Has(path, New) && CountFiles(folder) == 1, "a file is replaced");
}

void TestScratch(const std::string& folder, const std::string& path)
{
  AtomicFile file(path);
  file.Write(Old);
  {
    auto scratch = AtomicFile::MakeScratch(file);
    auto other = AtomicFile::MakeScratch(folder);
    scratch.Write(New);
    other.Write(Old);
    scratch.Overwrite(100, std::span(Old).first(50));
    Bytes back(50);
    scratch.ReadAt(100, back);
    Expect(std::equal(back.begin(), back.end(), Old.begin()), "a scratch file is read");
    Expect(scratch.GetTemporary().empty(), "a scratch file has no name");
  }
  Expect(file.GetSize() == Old.size(), "the size of a file");
  file.Commit();
  Expect(CountFiles(folder) == 1, "scratch files leave nothing");
}

void TestErrors(const std::string& folder, const std::string& path)
{
  using enum ErrorCode;
  ExpectError(CannotWrite, "No such file", [&] { AtomicFile file(folder + "/none/x.gtn"); });
  ExpectError(CannotWrite, "is a directory", [&] { AtomicFile file(folder); });
  ExpectError(CannotOpen, "No such file", [&] { OpenFile(folder + "/none.gtn"); });
  ExpectError(CannotOpen, "is a directory", [&] { OpenFile(folder); });
  SetReadOnly(path, true);
  ExpectError(CannotWrite, "is read-only", [&] { AtomicFile file(path); });
  SetReadOnly(path, false);
  Expect(CountFiles(folder) == 1, "errors leave nothing");
}

/** A file that replaces one that is open, as when time steps are added. */
void TestChanges(const std::string& path)
{
  FileHandle::Kind kind{};
  std::uint64_t size = 0;
  FileHandle handle;
  Write(path, Old);
  Expect(handle.OpenToRead(path, kind, size) == 0 && size == Old.size(), "opening");
  {
    AtomicFile file(path, handle);
    file.Write(New);
    const bool isReplaced = ReplaceOpenFile([&] { file.Commit(); });
    Expect(Has(path, isReplaced ? New : Old), "the file that is open is replaced or kept");
  }
  Expect(handle.OpenToRead(path, kind, size) == 0, "opening again");
  AtomicFile file(path, handle);
  handle.Close();
  file.Write(Old);
  Write(path, MakeBytes(20, 0));
  ExpectError(ErrorCode::CannotWrite, "another program has changed", [&] { file.Commit(); });
  Expect(Has(path, MakeBytes(20, 0)), "a file that was changed is kept");
}

/** A file that several processes write, with bytes behind 4 GiB. */
void TestCommon(const std::string& folder, const std::string& path)
{
  constexpr std::uint64_t beyond = (std::uint64_t{ 4 } << 30) + 12345;
  auto common = AtomicFile::MakeCommon(path);
  Expect(!common.GetTemporary().empty(), "a common file has a name");
  common.Write(Old);
  const auto hole = common.Skip(beyond - Old.size());
  common.Write(New);
  auto own = AtomicFile::MakeScratch(folder);
  own.Write(New);
  own.CopyTo(common.GetTemporary(), 10, hole, 500);
  common.Commit();
  const auto source = OpenFile(path);
  Expect(source->GetSize() == beyond + New.size(), "the size of a large file");
  Expect(Read(*source, beyond, New.size()) == New, "bytes behind 4 GiB");
  Expect(
    Read(*source, hole, 500) == Bytes(New.begin() + 10, New.begin() + 510), "bytes of another");
  Expect(Read(*source, beyond + New.size() + 5, 10).empty(), "nothing behind the end");
}

void Run()
{
  // Longer than Windows usually takes, with umlauts and an emoji.
  std::vector<std::string> folders{ "portFiles.tmp" };
  for (const char letter : std::string("abcd"))
  {
    folders.push_back(folders.back() + "/\xc3\xa4\xe2\x82\xac" + std::string(70, letter));
  }
  std::for_each(folders.begin(), folders.end(), MakeFolder);
  const auto& folder = folders.back();
  const auto path = folder + "/m\xc3\xb6 \xf0\x9f\x98\x80.gtn";
  Expect(path.size() > 300, "a long name");
  TestReplacing(folder, path);
  TestScratch(folder, path);
  TestErrors(folder, path);
  TestChanges(path);
  TestCommon(folder, path);
  Remove(path);
  std::for_each(folders.rbegin(), folders.rend(), Remove);
}
}

int main()
{
  try
  {
    Run();
  }
  catch (const std::exception& error)
  {
    Expect(false, error.what());
  }
  std::printf("portFiles: %d failures\n", Failures);
  return Failures == 0 ? 0 : 1;
}
