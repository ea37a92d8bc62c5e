// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// What is known of cell types, against VTK's classes of them.

#include "gatunCellShapes.h"

#include "vtkCell.h"
#include "vtkCell3D.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace
{
using Face = std::vector<vtkIdType>;

Face Turn(Face face)
{
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

std::set<Face> GetOwnFaces(const gatun::CellShape& shape)
{
  std::set<Face> faces;
  for (std::size_t at = 0; at < shape.Faces.size(); at += 1u + shape.Faces[at])
  {
    const auto corners = shape.Faces.subspan(at + 1, shape.Faces[at]);
    faces.insert(Turn({ corners.begin(), corners.end() }));
  }
  return faces;
}

/** VTK's faces of voxels are not in a cycle, and do not all look the same way. */
std::set<Face> Sort(const std::set<Face>& faces)
{
  std::set<Face> sorted;
  for (Face face : faces)
  {
    std::sort(face.begin(), face.end());
    sorted.insert(face);
  }
  return sorted;
}

std::set<Face> GetFaces(vtkCell3D* cell)
{
  std::set<Face> faces;
  for (vtkIdType i = 0; i < cell->GetNumberOfFaces(); ++i)
  {
    const vtkIdType* corners = nullptr;
    const vtkIdType count = cell->GetFacePoints(i, corners);
    faces.insert(Turn(Face(corners, corners + count)));
  }
  return faces;
}

/** Counts the linear 3D cells among the good ones. */
bool IsRight(int type, int& linear)
{
  const gatun::CellKind kind = gatun::GetCellKind(type);
  const auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  if (!cell)
  {
    return true; // a type without a class, or none at all
  }
  const char* const name = gatun::GetCellTypeName(type);
  if (!name || std::string(name) != cell->GetClassName())
  {
    return false;
  }
  if (kind.Dimension != cell->GetCellDimension() ||
    (kind.Points > 0 && kind.Points != cell->GetNumberOfPoints()))
  {
    return false;
  }
  if (kind.Dimension != 3)
  {
    return !kind.Shape;
  }
  auto* const solid = vtkCell3D::SafeDownCast(cell);
  if (!solid || !kind.IsLinear())
  {
    return !kind.Shape || !cell->IsLinear();
  }
  ++linear;
  const auto found = GetOwnFaces(*kind.Shape);
  return type == VTK_VOXEL ? Sort(found) == Sort(GetFaces(solid)) : found == GetFaces(solid);
}
}

//------------------------------------------------------------------------------
int TestCellKinds(int, char*[])
{
  int wrong = 0;
  int linear = 0;
  for (int type = 0; type < 256; ++type)
  {
    if (!IsRight(type, linear))
    {
      std::cerr << "cells of type " << type << " are not as VTK has them\n";
      ++wrong;
    }
  }
  if (linear != 7)
  {
    std::cerr << linear << " linear 3D cells\n";
    ++wrong;
  }
  for (const int type : { -1, 38, 43, 82, 200, 255, 1 << 30 })
  {
    if (gatun::GetCellKind(type).Dimension != -1)
    {
      std::cerr << "there are no cells of type " << type << "\n";
      ++wrong;
    }
  }
  return wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
