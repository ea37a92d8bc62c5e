// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnBlockList_h
#define gtnBlockList_h

// Files that list blocks in other files.

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

/** Reads such a file, but none of those that it lists. Throws Failure. */
BlockList ReadBlockList(const std::string& file);
}

#endif
