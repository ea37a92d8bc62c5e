// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChildProcess.h"

#include "gatunTetGenStream.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <system_error>

extern char** environ;

namespace gatun
{
namespace
{
[[noreturn]] void ThrowSystemError(int code)
{
  throw std::system_error(code, std::generic_category());
}

/** Two ends of a socket, neither of which another program gets. */
class SocketPair
{
public:
  SocketPair()
  {
#ifdef SOCK_CLOEXEC
    constexpr int type = SOCK_STREAM | SOCK_CLOEXEC;
#else
    constexpr int type = SOCK_STREAM;
#endif
    if (socketpair(AF_UNIX, type, 0, this->Ends) != 0)
    {
      ThrowSystemError(errno);
    }
    for (const int end : this->Ends)
    {
      fcntl(end, F_SETFD, FD_CLOEXEC);
#ifdef SO_NOSIGPIPE
      const int on = 1;
      setsockopt(end, SOL_SOCKET, SO_NOSIGPIPE, &on, sizeof(on));
#endif
    }
    fcntl(this->Ends[0], F_SETFL, fcntl(this->Ends[0], F_GETFL) | O_NONBLOCK);
  }
  ~SocketPair()
  {
    close(this->Ends[0]);
    this->CloseOther();
  }
  SocketPair(const SocketPair&) = delete;
  SocketPair& operator=(const SocketPair&) = delete;

  int GetOwn() const
  {
    return this->Ends[0];
  }
  int GetOther() const
  {
    return this->Ends[1];
  }
  void CloseOther()
  {
    if (this->Ends[1] >= 0)
    {
      close(this->Ends[1]);
      this->Ends[1] = -1;
    }
  }

private:
  int Ends[2];
};

/** How a program is started: with nothing but its standard input, output and error. */
class Setup
{
public:
  Setup(int input, bool quiet)
  {
    posix_spawn_file_actions_init(&this->Files);
    posix_spawnattr_init(&this->Attributes);
    posix_spawn_file_actions_adddup2(&this->Files, input, STDIN_FILENO);
    if (quiet)
    {
      posix_spawn_file_actions_addopen(&this->Files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
      posix_spawn_file_actions_addopen(&this->Files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    }
#if defined(__GLIBC_PREREQ)
#if __GLIBC_PREREQ(2, 34)
    posix_spawn_file_actions_addclosefrom_np(&this->Files, STDERR_FILENO + 1);
#endif
#endif
    // Signals that the host ignores or blocks end the program as usual.
    sigset_t none;
    sigemptyset(&none);
    sigset_t all;
    sigfillset(&all);
    posix_spawnattr_setsigmask(&this->Attributes, &none);
    posix_spawnattr_setsigdefault(&this->Attributes, &all);
    posix_spawnattr_setflags(&this->Attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~Setup()
  {
    posix_spawnattr_destroy(&this->Attributes);
    posix_spawn_file_actions_destroy(&this->Files);
  }
  Setup(const Setup&) = delete;
  Setup& operator=(const Setup&) = delete;

  pid_t Start(const std::string& program) const
  {
    std::string name = program;
    char* const arguments[] = { name.data(), nullptr };
    pid_t process = 0;
    const int error =
      posix_spawn(&process, program.c_str(), &this->Files, &this->Attributes, arguments, environ);
    if (error != 0)
    {
      ThrowSystemError(error);
    }
    return process;
  }

private:
  posix_spawn_file_actions_t Files;
  posix_spawnattr_t Attributes;
};

/** Kills and reaps the process on every path. */
class Child
{
public:
  explicit Child(pid_t process)
    : Process(process)
  {
  }
  ~Child()
  {
    if (this->Process > 0)
    {
      kill(this->Process, SIGKILL);
      this->Wait();
    }
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
};

/** Sends the input and reads what comes back until the other end closes. Returns false if keepGoing
 * did. */
bool Talk(int socket, const Bytes& input, const std::function<bool()>& keepGoing, Bytes& result)
{
  constexpr std::size_t step = std::size_t(1) << 20;
#ifdef MSG_NOSIGNAL
  constexpr int flags = MSG_NOSIGNAL;
#else
  constexpr int flags = 0;
#endif
  const auto isFatal = [] { return errno != EINTR && errno != EAGAIN && errno != EWOULDBLOCK; };
  std::size_t sent = 0;
  bool isSending = true;
  for (;;)
  {
    if (isSending && sent == input.size())
    {
      isSending = false;
      shutdown(socket, SHUT_WR);
    }
    const short wanted = isSending ? POLLIN | POLLOUT : POLLIN;
    pollfd ready{ socket, wanted, 0 };
    if (poll(&ready, 1, 100) <= 0)
    {
      if (!keepGoing())
      {
        return false;
      }
      continue;
    }
    if (isSending && (ready.revents & POLLOUT))
    {
      const ssize_t count =
        send(socket, input.data() + sent, std::min(step, input.size() - sent), flags);
      sent += count > 0 ? count : 0;
      // A program that has ended does not read the rest; what it has answered follows.
      isSending = count >= 0 || !isFatal();
    }
    if (ready.revents & (POLLIN | POLLHUP | POLLERR))
    {
      const std::size_t size = result.size();
      result.resize(size + step);
      const ssize_t count = recv(socket, result.data() + size, step, 0);
      result.resize(size + (count > 0 ? count : 0));
      if (count == 0 || (count < 0 && isFatal()))
      {
        return true;
      }
    }
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
ChildOutcome RunProgram(const std::string& program, const Bytes& input,
  const std::function<bool()>& keepGoing, bool quiet, Bytes& result)
{
  result.clear();
  SocketPair sockets;
  Child child(Setup(sockets.GetOther(), quiet).Start(program));
  sockets.CloseOther();
  if (!Talk(sockets.GetOwn(), input, keepGoing, result))
  {
    return ChildOutcome::Stopped;
  }
  const int status = child.Wait();
  if (WIFEXITED(status) && WEXITSTATUS(status) == TetGenDone)
  {
    return ChildOutcome::Done;
  }
  // The kernel sends SIGKILL when the system is out of memory.
  const bool noMemory = (WIFEXITED(status) && WEXITSTATUS(status) == TetGenNoMemory) ||
    (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
  return noMemory ? ChildOutcome::OutOfMemory : ChildOutcome::Crashed;
}

//------------------------------------------------------------------------------
std::string FindProgram(const char* name)
{
  Dl_info info;
  if (dladdr(reinterpret_cast<const void*>(&FindProgram), &info) == 0 || !info.dli_fname)
  {
    ThrowSystemError(ENOENT);
  }
  // The real path: the folder is next to the library, not next to a link to it.
  const std::unique_ptr<char, decltype(&std::free)> path(
    realpath(info.dli_fname, nullptr), &std::free);
  if (!path)
  {
    ThrowSystemError(errno);
  }
  const std::string library = path.get();
  const std::string folder = library.substr(0, library.rfind('/'));
#ifdef GATUN_LIBRARIES_FROM_PROGRAMS
  // A static library is part of a program.
  return folder + "/" GATUN_LIBRARIES_FROM_PROGRAMS "/gatun/" + name;
#else
  return folder + "/gatun/" + name;
#endif
}
}
