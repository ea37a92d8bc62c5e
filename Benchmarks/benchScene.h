// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchScene_h
#define benchScene_h

// What all images of the benchmarks show, whoever draws them.

#include "gatunFileReader.h"
#include "gatunRayTable.h"
#include "gatunRayView.h"

#include <array>
#include <cstdint>
#include <string>

class vtkCamera;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

namespace bench
{
/** Degrees that the camera goes on from one image to the next. */
inline constexpr double TurnOfImages = 7;

/** A mesh's box and values, and how it is looked at: all of it, a little from above. */
struct Scene
{
  std::array<double, 6> Box{};
  std::array<double, 2> Values{};

  /** Puts a camera in its place, turned around the mesh by an angle in degrees. */
  void SetUp(vtkCamera* camera, double turn = 0) const;
  void SetUp(vtkVolumeProperty* property) const;

  /** The same for the core; samples, if the mode takes any, are as far apart as pixels are. */
  gatun::RayView MakeView(int size) const;
  gatun::RayTable MakeTable(const gatun::RayView& view, gatun::RayMode mode) const;

private:
  double GetDiagonal() const;
};

/** The scene of a grid and a point array of it. Throws Failure. */
Scene MakeScene(vtkUnstructuredGrid* grid, const std::string& array);

/** The scene of a .gtn file, by its tables alone. */
Scene MakeScene(const gatun::FileReader& file, const std::string& array);

/** Which of a file's arrays it is. Throws Failure if there is none of that name. */
std::uint32_t FindPointArray(const gatun::FileReader& file, const std::string& array);
}

#endif
