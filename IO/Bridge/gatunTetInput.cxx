// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTetInput.h"

#include "gatunArrayBridge.h"
#include "gatunCellCheck.h"
#include "gatunError.h"
#include "gatunGhosts.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace
{

//------------------------------------------------------------------------------
// What a cell type becomes.
enum class Treatment
{
  Keep,
  Split,
  Linearize,
  Refuse
};

struct CellKind
{
  Treatment How = Treatment::Refuse;
  vtkIdType Points = 0;
};

CellKind KindOf(int type)
{
  switch (type)
  {
    case VTK_TETRA:
      return { Treatment::Keep, 4 };
    case VTK_PYRAMID:
      return { Treatment::Split, 5 };
    case VTK_WEDGE:
      return { Treatment::Split, 6 };
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
      return { Treatment::Split, 8 };
    case VTK_PENTAGONAL_PRISM:
      return { Treatment::Split, 10 };
    case VTK_HEXAGONAL_PRISM:
      return { Treatment::Split, 12 };
    case VTK_QUADRATIC_TETRA:
      return { Treatment::Linearize, 10 };
    default:
      return {};
  }
}

using TypeCounts = std::array<vtkIdType, 256>;

//------------------------------------------------------------------------------
// "12 vtkHexahedron, 3 vtkWedge" of the types with this treatment; empty if there are none.
std::string List(const TypeCounts& counts, Treatment how)
{
  std::string list;
  for (int type = 0; type < static_cast<int>(counts.size()); ++type)
  {
    const vtkIdType count = counts[static_cast<std::size_t>(type)];
    if (count > 0 && KindOf(type).How == how)
    {
      const char* name = vtkCellTypes::GetClassNameFromTypeId(type);
      list += (list.empty() ? "" : ", ") + std::to_string(count) + " " +
        (name ? name : "cells of type " + std::to_string(type));
    }
  }
  return list;
}

//------------------------------------------------------------------------------
void CheckLengths(vtkDataSetAttributes* attributes, vtkIdType tuples, const std::string& place)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != tuples)
    {
      gatun::ThrowInvalid("the " + place + " array '" + (array->GetName() ? array->GetName() : "") +
        "' has " + std::to_string(array->GetNumberOfTuples()) + " tuples for " +
        std::to_string(tuples) + " " + place + "s");
    }
  }
}

//------------------------------------------------------------------------------
// Tetrahedra by their corners, and the input cell of each.
struct Tets
{
  std::vector<vtkIdType> Corners;
  std::vector<vtkIdType> Cells;

  void Add(const vtkIdType* corners, vtkIdType cell)
  {
    this->Corners.insert(this->Corners.end(), corners, corners + 4);
    this->Cells.push_back(cell);
  }
};

//------------------------------------------------------------------------------
// The tetrahedra that vtkDataSetTriangleFilter makes of some cells, by ascending cell.
Tets Split(vtkPoints* points, vtkUnsignedCharArray* types, vtkCellArray* cells,
  const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkUnstructuredGrid> part;
  vtkNew<vtkIdTypeArray> origin;
  origin->SetName("Origin");
  part->SetPoints(points);
  part->Allocate(static_cast<vtkIdType>(ids.size()));
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (const vtkIdType id : ids)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    iterator->GetCellAtId(id, size, corners);
    part->InsertNextCell(types->GetValue(id), size, corners);
    origin->InsertNextValue(id);
  }
  part->GetCellData()->AddArray(origin);

  vtkNew<vtkDataSetTriangleFilter> filter;
  filter->SetInputData(part);
  filter->Update();
  vtkUnstructuredGrid* split = filter->GetOutput();
  auto* splitOrigin =
    vtkIdTypeArray::SafeDownCast(split->GetCellData()->GetAbstractArray("Origin"));
  if (split->GetNumberOfCells() > 0 && !splitOrigin)
  {
    gatun::ThrowInvalid("vtkDataSetTriangleFilter failed");
  }
  Tets tets;
  auto splitIterator = vtk::TakeSmartPointer(split->GetCells()->NewIterator());
  for (vtkIdType id = 0; id < split->GetNumberOfCells(); ++id)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    splitIterator->GetCellAtId(id, size, corners);
    if (size == 4)
    {
      tets.Add(corners, splitOrigin->GetValue(id));
    }
  }
  return tets;
}

//------------------------------------------------------------------------------
template <typename ArrayT>
vtkSmartPointer<vtkCellArray> MakeCells(const std::vector<vtkIdType>& corners)
{
  vtkNew<ArrayT> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(corners.size()));
  std::transform(corners.begin(), corners.end(), connectivity->GetPointer(0),
    [](vtkIdType id) { return static_cast<typename ArrayT::ValueType>(id); });
  vtkNew<ArrayT> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(corners.size() / 4 + 1));
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
  {
    offsets->SetValue(i, static_cast<typename ArrayT::ValueType>(4 * i));
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

//------------------------------------------------------------------------------
void GatherAll(
  vtkDataSetAttributes* from, const std::vector<vtkIdType>& tuples, vtkDataSetAttributes* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = from->GetAbstractArray(i);
    gatun::AddWithRoles(to, gatun::Gather(array, tuples), gatun::AttributeRolesOf(from, array));
  }
}

} // anonymous namespace

namespace gatun
{

//------------------------------------------------------------------------------
TetInput MakeTetInput(vtkUnstructuredGrid* input, bool linearizeQuadratic)
{
  const vtkIdType points = input->GetNumberOfPoints();
  const vtkIdType cellCount = input->GetNumberOfCells();
  vtkUnsignedCharArray* types = input->GetCellTypesArray();
  vtkCellArray* cells = input->GetCells();
  TypeCounts counts = {};
  if (cellCount > 0)
  {
    if (!types || !cells || types->GetNumberOfValues() != cells->GetNumberOfCells())
    {
      gatun::ThrowInvalid("the number of cell types is not that of the cells");
    }
    CheckOffsets(cells);
    const unsigned char* values = types->GetPointer(0);
    for (vtkIdType cell = 0; cell < cellCount; ++cell)
    {
      ++counts[values[cell]];
    }
  }
  const std::string refused = List(counts, Treatment::Refuse);
  if (!refused.empty())
  {
    gatun::ThrowInvalid("only 3D cells can be written, not " + refused +
      "; take the tetrahedra out first, as vtkDataSetTriangleFilter does with TetrahedraOnly");
  }
  const std::string quadratic = List(counts, Treatment::Linearize);
  if (!quadratic.empty() && !linearizeQuadratic)
  {
    gatun::ThrowInvalid(quadratic +
      ": quadratic cells are written only with LinearizeQuadratic on, as linear "
      "ones");
  }
  CheckLengths(input->GetPointData(), points, "point");
  CheckLengths(input->GetCellData(), cellCount, "cell");

  TetInput result;
  const std::string split = List(counts, Treatment::Split);
  vtkUnsignedCharArray* ghosts =
    GhostsWith(input->GetCellData(), vtkDataSetAttributes::DUPLICATECELL);
  if (split.empty() && quadratic.empty() && !ghosts)
  {
    if (cellCount > 0 && cells->IsHomogeneous() != 4)
    {
      gatun::ThrowInvalid("there is a tetrahedron that does not have 4 points");
    }
    result.Grid = input;
    return result;
  }

  // Which points were in use, which cells stay, and which of them are to be split.
  std::vector<bool> usedBefore(static_cast<std::size_t>(points));
  std::vector<vtkIdType> toSplit;
  Tets simple;
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (vtkIdType cell = 0; cell < cellCount; ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    iterator->GetCellAtId(cell, size, corners);
    const CellKind kind = KindOf(types->GetValue(cell));
    if (size != kind.Points)
    {
      gatun::ThrowInvalid("cell " + std::to_string(cell) + " has " + std::to_string(size) +
        " points, not " + std::to_string(kind.Points));
    }
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (corners[i] < 0 || corners[i] >= points)
      {
        gatun::ThrowInvalid("cell " + std::to_string(cell) + " names point " +
          std::to_string(corners[i]) + " of " + std::to_string(points));
      }
      usedBefore[static_cast<std::size_t>(corners[i])] = true;
    }
    if (ghosts && (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL))
    {
      continue;
    }
    if (kind.How == Treatment::Split)
    {
      toSplit.push_back(cell);
    }
    else
    {
      simple.Add(corners, cell);
    }
  }
  Tets parts;
  if (!toSplit.empty())
  {
    parts = Split(input->GetPoints(), types, cells, toSplit);
    result.Warnings.push_back(split + " were split: " + std::to_string(parts.Cells.size()) +
      " tetrahedra are written in their place");
  }
  if (!quadratic.empty())
  {
    result.Warnings.push_back(quadratic + " are written as linear ones, without mid-edge points");
  }

  // Both by ascending cell of the input.
  Tets tets;
  for (std::size_t s = 0, p = 0; s < simple.Cells.size() || p < parts.Cells.size();)
  {
    const bool takePart =
      s == simple.Cells.size() || (p < parts.Cells.size() && parts.Cells[p] < simple.Cells[s]);
    Tets& from = takePart ? parts : simple;
    std::size_t& i = takePart ? p : s;
    tets.Add(&from.Corners[4 * i], from.Cells[i]);
    ++i;
  }

  // Points that were in use and no longer are go.
  std::vector<vtkIdType> pointsKept;
  std::vector<bool> usedAfter(static_cast<std::size_t>(points));
  for (const vtkIdType corner : tets.Corners)
  {
    usedAfter[static_cast<std::size_t>(corner)] = true;
  }
  std::vector<vtkIdType> newId(static_cast<std::size_t>(points), -1);
  for (vtkIdType point = 0; point < points; ++point)
  {
    const auto i = static_cast<std::size_t>(point);
    if (usedAfter[i] || !usedBefore[i])
    {
      newId[i] = static_cast<vtkIdType>(pointsKept.size());
      pointsKept.push_back(point);
    }
  }
  for (vtkIdType& corner : tets.Corners)
  {
    corner = newId[static_cast<std::size_t>(corner)];
  }

  result.Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (pointsKept.size() == newId.size())
  {
    result.Grid->SetPoints(input->GetPoints());
    result.Grid->GetPointData()->ShallowCopy(input->GetPointData());
  }
  else
  {
    vtkNew<vtkPoints> kept;
    kept->SetData(vtkDataArray::SafeDownCast(Gather(input->GetPoints()->GetData(), pointsKept)));
    result.Grid->SetPoints(kept);
    GatherAll(input->GetPointData(), pointsKept, result.Grid->GetPointData());
  }
  result.Grid->SetCells(VTK_TETRA,
    cells->IsStorage64Bit() ? MakeCells<vtkTypeInt64Array>(tets.Corners)
                            : MakeCells<vtkTypeInt32Array>(tets.Corners));
  vtkCellData* cellData = result.Grid->GetCellData();
  GatherAll(input->GetCellData(), tets.Cells, cellData);
  if (!toSplit.empty())
  {
    cellData->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
    if (!cellData->HasArray("OriginalCellIds"))
    {
      vtkNew<vtkIdTypeArray> origin;
      origin->SetName("OriginalCellIds");
      origin->SetNumberOfValues(static_cast<vtkIdType>(tets.Cells.size()));
      std::copy(tets.Cells.begin(), tets.Cells.end(), origin->GetPointer(0));
      cellData->AddArray(origin);
    }
  }
  if (ghosts)
  {
    if (GhostsWith(result.Grid->GetPointData(), vtkDataSetAttributes::DUPLICATEPOINT))
    {
      // Not in the arrays of the input.
      const char* name = vtkDataSetAttributes::GhostArrayName();
      std::vector<vtkIdType> all(static_cast<std::size_t>(result.Grid->GetNumberOfPoints()));
      for (std::size_t i = 0; i < all.size(); ++i)
      {
        all[i] = static_cast<vtkIdType>(i);
      }
      result.Grid->GetPointData()->AddArray(
        Gather(result.Grid->GetPointData()->GetAbstractArray(name), all));
    }
    ClearGhosts(cellData, vtkDataSetAttributes::DUPLICATECELL);
    ClearGhosts(result.Grid->GetPointData(), vtkDataSetAttributes::DUPLICATEPOINT);
  }
  result.Grid->GetFieldData()->ShallowCopy(input->GetFieldData());
  return result;
}

}
