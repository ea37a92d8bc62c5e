// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPublishedFile_h
#define gatunPublishedFile_h

#include "gatunSharedFile.h"

#include <cstddef>
#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace gatun
{
/** The contents of a vtkGatunFileHandle: a file, or one of the meshes of a series, and the settings
 * of its reader. They never change after they were published. */
struct PublishedFile
{
  std::string Path;
  std::shared_ptr<SharedFile> File; ///< null if the file cannot be opened

  /** The error that opening the file, or a setting of the reader, leads to. */
  std::exception_ptr Failure;

  /** The reason why the file cannot stand in for the reader's output; empty if it can. */
  std::string Reason;

  std::vector<bool> Selected; ///< for each array of the file, whether the reader reads it
  std::size_t Merges = 0;     ///< number of merges that the reader makes
  bool RestoreOrder = true;
  bool SplitCells = false;
  bool GenerateGlobalIds = false;
  bool OnDemand = false; ///< whether the reader's output is an outline, without the mesh

  bool CanReplaceOutput() const { return this->File && this->Reason.empty(); }
};
}

#endif
