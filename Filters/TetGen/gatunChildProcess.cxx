// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChildProcess.h"

#if defined(__unix__) || defined(__APPLE__)
#define GATUN_HAS_FORK 1
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#else
#define GATUN_HAS_FORK 0
#endif

#include <cerrno>
#include <cstdio>
#include <new>

namespace gatun
{
#if GATUN_HAS_FORK
namespace
{

enum ExitCode
{
  Success = 0,
  Failure = 1,
  NoMemory = 2
};

[[noreturn]] void BeChild(const std::function<void(Bytes&)>& work, int target, bool quiet)
{
  // A crash is expected here; do not run the signal handlers of the parent.
  for (const int signal : { SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGTERM })
  {
    std::signal(signal, SIG_DFL);
  }
  if (quiet)
  {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
  try
  {
    Bytes bytes;
    work(bytes);
    for (std::size_t done = 0; done < bytes.size();)
    {
      const ssize_t count = write(target, bytes.data() + done, bytes.size() - done);
      if (count < 0 && errno != EINTR)
      {
        _exit(Failure);
      }
      done += count > 0 ? count : 0;
    }
    std::fflush(stdout);
    _exit(Success);
  }
  catch (const std::bad_alloc&)
  {
    _exit(NoMemory);
  }
  catch (...)
  {
    _exit(Failure);
  }
}

// Reads until the other end closes. Returns false if keepGoing returned false.
bool ReadAll(int source, const std::function<bool()>& keepGoing, Bytes& result)
{
  constexpr std::size_t step = std::size_t(1) << 20;
  for (;;)
  {
    pollfd ready{ source, POLLIN, 0 };
    if (poll(&ready, 1, 100) <= 0)
    {
      if (!keepGoing())
      {
        return false;
      }
      continue;
    }
    const std::size_t size = result.size();
    result.resize(size + step);
    const ssize_t count = read(source, result.data() + size, step);
    result.resize(size + (count > 0 ? count : 0));
    if (count == 0 || (count < 0 && errno != EINTR))
    {
      return true;
    }
  }
}

// Kills and reaps the child on every exit path of the parent.
class Child
{
public:
  Child(pid_t process, int pipe)
    : Process(process)
    , Pipe(pipe)
  {
  }
  ~Child()
  {
    if (this->Process > 0)
    {
      kill(this->Process, SIGKILL);
      this->Wait();
    }
    close(this->Pipe);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  int Wait()
  {
    int status = 0;
    while (waitpid(this->Process, &status, 0) < 0 && errno == EINTR)
    {
    }
    this->Process = 0;
    return status;
  }

private:
  pid_t Process;
  int Pipe;
};

} // anonymous namespace
#endif

//------------------------------------------------------------------------------
ChildOutcome RunInChild(const std::function<void(Bytes&)>& work,
  const std::function<bool()>& keepGoing, bool quiet, Bytes& result)
{
  result.clear();
#if GATUN_HAS_FORK
  std::fflush(nullptr); // otherwise the child would print buffered output again
  int ends[2];
  if (pipe(ends) == 0)
  {
    const pid_t process = fork();
    if (process == 0)
    {
      close(ends[0]);
      BeChild(work, ends[1], quiet);
    }
    close(ends[1]);
    if (process > 0)
    {
      Child child(process, ends[0]);
      if (!ReadAll(ends[0], keepGoing, result))
      {
        return ChildOutcome::Stopped;
      }
      const int status = child.Wait();
      if (WIFEXITED(status) && WEXITSTATUS(status) == Success)
      {
        return ChildOutcome::Done;
      }
      // The kernel sends SIGKILL when the system is out of memory.
      const bool noMemory = (WIFEXITED(status) && WEXITSTATUS(status) == NoMemory) ||
        (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
      return noMemory ? ChildOutcome::OutOfMemory : ChildOutcome::Crashed;
    }
    close(ends[0]);
  }
#else
  static_cast<void>(quiet);
#endif
  if (!keepGoing())
  {
    return ChildOutcome::Stopped;
  }
  work(result);
  return ChildOutcome::Done;
}
}
