// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPartList_h
#define gtnPartList_h

// Files that list the parts of a mesh in other files, and what these parts have together.

#include "gtnInputOptions.h"
#include "gtnXMLPieces.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace gtn
{
/** Whether a file lists parts of a mesh, by its extension: .pvtu .pvtp. */
bool IsPartList(const std::string& file);

/** The files that such a file lists; any other file itself. Those that do not exist are handled by
 * FindExisting. Throws Failure. */
std::vector<std::string> FindParts(const std::string& file, const InputOptions& options);

/** The files that exist. Names the others, if the options let them be skipped. list: the file that
 * lists them. Throws Failure otherwise, and if none exists. */
std::vector<std::string> FindExisting(
  const std::string& list, const std::vector<std::string>& files, const InputOptions& options);

/**
 * The types of the points and arrays that all parts of a mesh in .vtu and .vtp files have. VTK's
 * readers of .pvtu and .pvtp files believe what these declare, and read garbage where that is
 * wrong; here, the parts count. Where some have Float32 and others Float64, all get Float64, which
 * is exact. Other differences are refused, and so are arrays that some parts lack.
 */
class PartForm
{
public:
  PartForm() = default;

  /** Reads the parts without their values. list: the file that lists them. Throws Failure. */
  PartForm(
    const std::string& list, const std::vector<std::string>& files, const InputOptions& options);

  /** Converts the points and arrays of a part to these types. */
  void Apply(vtkDataSet* part) const;

private:
  struct Part
  {
    std::string File;
    XMLForm Form;
  };

  void MatchPoints(const std::vector<Part>& parts);
  void MatchArrays(const std::vector<Part>& parts, const InputOptions& options);
  void MatchArray(const std::vector<Part>& parts, XMLArrayForm array);
  void Warn(const std::string& what) const;

  std::string List;
  bool IsQuiet = false;
  XMLForm Form;
};
}

#endif
