// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnMeshio.h"

#include "gtnFailure.h"
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

// Writes what meshio reads as a .vtu file. The arguments: the file, and the number of an open file.
constexpr const char* meshioScript = R"py(
import sys
sys.path = [path for path in sys.path if path]  # not what lies in the current folder
try:
    import meshio
    import numpy as np
    from meshio._vtk_common import meshio_to_vtk_type as kinds
except ImportError:
    sys.exit(3)

def fail(text):
    print("error: " + text)
    sys.exit(1)

try:
    mesh = meshio.read(sys.argv[1])
except SystemExit:
    fail("meshio cannot read it")
except BaseException as error:
    fail("meshio: " + (str(error) or type(error).__name__).replace("\n", " "))

def plain(values):
    values = np.asarray(values)
    if values.dtype == bool:
        values = values.astype(np.uint8)
    if values.dtype == np.float16:
        values = values.astype(np.float32)
    if values.dtype.kind not in "iuf" or values.dtype.itemsize > 8:
        return None
    values = values.astype(values.dtype.newbyteorder("<"))
    return np.ascontiguousarray(values.reshape(len(values), -1) if values.ndim > 2 else values)

def put(arrays, name, values, what):
    values = plain(values)
    if values is None:
        print("warning: the %s '%s' is left out: its values are no numbers" % (what, name))
        return
    while name in arrays:
        name += " (set)"
    arrays[name] = values

points = plain(mesh.points)
if points.shape[1] < 3:
    points = np.hstack([points, np.zeros((len(points), 3 - points.shape[1]), points.dtype)])
if points.dtype.kind != "f":
    points = points.astype(np.float64)
sizes, types, ids, faces, places, count = [], [], [], [], [], 0
for block in mesh.cells:
    kind, data = block.type, block.data
    if kind.startswith("polyhedron"):
        for cell in data:
            corners = np.unique(np.concatenate([np.asarray(face) for face in cell]))
            ids.append(corners)
            sizes.append([len(corners)])
            stream = [len(cell)]
            for face in cell:
                stream += [len(face), *map(int, face)]
            faces.append(stream)
            count += len(stream)
            places.append([count])
        types.append(np.full(len(data), 42))
        continue
    number = 7 if kind.startswith("polygon") else kinds.get(kind)
    if number is None:
        fail("has cells of the type %s of meshio, which VTK does not have" % kind)
    data = np.asarray(data).reshape(len(data), -1)
    if number == 13:  # meshio's and VTK's triangles have opposite directions
        data = data[:, [0, 2, 1, 3, 5, 4]]
    ids.append(data.ravel())
    sizes.append(np.full(len(data), data.shape[1]))
    types.append(np.full(len(data), number))
    places.append(np.full(len(data), -1))

def join(parts, kind):
    return np.concatenate([np.asarray(p) for p in parts]).astype(kind) if parts else np.zeros(0, kind)

lengths = [len(block.data) for block in mesh.cells]
cells = sum(lengths)
point_data, cell_data, field_data = {}, {}, {}
for name, values in mesh.point_data.items():
    put(point_data, name, values, "point array")
for name, blocks in mesh.cell_data.items():
    put(cell_data, name, np.concatenate([np.asarray(b) for b in blocks]), "cell array")
for name, values in mesh.field_data.items():
    values = np.atleast_1d(np.asarray(values)).reshape(1, -1)
    if values.size:
        put(field_data, name, values, "field array")
for tags in (getattr(mesh, "point_tags", {}), getattr(mesh, "cell_tags", {})):  # of MED
    for number, names in tags.items():
        for name in names:
            put(field_data, name, np.array([[number]]), "name of a group")

def marks(length, members):
    members = np.asarray([] if members is None else members)
    if members.dtype == bool:
        return members.astype(np.uint8)
    found = np.zeros(length, np.uint8)
    found[members.astype(np.int64)] = 1
    return found

for name, members in mesh.point_sets.items():
    put(point_data, name, marks(len(points), members), "point set")
for name, blocks in mesh.cell_sets.items():
    if name.startswith("gmsh:bounding_entities"):
        print("warning: the sets of bounding entities of Gmsh are left out")
        continue
    put(cell_data, name, np.concatenate([marks(n, b) for n, b in zip(lengths, blocks)]), "cell set")

from xml.sax.saxutils import quoteattr
head, raw, offset = [], [], 0

def array(name, values, more=""):
    global offset
    names = {"i": "Int", "u": "UInt", "f": "Float"}
    kind = names[values.dtype.kind] + str(8 * values.dtype.itemsize)
    width = values.shape[1] if values.ndim > 1 else 1
    head.append('<DataArray type="%s" Name=%s NumberOfComponents="%d" format="appended" offset="%d"%s/>'
                % (kind, quoteattr(name), width, offset, more))
    values = np.ascontiguousarray(values)
    raw.append(values)
    offset += 8 + values.nbytes

head.append('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
            'header_type="UInt64"><UnstructuredGrid><FieldData>')
for name, values in field_data.items():
    array(name, values, ' NumberOfTuples="1"')
head.append('</FieldData><Piece NumberOfPoints="%d" NumberOfCells="%d"><PointData>' % (len(points), cells))
for name, values in point_data.items():
    array(name, values)
head.append("</PointData><CellData>")
for name, values in cell_data.items():
    array(name, values)
head.append("</CellData><Points>")
array("Points", points)
head.append("</Points><Cells>")
array("connectivity", join(ids, "<i8"))
array("offsets", np.cumsum(join(sizes, "<i8")))
array("types", join(types, np.uint8))
if faces:
    array("faces", join(faces, "<i8"))
    array("faceoffsets", join(places, "<i8"))
head.append('</Cells></Piece></UnstructuredGrid><AppendedData encoding="raw">_')
with open(int(sys.argv[2]), "wb") as out:
    out.write("".join(head).encode("utf-8"))
    for values in raw:
        out.write(np.array([values.nbytes], "<u8").tobytes())
        out.write(values.data if values.size else b"")
    out.write(b"</AppendedData></VTKFile>")
)py";

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
  std::array<std::string, 5> words{ python, "-c", meshioScript, file, "3" };
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
