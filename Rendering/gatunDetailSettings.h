// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunDetailSettings_h
#define gatunDetailSettings_h

#include "vtkGatunDetailPolicy.h"

namespace gatun
{
/** The properties of a vtkGatunDetailPolicy, for an image. */
struct DetailSettings
{
  bool JustInTime = false;
  double TimeBudget = 0;
  bool ViewDependent = true;
  double PixelError = 0;
  double Ratio = 0;

  DetailSettings() = default;

  /** Throws InvalidInput if a property is not a number. */
  explicit DetailSettings(vtkGatunDetailPolicy* policy);
};
}

#endif
