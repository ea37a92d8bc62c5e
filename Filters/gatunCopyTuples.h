// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCopyTuples_h
#define gatunCopyTuples_h

#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <numeric>

namespace gatun
{
/** Copies tuples of some numbers to the beginning. */
inline void CopyTuples(vtkDataSetAttributes* from, vtkIdList* ids, vtkDataSetAttributes* to)
{
  vtkNew<vtkIdList> places;
  places->SetNumberOfIds(ids->GetNumberOfIds());
  std::iota(places->begin(), places->end(), vtkIdType{ 0 });
  to->CopyGlobalIdsOn();
  to->CopyAllocate(from, ids->GetNumberOfIds());
  to->CopyData(from, ids, places);
}
}

#endif
