// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunOpenFile_h
#define gatunOpenFile_h

#include "gatun.h"
#include "gatunBorder.h"
#include "gatunFileReader.h"
#include "gatunSharedFile.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

/** An open file of a mesh. */
struct gatun_file
{
  gatun_file(std::shared_ptr<const gatun::FileReader> file, std::uint64_t cacheBytes);

  const gatun::FileReader& GetFile() const { return *this->Shared->GetFile(); }

  /** The number of time steps of all meshes. */
  std::size_t CountSteps() const;

  /** The mesh of a step of the file, and its step of that mesh. Step 0 exists always. */
  struct Place
  {
    std::shared_ptr<gatun::SharedFile> Mesh;
    std::size_t Step;
    std::uint32_t Number; // of the mesh
    double Time;
  };
  Place Find(std::uint64_t step) const;

  /** A source of a simplified mesh: a level, or a part of the points left out. */
  static gatun::SharedFile::Place Simplify(
    gatun::SharedFile& mesh, std::uint32_t level, double ratio);

  std::shared_ptr<gatun::SharedFile> Shared;

  // Descriptions in the form of C, of each array and of that of the points.
  std::vector<gatun::TextList> ComponentNames;
  std::vector<gatun::KeyList> Keys;
};

#endif
