// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellCheck.h"

#include "gatunError.h"

#include "vtkCellArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <string>

namespace
{

//------------------------------------------------------------------------------
template <typename ArrayT>
bool OffsetsFit(ArrayT* offsets, ArrayT* connectivity)
{
  const auto* begin = offsets->GetPointer(0);
  const auto* end = begin + offsets->GetNumberOfValues();
  return begin != end && *begin == 0 && std::is_sorted(begin, end) &&
    end[-1] <= connectivity->GetNumberOfValues();
}

//------------------------------------------------------------------------------
template <typename ArrayT>
void CheckIds(ArrayT* connectivity, vtkIdType points)
{
  const auto* begin = connectivity->GetPointer(0);
  const auto* end = begin + connectivity->GetNumberOfValues();
  const auto* wrong =
    std::find_if(begin, end, [points](auto id) { return id < 0 || id >= points; });
  if (wrong != end)
  {
    throw gatun::Error(gatun::ErrorCode::InvalidInput,
      "a cell names point " + std::to_string(*wrong) + " of " + std::to_string(points));
  }
}

} // anonymous namespace

namespace gatun
{

//------------------------------------------------------------------------------
void CheckOffsets(vtkCellArray* cells)
{
  const bool good = cells->IsStorage64Bit()
    ? OffsetsFit(cells->GetOffsetsArray64(), cells->GetConnectivityArray64())
    : OffsetsFit(cells->GetOffsetsArray32(), cells->GetConnectivityArray32());
  if (!good)
  {
    throw Error(ErrorCode::InvalidInput, "the offsets of the cells do not fit their connectivity");
  }
}

//------------------------------------------------------------------------------
void CheckPointIds(vtkCellArray* cells, vtkIdType points)
{
  if (cells->IsStorage64Bit())
  {
    CheckIds(cells->GetConnectivityArray64(), points);
  }
  else
  {
    CheckIds(cells->GetConnectivityArray32(), points);
  }
}

}
