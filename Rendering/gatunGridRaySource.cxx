// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunGridRaySource.h"

#include "gatunArrayBridge.h"
#include "gatunError.h"
#include "gatunTetInput.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace gatun
{
namespace
{
vtkDataArray* FindArray(vtkDataSetAttributes* attributes, const RayArray& wanted)
{
  if (wanted.Index)
  {
    const int index = *wanted.Index;
    return index >= 0 && index < attributes->GetNumberOfArrays() ? attributes->GetArray(index)
                                                                 : nullptr;
  }
  return wanted.Name.empty() ? attributes->GetScalars() : attributes->GetArray(wanted.Name.c_str());
}

/** The array to draw, and whether it is of the points or of the cells. */
std::pair<vtkDataArray*, Association> FindArray(vtkUnstructuredGrid* grid, const RayArray& wanted)
{
  for (const auto where : { Association::Point, Association::Cell })
  {
    if (wanted.Association >= 0 && wanted.Association != static_cast<int>(where))
    {
      continue;
    }
    vtkDataSetAttributes* const attributes = where == Association::Point
      ? static_cast<vtkDataSetAttributes*>(grid->GetPointData())
      : grid->GetCellData();
    if (vtkDataArray* const found = FindArray(attributes, wanted))
    {
      return { found, where };
    }
  }
  ThrowInvalid(DescribeMissing(wanted));
}

/** Which tetrahedra are not to be drawn; empty if all are. */
std::vector<unsigned char> FindHidden(vtkUnstructuredGrid* grid)
{
  constexpr unsigned char cellFlags = vtkDataSetAttributes::DUPLICATECELL |
    vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
  auto* const cells = grid->GetCellGhostArray();
  auto* const points = grid->GetPointGhostArray();
  if (!cells && !points)
  {
    return {};
  }
  std::vector<unsigned char> hidden(static_cast<std::size_t>(grid->GetNumberOfCells()), 0);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    bool isHidden = cells && (cells->GetValue(cell) & cellFlags) != 0;
    if (points && !isHidden)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      grid->GetCellPoints(cell, count, ids);
      isHidden = std::any_of(ids, ids + count,
        [&](vtkIdType id)
        { return (points->GetValue(id) & vtkDataSetAttributes::HIDDENPOINT) != 0; });
    }
    hidden[static_cast<std::size_t>(cell)] = isHidden ? 1 : 0;
  }
  return hidden;
}

}

//------------------------------------------------------------------------------
std::string DescribeMissing(const RayArray& array)
{
  const std::string where = array.Association == 0 ? "point "
    : array.Association == 1                       ? "cell "
                                                   : "";
  if (array.Index)
  {
    return "there is no " + where + "array " + std::to_string(*array.Index) + " to draw";
  }
  return array.Name.empty() ? "there are no " + where + "scalars to draw"
                            : "there is no " + where + "array '" + array.Name + "'";
}

//------------------------------------------------------------------------------
int FindComponent(const RayArray& array, std::uint32_t components)
{
  if (array.Component < -1 || array.Component >= static_cast<int>(components))
  {
    ThrowInvalid("the array to draw has no component " + std::to_string(array.Component));
  }
  return components == 1 ? 0 : array.Component;
}

//------------------------------------------------------------------------------
Range GetWholeRange(const RaySource& source)
{
  Range whole;
  for (std::size_t block = 0; block < source.GetNumberOfBlocks(); ++block)
  {
    const Range range = source.GetRange(block);
    whole.Min = std::min(whole.Min, range.Min);
    whole.Max = std::max(whole.Max, range.Max);
  }
  return whole;
}

//------------------------------------------------------------------------------
GridMesh::GridMesh(vtkUnstructuredGrid* grid, const RayArray& array)
  : Tets(MakeTetInput(grid).Grid)
  , Mesh(std::make_unique<BridgedMesh>(Tets))
{
  const auto [scalars, where] = FindArray(this->Tets, array);
  const BridgedArray values = Bridge(scalars, where);
  this->Scalars = values.Owner;
  this->Hidden = FindHidden(this->Tets);
  this->Values = { where, values.Description.Type, values.Description.Components,
    FindComponent(array, values.Description.Components), values.Values };
}

GridMesh::~GridMesh() = default;

//------------------------------------------------------------------------------
GridRaySource::GridRaySource(vtkUnstructuredGrid* grid, const RayArray& array, std::uint64_t budget)
  : Mesh(grid, array)
  , Source(this->Mesh.GetMesh(), this->Mesh.GetValues(), this->Mesh.GetHidden(), budget)
{
}

GridRaySource::~GridRaySource() = default;

//------------------------------------------------------------------------------
std::size_t GridRaySource::GetNumberOfBlocks() const
{
  return this->Source.GetNumberOfBlocks();
}

//------------------------------------------------------------------------------
const Bounds& GridRaySource::GetBounds(std::size_t block) const
{
  return this->Source.GetBounds(block);
}

//------------------------------------------------------------------------------
Range GridRaySource::GetRange(std::size_t block) const
{
  return this->Source.GetRange(block);
}

//------------------------------------------------------------------------------
RaySource::Blocks GridRaySource::GetBlocks(
  std::span<const std::size_t> blocks, const Progress& progress)
{
  return this->Source.GetBlocks(blocks, progress);
}
}
