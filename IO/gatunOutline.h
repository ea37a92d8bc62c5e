// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunOutline_h
#define gatunOutline_h

#include "vtkType.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <cstddef>
#include <cstdint>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
class FileReader;

/**
 * Creates the outline of the mesh of a file from its tables alone: the 8 corners of the bounds, 12
 * lines, and the arrays with the given indices. The values of an array span the range of the mesh
 * at the given step, for each component and, with up to three components, for the magnitude as
 * well. Global and pedigree ids become ordinary arrays; ghost arrays are skipped.
 *
 * If isEmpty is set, or the mesh has no finite coordinates, the output has the arrays but no points
 * and cells.
 */
void MakeOutline(const FileReader& file, const std::vector<std::uint32_t>& arrays, std::size_t step,
  bool isEmpty, vtkUnstructuredGrid* output);

/**
 * Gives the boundary of the mesh of a file the ranges of the mesh: adds the corners of the bounds
 * as points that no cell has, with values that span the ranges of the point arrays at the given
 * step. Global and pedigree ids of points become ordinary arrays, as in an outline. Does nothing if
 * the boundary has no points.
 */
void AddOutlinePoints(const FileReader& file, const std::vector<std::uint32_t>& arrays,
  std::size_t step, vtkUnstructuredGrid* boundary);
}

#endif
