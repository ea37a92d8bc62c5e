// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSurfacePart_h
#define gatunSurfacePart_h

// Isosurfaces in a part of a mesh, with their arrays.

#include "gatunExport.h"
#include "gatunMarch.h"
#include "gatunPageArray.h"
#include "gatunTypes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/** The values of an array, tuple by tuple. */
struct TupleView
{
  const void* Values = nullptr;
  ScalarType Type = ScalarType::Float32;
  std::uint32_t Components = 1;

  std::size_t GetTupleSize() const { return this->Components * SizeOf(this->Type); }
};

/** A mesh in memory. */
struct SurfaceInput
{
  MarchInput Mesh;
  TupleView Points; ///< coordinates; three components
  std::vector<TupleView> PointArrays;
  std::vector<TupleView> CellArrays;
};

struct SurfaceOptions
{
  std::vector<double> Values;                      ///< isovalues: finite, strictly ascending
  ScalarType CoordinateType = ScalarType::Float32; ///< of the surface: Float32 or Float64
  bool Normals = false;
};

/** Isosurfaces in a part of a mesh. Tuples are contiguous. */
struct SurfacePart
{
  std::size_t NumberOfPoints = 0;
  PageArray<std::uint8_t> Points;
  std::vector<PageArray<std::uint8_t>> PointArrays; ///< interpolated between the ends of edges
  std::vector<PageArray<std::uint8_t>>
    CellArrays; ///< the values of the tetrahedron of each triangle
  PageArray<std::array<std::uint32_t, 3>> Triangles;

  /** With normals: for each point, the sum of the gradients of the tetrahedra of the part around
   * its edge, weighted by their volumes. Not normalized, so that parts can be added. */
  std::vector<std::array<double, 3>> Gradients;
};

/** Finds the isosurfaces in the tetrahedra first to last - 1. */
GATUN_EXPORT SurfacePart MakeSurfacePart(const SurfaceInput& input, const SurfaceOptions& options,
  std::uint64_t first, std::uint64_t last);

/** Finds the isosurfaces in all tetrahedra, in parts, in parallel. Progress: see ParallelFor. */
GATUN_EXPORT std::vector<SurfacePart> MakeSurfaceParts(const SurfaceInput& input,
  const SurfaceOptions& options, std::uint64_t tets,
  const std::function<bool(double)>& progress = {});

/**
 * Sets the values of a mesh to a component of an array, or to the length of its tuples if component
 * is -1 (to the value itself for arrays with one component). If values must be converted to double,
 * they are stored in converted, which must exist as long as the mesh is used.
 */
GATUN_EXPORT void SetMarchValues(MarchInput& mesh, const TupleView& array, std::size_t tuples,
  int component, std::vector<double>& converted);
}

#endif
