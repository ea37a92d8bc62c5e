// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The nodes of Lagrange and Bezier cells, against VTK's classes of them.

#include "gatunCellNodes.h"

#include "vtkCell.h"
#include "vtkGenericCell.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderWedge.h"
#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace
{
/** VTK's coordinates of a node in the cell, from 0 to 1. */
using Place = std::array<double, 3>;

bool IsNear(const Place& a, const Place& b)
{
  constexpr double roundoff = 1e-12;
  double far = 0;
  for (unsigned i = 0; i < 3; ++i)
  {
    far = std::max(far, std::abs(a[i] - b[i]));
  }
  return far < roundoff;
}

/** A cell of VTK with points that are where they are in the parametric cell. */
vtkSmartPointer<vtkCell> MakeCell(int type, vtkIdType points)
{
  auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  cell->GetPoints()->SetNumberOfPoints(points);
  cell->GetPointIds()->SetNumberOfIds(points);
  for (vtkIdType i = 0; i < points; ++i)
  {
    cell->GetPoints()->SetPoint(i, 0, 0, 0);
    cell->GetPointIds()->SetId(i, i);
  }
  if (auto* const hexahedron = vtkHigherOrderHexahedron::SafeDownCast(cell))
  {
    hexahedron->SetUniformOrderFromNumPoints(points);
  }
  if (auto* const wedge = vtkHigherOrderWedge::SafeDownCast(cell))
  {
    wedge->SetUniformOrderFromNumPoints(points);
  }
  if (auto* const quad = vtkHigherOrderQuadrilateral::SafeDownCast(cell))
  {
    quad->SetUniformOrderFromNumPoints(points);
  }
  cell->Initialize();
  return cell;
}

std::vector<Place> GetPlaces(vtkCell* cell)
{
  const double* const coordinates = cell->GetParametricCoords();
  std::vector<Place> places;
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    places.push_back({ coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2] });
  }
  return places;
}

/** The mean of the corners of a node with its weights. */
Place GetMean(const gatun::CellNode& node, const std::vector<Place>& places)
{
  Place mean{ 0, 0, 0 };
  double sum = 0;
  for (unsigned c = 0; c < 4 && node.Host[c] != gatun::CellNode::None; ++c)
  {
    sum += node.Weights[c];
    for (unsigned i = 0; i < 3; ++i)
    {
      mean[i] += node.Weights[c] * places[node.Host[c]][i];
    }
  }
  for (auto& x : mean)
  {
    x /= sum;
  }
  return mean;
}

/** Whether the shape function of a node is 1 where the node is. Bezier cells do not interpolate. */
bool IsInterpolated(vtkCell* cell, const gatun::CellNode& node, const Place& place)
{
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()), 0.0);
  Place x{};
  int subCell = 0;
  cell->EvaluateLocation(subCell, place.data(), x.data(), weights.data());
  constexpr double roundoff = 1e-9;
  return std::abs(weights[node.Point] - 1.0) < roundoff;
}

bool IsRight(int type, unsigned order)
{
  const auto& nodes = gatun::GetNodesOfOrder(type, order);
  const auto cell = MakeCell(type, static_cast<vtkIdType>(nodes.Points));
  const auto places = GetPlaces(cell);
  const bool interpolates = type < 75;
  for (const auto& node : nodes.Nodes)
  {
    Place place{};
    for (unsigned i = 0; i < 3; ++i)
    {
      place[i] = double{ 1 } * node.Place[i] / order;
    }
    const bool isInside = node.Where == gatun::CellNode::Kind::Inside;
    if (!IsNear(place, places[node.Point]) ||
      (!isInside && !IsNear(GetMean(node, places), places[node.Point])) ||
      (interpolates && order < 6 && !IsInterpolated(cell, node, place)))
    {
      std::cerr << "point " << node.Point << " of cells of type " << type << " and order " << order
                << " is not where VTK has it\n";
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
int TestCellNodes(int, char*[])
{
  int wrong = 0;
  int types = 0;
  for (int type = 0; type < 256; ++type)
  {
    if (!gatun::HasNodeOrder(type))
    {
      continue;
    }
    ++types;
    for (const unsigned order : { 1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 9u, gatun::MaxNodeOrder })
    {
      wrong += IsRight(type, order) ? 0 : 1;
    }
  }
  if (types != 12)
  {
    std::cerr << types << " types of cells of any order\n";
    ++wrong;
  }
  return wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
