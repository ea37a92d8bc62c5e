// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTetInput.h"

#include "gatunArrayBridge.h"
#include "gatunCellCheck.h"
#include "gatunCellShapes.h"
#include "gatunCellSplit.h"
#include "gatunError.h"
#include "gatunGhosts.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
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
        (isKnown ? vtkCellTypes::GetClassNameFromTypeId(type) : "of type " + std::to_string(type));
    }
  }
  return list;
}

//------------------------------------------------------------------------------
[[noreturn]] void ThrowTupleCount(
  vtkAbstractArray& array, const std::string& place, vtkIdType tuples)
{
  const std::string name = array.GetName() ? array.GetName() : "";
  gatun::ThrowInvalid("the " + place + " array '" + name + "' has " +
    std::to_string(array.GetNumberOfTuples()) + " tuples for " + std::to_string(tuples) + " " +
    place + "s");
}

//------------------------------------------------------------------------------
void CheckLengths(vtkDataSetAttributes* attributes, vtkIdType tuples, const std::string& place)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != tuples)
    {
      ThrowTupleCount(*array, place, tuples);
    }
  }
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
  offsets->SetNumberOfValues(static_cast<vtkIdType>(corners.size()) / 4 + 1);
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

//------------------------------------------------------------------------------
// The steps of MakeTetInput.
class TetInputMaker
{
public:
  TetInputMaker(vtkUnstructuredGrid* input, const gatun::TetInputOptions& options)
    : Input(input)
    , Options(options)
    , Types(input->GetCellTypesArray())
    , Cells(input->GetCells())
    , Ghosts(gatun::GhostsWith(input->GetCellData(), vtkDataSetAttributes::DUPLICATECELL))
    , PointIsUsed(static_cast<std::size_t>(input->GetNumberOfPoints()))
  {
  }

  gatun::TetInput Make()
  {
    this->CheckTypes();
    CheckLengths(this->Input->GetPointData(), this->Input->GetNumberOfPoints(), "point");
    CheckLengths(this->Input->GetCellData(), this->Input->GetNumberOfCells(), "cell");
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
    this->RemoveGhosts();
    this->Result.Grid->GetFieldData()->ShallowCopy(this->Input->GetFieldData());
    return this->Result;
  }

private:
  void CheckTypes();
  bool IsMadeOfTets() const;
  void CheckCell(vtkIdType cell, vtkIdType size, const vtkIdType* corners) const;
  void SelectCells();
  void SplitCells();
  void CompactPoints();
  void MakeGrid();
  void CopyCellData();
  void RemoveGhosts();

  vtkUnstructuredGrid* const Input;
  const gatun::TetInputOptions Options;
  vtkUnsignedCharArray* const Types;
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
// Counts the cell types and refuses those that cannot be written.
void TetInputMaker::CheckTypes()
{
  const vtkIdType count = this->Input->GetNumberOfCells();
  if (count > 0)
  {
    if (!this->Types || !this->Cells ||
      this->Types->GetNumberOfValues() != this->Cells->GetNumberOfCells())
    {
      gatun::ThrowInvalid("the number of cell types is not that of the cells");
    }
    gatun::CheckOffsets(this->Cells);
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
  if (!this->Result.LeftOut.empty() && !this->Options.LeaveOutOthers)
  {
    gatun::ThrowInvalid("only 3D cells can be written, not " + this->Result.LeftOut +
      "; take the tetrahedra out first, as vtkDataSetTriangleFilter does with TetrahedraOnly");
  }
  const std::string nonlinear = List(this->Counts, Treatment::Linearize);
  if (!nonlinear.empty() && !this->Options.Linearize)
  {
    gatun::ThrowInvalid(
      nonlinear + ": nonlinear cells are written only with LinearizeQuadratic on, as linear ones");
  }
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
void TetInputMaker::CheckCell(vtkIdType cell, vtkIdType size, const vtkIdType* corners) const
{
  const gatun::CellKind kind = gatun::GetCellKind(this->Types->GetValue(cell));
  const vtkIdType least = kind.Points > 0 ? kind.Points : kind.Shape ? kind.Shape->Corners : 0;
  if (size < least || (kind.Points > 0 && size > least))
  {
    gatun::ThrowInvalid("cell " + std::to_string(cell) + " has " + std::to_string(size) +
      " points, not " + std::to_string(least) + (kind.Points > 0 ? "" : " or more"));
  }
  const vtkIdType points = this->Input->GetNumberOfPoints();
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (corners[i] < 0 || corners[i] >= points)
    {
      gatun::ThrowInvalid("cell " + std::to_string(cell) + " names point " +
        std::to_string(corners[i]) + " of " + std::to_string(points));
    }
  }
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
    this->CheckCell(cell, size, corners);
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
  const std::string split = List(this->Counts, Treatment::Split);
  this->IsSplit = !split.empty();
  if (this->IsSplit && !this->Options.LeaveOutOthers)
  {
    const auto parts = std::count_if(this->Output.Cells.begin(), this->Output.Cells.end(),
      [this](vtkIdType cell)
      { return GetTreatment(this->Types->GetValue(cell)) == Treatment::Split; });
    this->Result.Warnings.push_back(
      split + " were split: " + std::to_string(parts) + " tetrahedra are written in their place");
  }
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
    GatherAll(this->Input->GetPointData(), this->PointsKept, grid->GetPointData());
  }
  grid->SetCells(VTK_TETRA,
    this->Cells->IsStorage64Bit() ? MakeCells<vtkTypeInt64Array>(this->Output.Corners)
                                  : MakeCells<vtkTypeInt32Array>(this->Output.Corners));
}

//------------------------------------------------------------------------------
void TetInputMaker::CopyCellData()
{
  vtkCellData* cellData = this->Result.Grid->GetCellData();
  GatherAll(this->Input->GetCellData(), this->Output.Cells, cellData);
  if (!this->IsSplit)
  {
    return;
  }
  cellData->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  if (!cellData->HasArray("OriginalCellIds"))
  {
    vtkNew<vtkIdTypeArray> origin;
    origin->SetName("OriginalCellIds");
    origin->SetNumberOfValues(static_cast<vtkIdType>(this->Output.Cells.size()));
    std::copy(this->Output.Cells.begin(), this->Output.Cells.end(), origin->GetPointer(0));
    cellData->AddArray(origin);
  }
}

//------------------------------------------------------------------------------
// Clears the marks of ghosts, which are no longer there. Leaves the arrays of the input as they
// are.
void TetInputMaker::RemoveGhosts()
{
  if (!this->Ghosts)
  {
    return;
  }
  vtkPointData* pointData = this->Result.Grid->GetPointData();
  if (gatun::GhostsWith(pointData, vtkDataSetAttributes::DUPLICATEPOINT))
  {
    // A copy, because the array may be that of the input.
    std::vector<vtkIdType> all(static_cast<std::size_t>(this->Result.Grid->GetNumberOfPoints()));
    std::iota(all.begin(), all.end(), vtkIdType{ 0 });
    pointData->AddArray(
      gatun::Gather(pointData->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()), all));
  }
  gatun::ClearGhosts(this->Result.Grid->GetCellData(), vtkDataSetAttributes::DUPLICATECELL);
  gatun::ClearGhosts(pointData, vtkDataSetAttributes::DUPLICATEPOINT);
}

} // anonymous namespace

namespace gatun
{

//------------------------------------------------------------------------------
TetInput MakeTetInput(vtkUnstructuredGrid* input, const TetInputOptions& options)
{
  return TetInputMaker(input, options).Make();
}

}
