// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunDetailSettings_h
#define gatunDetailSettings_h

#include "vtkGatunDetailPolicy.h"

#include "vtkSmartPointer.h"

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

/** The policy of an object, which is never null. */
class DetailPolicyOwner
{
public:
  /** Returns whether the policy is another one now. Null: a new one. */
  bool Set(vtkGatunDetailPolicy* policy);
  vtkGatunDetailPolicy* Get() const { return this->Policy; }

private:
  vtkSmartPointer<vtkGatunDetailPolicy> Policy = vtkSmartPointer<vtkGatunDetailPolicy>::New();
};
}

#endif
