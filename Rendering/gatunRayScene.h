// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunRayScene_h
#define gatunRayScene_h

#include "gatunRaySource.h"
#include "gatunTypes.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace gatun
{
class FileReader;

/** Which values are drawn. */
struct RayArray
{
  std::string Name;     ///< empty: the active scalars, of the points or else of the cells
  int Association = -1; ///< 0: of the points; 1: of the cells; -1: of either, points first
  int Component = 0;    ///< -1: the length of the tuples

  bool operator==(const RayArray&) const = default;
};

/**
 * What is drawn: a grid in memory, or a file of which only what is seen is ever decoded. What has
 * been prepared is kept, up to a budget, until something else is to be drawn.
 *
 * Methods throw gatun::Error: no such array, cells that cannot be drawn, a file that is damaged.
 */
class RayScene
{
public:
  RayScene();
  ~RayScene();
  RayScene(RayScene&&) = delete;
  RayScene& operator=(RayScene&&) = delete;

  void SetGrid(vtkUnstructuredGrid* grid, const RayArray& array, std::uint64_t budget);
  void SetFile(const std::string& path, double time, const RayArray& array, std::uint64_t budget);
  void Clear();

  RaySource& GetSource() { return *this->Source; }

  /** Of the values of everything. */
  const Range& GetRange() const { return this->Values; }

private:
  bool IsKnown(const void* what, const std::string& path, vtkMTimeType stamp, const RayArray& array,
    std::uint64_t budget);

  // What the source was made for.
  const void* Grid = nullptr;
  std::string Path;
  vtkMTimeType Stamp = 0;
  RayArray Array;
  std::uint64_t Budget = 0;

  vtkSmartPointer<vtkUnstructuredGrid> Tets; // keeps alive what the source looks at
  vtkSmartPointer<vtkDataArray> Coordinates;
  vtkSmartPointer<vtkDataArray> Scalars;
  std::vector<unsigned char> Hidden;
  std::shared_ptr<const FileReader> File;
  std::unique_ptr<RaySource> Source;
  Range Values;
};
}

#endif
