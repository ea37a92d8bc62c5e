// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Processes that are killed while they write a file.

#include "gatunHostile.h"
#include "gatunParallel.h"
#include "gatunVerifyFile.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <functional>
#include <iostream>
#include <random>
#include <thread>

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
using namespace gatun;
using namespace gatun::test;
namespace fs = std::filesystem;

void WriteCubesTo(const std::string& path, std::int64_t cubes)
{
  WriteSample(path, MakeCubes(cubes, 0.1), {}, 1);
}

constexpr int Kills = 40;
constexpr int UnnamedFlag = O_TMPFILE & ~O_DIRECTORY;

/** Whether files in a folder can do without a name. */
bool HasUnnamedFiles(const std::string& folder)
{
  const int handle = ::open(folder.c_str(), O_TMPFILE | O_RDWR, 0600);
  if (handle >= 0)
  {
    ::close(handle);
  }
  return handle >= 0;
}

/** Makes O_TMPFILE fail in this process, as it does on some file systems. */
bool ForbidUnnamedFiles()
{
  // The third argument of openat is the flags.
  ::sock_filter program[] = {
    BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(::seccomp_data, nr)),
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_openat, 0, 3),
    BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(::seccomp_data, args[2])),
    BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, UnnamedFlag, 0, 1),
    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EOPNOTSUPP),
    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const ::sock_fprog filter{ std::size(program), program };
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
    ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

/** Runs a function in a child process and returns its exit code; kills it after a time, if any. */
int RunInChild(const std::function<bool()>& run, std::chrono::microseconds killAfter = {})
{
  const ::pid_t child = ::fork();
  if (child == 0)
  {
    SetNumberOfThreads(1); // for a file that is the same in each run
    bool ok = false;
    try
    {
      ok = run();
    }
    catch (const std::exception& error)
    {
      std::cerr << error.what() << std::endl;
    }
    std::_Exit(ok ? 0 : 1);
  }
  if (killAfter.count() > 0)
  {
    std::this_thread::sleep_for(killAfter);
    ::kill(child, SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/** The tetrahedra of the files that WriteCubesTo makes in turns. */
constexpr std::int64_t Sizes[] = { 6, 9 };

bool IsWhole(const std::string& path)
{
  const FileReader file(path);
  const auto tets = static_cast<std::int64_t>(file.GetNumberOfTets());
  return VerifyFile(file) &&
    std::any_of(
      std::begin(Sizes), std::end(Sizes), [=](std::int64_t n) { return 6 * n * n * n == tets; });
}

struct Leftovers
{
  int Names = 0; ///< kills after which there was a temporary name
  int Half = 0;  ///< of these files, those that are not complete
};

/** Kills processes that replace a file again and again, or write it for the first time. */
Leftovers KillWriters(const std::string& path, bool replaces, const std::function<bool()>& prepare)
{
  Leftovers left;
  std::mt19937 random(replaces ? 1 : 2);
  std::uniform_int_distribution<int> pause(100, 40000);
  const auto folder = fs::path(path).parent_path();
  for (int i = 0; i < Kills; ++i)
  {
    if (replaces)
    {
      WriteCubesTo(path, Sizes[0]);
    }
    const auto forever = [&]
    {
      if (!prepare())
      {
        return false;
      }
      for (std::size_t turn = 1;; ++turn)
      {
        WriteCubesTo(path, Sizes[turn % 2]);
        if (!replaces)
        {
          fs::remove(path);
        }
      }
    };
    EXPECT_EQ(RunInChild(forever, std::chrono::microseconds(pause(random))), -1);
    EXPECT_TRUE(!replaces || fs::exists(path));
    bool isNamed = false;
    for (const auto& entry : fs::directory_iterator(folder))
    {
      if (entry.path() == path)
      {
        EXPECT_TRUE(IsWhole(path)) << "after kill " << i;
        continue;
      }
      EXPECT_TRUE(entry.path().string().starts_with(path + ".part-")) << entry.path();
      isNamed = true;
      try
      {
        left.Half += !IsWhole(entry.path().string());
      }
      catch (const Error&)
      {
        ++left.Half;
      }
    }
    left.Names += isNamed;
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  return left;
}

TEST(KilledWriter, LeavesNothingHalf)
{
  const auto folder = fs::path(GetPath("folder"));
  fs::create_directory(folder);
  if (!HasUnnamedFiles(folder))
  {
    GTEST_SKIP() << "the file system has no files without a name";
  }
  const auto path = (folder / "a.gtn").string();
  const auto nothing = [] { return true; };
  // A new file gets its name in one step.
  EXPECT_EQ(KillWriters(path, false, nothing).Names, 0);
  // A file that replaces another one has a temporary name for a moment, but is complete by then.
  EXPECT_EQ(KillWriters(path, true, nothing).Half, 0);
}

TEST(KilledWriter, LeavesNoHalfFileWhereFilesNeedNames)
{
  const auto folder = fs::path(GetPath("folder"));
  fs::create_directory(folder);
  if (RunInChild(ForbidUnnamedFiles) != 0)
  {
    GTEST_SKIP() << "system calls cannot be filtered";
  }
  const auto path = (folder / "a.gtn").string();
  for (const bool replaces : { false, true })
  {
    const auto left = KillWriters(path, replaces, ForbidUnnamedFiles);
    std::cout << left.Names << " of " << Kills << " kills left a temporary file\n";
  }
}

TEST(KilledWriter, FilesThatNeedNamesAreLikeTheOthers)
{
  const auto folder = fs::path(GetPath("folder"));
  fs::create_directory(folder);
  if (RunInChild(ForbidUnnamedFiles) != 0)
  {
    GTEST_SKIP() << "system calls cannot be filtered";
  }
  const auto path = (folder / "a.gtn").string();
  const auto getMode = [&] { return static_cast<unsigned>(fs::status(path).permissions()); };
  const auto write = [&]
  {
    ::umask(027);
    WriteCubesTo(path, 2);
    return true;
  };
  const auto writeNamed = [&]
  { return ForbidUnnamedFiles() && !HasUnnamedFiles(folder) && write(); };
  for (const auto& run : { std::function<bool()>(write), std::function<bool()>(writeNamed) })
  {
    EXPECT_EQ(RunInChild(run), 0);
    EXPECT_EQ(getMode(), 0640U);
    fs::permissions(path, static_cast<fs::perms>(0604));
    EXPECT_EQ(RunInChild(run), 0);
    EXPECT_EQ(getMode(), 0604U);
    EXPECT_EQ(ListFolder(path), (std::vector<std::string>{ "a.gtn" }));
    fs::remove(path);
  }
}
}
