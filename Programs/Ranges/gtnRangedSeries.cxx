// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnRangedSeries.h"

#include "gtnFailure.h"
#include "gtnText.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>

namespace gtn
{
namespace
{

const char* const HowToFillSeries = " (--fill-missing fills it in, without --memory and --pieces)";

std::size_t SizeOfPoint(vtkUnstructuredGrid* grid)
{
  return grid->GetPoints()
    ? 3 * static_cast<std::size_t>(grid->GetPoints()->GetData()->GetDataTypeSize())
    : 0;
}

} // anonymous namespace

//------------------------------------------------------------------------------
RangedSeries::RangedSeries(
  const std::vector<std::string>& files, const std::vector<double>& times, const Open& open)
  : Files(files)
  , Times(times)
  , OpenFile(open)
  , First(open(files.front()))
  , Steps(files.size())
{
  for (std::size_t step = 0; step < files.size(); ++step)
  {
    const auto mesh = step > 0 ? open(files[step]) : nullptr;
    this->Steps[step].Template = (mesh ? mesh : this->First)->GetTemplate(0);
    this->MatchArrays(step);
  }
  this->Steps.front().IsChecked = true;
}

//------------------------------------------------------------------------------
void RangedSeries::Fail(std::size_t step, const std::string& problem) const
{
  throw Failure(this->Files[step],
    problem + " in time step " + std::to_string(step) + " (time " +
      DescribeNumber(this->Times[step]) + ")");
}

//------------------------------------------------------------------------------
void RangedSeries::MatchArrays(std::size_t step)
{
  Step& here = this->Steps[step];
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkFieldData* first = this->Steps.front().Template->GetAttributesAsFieldData(association);
    vtkFieldData* now = here.Template->GetAttributesAsFieldData(association);
    const std::string what = association == vtkDataObject::POINT ? "point" : "cell";
    const auto title = [&](vtkAbstractArray* array)
    {
      return "the " + what + " array '" +
        MakePrintableLine(array->GetName() ? array->GetName() : "") + "'";
    };
    for (int i = 0; i < first->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = first->GetAbstractArray(i);
      int number = -1;
      vtkAbstractArray* other =
        array->GetName() ? now->GetAbstractArray(array->GetName(), number) : nullptr;
      if (!other)
      {
        this->Fail(step, title(array) + " of the first step is missing" + HowToFillSeries);
      }
      if (other->GetDataType() != array->GetDataType() ||
        other->GetNumberOfComponents() != array->GetNumberOfComponents())
      {
        const auto kind = [](vtkAbstractArray* one)
        {
          return std::string(one->GetDataTypeAsString()) + " with " +
            std::to_string(one->GetNumberOfComponents()) + " components";
        };
        this->Fail(
          step, title(array) + " is " + kind(other) + ", and at the first step " + kind(array));
      }
      here.Arrays[association].push_back(number);
    }
    for (int i = 0; i < now->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = now->GetAbstractArray(i);
      if (!array->GetName() || !first->HasArray(array->GetName()))
      {
        this->Fail(step, title(array) + " appears" + HowToFillSeries);
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* RangedSeries::GetTemplate(std::size_t step) const
{
  return this->Steps[step].Template;
}

//------------------------------------------------------------------------------
void RangedSeries::ReadPoints(std::uint64_t begin, std::size_t count, void* values)
{
  this->First->ReadPoints(begin, count, values);
}

//------------------------------------------------------------------------------
void RangedSeries::ReadCells(std::uint64_t begin, std::size_t count, RangedCells& cells)
{
  this->First->ReadCells(begin, count, cells);
}

//------------------------------------------------------------------------------
void RangedSeries::ReadArray(int association, int array, std::size_t step, std::uint64_t begin,
  std::size_t count, void* values)
{
  const int number = this->Steps[step].Arrays[association][static_cast<std::size_t>(array)];
  this->GetMesh(step).ReadArray(association, number, 0, begin, count, values);
}

//------------------------------------------------------------------------------
RangedMesh& RangedSeries::GetMesh(std::size_t step)
{
  if (step == 0)
  {
    return *this->First;
  }
  if (!this->Current || step != this->CurrentStep)
  {
    if (this->Current)
    {
      this->Current->CheckUnchanged();
    }
    this->Current = this->OpenFile(this->Files[step]);
    this->CurrentStep = step;
  }
  if (!this->Steps[step].IsChecked)
  {
    this->CheckMesh(step, *this->Current);
    this->Steps[step].IsChecked = true;
  }
  return *this->Current;
}

//------------------------------------------------------------------------------
void RangedSeries::CheckMesh(std::size_t step, RangedMesh& mesh)
{
  const std::uint64_t points = this->GetNumberOfPoints();
  const std::uint64_t cells = this->GetNumberOfCells();
  const std::size_t size = SizeOfPoint(this->First->GetTemplate(0));
  bool isSame = mesh.GetNumberOfPoints() == points && mesh.GetNumberOfCells() == cells &&
    SizeOfPoint(mesh.GetTemplate(0)) == size;
  std::vector<std::uint8_t> one(BlockSize * size);
  std::vector<std::uint8_t> other(BlockSize * size);
  for (std::uint64_t begin = 0; begin < points && isSame; begin += BlockSize)
  {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(BlockSize, points - begin));
    this->First->ReadPoints(begin, count, one.data());
    mesh.ReadPoints(begin, count, other.data());
    isSame = one == other;
  }
  RangedCells first;
  RangedCells now;
  for (std::uint64_t begin = 0; begin < cells && isSame; begin += first.Types.size())
  {
    this->First->ReadCells(begin, BlockSize, first);
    mesh.ReadCells(begin, BlockSize, now);
    isSame = first.Types == now.Types && first.Sizes == now.Sizes && first.Points == now.Points &&
      first.FaceSizes == now.FaceSizes && first.Faces == now.Faces;
  }
  if (!isSame)
  {
    this->Fail(step,
      "parts of a mesh, as with --memory and --pieces, cannot be those of points that move; the "
      "points or the cells change");
  }
}

//------------------------------------------------------------------------------
void RangedSeries::CheckUnchanged() const
{
  this->First->CheckUnchanged();
  if (this->Current)
  {
    this->Current->CheckUnchanged();
  }
}
}
