// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellInput.h"

#include "gatunArrayBridge.h"
#include "gatunBridgedMesh.h"
#include "gatunCellCheck.h"
#include "gatunGhosts.h"
#include "gatunGridPart.h"
#include "gatunMeshAccess.h"
#include "gatunMeshCheck.h"
#include "gatunTetInput.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
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
    auto grid = ExtractPart(this->Input, this->Kept, this->NewIds);
    GatherAll(this->Input->GetPointData(), this->Kept.Points, grid->GetPointData());
    GatherAll(this->Input->GetCellData(), this->Kept.Cells, grid->GetCellData());
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
        this->NewIds[i] = static_cast<vtkIdType>(this->Kept.Points.size());
        this->Kept.Points.push_back(static_cast<vtkIdType>(i));
      }
    }
  }

  void SelectCells()
  {
    for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
    {
      if (!this->IsGhost(cell))
      {
        this->Kept.Cells.push_back(cell);
      }
    }
  }

  vtkUnstructuredGrid* const Input;
  const MeshAccess& Access;
  vtkUnsignedCharArray* const Ghosts;
  std::vector<vtkIdType> NewIds; // of all points
  GridPart Kept;
};
}

//------------------------------------------------------------------------------
std::string DescribeLostGhosts(std::size_t cells)
{
  return std::to_string(cells) + (cells == 1 ? " ghost cell is" : " ghost cells are") +
    " left out (vtkGhostType)";
}

//------------------------------------------------------------------------------
CellInput MakeCellInput(vtkUnstructuredGrid* input, bool split, GhostCells ghosts)
{
  if (split)
  {
    const std::size_t lost = CountGhosts(input->GetCellData());
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
    return { tets.Grid, tets.Warnings, lost };
  }
  CheckGrid(input);
  const BridgedMesh mesh(input);
  if (mesh.Mesh.Types)
  {
    CheckCells(input); // the sizes of tetrahedra are known to be right
  }
  const MeshAccess access(mesh.Mesh);
  CheckCells(access);
  const std::size_t lost = ghosts == GhostCells::Remove ? CountGhosts(input->GetCellData()) : 0;
  CellInput cells;
  cells.Grid = input;
  if (lost > 0)
  {
    cells.Grid = GhostRemover(input, access).Make();
  }
  cells.GhostCells = lost;
  return cells;
}
}
