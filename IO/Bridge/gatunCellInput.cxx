// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellInput.h"

#include "gatunArrayBridge.h"
#include "gatunBridgedMesh.h"
#include "gatunCellCheck.h"
#include "gatunGhosts.h"
#include "gatunMeshAccess.h"
#include "gatunMeshCheck.h"
#include "gatunTetInput.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cstddef>

namespace gatun
{
namespace
{
/** Copies a grid without its ghost cells and the points that only they use. */
class GhostRemover
{
public:
  GhostRemover(vtkUnstructuredGrid* input, const MeshAccess& access)
    : Input(input)
    , Access(access)
    , Ghosts(GhostsWith(input->GetCellData(), vtkDataSetAttributes::DUPLICATECELL))
    , NewIds(static_cast<std::size_t>(input->GetNumberOfPoints()), Free)
  {
  }

  vtkSmartPointer<vtkUnstructuredGrid> Make()
  {
    this->SelectPoints();
    this->SelectCells();
    const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkPoints> points;
    points->SetData(
      vtkDataArray::SafeDownCast(Gather(this->Input->GetPoints()->GetData(), this->PointsKept)));
    grid->SetPoints(points);
    if (this->Faces->GetNumberOfValues() > 0)
    {
      grid->SetCells(this->Types, this->Cells, this->FaceLocations, this->Faces);
    }
    else
    {
      grid->SetCells(this->Types, this->Cells);
    }
    GatherAll(this->Input->GetPointData(), this->PointsKept, grid->GetPointData());
    GatherAll(this->Input->GetCellData(), this->CellsKept, grid->GetCellData());
    grid->GetFieldData()->ShallowCopy(this->Input->GetFieldData());
    ClearGhosts(grid);
    return grid;
  }

private:
  static constexpr vtkIdType Free = -1; // used by no cell
  static constexpr vtkIdType Gone = -2; // used by ghost cells only

  bool IsGhost(vtkIdType cell) const
  {
    return (this->Ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
  }

  void SelectPoints()
  {
    const auto mark = [&](bool ghosts, vtkIdType as)
    {
      for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
      {
        if (this->IsGhost(cell) == ghosts)
        {
          this->Access.ForEachPoint(static_cast<std::uint64_t>(cell),
            [&](std::uint64_t point) { this->NewIds[static_cast<std::size_t>(point)] = as; });
        }
      }
    };
    mark(true, Gone);
    mark(false, Free);
    for (std::size_t i = 0; i < this->NewIds.size(); ++i)
    {
      if (this->NewIds[i] != Gone)
      {
        this->NewIds[i] = static_cast<vtkIdType>(this->PointsKept.size());
        this->PointsKept.push_back(static_cast<vtkIdType>(i));
      }
    }
  }

  void SelectCells()
  {
    if (!this->Input->GetCells()->IsStorage64Bit())
    {
      this->Cells->Use32BitStorage();
    }
    auto iterator = vtk::TakeSmartPointer(this->Input->GetCells()->NewIterator());
    for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
    {
      if (this->IsGhost(cell))
      {
        continue;
      }
      this->CellsKept.push_back(cell);
      const int type = this->Input->GetCellType(cell);
      this->Types->InsertNextValue(static_cast<unsigned char>(type));
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCellAtId(cell, size, ids);
      this->Cells->InsertNextCell(static_cast<int>(size));
      for (vtkIdType i = 0; i < size; ++i)
      {
        this->Cells->InsertCellPoint(this->NewIds[static_cast<std::size_t>(ids[i])]);
      }
      this->FaceLocations->InsertNextValue(
        type == VTK_POLYHEDRON ? this->Faces->GetNumberOfValues() : -1);
      if (type == VTK_POLYHEDRON)
      {
        this->CopyFaces(cell);
      }
    }
  }

  /** The faces of polyhedra name the points of the cell. */
  void CopyFaces(vtkIdType cell)
  {
    vtkIdTypeArray* const from = this->Input->GetFaces();
    vtkIdTypeArray* const locations = this->Input->GetFaceLocations();
    vtkIdType at = from && locations ? locations->GetValue(cell) : -1;
    if (at < 0)
    {
      this->Faces->InsertNextValue(0);
      return;
    }
    const vtkIdType faces = from->GetValue(at++);
    this->Faces->InsertNextValue(faces);
    for (vtkIdType face = 0; face < faces; ++face)
    {
      const vtkIdType size = from->GetValue(at++);
      this->Faces->InsertNextValue(size);
      for (vtkIdType i = 0; i < size; ++i)
      {
        const auto id = static_cast<std::size_t>(from->GetValue(at++));
        this->Faces->InsertNextValue(this->NewIds[id]);
      }
    }
  }

  vtkUnstructuredGrid* const Input;
  const MeshAccess& Access;
  vtkUnsignedCharArray* const Ghosts;
  std::vector<vtkIdType> NewIds; // of all points
  std::vector<vtkIdType> PointsKept;
  std::vector<vtkIdType> CellsKept;
  vtkNew<vtkUnsignedCharArray> Types;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkIdTypeArray> FaceLocations;
  vtkNew<vtkIdTypeArray> Faces;
};
}

//------------------------------------------------------------------------------
CellInput MakeCellInput(vtkUnstructuredGrid* input, bool split)
{
  if (split)
  {
    TetInput tets = MakeTetInput(input, true);
    if (!tets.Split.empty())
    {
      tets.Warnings.push_back(tets.Split + " were split: " + std::to_string(tets.SplitTets) +
        " tetrahedra are written in their place");
    }
    if (!tets.LeftOut.empty())
    {
      tets.Warnings.push_back(tets.LeftOut + " are left out");
    }
    return { tets.Grid, tets.Warnings };
  }
  CheckGrid(input);
  CheckCells(input);
  const BridgedMesh mesh(input);
  const MeshAccess access(mesh.Mesh);
  CheckCells(access);
  if (!GhostsWith(input->GetCellData(), vtkDataSetAttributes::DUPLICATECELL))
  {
    return { input, {} };
  }
  return { GhostRemover(input, access).Make(), {} };
}
}
