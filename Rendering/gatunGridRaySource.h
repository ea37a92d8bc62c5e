// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGridRaySource_h
#define gatunGridRaySource_h

#include "gatunBridgedMesh.h"
#include "gatunMemoryRaySource.h"
#include "gatunRaySource.h"
#include "gatunTypes.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkDataArray;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** Which values are drawn. */
struct RayArray
{
  std::string Name;         ///< empty: the active scalars, of the points or else of the cells
  int Association = -1;     ///< 0: of the points; 1: of the cells; -1: of either, points first
  int Component = -1;       ///< -1: the length of tuples, or the value where there is one component
  std::optional<int> Index; ///< which array of its kind, from 0, instead of a name

  bool operator==(const RayArray&) const = default;
};

/** What is missing, for a message. */
std::string DescribeMissing(const RayArray& array);

/** The component that is drawn of an array with so many, or -1 for the length. Throws InvalidInput
 * if it does not have it. */
int FindComponent(const RayArray& array, std::uint32_t components);

/** The range of all blocks together. */
Range GetWholeRange(const RaySource& source);

/** Tetrahedra of a grid, and its values, as the core takes them. */
class GridMesh
{
public:
  /** Throws as GridRaySource does. */
  GridMesh(vtkUnstructuredGrid* grid, const RayArray& array);
  ~GridMesh();
  GridMesh(const GridMesh&) = delete;
  GridMesh& operator=(const GridMesh&) = delete;

  const MeshInput& GetMesh() const { return this->Mesh->Mesh; }
  const RayValuesInput& GetValues() const { return this->Values; }

  /** Null, or for each tetrahedron whether it is left out. */
  const unsigned char* GetHidden() const
  {
    return this->Hidden.empty() ? nullptr : this->Hidden.data();
  }

private:
  vtkSmartPointer<vtkUnstructuredGrid> Tets; // keeps alive what the others look at
  std::unique_ptr<BridgedMesh> Mesh;
  vtkSmartPointer<vtkDataArray> Scalars;
  std::vector<unsigned char> Hidden;
  RayValuesInput Values;
};

/**
 * A grid in memory, of any cells that can be made tetrahedra, in blocks. Hidden, refined and
 * duplicate cells are left out. The grid must not change.
 */
class GridRaySource final : public RaySource
{
public:
  /** Throws InvalidInput for an array that is not there and for cells that cannot be drawn. */
  GridRaySource(vtkUnstructuredGrid* grid, const RayArray& array, std::uint64_t budget);
  ~GridRaySource() override;

  std::size_t GetNumberOfBlocks() const override;
  const Bounds& GetBounds(std::size_t block) const override;
  Range GetRange(std::size_t block) const override;
  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) override;

private:
  GridMesh Mesh;
  MemoryRaySource Source;
};
}

#endif
