// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnTimes_h
#define gtnTimes_h

// The time steps of a source in VTK's pipeline.

#include <cstddef>
#include <vector>

class vtkInformation;

namespace gtn
{
/** Tells the pipeline the times of a source, in ascending order; nothing if there are none. */
void PublishTimes(vtkInformation* info, const std::vector<double>& times);

/** The step that a source is asked for: the last one that is not later. 0 without times. */
std::size_t FindStep(vtkInformation* info, const std::vector<double>& times);
}

#endif
