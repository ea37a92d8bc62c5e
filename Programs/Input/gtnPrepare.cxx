// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnPrepare.h"

#include "gtnFailure.h"
#include "gtnReaders.h"
#include "gtnSurfaceWriter.h"
#include "gtnText.h"

#include "gatunArrayBridge.h"
#include "gatunBlockArrays.h"
#include "gatunCellInput.h"
#include "gatunGhosts.h"
#include "gatunSurfaceGrid.h"
#include "gatunSurfaceTriangles.h"
#include "gatunTetInput.h"
#include "vtkGatunMergeBlocks.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/core.h>

#include <algorithm>
#include <exception>

namespace gtn
{
vtkStandardNewMacro(Preparer);

namespace
{

vtkSmartPointer<vtkUnstructuredGrid> Merge(vtkCompositeDataSet* blocks)
{
  vtkNew<vtkGatunMergeBlocks> merge;
  merge->SetInputDataObject(blocks);
  merge->Update();
  return merge->GetOutput();
}

vtkIdType CountBlocks(vtkCompositeDataSet* blocks)
{
  vtkIdType count = 0;
  auto iterator = vtk::TakeSmartPointer(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    ++count;
  }
  return count;
}

// Points of whole numbers as double, where that is exact; the writer refuses the others.
void MakePointsReal(vtkUnstructuredGrid* grid)
{
  vtkPoints* points = grid->GetPoints();
  const int type = points ? points->GetDataType() : VTK_FLOAT;
  if (type == VTK_FLOAT || type == VTK_DOUBLE || points->GetData()->GetDataTypeSize() > 4)
  {
    return;
  }
  vtkNew<vtkPoints> real;
  real->SetDataTypeToDouble();
  real->GetData()->DeepCopy(points->GetData());
  real->GetData()->SetName(points->GetData()->GetName());
  grid->SetPoints(real);
}

// Points of the grid have the type of those of the data. Origin and spacing of an image are double,
// and so are points of coordinates along the axes that are not float.
int FindPrecision(vtkDataSet* data)
{
  const auto isFloat = [](vtkDataArray* axis) { return axis && axis->GetDataType() == VTK_FLOAT; };
  auto* const rectilinear = vtkRectilinearGrid::SafeDownCast(data);
  const bool areFloat = rectilinear && isFloat(rectilinear->GetXCoordinates()) &&
    isFloat(rectilinear->GetYCoordinates()) && isFloat(rectilinear->GetZCoordinates());
  return (rectilinear && !areFloat) || vtkImageData::SafeDownCast(data)
    ? vtkAlgorithm::DOUBLE_PRECISION
    : vtkAlgorithm::DEFAULT_PRECISION;
}

vtkSmartPointer<vtkUnstructuredGrid> ToUnstructured(vtkDataSet* data)
{
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(data);
  append->SetOutputPointsPrecision(FindPrecision(data));
  append->Update();
  auto* const points = vtkPointSet::SafeDownCast(data);
  if (points && points->GetPoints() && append->GetOutput()->GetPoints())
  {
    gatun::CopyNames(points->GetPoints()->GetData(), append->GetOutput()->GetPoints()->GetData());
  }
  return append->GetOutput();
}

std::size_t CountBlockGhosts(vtkCompositeDataSet* blocks)
{
  std::size_t count = 0;
  auto iterator = vtk::TakeSmartPointer(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* const grid = vtkUnstructuredGrid::SafeDownCast(iterator->GetCurrentDataObject());
    count += grid ? gatun::CountGhosts(grid->GetCellData()) : 0;
  }
  return count;
}

bool IsWanted(const std::vector<std::string>& names, const char* name)
{
  return name && std::find(names.begin(), names.end(), name) != names.end();
}

// Those not in names go.
void Select(vtkUnstructuredGrid* grid, const std::vector<std::string>& names)
{
  for (vtkDataSetAttributes* attributes :
    { static_cast<vtkDataSetAttributes*>(grid->GetPointData()),
      static_cast<vtkDataSetAttributes*>(grid->GetCellData()) })
  {
    for (int i = attributes->GetNumberOfArrays() - 1; i >= 0; --i)
    {
      if (!IsWanted(names, attributes->GetAbstractArray(i)->GetName()))
      {
        attributes->RemoveArray(i);
      }
    }
  }
}

std::string PrintableName(vtkAbstractArray* array)
{
  return MakePrintableLine(array->GetName() ? array->GetName() : "(no name)");
}

// Removes the arrays that are no numbers. Returns what they are.
std::vector<std::string> RemoveTexts(vtkUnstructuredGrid* grid)
{
  std::vector<std::string> removed;
  const auto remove = [&](vtkDataSetAttributes* attributes, const char* where)
  {
    for (int i = attributes->GetNumberOfArrays() - 1; i >= 0; --i)
    {
      vtkAbstractArray* const array = attributes->GetAbstractArray(i);
      if (!vtkDataArray::SafeDownCast(array))
      {
        const std::string name = PrintableName(array);
        removed.push_back(fmt::format(
          "the {} array '{}' is left out, because it is a {}, without numbers; --skip '{}' leaves "
          "it out without a message",
          where, name, array->GetClassName(), name));
        attributes->RemoveArray(i);
      }
    }
  };
  remove(grid->GetPointData(), "point");
  remove(grid->GetCellData(), "cell");
  return removed;
}

// Those in names go.
void Remove(vtkUnstructuredGrid* grid, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    grid->GetPointData()->RemoveArray(name.c_str());
    grid->GetCellData()->RemoveArray(name.c_str());
  }
}

std::vector<std::string> NamesOf(vtkUnstructuredGrid* grid)
{
  std::vector<std::string> names;
  for (vtkFieldData* data : { static_cast<vtkFieldData*>(grid->GetPointData()),
         static_cast<vtkFieldData*>(grid->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      names.push_back(PrintableName(data->GetAbstractArray(i)));
    }
  }
  return names;
}

void CheckNames(vtkUnstructuredGrid* grid, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    if (!grid->GetPointData()->HasArray(name.c_str()) &&
      !grid->GetCellData()->HasArray(name.c_str()))
    {
      const std::vector<std::string> known = NamesOf(grid);
      throw Failure(fmt::format("has no array '{}'; there {}", MakePrintableLine(name),
        known.empty() ? "are none" : "are " + Join(known)));
    }
  }
}

vtkSmartPointer<vtkUnstructuredGrid> Copy(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkUnstructuredGrid> copy;
  copy->ShallowCopy(grid);
  return copy;
}

} // anonymous namespace

//------------------------------------------------------------------------------
void Preparer::SetOptions(const InputOptions& options)
{
  this->Options = options;
  this->Modified();
}

//------------------------------------------------------------------------------
void Preparer::Prepare(vtkDataObject* input, const InputOptions& options, vtkDataObject* output)
{
  vtkNew<Preparer> preparer;
  preparer->SetOptions(options);
  preparer->SetInputDataObject(input);
  preparer->Update();
  if (preparer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw Failure("cannot be used");
  }
  vtkDataObject* const prepared = preparer->GetOutputDataObject(0);
  if (!prepared->IsA(output->GetClassName()))
  {
    throw Failure(vtkPolyData::SafeDownCast(prepared) ? "is a surface, and others are not"
                                                      : "is not a surface, and others are");
  }
  output->ShallowCopy(prepared);
}

//------------------------------------------------------------------------------
int Preparer::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int Preparer::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const bool isSurface = vtkPolyData::GetData(inputVector[0]) != nullptr;
  return this->SetOutputDataObject(
    isSurface ? VTK_POLY_DATA : VTK_UNSTRUCTURED_GRID, outputVector->GetInformationObject(0), true);
}

//------------------------------------------------------------------------------
int Preparer::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  // VTK's readers of legacy files claim to have a step at time 0; these files have no time.
  vtkAlgorithm* const source = this->GetInputAlgorithm(0, 0);
  if (source && source->IsA("vtkDataReader"))
  {
    vtkInformation* const info = outputVector->GetInformationObject(0);
    info->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    info->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  }
  return 1;
}

//------------------------------------------------------------------------------
// Tells what is left out though nobody asked for it.
void Preparer::Lose(const std::string& what)
{
  if (this->Options.Lost)
  {
    this->Options.Lost->insert(what);
  }
  else
  {
    vtkWarningMacro(<< what);
  }
}

//------------------------------------------------------------------------------
void Preparer::NameArrays(vtkUnstructuredGrid* grid)
{
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    const char* const where = association == vtkDataObject::POINT ? "point" : "cell";
    for (const std::string& message : gatun::NameArrays(grid->GetAttributes(association), where))
    {
      vtkWarningMacro(<< message);
    }
  }
}

//------------------------------------------------------------------------------
// Names the tables of colors of arrays, which a .gtn file does not hold.
void Preparer::LoseTables(vtkDataSet* data)
{
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* const attributes = data->GetAttributes(association);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* const array = attributes->GetArray(i);
      if (array && array->GetLookupTable())
      {
        this->Lose(fmt::format("the lookup table of the {} array '{}' is left out",
          association == vtkDataObject::POINT ? "point" : "cell", PrintableName(array)));
      }
    }
  }
}

//------------------------------------------------------------------------------
// Converts the cells as the options say, with warnings.
vtkSmartPointer<vtkUnstructuredGrid> Preparer::Convert(vtkUnstructuredGrid* grid, bool isSurface)
{
  gatun::CellInput cells;
  if (this->Options.VolumesOnly && !isSurface)
  {
    const gatun::TetInput tets = gatun::MakeTetInput(grid);
    if (tets.Grid->GetNumberOfCells() == 0 && !tets.LeftOut.empty())
    {
      throw Failure(DescribeFlatCells(tets.LeftOut));
    }
    cells = { tets.Grid, tets.Warnings };
  }
  else
  {
    cells = gatun::MakeCellInput(grid, this->Options.Split,
      this->Options.Ghosts ? gatun::GhostCells::Keep : gatun::GhostCells::Remove);
  }
  for (const std::string& warning : cells.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (cells.GhostCells > 0 && this->Options.Ghosts)
  {
    this->Lose(gatun::DescribeLostGhosts(cells.GhostCells));
  }
  else if (cells.GhostCells > 0 && !this->Options.Lost)
  {
    vtkWarningMacro(<< gatun::DescribeLostGhosts(cells.GhostCells));
  }
  return cells.Grid;
}

//------------------------------------------------------------------------------
void Preparer::MakeOutput(vtkDataObject* input, vtkDataObject* output)
{
  if (auto* const set = vtkDataSet::SafeDownCast(input); set && !this->Options.VolumesOnly)
  {
    this->LoseTables(set);
  }
  auto* const surface = vtkPolyData::SafeDownCast(input);
  vtkSmartPointer<vtkUnstructuredGrid> grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (surface)
  {
    if (this->Options.Split || (this->Options.VolumesOnly && !this->Options.SurfacesToo))
    {
      throw Failure(DescribeSurface());
    }
    grid = gatun::MakeSurfaceGrid(surface);
  }
  else if (this->Options.Triangles)
  {
    throw Failure("is no surface (vtkPolyData), whose cells could be divided into triangles");
  }
  else if (auto* blocks = vtkCompositeDataSet::SafeDownCast(input))
  {
    const std::size_t ghosts = CountBlockGhosts(blocks);
    grid = Merge(blocks);
    vtkWarningMacro(<< CountBlocks(blocks) << " blocks were merged into one grid");
    if (ghosts > 0 && this->Options.Ghosts && !this->Options.VolumesOnly)
    {
      this->Lose(gatun::DescribeLostGhosts(ghosts));
    }
  }
  else if (auto* data = vtkDataSet::SafeDownCast(input); data && !grid)
  {
    grid = ToUnstructured(data);
  }
  if (!grid)
  {
    throw Failure("holds " + std::string(input->GetClassName()) + ", which is not a mesh");
  }
  grid = Copy(grid);
  MakePointsReal(grid);
  if (!this->Options.VolumesOnly)
  {
    this->NameArrays(grid);
  }
  CheckNames(grid, this->Options.Skip);
  Remove(grid, this->Options.Skip);
  if (!this->Options.AllArrays)
  {
    CheckNames(grid, this->Options.Arrays);
    // The marks of ghosts are needed until these have been removed.
    std::vector<std::string> names = this->Options.Arrays;
    names.emplace_back(vtkDataSetAttributes::GhostArrayName());
    Select(grid, names);
  }
  if (!this->Options.VolumesOnly)
  {
    for (const std::string& removed : RemoveTexts(grid))
    {
      this->Lose(removed);
    }
  }
  grid = Copy(this->Convert(grid, surface != nullptr));
  if (!this->Options.AllArrays)
  {
    // That of split cells is a result.
    std::vector<std::string> names = this->Options.Arrays;
    names.emplace_back("OriginalCellIds");
    Select(grid, names);
  }
  if (surface)
  {
    auto* const prepared = vtkPolyData::SafeDownCast(output);
    gatun::MakeSurface(grid, gatun::FindSurfaceCells(grid), prepared);
    if (this->Options.Triangles)
    {
      const vtkIdType degenerate =
        CountDegenerate(prepared->GetPolys()) + CountDegenerate(prepared->GetStrips());
      if (degenerate > 0)
      {
        vtkWarningMacro(<< degenerate
                        << " polygons and strips of less than 3 corners are left out");
      }
      prepared->ShallowCopy(gatun::MakeTriangleSurface(prepared));
    }
  }
  else
  {
    output->ShallowCopy(grid);
  }
}

//------------------------------------------------------------------------------
int Preparer::RequestData(vtkInformation* vtkNotUsed(request), vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    this->MakeOutput(input, output);
  }
  catch (const std::exception& error)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(<< ReasonOf(error));
    return 0;
  }
  vtkInformation* const info = input->GetInformation();
  if (info->Has(vtkDataObject::DATA_TIME_STEP()))
  {
    output->GetInformation()->Set(
      vtkDataObject::DATA_TIME_STEP(), info->Get(vtkDataObject::DATA_TIME_STEP()));
  }
  return 1;
}
}
