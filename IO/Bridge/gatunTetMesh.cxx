// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTetMesh.h"

#include "gatunArrayBridge.h"
#include "gatunError.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

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
  doubles->SetNumberOfTuples(data->GetNumberOfTuples());
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
TetMesh::TetMesh(vtkUnstructuredGrid* grid)
{
  if (grid->GetNumberOfPoints() > 0)
  {
    this->Coordinates = CoordinatesOf(grid->GetPoints(), this->PointsConverted);
    this->Mesh.Points = static_cast<std::uint64_t>(grid->GetNumberOfPoints());
    this->Mesh.Coordinates = this->Coordinates->GetVoidPointer(0);
  }
  if (grid->GetPoints() && grid->GetPoints()->GetDataType() != VTK_FLOAT)
  {
    this->Mesh.CoordinateType = ScalarType::Float64;
  }
  if (vtkCellArray* cells = grid->GetCells())
  {
    this->Mesh.WideIds = cells->IsStorage64Bit();
    if (cells->GetNumberOfCells() > 0)
    {
      this->Connectivity = cells->GetConnectivityArray();
      this->Mesh.Tets = static_cast<std::uint64_t>(cells->GetNumberOfCells());
      this->Mesh.Connectivity = this->Connectivity->GetVoidPointer(0);
    }
  }
}

TetMesh::~TetMesh() = default;

//------------------------------------------------------------------------------
std::size_t TetMesh::Hash() const
{
  const auto bytesOf = [](vtkDataArray* array)
  {
    return array ? std::string_view(static_cast<const char*>(array->GetVoidPointer(0)),
                     static_cast<std::size_t>(array->GetNumberOfValues()) *
                       static_cast<std::size_t>(array->GetDataTypeSize()))
                 : std::string_view();
  };
  const std::hash<std::string_view> hash;
  return hash(bytesOf(this->Coordinates)) * 31 + hash(bytesOf(this->Connectivity));
}
}
