// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPieceBoundary.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkGeometryFilter.h"
#include "vtkIdList.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace gatun
{
namespace
{
using Place = std::array<double, 3>;

constexpr int CountTag = 20260;
constexpr int PlacesTag = 20261;

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
  if (place == place)
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

/** Exchanges places with one process after the other. */
class PlaceExchange
{
public:
  explicit PlaceExchange(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  /** Returns the places of the others that are in the box of these. */
  std::vector<Place> Exchange(const std::vector<Place>& own)
  {
    const auto boxes = this->GatherBoxes(own);
    const int me = this->Controller->GetLocalProcessId();
    for (int peer = 0; peer < this->Controller->GetNumberOfProcesses(); ++peer)
    {
      const vtkBoundingBox& box = boxes[static_cast<std::size_t>(peer)];
      if (peer == me || !box.IsValid() || !boxes[static_cast<std::size_t>(me)].Intersects(box))
      {
        continue;
      }
      // All have the same order of pairs, so that nobody waits for ever.
      if (me < peer)
      {
        this->Send(own, box, peer);
        this->Receive(peer);
      }
      else
      {
        this->Receive(peer);
        this->Send(own, box, peer);
      }
    }
    return std::move(this->Places);
  }

private:
  std::vector<vtkBoundingBox> GatherBoxes(const std::vector<Place>& own)
  {
    vtkBoundingBox box;
    for (const Place& place : own)
    {
      box.AddPoint(place[0], place[1], place[2]);
    }
    std::array<double, 6> bounds{};
    box.GetBounds(bounds.data()); // of an empty box: the minimum is above the maximum
    std::vector<double> all(
      bounds.size() * static_cast<std::size_t>(this->Controller->GetNumberOfProcesses()));
    this->Controller->AllGather(bounds.data(), all.data(), static_cast<vtkIdType>(bounds.size()));
    std::vector<vtkBoundingBox> boxes;
    for (std::size_t i = 0; i < all.size(); i += bounds.size())
    {
      vtkBoundingBox& next = boxes.emplace_back();
      if (all[i] <= all[i + 1])
      {
        next.SetBounds(all.data() + i);
      }
    }
    return boxes;
  }

  void Send(const std::vector<Place>& own, const vtkBoundingBox& box, int peer)
  {
    std::vector<double> values;
    for (const Place& place : own)
    {
      if (box.ContainsPoint(place.data()))
      {
        values.insert(values.end(), place.begin(), place.end());
      }
    }
    const auto count = static_cast<vtkIdType>(values.size());
    this->Controller->Send(&count, 1, peer, CountTag);
    if (count > 0)
    {
      this->Controller->Send(values.data(), count, peer, PlacesTag);
    }
  }

  void Receive(int peer)
  {
    vtkIdType count = 0;
    this->Controller->Receive(&count, 1, peer, CountTag);
    std::vector<double> values(static_cast<std::size_t>(count));
    if (count > 0)
    {
      this->Controller->Receive(values.data(), count, peer, PlacesTag);
    }
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
    {
      this->Places.push_back({ values[i], values[i + 1], values[i + 2] });
    }
  }

  vtkMultiProcessController* const Controller;
  std::vector<Place> Places;
};
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> FindCommonPoints(
  vtkUnstructuredGrid* tets, vtkMultiProcessController* controller)
{
  return MarkPlaces(tets, PlaceExchange(controller).Exchange(FindBoundaryPlaces(tets)));
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> FindCommonPoints(vtkUnstructuredGrid* tets, vtkUnstructuredGrid* input)
{
  auto places = FindGhostPlaces(input);
  return MarkPlaces(tets, places.empty() ? FindBoundaryPlaces(tets) : std::move(places));
}
}
