// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunParallel_h
#define gatunParallel_h

#include "gatunExport.h" // For export macro

#include <cstddef>
#include <functional>

namespace gatun
{
/**
 * Calls body(0) ... body(count - 1), each once, on the threads of a backend (gatunThreads.h):
 *
 * - In VTK's modules, on those of vtkSMPTools. If its backend is Sequential by default, as in
 *   Debian's ParaView, on threads of its own: as many as SetNumberOfThreads or VTK_SMP_MAX_THREADS
 * of the environment says.
 * - In a library without VTK, on threads of its own: as many as SetNumberOfThreads says.
 *
 * By default there is one thread for each processor that the affinity and the control groups (the
 * quota of a container) of this process allow.
 *
 * If a body throws, the bodies that have not begun are skipped, and the first exception is thrown
 * again by the calling thread. The calling thread calls progress(fraction) before and after all
 * bodies, and may do so between its own; if that returns false, the rest is skipped and
 * Error(Aborted) thrown.
 * A ParallelFor within a body runs on the thread of that body.
 */
GATUN_EXPORT void ParallelFor(std::size_t count, const std::function<void(std::size_t)>& body,
  const std::function<bool(double)>& progress = {});

/** The maximum number of bodies that ParallelFor runs at the same time. */
GATUN_EXPORT int GetNumberOfThreads();

/** Sets the number of threads for the whole process, of vtkSMPTools, too; 0 for the default.
 * Returns what was set before. */
GATUN_EXPORT int SetNumberOfThreads(int count);

/** Calls work while there is a given number of threads in the whole process. */
GATUN_EXPORT void WithNumberOfThreads(int count, const std::function<void()>& work);
}

#endif
