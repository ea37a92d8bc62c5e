// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyLookup_h
#define gatunHartleyLookup_h

#include "gatunHartleyKernel.h"
#include "gatunHartleyShading.h"
#include "gatunTypes.h"

#include <vector>

namespace gatun
{
/** An opacity model with its transfer function, tabulated. */
class HartleyLookup
{
public:
  HartleyLookup(const HartleyShading& shading, double base, const Range& range);

  const HartleyOpacity& GetOpacity() const { return this->Opacity; }

  /** Whether blocks whose voxels all have the base value are transparent. */
  bool IsBaseClear() const { return this->BaseClear; }

private:
  void MakeTable(const HartleyShading& shading);

  HartleyOpacity Opacity;
  bool BaseClear = false;
  std::vector<float> Table;
};
}

#endif
