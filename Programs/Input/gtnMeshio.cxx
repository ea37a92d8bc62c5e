// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnMeshio.h"

#include "gtnFailure.h"
#include "gtnMeshioScript.h"
#include "gtnMessages.h"
#include "gtnProgress.h"
#include "gtnReadable.h"
#include "gtnText.h"

#include "vtkObjectFactory.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>

namespace gtn
{
namespace
{
constexpr std::array<std::string_view, 17> meshioExtensions{ ".msh", ".med", ".inp", ".su2",
  ".xdmf", ".xmf", ".bdf", ".nas", ".fem", ".mesh", ".meshb", ".vol", ".avs", ".mdpa", ".f3grid",
  ".ugrid", ".h5m" };

constexpr int noMeshio = 3; // exit code of the script

/** A file without a name, which goes with this object. */
class NamelessFile
{
public:
  NamelessFile()
  {
    std::string name = (std::filesystem::temp_directory_path() / "gtn-XXXXXX").string();
    this->Handle = ::mkostemp(name.data(), O_CLOEXEC);
    if (this->Handle < 0)
    {
      throw Failure(name, std::string("cannot be made: ") + std::strerror(errno));
    }
    ::unlink(name.c_str());
  }
  ~NamelessFile() { ::close(this->Handle); }
  NamelessFile(const NamelessFile&) = delete;
  NamelessFile& operator=(const NamelessFile&) = delete;

  int Get() const { return this->Handle; }
  std::string GetPath() const { return "/proc/self/fd/" + std::to_string(this->Handle); }

private:
  int Handle;
};

/** Reads a file without a name, which goes with it. */
class MeshioReader : public vtkXMLUnstructuredGridReader
{
public:
  static MeshioReader* New();
  vtkTypeMacro(MeshioReader, vtkXMLUnstructuredGridReader);

  const NamelessFile& GetFile() const { return this->File; }

protected:
  MeshioReader() { this->SetFileName(this->File.GetPath().c_str()); }

private:
  NamelessFile File;
};
vtkStandardNewMacro(MeshioReader);

/** Starts a Python with the script; its output, and the result as file 3, go to files. Returns
 * nothing if there is no such Python. */
std::optional<pid_t> StartPython(const char* python, const std::string& file,
  const NamelessFile& result, const NamelessFile& output)
{
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, output.Get(), STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, result.Get(), STDERR_FILENO + 1);
  std::array<std::string, 5> words{ python, "-c", MeshioScript, file, "3" };
  std::array<char*, 6> arguments{};
  std::transform(
    words.begin(), words.end(), arguments.begin(), [](std::string& word) { return word.data(); });
  pid_t process = 0;
  const int error = posix_spawnp(&process, python, &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0 && error != ENOENT && error != EACCES)
  {
    throw Failure(file, std::string("cannot start ") + python + ": " + std::strerror(error));
  }
  return error == 0 ? std::optional(process) : std::nullopt;
}

/** The exit code, or -1 for a crash. Throws Interrupted. */
int WaitFor(pid_t process)
{
  int status = 0;
  for (;;)
  {
    const pid_t ended = ::waitpid(process, &status, WNOHANG);
    if (ended == process)
    {
      return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    if (IsInterrupted() || (ended < 0 && errno != EINTR))
    {
      ::kill(process, SIGKILL);
      ::waitpid(process, &status, 0);
      CheckInterrupt();
      return -1;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}
}

//------------------------------------------------------------------------------
bool IsMeshioFile(const std::string& file)
{
  return std::find(meshioExtensions.begin(), meshioExtensions.end(), ExtensionOf(file)) !=
    meshioExtensions.end();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAlgorithm> MakeMeshioReader(const std::string& file)
{
  CheckReadable(file);
  auto reader = vtkSmartPointer<MeshioReader>::New();
  const NamelessFile output;
  int code = noMeshio;
  // The one that the user calls, and the one that has the packages of the system.
  for (const char* const python : { "python3", "/usr/bin/python3" })
  {
    const std::optional<pid_t> process = StartPython(python, file, reader->GetFile(), output);
    code = process ? WaitFor(*process) : noMeshio;
    if (code != noMeshio)
    {
      break;
    }
  }
  if (code == noMeshio)
  {
    throw Failure(file,
      "is read by Python's package meshio, which neither python3 nor /usr/bin/python3 has; install "
      "it by apt-get install python3-meshio");
  }
  constexpr std::string_view error = "error: ";
  constexpr std::string_view warning = "warning: ";
  std::ifstream lines(output.GetPath());
  for (std::string line; std::getline(lines, line);)
  {
    if (line.starts_with(error))
    {
      throw Failure(file, MakePrintableLine(line.substr(error.size())));
    }
    if (line.starts_with(warning))
    {
      Say(Failure(file, MakePrintableLine(line.substr(warning.size()))).what());
    }
  }
  if (code != 0)
  {
    throw Failure(file, "cannot be read by Python's package meshio, which failed");
  }
  return reader;
}
}
