// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Compares systems: portHashes FILE... prints a line for each file, with the hash of all that it
// decodes to, and hashes of the files that are written of that. Files and systems do not matter to
// the text, so that Utilities/setup.sh ports can compare it. Needs the core only.

#include "gatunPortFile.h"
#include "gatunPortMesh.h"
#include "gatunPortVolume.h"

#include "gatunError.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <span>
#include <string>

namespace
{
using namespace gatun;
using namespace gatun::port;

/** A mesh, its levels and its boundary, each written anew. Other meshes of a series are meshes of
 * their own. */
void AddMesh(Line& line, const std::shared_ptr<const FileReader>& file, bool isFirst)
{
  const PortMesh mesh(file);
  mesh.AddDecoded(line.Decoded);
  AddEncoded(line, mesh);
  for (std::size_t i = 1; isFirst && i < file->GetNumberOfMeshes(); ++i)
  {
    AddMesh(line, file->OpenMesh(i), false);
  }
  for (std::size_t i = 0; i < file->GetLevels().size(); ++i)
  {
    AddMesh(line, file->OpenLevel(i), false);
  }
  if (file->HasBoundary())
  {
    AddMesh(line, file->OpenBoundary(), false);
  }
}

void AddFile(Line& line, const std::string& path)
{
  if (path.ends_with(".ghv"))
  {
    AddVolume(line, path);
  }
  else if (path.ends_with(".gtn"))
  {
    AddMesh(line, std::make_shared<const FileReader>(path), true);
  }
  else
  {
    AddGrid(line, static_cast<std::uint32_t>(std::stoul(path)));
  }
}
}

int main(int argc, char* argv[])
{
  int failed = 0;
  for (const std::string path : std::span(argv, static_cast<std::size_t>(argc)).subspan(1))
  {
    Line line;
    std::string problem;
    try
    {
      AddFile(line, path);
    }
    catch (const std::exception& error)
    {
      problem = std::string(": ") + error.what();
      ++failed;
    }
    std::printf("%s%s%s\n", path.substr(path.find_last_of("/\\") + 1).c_str(),
      line.GetText().c_str(), problem.c_str());
    std::fflush(stdout);
  }
  return failed == 0 ? 0 : 1;
}
