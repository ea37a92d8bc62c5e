// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceGrid.h"

#include "gatunArrayBridge.h"
#include "gatunCellArrays.h"
#include "gatunCellCheck.h"
#include "gatunError.h"
#include "gatunNewArray.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>

namespace gatun
{
namespace
{
using CellLists = std::array<vtkCellArray*, SurfaceLists>;

CellLists ListsOf(vtkPolyData* surface)
{
  return { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() };
}

//------------------------------------------------------------------------------
void CheckLists(vtkPolyData* surface)
{
  static const char* const names[] = { "vertices", "lines", "polygons", "strips" };
  const CellLists lists = ListsOf(surface);
  for (std::size_t i = 0; i < lists.size(); ++i)
  {
    try
    {
      CheckOffsets(lists[i]);
      CheckPointIds(lists[i], surface->GetNumberOfPoints());
    }
    catch (const Error& error)
    {
      ThrowInvalid(std::string("the ") + names[i] + " are wrong: " + error.what());
    }
  }
}

//------------------------------------------------------------------------------
/** All cells of all lists as one cell array. */
template <typename ArrayT>
vtkSmartPointer<vtkCellArray> Concatenate(const CellLists& lists)
{
  using ValueT = typename ArrayT::ValueType;
  vtkIdType cells = 0;
  vtkIdType ids = 0;
  for (vtkCellArray* list : lists)
  {
    cells += list->GetNumberOfCells();
    UseCellArrays(list,
      [&](const auto* offsets, const auto*, vtkIdType)
      { ids += static_cast<vtkIdType>(offsets[list->GetNumberOfCells()]); });
  }
  vtkNew<ArrayT> offsets;
  SizeArray(offsets, cells + 1);
  vtkNew<ArrayT> connectivity;
  SizeArray(connectivity, ids);
  ValueT* start = offsets->GetPointer(0);
  ValueT* id = connectivity->GetPointer(0);
  *start++ = 0;
  ValueT before = 0;
  for (vtkCellArray* list : lists)
  {
    UseCellArrays(list,
      [&](const auto* from, const auto* corners, vtkIdType)
      {
        const vtkIdType count = list->GetNumberOfCells();
        const auto toValue = [](auto value) { return static_cast<ValueT>(value); };
        start = std::transform(from + 1, from + 1 + count, start,
          [&](auto offset) { return static_cast<ValueT>(before + static_cast<ValueT>(offset)); });
        id = std::transform(corners, corners + from[count], id, toValue);
        before = static_cast<ValueT>(before + static_cast<ValueT>(from[count]));
      });
  }
  auto all = vtkSmartPointer<vtkCellArray>::New();
  all->SetData(offsets, connectivity);
  return all;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> JoinLists(const CellLists& lists)
{
  CellLists filled{};
  const auto end = std::copy_if(lists.begin(), lists.end(), filled.begin(),
    [](vtkCellArray* list) { return list->GetNumberOfCells() > 0; });
  if (end - filled.begin() == 1)
  {
    return filled[0];
  }
  vtkIdType ids = 0;
  bool isWide = false;
  for (auto list = filled.begin(); list != end; ++list)
  {
    ids += (*list)->GetNumberOfConnectivityIds();
    isWide = isWide || HasWideIds(*list);
  }
  isWide = isWide || ids > VTK_INT_MAX;
  return isWide ? Concatenate<vtkTypeInt64Array>(lists) : Concatenate<vtkTypeInt32Array>(lists);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnsignedCharArray> MakeTypes(const CellLists& lists, vtkIdType cells)
{
  auto types = vtkSmartPointer<vtkUnsignedCharArray>::New();
  SizeArray(types, cells);
  unsigned char* type = types->GetPointer(0);
  for (std::size_t i = 0; i < lists.size(); ++i)
  {
    UseCellArrays(lists[i],
      [&](const auto* offsets, const auto*, vtkIdType)
      {
        for (vtkIdType c = 0; c < lists[i]->GetNumberOfCells(); ++c)
        {
          *type++ = GetSurfaceCell(static_cast<SurfaceList>(i), offsets[c + 1] - offsets[c]);
        }
      });
  }
  return types;
}

//------------------------------------------------------------------------------
/** The cells of a grid that Order names from first on, as a cell array of the same type. */
template <typename ArrayT>
vtkSmartPointer<vtkCellArray> Extract(
  vtkCellArray* cells, const vtkIdType* first, const vtkIdType* last)
{
  using ValueT = typename ArrayT::ValueType;
  vtkIdType ids = 0;
  std::for_each(first, last, [&](vtkIdType cell) { ids += cells->GetCellSize(cell); });
  vtkNew<ArrayT> offsets;
  SizeArray(offsets, last - first + 1);
  vtkNew<ArrayT> connectivity;
  SizeArray(connectivity, ids);
  ValueT* start = offsets->GetPointer(0);
  ValueT* id = connectivity->GetPointer(0);
  *start = 0;
  UseCellArrays(cells,
    [&](const auto* from, const auto* corners, vtkIdType)
    {
      for (const vtkIdType* cell = first; cell != last; ++cell)
      {
        id = std::transform(corners + from[*cell], corners + from[*cell + 1], id,
          [](auto value) { return static_cast<ValueT>(value); });
        *++start = static_cast<ValueT>(id - connectivity->GetPointer(0));
      }
    });
  auto extracted = vtkSmartPointer<vtkCellArray>::New();
  extracted->SetData(offsets, connectivity);
  return extracted;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> MakeSurfaceGrid(vtkPolyData* surface)
{
  CheckLists(surface);
  const CellLists lists = ListsOf(surface);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(surface->GetPoints());
  const vtkIdType cells = std::accumulate(lists.begin(), lists.end(), vtkIdType{ 0 },
    [](vtkIdType sum, vtkCellArray* list) { return sum + list->GetNumberOfCells(); });
  if (cells > 0)
  {
    grid->SetCells(MakeTypes(lists, cells), JoinLists(lists));
  }
  grid->GetPointData()->ShallowCopy(surface->GetPointData());
  grid->GetCellData()->ShallowCopy(surface->GetCellData());
  grid->GetFieldData()->ShallowCopy(surface->GetFieldData());
  return grid;
}

//------------------------------------------------------------------------------
SurfaceCells FindSurfaceCells(vtkUnstructuredGrid* grid)
{
  SurfaceCells cells;
  const vtkIdType count = grid->GetNumberOfCells();
  if (count == 0)
  {
    return cells;
  }
  cells.Source = grid->GetCells();
  const auto typeArray = GetCellTypes(grid);
  const unsigned char* const types = typeArray->GetPointer(0);
  std::array<vtkIdType, SurfaceLists + 1> ends{}; // of the lists, behind a 0
  const auto listOf = [types](vtkIdType cell)
  { return static_cast<std::size_t>(GetSurfaceList(types[cell])); };
  bool isSorted = true;
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    if (!IsSurfaceCell(types[cell]))
    {
      throw Error(ErrorCode::Corrupt,
        "a surface has a cell of type " + std::to_string(static_cast<int>(types[cell])));
    }
    ++ends[listOf(cell) + 1];
    isSorted = isSorted && (cell == 0 || listOf(cell - 1) <= listOf(cell));
  }
  const auto only = std::find(ends.begin(), ends.end(), count);
  if (only != ends.end())
  {
    cells.Lists[static_cast<std::size_t>(only - ends.begin()) - 1] = cells.Source;
    return cells;
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  cells.Order.resize(static_cast<std::size_t>(count));
  std::array<vtkIdType, SurfaceLists + 1> next = ends;
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    cells.Order[static_cast<std::size_t>(next[listOf(cell)]++)] = cell;
  }
  for (std::size_t i = 0; i < SurfaceLists; ++i)
  {
    const vtkIdType* const first = cells.Order.data() + ends[i];
    const vtkIdType* const last = cells.Order.data() + ends[i + 1];
    if (first != last)
    {
      cells.Lists[i] = HasWideIds(cells.Source)
        ? Extract<vtkTypeInt64Array>(cells.Source, first, last)
        : Extract<vtkTypeInt32Array>(cells.Source, first, last);
    }
  }
  if (isSorted)
  {
    cells.Order = {};
  }
  return cells;
}

//------------------------------------------------------------------------------
void MakeSurface(vtkUnstructuredGrid* grid, const SurfaceCells& cells, vtkPolyData* surface)
{
  surface->SetPoints(grid->GetPoints());
  surface->SetVerts(cells.Lists[0]);
  surface->SetLines(cells.Lists[1]);
  surface->SetPolys(cells.Lists[2]);
  surface->SetStrips(cells.Lists[3]);
  surface->GetPointData()->ShallowCopy(grid->GetPointData());
  if (cells.Order.empty())
  {
    surface->GetCellData()->ShallowCopy(grid->GetCellData());
  }
  else
  {
    GatherAll(grid->GetCellData(), cells.Order, surface->GetCellData());
  }
  surface->GetFieldData()->ShallowCopy(grid->GetFieldData());
}
}
