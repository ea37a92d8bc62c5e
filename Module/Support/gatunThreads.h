// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunThreads_h
#define gatunThreads_h

// The seam between the core and a system of threads. A backend is one source that defines
// RunOnThreads, GetNumberOfThreads and SetNumberOfThreads, and the linker chooses it:
// gatunThreadsVTK.cxx in VTK's modules, gatunThreadsStandard.cxx in a library without VTK.

#include <cstddef>
#include <functional>

namespace gatun
{
/** Calls take on up to so many threads at once. The caller's may be one of them or none. */
void RunOnThreads(std::size_t count, const std::function<void()>& take);

/** The same with std::thread and the caller's thread. If the system has no more threads, those that
 * there are do the work. */
void RunOnStandardThreads(std::size_t count, const std::function<void()>& take);
}

#endif
