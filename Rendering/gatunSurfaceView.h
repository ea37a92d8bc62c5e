// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceView_h
#define gatunSurfaceView_h

// Which parts of a surface a camera sees.

#include "gatunTypes.h"

#include "vtkType.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <array>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkActor;
class vtkPolyData;
class vtkRenderer;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** A cone that has the normals of all triangles of a part of a surface. */
struct NormalCone
{
  std::array<double, 3> Axis{};
  double Angle = 0;   ///< between the axis and a normal at most, in radians
  bool Known = false; ///< false if there is no such cone narrower than a half space
};

/** The cone of the normals by the order of corners. It is known only if all cells are triangles
 * with finite coordinates; those without area have no normal and do not count. */
NormalCone FindNormalCone(vtkPolyData* part);

/** A camera's view of an actor, for parts in the coordinates of the actor's data. */
class SurfaceView
{
public:
  SurfaceView(vtkRenderer* renderer, vtkActor* actor);

  /** Whether a part within a box may be in the view. */
  bool Reaches(const Bounds& box) const;

  /** Whether all triangles of a part within a box are culled, as their back or front faces are. */
  bool Culls(const Bounds& box, const NormalCone& cone) const;

  /** 1 if back faces by the order of corners are culled, -1 if front faces are, 0 if neither. */
  int GetCulledSide() const { return this->Side > 0 ? 1 : this->Side < 0 ? -1 : 0; }

  /** A number that grows with the distance of the middle of a box from the camera. */
  double GetDepth(const Bounds& box) const;

private:
  using Vector = std::array<double, 3>;

  std::array<double, 16> ToClip{}; ///< from data to clip coordinates, by rows
  std::array<double, 2> Margin{};  ///< by which lines and points are wider than their places
  Vector Eye{};                    ///< in data coordinates
  Vector Direction{};              ///< of parallel projections, in data coordinates
  bool IsParallel = false;
  double Side = 0; ///< 1 if back faces by the order of corners are culled, -1 if front faces; or 0
};
}

#endif
