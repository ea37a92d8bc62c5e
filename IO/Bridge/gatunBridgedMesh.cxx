// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBridgedMesh.h"

#include "gatunArrayBridge.h"
#include "gatunCellArrays.h"
#include "gatunError.h"
#include "gatunNewArray.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace gatun
{
namespace
{
/** Coordinates as float or double. Sets converted where they had another type. */
vtkSmartPointer<vtkDataArray> CoordinatesOf(vtkPoints* points, bool& converted)
{
  vtkDataArray* data = points->GetData();
  if (data->GetDataType() == VTK_FLOAT || data->GetDataType() == VTK_DOUBLE)
  {
    return Contiguous(data);
  }
  converted = true;
  auto doubles = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(VTK_DOUBLE));
  doubles->SetNumberOfComponents(3);
  SizeArray(doubles, data->GetNumberOfTuples());
  // Up to here every integer is a double.
  constexpr double exact = 9007199254740992.0;
  for (vtkIdType point = 0; point < data->GetNumberOfTuples(); ++point)
  {
    double tuple[3];
    data->GetTuple(point, tuple);
    if (std::max({ std::abs(tuple[0]), std::abs(tuple[1]), std::abs(tuple[2]) }) >= exact)
    {
      ThrowInvalid(
        "the coordinates of point " + std::to_string(point) + " are integers beyond 2^53");
    }
    doubles->SetTuple(point, tuple);
  }
  return doubles;
}
}

//------------------------------------------------------------------------------
BridgedMesh::BridgedMesh(vtkUnstructuredGrid* grid)
{
  if (grid->GetNumberOfPoints() > 0)
  {
    this->Coordinates = CoordinatesOf(grid->GetPoints(), this->PointsConverted);
    this->Mesh.Points = static_cast<std::uint64_t>(grid->GetNumberOfPoints());
    this->Mesh.Coordinates = this->Coordinates->GetVoidPointer(0);
  }
  if (grid->GetPoints())
  {
    this->Mesh.PointArray = DescribePoints(grid->GetPoints()->GetData());
  }
  if (grid->GetPoints() && grid->GetPoints()->GetDataType() != VTK_FLOAT)
  {
    this->Mesh.CoordinateType = ScalarType::Float64;
  }
  if (vtkCellArray* cells = grid->GetCells())
  {
    this->Mesh.WideIds = HasWideIds(cells);
    if (cells->GetNumberOfCells() > 0)
    {
      this->Connectivity = GetPointIds(cells);
      this->Mesh.Cells = static_cast<std::uint64_t>(cells->GetNumberOfCells());
      // Cells without points have no ids, and an empty array no memory.
      static constexpr std::int64_t none = 0;
      this->Mesh.Connectivity =
        this->Connectivity->GetNumberOfValues() > 0 ? this->Connectivity->GetVoidPointer(0) : &none;
      const auto types = GetCellTypes(grid);
      const unsigned char* const begin = types->GetPointer(0);
      if (cells->IsHomogeneous() != 4 ||
        !std::all_of(begin, begin + types->GetNumberOfValues(),
          [](unsigned char type) { return type == VTK_TETRA; }))
      {
        this->Types = types;
        this->Mesh.Types = begin;
        this->SetOthers(grid);
      }
    }
  }
}

//------------------------------------------------------------------------------
/** Sets what only cells other than tetrahedra need. */
void BridgedMesh::SetOthers(vtkUnstructuredGrid* grid)
{
  const auto bytesOf = [](vtkIdTypeArray* ids)
  {
    static_assert(sizeof(vtkIdType) == sizeof(std::int64_t));
    return reinterpret_cast<const std::int64_t*>(ids->GetPointer(0));
  };
  this->Offsets = GetOffsets(grid->GetCells());
  this->Mesh.Offsets = this->Offsets->GetVoidPointer(0);
  const FaceStream faces = GetFaceStream(grid);
  if (faces.Values && faces.Locations->GetNumberOfValues() >= grid->GetNumberOfCells())
  {
    this->Faces = faces;
    this->Mesh.FaceLocations = bytesOf(faces.Locations);
    this->Mesh.Faces = bytesOf(faces.Values);
    this->Mesh.FacesSize = static_cast<std::uint64_t>(faces.Values->GetNumberOfValues());
  }
}

BridgedMesh::~BridgedMesh() = default;

//------------------------------------------------------------------------------
namespace
{
template <std::size_t N>
Fingerprint HashArrays(const std::array<vtkDataArray*, N>& arrays)
{
  std::array<std::span<const std::uint8_t>, N> bytes;
  for (std::size_t i = 0; i < N; ++i)
  {
    if (vtkDataArray* const array = arrays[i])
    {
      bytes[i] = { static_cast<const std::uint8_t*>(array->GetVoidPointer(0)),
        static_cast<std::size_t>(array->GetNumberOfValues()) *
          static_cast<std::size_t>(array->GetDataTypeSize()) };
    }
  }
  return MakeFingerprint(bytes);
}
}

//------------------------------------------------------------------------------
Fingerprint BridgedMesh::HashCells() const
{
  return HashArrays<5>(
    { this->Connectivity, this->Offsets, this->Types, this->Faces.Locations, this->Faces.Values });
}

//------------------------------------------------------------------------------
Fingerprint BridgedMesh::HashPoints() const
{
  return HashArrays<1>({ this->Coordinates });
}

//------------------------------------------------------------------------------
Fingerprint BridgedMesh::Hash() const
{
  return HashArrays<6>({ this->Coordinates, this->Connectivity, this->Offsets, this->Types,
    this->Faces.Locations, this->Faces.Values });
}
}
