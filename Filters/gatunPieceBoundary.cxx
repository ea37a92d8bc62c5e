// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPieceBoundary.h"

#include "gatunBytes.h"
#include "gatunProcessExchange.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkGeometryFilter.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace gatun
{
namespace
{
using Place = std::array<double, 3>;

/** The coordinates of a point; zeros of either sign are one. */
Place GetPlace(vtkPointSet* points, vtkIdType point)
{
  Place place{};
  points->GetPoint(point, place.data());
  for (double& x : place)
  {
    x += 0.0;
  }
  return place;
}

/** Adds the place of a point, unless a coordinate is not a number. */
void AddPlace(vtkPointSet* points, vtkIdType point, std::vector<Place>& places)
{
  const Place place = GetPlace(points, point);
  if (std::none_of(place.begin(), place.end(), [](double x) { return std::isnan(x); }))
  {
    places.push_back(place);
  }
}

/** The places of the points on the boundary of a mesh. */
std::vector<Place> FindBoundaryPlaces(vtkUnstructuredGrid* tets)
{
  std::vector<Place> places;
  if (tets->GetNumberOfCells() == 0)
  {
    return places;
  }
  vtkNew<vtkUnstructuredGrid> bare;
  bare->CopyStructure(tets);
  vtkNew<vtkGeometryFilter> boundary;
  boundary->SetInputData(bare);
  boundary->Update();
  vtkPolyData* const surface = boundary->GetOutput();
  for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
  {
    AddPlace(surface, point, places);
  }
  return places;
}

/** The places of the points of ghost cells. */
std::vector<Place> FindGhostPlaces(vtkUnstructuredGrid* input)
{
  std::vector<Place> places;
  vtkUnsignedCharArray* const ghosts = input->GetCellGhostArray();
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; ghosts && cell < input->GetNumberOfCells(); ++cell)
  {
    if ((ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0)
    {
      input->GetCellPoints(cell, points);
      for (const vtkIdType point : *points)
      {
        AddPlace(input, point, places);
      }
    }
  }
  return places;
}

std::vector<std::uint8_t> MarkPlaces(vtkUnstructuredGrid* tets, std::vector<Place> places)
{
  std::sort(places.begin(), places.end());
  std::vector<std::uint8_t> marks(static_cast<std::size_t>(tets->GetNumberOfPoints()));
  for (std::size_t point = 0; point < marks.size(); ++point)
  {
    marks[point] = std::binary_search(
      places.begin(), places.end(), GetPlace(tets, static_cast<vtkIdType>(point)));
  }
  return marks;
}

using Message = ProcessExchange::Message;

/** The box around some places, from the lowest to the highest; upside down if there are none. */
std::array<double, 6> FindBox(const std::vector<Place>& places)
{
  vtkBoundingBox box;
  for (const Place& place : places)
  {
    box.AddPoint(place[0], place[1], place[2]);
  }
  std::array<double, 6> bounds{};
  box.GetBounds(bounds.data());
  return bounds;
}

/** The places within a box. */
Message PackPlaces(const std::vector<Place>& places, const std::array<double, 6>& bounds)
{
  ByteWriter writer;
  if (bounds[0] <= bounds[1])
  {
    const vtkBoundingBox box(bounds.data());
    for (const Place& place : places)
    {
      if (box.ContainsPoint(place.data()))
      {
        for (const double x : place)
        {
          writer.Put(x);
        }
      }
    }
  }
  return std::move(writer.Data);
}

/** The places of others that are within the box of these. */
std::vector<Place> ExchangePlaces(const std::vector<Place>& own, ProcessExchange& exchange)
{
  const auto boxes = exchange.Gather(FindBox(own));
  std::vector<Message> messages(boxes.size());
  for (std::size_t p = 0; p < boxes.size(); ++p)
  {
    if (static_cast<int>(p) != exchange.GetProcess())
    {
      messages[p] = PackPlaces(own, boxes[p]);
    }
  }
  std::vector<Place> others;
  for (const Message& message : exchange.Exchange(std::move(messages)))
  {
    ByteReader reader(message);
    while (reader.GetRemaining() > 0)
    {
      for (double& x : others.emplace_back())
      {
        x = reader.Get<double>();
      }
    }
  }
  return others;
}
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> FindCommonPoints(vtkUnstructuredGrid* tets, ProcessExchange& exchange)
{
  std::vector<Place> own;
  exchange.Together([&] { own = FindBoundaryPlaces(tets); });
  return MarkPlaces(tets, ExchangePlaces(own, exchange));
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> FindCommonPoints(vtkUnstructuredGrid* tets, vtkUnstructuredGrid* input)
{
  auto places = FindGhostPlaces(input);
  return MarkPlaces(tets, places.empty() ? FindBoundaryPlaces(tets) : std::move(places));
}
}
