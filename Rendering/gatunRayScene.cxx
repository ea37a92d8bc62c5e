// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunRayScene.h"

#include "gatunArrayBridge.h"
#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunTetInput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include <vtksys/SystemTools.hxx>

#include <algorithm>

namespace gatun
{
namespace
{
[[noreturn]] void ThrowInvalid(const std::string& what)
{
  throw Error(ErrorCode::InvalidInput, what);
}

std::string Describe(const RayArray& array)
{
  const char* where = array.Association == 0 ? "point " : array.Association == 1 ? "cell " : "";
  return array.Name.empty() ? std::string("there are no ") + where + "scalars to draw"
                            : std::string("there is no ") + where + "array '" + array.Name + "'";
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
    vtkDataArray* const found =
      wanted.Name.empty() ? attributes->GetScalars() : attributes->GetArray(wanted.Name.c_str());
    if (found)
    {
      return { found, where };
    }
  }
  ThrowInvalid(Describe(wanted));
}

std::uint32_t FindArray(const FileReader& file, const RayArray& wanted)
{
  const auto& arrays = file.GetArrays();
  const auto fits = [&](const ArrayDescription& array, bool active)
  {
    constexpr std::uint32_t scalars = 1;
    return (wanted.Association < 0 || wanted.Association == static_cast<int>(array.Where)) &&
      (active ? (array.AttributeRoles & scalars) != 0 : array.Name == wanted.Name);
  };
  for (const auto where : { Association::Point, Association::Cell })
  {
    for (std::size_t i = 0; i < arrays.size(); ++i)
    {
      if (arrays[i].Where == where && fits(arrays[i], wanted.Name.empty()))
      {
        return static_cast<std::uint32_t>(i);
      }
    }
  }
  ThrowInvalid(file.GetPath() + ": " + Describe(wanted));
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

void RequireComponent(const RayArray& array, std::uint32_t components)
{
  if (array.Component < -1 || array.Component >= static_cast<int>(components))
  {
    ThrowInvalid("the array to draw has no component " + std::to_string(array.Component));
  }
}
}

RayScene::RayScene() = default;
RayScene::~RayScene() = default;

//------------------------------------------------------------------------------
void RayScene::Clear()
{
  this->Source.reset(); // first: it looks at the others
  this->File.reset();
  this->Tets = nullptr;
  this->Coordinates = nullptr;
  this->Scalars = nullptr;
  this->Hidden.clear();
  this->Values = {};
}

//------------------------------------------------------------------------------
bool RayScene::IsKnown(const void* grid, const std::string& path, vtkMTimeType stamp,
  const RayArray& array, std::uint64_t budget)
{
  if (this->Source && grid == this->Grid && path == this->Path && stamp == this->Stamp &&
    array == this->Array && budget == this->Budget)
  {
    return true;
  }
  this->Clear();
  this->Grid = grid;
  this->Path = path;
  this->Stamp = stamp;
  this->Array = array;
  this->Budget = budget;
  return false;
}

//------------------------------------------------------------------------------
void RayScene::SetGrid(vtkUnstructuredGrid* grid, const RayArray& array, std::uint64_t budget)
{
  if (this->IsKnown(grid, {}, grid->GetMTime(), array, budget))
  {
    return;
  }
  this->Tets = MakeTetInput(grid, true).Grid;
  const auto [scalars, where] = FindArray(this->Tets, array);
  const BridgedArray values = Bridge(scalars, where);
  RequireComponent(array, values.Description.Components);
  this->Scalars = values.Owner;
  this->Hidden = FindHidden(this->Tets);

  MeshInput mesh;
  mesh.Points = static_cast<std::uint64_t>(this->Tets->GetNumberOfPoints());
  mesh.Tets = static_cast<std::uint64_t>(this->Tets->GetNumberOfCells());
  if (vtkPoints* const points = this->Tets->GetPoints())
  {
    this->Coordinates = Contiguous(points->GetData());
    if (points->GetDataType() != VTK_FLOAT && points->GetDataType() != VTK_DOUBLE)
    {
      auto doubles = vtkSmartPointer<vtkDoubleArray>::New();
      doubles->DeepCopy(this->Coordinates);
      this->Coordinates = doubles;
    }
    mesh.CoordinateType =
      this->Coordinates->GetDataType() == VTK_FLOAT ? ScalarType::Float32 : ScalarType::Float64;
    mesh.Coordinates = this->Coordinates->GetVoidPointer(0);
  }
  if (vtkCellArray* const cells = this->Tets->GetCells())
  {
    mesh.WideIds = cells->IsStorage64Bit();
    mesh.Connectivity = cells->GetConnectivityArray()->GetVoidPointer(0);
  }
  auto source = std::make_unique<MemoryRaySource>(mesh,
    RayValuesInput{ where, values.Description.Type, values.Description.Components, array.Component,
      values.Values },
    this->Hidden.empty() ? nullptr : this->Hidden.data(), budget);
  for (std::size_t block = 0; block < source->GetNumberOfBlocks(); ++block)
  {
    const Range range = source->GetRange(block);
    this->Values.Min = std::min(this->Values.Min, range.Min);
    this->Values.Max = std::max(this->Values.Max, range.Max);
  }
  this->Source = std::move(source);
}

//------------------------------------------------------------------------------
void RayScene::SetFile(
  const std::string& path, double time, const RayArray& array, std::uint64_t budget)
{
  const auto stamp = static_cast<vtkMTimeType>(vtksys::SystemTools::ModifiedTime(path)) << 20 ^
    static_cast<vtkMTimeType>(vtksys::SystemTools::FileLength(path));
  auto file = std::make_shared<const FileReader>(path);
  const auto& times = file->GetTimes();
  const auto step = file->HasTime()
    ? static_cast<std::size_t>(std::max<std::ptrdiff_t>(
        0, std::upper_bound(times.begin(), times.end(), time) - times.begin() - 1))
    : 0;
  if (this->IsKnown(nullptr, path, stamp ^ (static_cast<vtkMTimeType>(step) << 48), array, budget))
  {
    return;
  }
  const auto index = FindArray(*file, array);
  RequireComponent(array, file->GetArrays()[index].Components);
  const auto& ranges = file->GetRanges(index, step);
  this->Values =
    array.Component >= 0 ? ranges[static_cast<std::size_t>(array.Component)] : ranges.back();
  this->Source =
    std::make_unique<FileRaySource>(file, RayValues{ index, array.Component, step }, budget);
  this->File = std::move(file);
}
}
