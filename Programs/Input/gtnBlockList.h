// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnBlockList_h
#define gtnBlockList_h

// Files that list blocks in other files.

#include "gtnInputOptions.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkDataObjectTree;

namespace gtn
{
/** Blocks in files of their own. */
struct BlockList
{
  std::vector<std::string> Files;          ///< one for each block or part of a block
  vtkSmartPointer<vtkDataObjectTree> Tree; ///< with names and an empty grid for each file
  std::vector<unsigned> Places;            ///< the flat index of the grid of each file in the tree
};

/** Whether a file lists blocks in other files, by its extension: .vtm .vtmb .vtpc. */
bool IsBlockList(const std::string& file);

/** A list of blocks of one file, whose names are not known. */
BlockList MakeBlockList(const std::string& file, std::size_t count);

/** Reads such a file and the lists that it lists, but no blocks. Blocks whose files are missing are
 * blocks without data if the options let them be skipped. Throws Failure. */
BlockList ReadBlockList(const std::string& file, const InputOptions& options);
}

#endif
