// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTetInput.h"

#include "gatunArrayBridge.h"
#include "gatunCellArrays.h"
#include "gatunCellCheck.h"
#include "gatunCellShapes.h"
#include "gatunCellSplit.h"
#include "gatunError.h"
#include "gatunGhosts.h"
#include "gatunNewArray.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
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
#include <numeric>
#include <utility>

namespace
{

//------------------------------------------------------------------------------
// The treatment of a cell type.
enum class Treatment
{
  Keep,
  Split,
  Linearize,
  LeaveOut,
  Refuse
};

Treatment GetTreatment(int type)
{
  const gatun::CellKind kind = gatun::GetCellKind(type);
  if (kind.Dimension < 3)
  {
    return kind.Dimension < 0 ? Treatment::Refuse : Treatment::LeaveOut;
  }
  if (type == VTK_TETRA)
  {
    return Treatment::Keep;
  }
  return kind.Shape && !kind.IsLinear() ? Treatment::Linearize : Treatment::Split;
}

using TypeCounts = std::array<vtkIdType, 256>;

//------------------------------------------------------------------------------
// Lists the types with a treatment, such as "12 vtkHexahedron, 3 vtkWedge". Empty if there are
// none.
std::string List(const TypeCounts& counts, Treatment how)
{
  std::string list;
  for (int type = 0; type < static_cast<int>(counts.size()); ++type)
  {
    const vtkIdType count = counts[static_cast<std::size_t>(type)];
    if (count > 0 && GetTreatment(type) == how)
    {
      const bool isKnown = how != Treatment::Refuse;
      list += (list.empty() ? "" : ", ") + std::to_string(count) + " " +
        (isKnown ? gatun::GetCellTypeName(type) : "of type " + std::to_string(type));
    }
  }
  return list;
}

//------------------------------------------------------------------------------
template <typename ArrayT>
vtkSmartPointer<vtkCellArray> MakeCells(const std::vector<vtkIdType>& corners)
{
  const auto connectivity = gatun::MakeArray<ArrayT>(corners);
  vtkNew<ArrayT> offsets;
  gatun::SizeArray(offsets, static_cast<vtkIdType>(corners.size()) / 4 + 1);
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
  {
    offsets->SetValue(i, static_cast<typename ArrayT::ValueType>(4 * i));
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

//------------------------------------------------------------------------------
// The steps of MakeTetInput.
class TetInputMaker
{
public:
  TetInputMaker(vtkUnstructuredGrid* input, bool withOriginalIds)
    : Input(input)
    , WithOriginalIds(withOriginalIds)
    , Types(gatun::GetCellTypes(input))
    , Cells(input->GetCells())
    , Ghosts(gatun::GhostsWith(input->GetCellData(), vtkDataSetAttributes::DUPLICATECELL))
    , PointIsUsed(static_cast<std::size_t>(input->GetNumberOfPoints()))
  {
  }

  gatun::TetInput Make()
  {
    gatun::CheckGrid(this->Input);
    this->CheckTypes();
    if (this->IsMadeOfTets())
    {
      this->Result.Grid = this->Input;
      return this->Result;
    }
    this->SelectCells();
    this->SplitCells();
    this->CompactPoints();
    this->MakeGrid();
    this->CopyCellData();
    if (this->Ghosts)
    {
      gatun::ClearGhosts(this->Result.Grid);
    }
    this->Result.Grid->GetFieldData()->ShallowCopy(this->Input->GetFieldData());
    return this->Result;
  }

private:
  void CheckTypes();
  bool IsMadeOfTets() const;
  void SelectCells();
  void SplitCells();
  void CompactPoints();
  void MakeGrid();
  void CopyCellData();

  vtkUnstructuredGrid* const Input;
  const bool WithOriginalIds;
  const vtkSmartPointer<vtkUnsignedCharArray> Types;
  vtkCellArray* const Cells;
  vtkUnsignedCharArray* const Ghosts; // null if there are no ghost cells
  TypeCounts Counts = {};

  std::vector<bool> PointIsUsed;     // by any cell of the input
  std::vector<vtkIdType> Volumes;    // the cells that are taken
  gatun::SplitCells Output;          // sorted by the cells of the input
  bool IsSplit = false;              // whether there may be several for a cell
  std::vector<vtkIdType> PointsKept; // of the input
  gatun::TetInput Result;
};

//------------------------------------------------------------------------------
// Counts the cell types. Throws if some are unknown.
void TetInputMaker::CheckTypes()
{
  const vtkIdType count = this->Input->GetNumberOfCells();
  if (count > 0)
  {
    const unsigned char* values = this->Types->GetPointer(0);
    for (vtkIdType cell = 0; cell < count; ++cell)
    {
      ++this->Counts[values[cell]];
    }
  }
  const std::string unknown = List(this->Counts, Treatment::Refuse);
  if (!unknown.empty())
  {
    gatun::ThrowInvalid("there are cells of an unknown type: " + unknown);
  }
  this->Result.LeftOut = List(this->Counts, Treatment::LeaveOut);
}

//------------------------------------------------------------------------------
// Whether the input can be written as it is.
bool TetInputMaker::IsMadeOfTets() const
{
  const vtkIdType count = this->Input->GetNumberOfCells();
  if (this->Ghosts || this->Counts[VTK_TETRA] != count)
  {
    return false;
  }
  if (count > 0 && this->Cells->IsHomogeneous() != 4)
  {
    gatun::ThrowInvalid("there is a tetrahedron that does not have 4 points");
  }
  return true;
}

//------------------------------------------------------------------------------
// Finds the points in use and the cells to take. Ghosts are left out.
void TetInputMaker::SelectCells()
{
  auto iterator = vtk::TakeSmartPointer(this->Cells->NewIterator());
  for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    iterator->GetCellAtId(cell, size, corners);
    gatun::CheckCell(
      cell, this->Types->GetValue(cell), size, corners, this->Input->GetNumberOfPoints());
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->PointIsUsed[static_cast<std::size_t>(corners[i])] = true;
    }
    const bool isGhost =
      this->Ghosts && (this->Ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL);
    if (!isGhost && gatun::GetCellKind(this->Types->GetValue(cell)).Dimension == 3)
    {
      this->Volumes.push_back(cell);
    }
  }
}

//------------------------------------------------------------------------------
void TetInputMaker::SplitCells()
{
  this->Output = gatun::SplitIntoTets(this->Input, this->Volumes);
  if (this->Output.Cells.empty() && !this->Result.LeftOut.empty())
  {
    this->Result.Warnings.push_back("there are no 3D cells, only " + this->Result.LeftOut);
  }
  this->Result.Split = List(this->Counts, Treatment::Split);
  this->IsSplit = !this->Result.Split.empty();
  this->Result.SplitTets = std::count_if(this->Output.Cells.begin(), this->Output.Cells.end(),
    [this](vtkIdType cell)
    { return GetTreatment(this->Types->GetValue(cell)) == Treatment::Split; });
  const std::string nonlinear = List(this->Counts, Treatment::Linearize);
  if (!nonlinear.empty())
  {
    this->IsSplit = this->IsSplit || this->Output.Cells.size() != this->Volumes.size();
    this->Result.Warnings.push_back(
      nonlinear + " are taken for linear ones, without mid-edge points");
  }
}

//------------------------------------------------------------------------------
// Removes points that were in use and no longer are, and renumbers the others.
void TetInputMaker::CompactPoints()
{
  std::vector<bool> isStillUsed(this->PointIsUsed.size());
  for (const vtkIdType corner : this->Output.Corners)
  {
    isStillUsed[static_cast<std::size_t>(corner)] = true;
  }
  std::vector<vtkIdType> newId(this->PointIsUsed.size(), -1);
  for (std::size_t i = 0; i < newId.size(); ++i)
  {
    if (isStillUsed[i] || !this->PointIsUsed[i])
    {
      newId[i] = static_cast<vtkIdType>(this->PointsKept.size());
      this->PointsKept.push_back(static_cast<vtkIdType>(i));
    }
  }
  for (vtkIdType& corner : this->Output.Corners)
  {
    corner = newId[static_cast<std::size_t>(corner)];
  }
}

//------------------------------------------------------------------------------
// Makes the grid, with its points, their data and the cells.
void TetInputMaker::MakeGrid()
{
  this->Result.Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkUnstructuredGrid* grid = this->Result.Grid;
  if (this->PointsKept.size() == this->PointIsUsed.size())
  {
    grid->SetPoints(this->Input->GetPoints());
    grid->GetPointData()->ShallowCopy(this->Input->GetPointData());
  }
  else
  {
    vtkNew<vtkPoints> kept;
    kept->SetData(vtkDataArray::SafeDownCast(
      gatun::Gather(this->Input->GetPoints()->GetData(), this->PointsKept)));
    grid->SetPoints(kept);
    gatun::GatherAll(this->Input->GetPointData(), this->PointsKept, grid->GetPointData());
  }
  grid->SetCells(VTK_TETRA,
    gatun::HasWideIds(this->Cells) ? MakeCells<vtkTypeInt64Array>(this->Output.Corners)
                                   : MakeCells<vtkTypeInt32Array>(this->Output.Corners));
}

//------------------------------------------------------------------------------
void TetInputMaker::CopyCellData()
{
  vtkCellData* cellData = this->Result.Grid->GetCellData();
  gatun::GatherAll(this->Input->GetCellData(), this->Output.Cells, cellData);
  if (!this->IsSplit)
  {
    return;
  }
  cellData->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  if (this->WithOriginalIds && !cellData->HasArray("OriginalCellIds"))
  {
    vtkNew<vtkIdTypeArray> origin;
    origin->SetName("OriginalCellIds");
    gatun::SizeArray(origin, static_cast<vtkIdType>(this->Output.Cells.size()));
    std::copy(this->Output.Cells.begin(), this->Output.Cells.end(), origin->GetPointer(0));
    cellData->AddArray(origin);
  }
}

} // anonymous namespace

namespace gatun
{

//------------------------------------------------------------------------------
TetInput MakeTetInput(vtkUnstructuredGrid* input, bool withOriginalIds)
{
  return TetInputMaker(input, withOriginalIds).Make();
}

}
