// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Unusual paths and full disks.

#include "gatunFileSizeLimit.h"
#include "gatunHostile.h"
#include "gatunVerifyFile.h"

#include <cerrno>
#include <csignal>
#include <iterator>

#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{
using namespace gatun;
using namespace gatun::test;
namespace fs = std::filesystem;

/** While it lives, files are opened as a user who owns nothing, if this user can become one. */
class Stranger
{
public:
  Stranger()
  {
    if (::geteuid() == 0 && ::seteuid(65534) != 0)
    {
      ADD_FAILURE() << "root cannot become another user";
    }
  }
  ~Stranger()
  {
    if (::getuid() == 0)
    {
      EXPECT_EQ(::seteuid(0), 0);
    }
  }
  Stranger(const Stranger&) = delete;
  Stranger& operator=(const Stranger&) = delete;
};

void WriteCubes(const std::string& path, std::int64_t cubes = 3)
{
  WriteSample(path, MakeCubes(cubes, 0.1), {}, 1);
}

std::string Slurp(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(in), {} };
}

TEST(HostilePaths, WhatIsNoFileIsNotRead)
{
  const auto expect = [](const std::string& path, const std::string& what)
  {
    EXPECT_GATUN_ERROR(
      ErrorCode::CannotOpen, path, "cannot open: " + what, [&] { FileReader reader(path); });
    EXPECT_FALSE(FileReader::CanRead(path));
  };
  const auto fail = [](const std::string& path, int error)
  {
    EXPECT_GATUN_SYSTEM_ERROR(ErrorCode::CannotOpen, path, error, [&] { FileReader reader(path); });
    EXPECT_FALSE(FileReader::CanRead(path));
  };
  const auto folder = GetPath("folder");
  fs::create_directory(folder);
  const auto pipe = GetPath("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fail(GetPath("missing.gtn"), ENOENT);
  EXPECT_THROW(FileReader(""), Error);
  expect(folder, "is a directory");
  expect(folder + "/", "is a directory");
  expect(pipe, "is not a regular file"); // and does not wait for a writer
  expect("/dev/null", "is not a regular file");
  expect("/dev/zero", "is not a regular file");
  fail(GetPath(std::string(300, 'x')), ENAMETOOLONG);
  fs::create_symlink("loop", GetPath("loop"));
  fail(GetPath("loop"), ELOOP);
}

TEST(HostilePaths, AFileThatMayNotBeReadIsNotRead)
{
  const auto path = GetPath("secret.gtn");
  WriteCubes(path);
  ASSERT_EQ(::chmod(path.c_str(), 0), 0);
  const Stranger stranger;
  EXPECT_GATUN_SYSTEM_ERROR(ErrorCode::CannotOpen, path, EACCES, [&] { FileReader reader(path); });
  EXPECT_FALSE(FileReader::CanRead(path));
}

TEST(HostilePaths, AFileThatShrinksWhileItIsReadIsTruncated)
{
  const auto path = GetPath("shrinks.gtn");
  WriteCubes(path);
  const auto file = std::make_shared<FileReader>(path);
  fs::resize_file(path, 30);
  EXPECT_GATUN_ERROR(ErrorCode::Truncated, path, "became shorter", [&] { VerifyFile(*file); });
}

TEST(HostilePaths, WhatIsNoFileIsNotReplaced)
{
  const auto expect = [](const std::string& path, const std::string& what)
  { EXPECT_GATUN_ERROR(ErrorCode::CannotWrite, path, what, [&] { WriteCubes(path); }); };
  const auto folder = GetPath("folder");
  fs::create_directory(folder);
  const auto pipe = GetPath("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  expect(folder, "is a directory");
  expect(pipe, "is not a regular file");
  expect("/dev/null", "is not a regular file");
  const auto fail = [](const std::string& path, int error)
  { EXPECT_GATUN_SYSTEM_ERROR(ErrorCode::CannotWrite, path, error, [&] { WriteCubes(path); }); };
  fail(GetPath("missing/a.gtn"), ENOENT);
  fail(GetPath(std::string(300, 'x')), ENAMETOOLONG);
  EXPECT_EQ(ListFolder(pipe), (std::vector<std::string>{ "folder", "pipe" }));
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(HostilePaths, AFolderThatMayNotBeWrittenStaysAsItIs)
{
  const auto folder = GetPath("locked");
  fs::create_directory(folder);
  const auto path = folder + "/a.gtn";
  WriteCubes(path);
  const auto old = Slurp(path);
  ASSERT_EQ(::chmod(folder.c_str(), 0555), 0);
  {
    const Stranger stranger;
    EXPECT_GATUN_SYSTEM_ERROR(ErrorCode::CannotWrite, path, EACCES, [&] { WriteCubes(path, 2); });
  }
  ASSERT_EQ(::chmod(folder.c_str(), 0755), 0);
  EXPECT_EQ(Slurp(path), old);
  EXPECT_EQ(ListFolder(path), (std::vector<std::string>{ "a.gtn" }));
}

TEST(HostilePaths, AReadOnlyFileIsReplacedOnRequestOnly)
{
  const auto path = GetPath("read-only.gtn");
  WriteCubes(path);
  const auto old = Slurp(path);
  const auto refuse = [&](const std::string& why, std::optional<int> error = {})
  {
    ExpectError(
      ErrorCode::CannotWrite, path, why, [&] { WriteCubes(path, 2); }, __FILE__, error);
    EXPECT_EQ(Slurp(path), old);
    EXPECT_EQ(ListFolder(path), (std::vector<std::string>{ "read-only.gtn" }));
  };
  for (const ::mode_t mode : { 0444, 0400, 0 })
  {
    ASSERT_EQ(::chmod(path.c_str(), mode), 0);
    refuse("is read-only");
  }
  // Of somebody else, in a folder where all may write.
  ASSERT_EQ(::chmod(path.c_str(), 0644), 0);
  ASSERT_EQ(::chmod(fs::path(path).parent_path().c_str(), 0777), 0);
  if (::geteuid() == 0)
  {
    const Stranger stranger;
    refuse("cannot write", EACCES);
  }
}

TEST(HostilePaths, ALinkStaysALink)
{
  fs::create_directory(GetPath("there"));
  const auto target = GetPath("there/target.gtn");
  const auto link = GetPath("link.gtn");
  fs::create_symlink("there/target.gtn", link);
  // First where it leads to nothing yet.
  for (const std::int64_t cubes : { 2, 3 })
  {
    WriteCubes(link, cubes);
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(
      FileReader(target).GetNumberOfTets(), static_cast<std::uint64_t>(6 * cubes * cubes * cubes));
  }
  EXPECT_EQ(ListFolder(target), (std::vector<std::string>{ "target.gtn" }));
  EXPECT_EQ(ListFolder(link), (std::vector<std::string>{ "link.gtn", "there" }));
}

TEST(HostilePaths, PermissionsOfTheOldFileStay)
{
  const auto path = GetPath("mode.gtn");
  WriteCubes(path);
  for (const ::mode_t mode : { 0600, 0640, 0622, 0666 })
  {
    ASSERT_EQ(::chmod(path.c_str(), mode), 0);
    WriteCubes(path);
    struct stat status
    {
    };
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, mode);
  }
  const auto mask = ::umask(027);
  const auto fresh = GetPath("new.gtn");
  WriteCubes(fresh);
  ::umask(mask);
  EXPECT_EQ(fs::status(fresh).permissions(), static_cast<fs::perms>(0640));
}

TEST(HostilePaths, AFileThatGrowsTooLargeLeavesTheOldOne)
{
  const auto path = GetPath("old.gtn");
  WriteCubes(path);
  const auto old = Slurp(path);
  WriteCubes(GetPath("larger.gtn"), 8);
  const auto size = fs::file_size(GetPath("larger.gtn"));
  fs::remove(GetPath("larger.gtn"));
  for (const auto limit : { std::uintmax_t{ 0 }, std::uintmax_t{ 10 }, std::uintmax_t{ 20 },
         size / 2, size - 40, size - 1 })
  {
    {
      const FileSizeLimit full(limit);
      EXPECT_GATUN_SYSTEM_ERROR(ErrorCode::CannotWrite, path, EFBIG, [&] { WriteCubes(path, 8); });
    }
    EXPECT_EQ(Slurp(path), old);
    EXPECT_EQ(ListFolder(path), (std::vector<std::string>{ "old.gtn" }));
  }
  WriteCubes(path, 8);
  EXPECT_EQ(fs::file_size(path), size);
}

TEST(HostilePaths, AFullDiskLeavesTheOldFile)
{
  const auto disk = GetPath("disk");
  fs::create_directory(disk);
  if (::mount("gatun", disk.c_str(), "tmpfs", 0, "size=16k") != 0)
  {
    GTEST_SKIP() << "only root can mount a small disk";
  }
  const auto path = disk + "/old.gtn";
  WriteCubes(path);
  const auto old = Slurp(path);
  EXPECT_GATUN_SYSTEM_ERROR(ErrorCode::CannotWrite, path, ENOSPC, [&] { WriteCubes(path, 10); });
  EXPECT_EQ(Slurp(path), old);
  EXPECT_EQ(ListFolder(path), (std::vector<std::string>{ "old.gtn" }));
  EXPECT_EQ(::umount(disk.c_str()), 0);
}
}
