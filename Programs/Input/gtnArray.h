// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnArray_h
#define gtnArray_h

// Which array of a mesh a subcommand takes, and which component of it.

#include "gtnCommandLine.h"

#include "gatunTypes.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

class vtkDataSet;

namespace gatun
{
class FileReader;
}

namespace gtn
{
struct ArrayOptions
{
  std::string Name;             ///< empty: the active scalars, or else the first array
  std::optional<int> Component; ///< -1: the length of the tuples
};

/** --array and --component, which it returns. What: the kinds of arrays, for the help. */
std::array<CLI::Option*, 2> AddArray(
  CLI::App* command, ArrayOptions& options, const std::string& what);

/** An array that could be taken. */
struct ArrayChoice
{
  std::string Name;
  int Association = 0; ///< of points, or 1: of cells
  int Components = 1;
  bool Active = false;
  std::size_t Index = 0; ///< in the file, or in the grid's data
};

/** Those of the points, then those of the cells. */
std::vector<ArrayChoice> GetChoices(const gatun::FileReader& file);
std::vector<ArrayChoice> GetChoices(vtkDataSet* mesh);

/** The one that the options want. Purpose: what for, as in "to draw". Throws Failure for the
 * file. */
ArrayChoice ChooseArray(const ArrayOptions& options, const std::string& file,
  const std::vector<ArrayChoice>& choices, const std::string& purpose);

/** The component that the options want, -1 for the length; 0 if there is only one. Throws Failure
 * for the file. */
int ChooseComponent(const ArrayOptions& options, const std::string& file, const ArrayChoice& array);

/** Of that component, without NaN; Min > Max if there is none. */
gatun::Range GetRange(
  const gatun::FileReader& file, const ArrayChoice& array, int component, std::size_t step);
gatun::Range GetRange(vtkDataSet* mesh, const ArrayChoice& array, int component);

/** Throws Failure for the file if any of the names is none of the arrays. */
void CheckNames(const std::vector<std::string>& names, const std::string& file,
  const std::vector<ArrayChoice>& choices);

/** "a, b", for messages. */
std::string NamesOf(const std::vector<ArrayChoice>& choices);
}

#endif
