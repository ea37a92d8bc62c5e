// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunNewArray_h
#define gatunNewArray_h

// Arrays whose size comes from a file or an input. When there is no memory for them, a VTK with
// assertions ends the process; here std::bad_alloc is thrown.

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <initializer_list>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkAbstractArray;
class vtkCellArray;
class vtkPoints;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** Sets the number of tuples of an array, whose values are lost. Call it in place of
 * SetNumberOfTuples and SetNumberOfValues. Large ones are in huge pages, which are cleared faster
 * when they are first written. Throws std::bad_alloc. */
VTKGATUNIO_EXPORT void SizeArray(vtkAbstractArray* array, vtkIdType tuples);

/** The same in place of SetNumberOfPoints. */
VTKGATUNIO_EXPORT void SizePoints(vtkPoints* points, vtkIdType count);

/** A new array with some values. */
template <typename ArrayT, typename T>
vtkSmartPointer<ArrayT> MakeArray(const std::vector<T>& values)
{
  using ValueT = typename ArrayT::ValueType;
  auto array = vtkSmartPointer<ArrayT>::New();
  SizeArray(array.Get(), static_cast<vtkIdType>(values.size()));
  ValueT* to = array->GetPointer(0);
  for (const T value : values)
  {
    *to++ = static_cast<ValueT>(value);
  }
  return array;
}

/** Collects cells one by one, in place of vtkCellArray::InsertNextCell. */
class VTKGATUNIO_EXPORT CellCollector
{
public:
  void Reserve(std::size_t cells, std::size_t ids)
  {
    this->Offsets.reserve(cells + 1);
    this->Ids.reserve(ids);
  }

  /** Appends an id to the cell that EndCell ends. */
  void AddPoint(vtkIdType id) { this->Ids.push_back(id); }
  void EndCell() { this->Offsets.push_back(static_cast<vtkIdType>(this->Ids.size())); }

  void Add(std::initializer_list<vtkIdType> ids)
  {
    this->Ids.insert(this->Ids.end(), ids);
    this->EndCell();
  }

  std::size_t GetNumberOfCells() const { return this->Offsets.size() - 1; }

  /** The cells. isWide: with 64-bit integers. */
  vtkSmartPointer<vtkCellArray> Make(bool isWide = true) const;

private:
  std::vector<vtkIdType> Offsets{ 0 };
  std::vector<vtkIdType> Ids;
};
}

#endif
