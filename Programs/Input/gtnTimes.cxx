// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnTimes.h"

#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace gtn
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

//------------------------------------------------------------------------------
void PublishTimes(vtkInformation* info, const std::vector<double>& times)
{
  if (!times.empty())
  {
    const double range[2] = { times.front(), times.back() };
    info->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    info->Set(Pipeline::TIME_RANGE(), range, 2);
  }
}

//------------------------------------------------------------------------------
std::size_t FindStep(vtkInformation* info, const std::vector<double>& times)
{
  std::size_t step = 0;
  if (info->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    const double time = info->Get(Pipeline::UPDATE_TIME_STEP());
    while (step + 1 < times.size() && times[step + 1] <= time)
    {
      ++step;
    }
  }
  return step;
}
}
