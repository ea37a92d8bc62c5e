// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBoxParts.h"

#include "vtkBoundingBox.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

namespace gatun
{
//------------------------------------------------------------------------------
vtkBoundingBox MoveBox(const vtkBoundingBox& box, vtkMatrix4x4* matrix)
{
  vtkBoundingBox moved;
  for (int corner = 0; box.IsValid() && corner < 8; ++corner)
  {
    double point[4] = { 0, 0, 0, 1 };
    box.GetCorner(corner, point);
    matrix->MultiplyPoint(point, point);
    moved.AddPoint(point[0] / point[3], point[1] / point[3], point[2] / point[3]);
  }
  return moved;
}

//------------------------------------------------------------------------------
std::vector<vtkBoundingBox> SplitBox(const vtkBoundingBox& box, int parts)
{
  if (parts <= 1 || !box.IsValid())
  {
    return std::vector<vtkBoundingBox>(static_cast<std::size_t>(parts > 1 ? parts : 1), box);
  }
  int axis = 0;
  for (int other = 1; other < 3; ++other)
  {
    axis = box.GetLength(other) > box.GetLength(axis) ? other : axis;
  }
  const int before = parts / 2;
  double low[3];
  double high[3];
  box.GetMinPoint(low);
  box.GetMaxPoint(high);
  const double cut = low[axis] + (high[axis] - low[axis]) * before / parts;
  double middle[3] = { high[0], high[1], high[2] };
  middle[axis] = cut;
  std::vector<vtkBoundingBox> all =
    SplitBox(vtkBoundingBox(low[0], middle[0], low[1], middle[1], low[2], middle[2]), before);
  low[axis] = cut;
  const std::vector<vtkBoundingBox> behind =
    SplitBox(vtkBoundingBox(low[0], high[0], low[1], high[1], low[2], high[2]), parts - before);
  all.insert(all.end(), behind.begin(), behind.end());
  return all;
}

//------------------------------------------------------------------------------
void AddCuts(const vtkBoundingBox& part, const vtkBoundingBox& whole, vtkPlaneCollection* planes)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool atEnd : { false, true })
    {
      const double place = part.GetBound(2 * axis + (atEnd ? 1 : 0));
      if (place == whole.GetBound(2 * axis + (atEnd ? 1 : 0)))
      {
        continue; // a face of the whole cuts nothing
      }
      double origin[3] = { 0, 0, 0 };
      double normal[3] = { 0, 0, 0 };
      origin[axis] = place;
      normal[axis] = atEnd ? -1 : 1;
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(origin);
      plane->SetNormal(normal);
      planes->AddItem(plane);
    }
  }
}
}
