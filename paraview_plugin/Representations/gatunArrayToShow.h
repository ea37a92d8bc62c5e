// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunArrayToShow_h
#define gatunArrayToShow_h

#include <optional>
#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkPVArrayInformation;
class vtkPVDataInformation;
class vtkSMArrayListDomain;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** Whether an array names or marks things instead of measuring them: ghost types, global, pedigree
 * and original ids, numbers of blocks. */
bool IsBookkeeping(vtkPVArrayInformation& array);

/**
 * The place in a list of arrays of the one to show if nobody has chosen: the active scalars,
 * otherwise the first array of points, otherwise the first of cells. Bookkeeping arrays are taken
 * if there are no others. Nothing if the list has no arrays of numbers.
 */
std::optional<unsigned int> FindArrayToShow(vtkSMArrayListDomain& list, vtkPVDataInformation& data);
}

#endif
