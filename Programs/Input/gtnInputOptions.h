// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnInputOptions_h
#define gtnInputOptions_h

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace gtn
{
/** Some of the time steps. */
struct StepRange
{
  std::size_t First = 0;
  std::optional<std::size_t> Last; ///< that is taken, too; none: the last one of all
  std::size_t Stride = 1;
};

/** Which parts of a mesh are read, and how. */
struct InputOptions
{
  std::vector<std::string> Arrays; ///< names of the point and cell arrays to keep
  bool AllArrays = true;           ///< keep all, and Arrays means nothing
  std::vector<std::string> Skip;   ///< names of the point and cell arrays to leave out
  bool Ghosts = true;              ///< keep ghost cells
  bool Split = false;              ///< split cells into tetrahedra, with a warning
  bool Triangles = false;          ///< divide the cells of surfaces into triangles
  bool VolumesOnly = false;        ///< only the tetrahedra that cells consist of matter
  bool SurfacesToo = false;        ///< with VolumesOnly: surfaces matter, too
  bool Sets = false;               ///< also side sets, node sets, patches, boundaries
  bool NamesSets = false;          ///< say that they are left out, if they are
  bool InPieces = false;           ///< the files of a .pvtu or .pvd file are read one by one
  bool SkipMissing = false;        ///< go on without files that a list names and that are missing
  bool KeepApart = false;          ///< with InPieces: do not join points of different files
  std::optional<StepRange> Steps;  ///< only some of the time steps
  bool Quiet = false;              ///< no warnings

  /** Receives what is left out though no option says so, in place of warnings. May be null. */
  std::shared_ptr<std::set<std::string>> Lost;
};
}

#endif
