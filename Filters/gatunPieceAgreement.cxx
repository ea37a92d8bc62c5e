// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPieceAgreement.h"

#include "gatunError.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

namespace gatun
{
//------------------------------------------------------------------------------
bool PieceAgreement::AreAll(bool holds)
{
  int mine = holds ? 1 : 0;
  int all = mine;
  if (this->Controller)
  {
    this->Controller->AllReduce(&mine, &all, 1, vtkCommunicator::MIN_OP);
  }
  return all != 0;
}

//------------------------------------------------------------------------------
void PieceAgreement::Check(const std::exception_ptr& failure)
{
  const bool isGood = this->AreAll(!failure);
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  if (!isGood)
  {
    ThrowInvalid("another process has failed");
  }
}
}
