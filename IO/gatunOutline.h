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
 * Makes the outline of a file's mesh, from its tables alone: the corners of its bounds, 12 lines,
 * and the arrays of these indices, whose values have the ranges that the mesh's have at the step:
 * that of each component and, of up to three components, that of the length of the tuples, too.
 * Global and pedigree ids are arrays like any other there, and ghost flags are left out.
 *
 * Empty: the same without points and cells; so is the outline of a mesh without finite coordinates.
 */
void MakeOutline(const FileReader& file, const std::vector<std::uint32_t>& arrays, std::size_t step,
  bool isEmpty, vtkUnstructuredGrid* output);
}

#endif
