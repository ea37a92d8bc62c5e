// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnAlign_h
#define gtnAlign_h

// The arrays of the steps of an original in the order of the file that was packed.

#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;

namespace gtn
{
/** A step of a series. */
struct SeriesPlace
{
  bool IsSeries = false; ///< whether there are several steps
  bool IsFirst = true;
  bool Fill = false; ///< whether arrays that the step does not have are filled in
};

/** Returns the original with the point and cell arrays in the order of a file, whose steps all have
 * the same ones. Those that the file has for the sake of other steps are added as the writer does:
 * vtkGhostType with 0, arrays without tuples, and if wanted all others, with NaN or 0. Names of
 * components that the original does not have, and the active arrays of later steps, become those of
 * the file; rolesDiffer becomes true if these are others. */
vtkSmartPointer<vtkUnstructuredGrid> AlignArrays(vtkUnstructuredGrid* original,
  vtkUnstructuredGrid* packed, const SeriesPlace& place, bool& rolesDiffer);
}

#endif
