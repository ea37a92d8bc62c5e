// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileSettings_h
#define gatunFileSettings_h

#include "gatunPublishedFile.h"
#include "gatunSimplifyProperties.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gatun
{
/** The settings of a reader that its consumers need to use its file in place of its output. They
 * apply to all meshes of a series. */
struct FileSettings
{
  std::string Path;
  SimplifyProperties Simplification;
  bool RestoreOrder = true;
  bool SplitCells = false;
  bool GenerateGlobalIds = false;
  bool HasRegion = false; ///< whether the reader is restricted to a region of interest
  std::optional<std::uint64_t> LargeMesh; ///< the output of a mesh with more cells is an outline
  std::vector<bool> Selected; ///< for each array of the file, whether the reader reads it

  /** Whether a simplification is asked for, possible or not. */
  bool Simplifies() const { return !this->Simplification.GetTarget().IsWholeMesh(); }

  /** The number of merges that the simplification of a mesh takes. Throws Error. */
  std::size_t CountMerges(SharedFile& mesh) const;

  /** Whether the output is an outline. Throws Error. */
  bool IsOnDemand(SharedFile& mesh) const;

  /** What a handle tells of a mesh. */
  PublishedFile Describe(const std::shared_ptr<SharedFile>& mesh) const;
};

/** The mesh of a file that has the last step not later than a time, or the first step: 0 if the
 * mesh does not change. */
std::size_t FindMesh(const FileReader& file, double time);
}

#endif
