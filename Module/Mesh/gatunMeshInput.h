// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshInput_h
#define gatunMeshInput_h

#include "gatunTypes.h"

#include <cstdint>
#include <span>

namespace gatun
{
/**
 * A mesh in the caller's memory, with the cells in the layout of vtkUnstructuredGrid. It must exist
 * until FileWriter::Finish has returned.
 */
struct MeshInput
{
  std::uint64_t Points = 0;
  ScalarType CoordinateType = ScalarType::Float32; ///< Float32 or Float64
  const void* Coordinates = nullptr;               ///< x, y, z of each point
  PointsDescription PointArray;
  std::uint64_t Cells = 0;
  const void* Connectivity = nullptr; ///< the point ids of each cell: four if Types is null
  bool WideIds = true; ///< whether ids are std::int64_t or std::int32_t; recorded in the file

  /** The VTK type of each cell. If all cells are tetrahedra, this and all following pointers are
   * null. */
  const std::uint8_t* Types = nullptr;

  /** The position of each cell's first point id in Connectivity, and the number of all ids at the
   * end. Cells + 1 values of the type of ids. */
  const void* Offsets = nullptr;

  /** For each cell the position of its faces in Faces, or -1 unless it is a polyhedron. Null if
   * there are no polyhedra. */
  const std::int64_t* FaceLocations = nullptr;

  /** For each polyhedron the number of faces, and for each face the number of its points and their
   * ids. */
  const std::int64_t* Faces = nullptr;
  std::uint64_t FacesSize = 0; ///< the number of values in Faces
};

/** The cells of a MeshInput that remain at a time step, if some have been deleted since the first
 * step with the mesh. Deleted cells may come back. */
struct RemainingCells
{
  std::span<const std::uint64_t> Cells; ///< the numbers of the remaining cells, ascending

  /** Whether the step has only points of remaining cells. Otherwise it has all points of the mesh.
   */
  bool DropsPoints = false;
  std::span<const std::uint64_t> Points; ///< then their numbers, ascending
};
}

#endif
