// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSurfacePart_h
#define gatunSurfacePart_h

// Isosurfaces in a part of a mesh, with all that is on them.

#include "gatunMarch.h"
#include "gatunTypes.h"
#include "vtkGatunCoreModule.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/** Values of an array, tuple by tuple. */
struct TupleView
{
  const void* Values = nullptr;
  ScalarType Type = ScalarType::Float32;
  std::uint32_t Components = 1;

  std::size_t GetTupleSize() const { return this->Components * SizeOf(this->Type); }
};

/** A mesh in memory, as isosurfaces need it. */
struct SurfaceInput
{
  MarchInput Mesh;
  TupleView Points; ///< coordinates, of three components
  std::vector<TupleView> PointArrays;
  std::vector<TupleView> CellArrays;
};

struct SurfaceOptions
{
  std::vector<double> Values;                      ///< isovalues: finite, strictly ascending
  ScalarType CoordinateType = ScalarType::Float32; ///< of the surface: Float32 or Float64
  bool Normals = false;
};

/** Isosurfaces in a part of a mesh. Tuples lie one after the other. */
struct SurfacePart
{
  std::size_t NumberOfPoints = 0;
  std::vector<std::uint8_t> Points;
  std::vector<std::vector<std::uint8_t>> PointArrays; ///< interpolated between the ends of edges
  std::vector<std::vector<std::uint8_t>> CellArrays;  ///< of each triangle, as its tetrahedron
  std::vector<std::array<std::uint32_t, 3>> Triangles;

  /** With normals, of each point: the gradients of the part's tetrahedra around the edge that it is
   * on, times their volumes, added up. Not normalised, so that parts can be added, too. */
  std::vector<std::array<double, 3>> Gradients;
};

/** Finds the isosurfaces in the tetrahedra first to last - 1. */
VTKGATUNCORE_EXPORT SurfacePart MakeSurfacePart(const SurfaceInput& input,
  const SurfaceOptions& options, std::uint64_t first, std::uint64_t last);

/** Finds those in all tetrahedra, in parts, in parallel. Progress: as in ParallelFor. */
VTKGATUNCORE_EXPORT std::vector<SurfacePart> MakeSurfaceParts(const SurfaceInput& input,
  const SurfaceOptions& options, std::uint64_t tets,
  const std::function<bool(double)>& progress = {});

/**
 * Makes a component of an array, or the length of its tuples if component is -1 (of one component:
 * the value itself), the values of the mesh that isosurfaces are of. If they have to be converted,
 * to double, they go to converted, which must stay as long as the mesh is used.
 */
VTKGATUNCORE_EXPORT void SetMarchValues(MarchInput& mesh, const TupleView& array,
  std::size_t tuples, int component, std::vector<double>& converted);
}

#endif
