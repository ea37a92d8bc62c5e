// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnInputOptions_h
#define gtnInputOptions_h

#include <string>
#include <vector>

namespace gtn
{
/** Which parts of a mesh are read, and how. */
struct InputOptions
{
  std::vector<std::string> Arrays; ///< names of the point and cell arrays to keep
  bool AllArrays = true;           ///< keep all, and Arrays means nothing
  bool Split = false;              ///< split cells into tetrahedra, with a warning
  bool Triangles = false;          ///< divide the cells of surfaces into triangles
  bool VolumesOnly = false;        ///< only the tetrahedra that cells consist of matter
  bool SurfacesToo = false;        ///< with VolumesOnly: surfaces matter, too
  bool Sets = false;               ///< also side sets, node sets, patches, boundaries
  bool InPieces = false;           ///< the files of a .pvtu or .pvd file are read one by one
  bool SkipMissing = false;        ///< go on without files that a list names and that are missing
  bool KeepApart = false;          ///< with InPieces: do not join points of different files
  bool Quiet = false;              ///< no warnings
};
}

#endif
