// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunParallel_h
#define gatunParallel_h

#include "vtkGatunCoreModule.h"

#include <cstddef>
#include <functional>

namespace gatun
{
/**
 * Calls body(0) ... body(count - 1), each once, on the threads of vtkSMPTools; the one seam between
 * the core and VTK. Where the backend is Sequential only because nobody chose another (as in
 * Debian's ParaView), STDThread is used.
 *
 * The first exception of a body is thrown again here once all threads have come back; bodies that
 * had not begun by then are skipped. The calling thread calls progress(fraction) before all bodies,
 * and may do so between its own; when that returns false the rest is skipped and Error(Aborted)
 * thrown. Within a body, another ParallelFor runs on the thread of that body.
 */
VTKGATUNCORE_EXPORT void ParallelFor(std::size_t count,
  const std::function<void(std::size_t)>& body, const std::function<bool(double)>& progress = {});

/** How many bodies ParallelFor runs at the same time at most. */
VTKGATUNCORE_EXPORT int GetNumberOfThreads();
}

#endif
