// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunArrayChoice_h
#define gatunArrayChoice_h

#include "vtkDataArraySelection.h"
#include "vtkNew.h"

#include <map>
#include <string>
#include <vector>

namespace gatun
{
/** A vtkDataArraySelection that remembers arrays which the present file does not have, so that a
 * series of files with different arrays keeps the choice. */
class ArrayChoice
{
public:
  /** The names of the arrays of the file, each once. */
  void SetArrays(const std::vector<std::string>& names);

  /** Whether an array is selected. One without a name always is. */
  bool Wants(const std::string& name) const;

  vtkNew<vtkDataArraySelection> Selection;

private:
  std::map<std::string, bool> Remembered;
};
}

#endif
