// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunGhosts.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace gatun
{

//------------------------------------------------------------------------------
vtkUnsignedCharArray* GhostsWith(vtkDataSetAttributes* attributes, unsigned char bit)
{
  auto* ghosts = vtkArrayDownCast<vtkUnsignedCharArray>(
    attributes->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
  if (ghosts && ghosts->GetNumberOfComponents() == 1)
  {
    for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
    {
      if (ghosts->GetValue(i) & bit)
      {
        return ghosts;
      }
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::size_t CountGhosts(vtkDataSetAttributes* cellData)
{
  constexpr unsigned char bit = vtkDataSetAttributes::DUPLICATECELL;
  std::size_t count = 0;
  if (vtkUnsignedCharArray* const ghosts = GhostsWith(cellData, bit))
  {
    for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
    {
      count += (ghosts->GetValue(i) & bit) != 0;
    }
  }
  return count;
}

//------------------------------------------------------------------------------
void ClearGhosts(vtkDataSetAttributes* attributes, unsigned char bit)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  auto* ghosts = vtkArrayDownCast<vtkUnsignedCharArray>(attributes->GetAbstractArray(name));
  if (!ghosts || ghosts->GetNumberOfComponents() != 1)
  {
    return;
  }
  bool left = false;
  for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
  {
    if (ghosts->GetValue(i) & bit)
    {
      ghosts->SetValue(i, static_cast<unsigned char>(ghosts->GetValue(i) & ~bit));
    }
    left = left || ghosts->GetValue(i) != 0;
  }
  if (!left)
  {
    attributes->RemoveArray(name);
  }
}

//------------------------------------------------------------------------------
void ClearGhosts(vtkUnstructuredGrid* grid)
{
  const auto clear = [](vtkDataSetAttributes* attributes, unsigned char bit)
  {
    if (vtkUnsignedCharArray* const ghosts = GhostsWith(attributes, bit))
    {
      vtkNew<vtkUnsignedCharArray> copy;
      copy->DeepCopy(ghosts);
      copy->SetName(vtkDataSetAttributes::GhostArrayName());
      attributes->AddArray(copy);
    }
    ClearGhosts(attributes, bit);
  };
  clear(grid->GetCellData(), vtkDataSetAttributes::DUPLICATECELL);
  clear(grid->GetPointData(), vtkDataSetAttributes::DUPLICATEPOINT);
}

}
