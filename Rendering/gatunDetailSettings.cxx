// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunDetailSettings.h"

#include "gatunRayRendering.h"

namespace gatun
{
//------------------------------------------------------------------------------
DetailSettings::DetailSettings(vtkGatunDetailPolicy* policy)
  : JustInTime(policy->GetJustInTime())
  , TimeBudget(policy->GetTimeBudget())
  , ViewDependent(policy->GetViewDependent())
  , PixelError(policy->GetPixelError())
  , Ratio(policy->GetSimplificationRatio())
{
  RequireNumber("TimeBudget", this->TimeBudget);
  RequireNumber("PixelError", this->PixelError);
  RequireNumber("SimplificationRatio", this->Ratio);
}
}
